# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# The part of ./run that a student's tree does not have: grading, tests, measurements, and what is generated.

packages+=(ccache libarchive-dev libsodium-dev libsqlitecpp-dev bubblewrap python3 tzdata)
# Debian 13 does not have it.
optional_packages+=(similarity-tester)
# texel bench counts instructions with it; not every processor has it.
optional_packages+=(valgrind)
format_packages=(clang-format)
test_packages=(libgtest-dev libtinyobjloader-dev xvfb xauth xdotool x11-utils imagemagick chromium webp)
bench_packages=(libbenchmark-dev libosmesa6-dev libtinyobjloader-dev xvfb xauth chromium)
all_packages=(clang clang-tidy parallel mmdebstrap debian-archive-keyring slurmctld slurmd slurm-client munge)

course_help() {
  cat <<'TEXT'

For teachers and makers of the course:
./run starter DIR      write the tree that students start with; see
                       docs/student.md
./run web [--serve]    write the labs as pages for a browser into out/web;
                       --serve shows them here
./run web --starter    the same pages with the starter's steps, without
                       solutions, into out/web_starter
./run grade CLASS [..] grade a class: a folder with one folder or archive per
                       student; see docs/instructor.md
./run course NAME [..] autograder for Gradescope, GitHub workflow, gradebook,
                       similarity; see docs/course.md
./run test             check the formatting, build, run the tests, and run the
                       parsers' tests with sanitizers
./run test N           build, and run the tests of lab N
./run test ROOM        build, and run the tests of one folder below common or
                       teach, as in ./run test judge
./run test --all       run all tests, a build by Clang, clang-tidy for the
                       libraries below common/app, a class with all wrong and
                       all hostile solutions, a Gradescope container, a Slurm
                       cluster, and the last commit on bare machines of three
                       releases (hours)
./run bench [N] [args] measure the cost and the error of each method of each
                       lab, into out/bench/index.html
./run accuracy         the same, into docs/accuracy.md, docs/accuracy and
                       docs/accuracy.json, beside a graphics card's figures:
                       TEXEL_CONTEXT=egl ./run bench --json
                       docs/accuracy_gpu.json measures these
./run sweep [N]        measure N random settings of each lab beside its right
                       answer [112]: no error may be above its method's bound
                       (ten minutes)
./run performance      compare the programs with one written by hand,
                       and kernels with plain versions and other libraries;
                       writes docs/performance.md (about an hour).
                       --first-run-before TREE and --saves-before TREE also
                       compare what people wait for with earlier commits' trees,
                       in which ./run build was typed
./run renderers [args] draw all cases with every renderer of this machine into
                       out/renderers. Each limit must be three times the spread.
                       Without args it writes docs/renderers.json and
                       docs/accuracy/renderers.md. To include machines with
                       another Mesa, copy their folders into out/renderers first
./run mutants [args]   make small wrong changes in a copy of the tree, and check
                       that the tests notice. It writes docs/mutants.md;
                       without args it goes on where it was cut off (hours)
./run marks [N ..]     check that each mistake of the catalogue loses marks, and
                       no right answer does. Without args it writes
                       docs/marks.md (ten minutes)
./run format           format the C++ files
./run assets           draw the textures, normal maps and cube maps again that
                       are functions
./run expected [N ..]  draw the expected pictures of check again, with the
                       solutions
./run docs             write docs/pictures.md and the pictures of README and
                       handouts again
TEXT
}

# Grades the course's own solutions like a student's work. They need no sandbox.
grade_solutions() {
  say "Grading the solutions"
  rm -rf "$root/out/solutions" "$root/out/grades"
  mkdir -p "$root/out/solutions/solution"
  cp -r "$root"/{labs,shaders} "$root/out/solutions/solution"
  texel grade "$root/out/solutions" --out "$root/out/grades" --unsafe
}

# shellcheck source=teach/web/run.sh
source "$root/teach/web/run.sh"

sources() { find "$root"/{cmake,common,labs,teach,tools,tests} -name '*.?pp' -print0; }

# Each version of clang-format breaks some lines differently.
check_format() {
  local wanted=14 version
  version=$(clang-format --version | sed -E 's/.*version ([0-9]+).*/\1/')
  if [[ $version != "$wanted" ]]; then
    say "The formatting is not checked: this needs clang-format $wanted, and here is $version"
    return
  fi
  say "Checking the formatting"
  sources | xargs -0 -n 16 -P "$(nproc)" clang-format --dry-run -Werror || fail 1 "some files are not formatted; ./run format fixes that"
}

# What is exhaustive runs on a build server, and by --all.
exhaustive() { [[ -n ${CI:-}${TEXEL_TEST_ALL:-} ]]; }

run_tests() { # preset, arguments of ctest
  say "Testing (preset $1)"
  # One more than there are processors: the tests of windows and pages mostly wait.
  (cd "$root" && ctest --preset "$1" --parallel "$(($(nproc) + 1))" "${@:2}") || fail 1 "tests of the preset $1 failed"
}

build_tests() {
  # The driver's cache of compiled shaders starts empty, as on a new machine. Then all tests share it.
  rm -rf "$root/build/shaders"
  export MESA_SHADER_CACHE_DISABLE=false MESA_SHADER_CACHE_DIR=$root/build/shaders
  configure release -D TEXEL_TESTS=ON
  build release all
}

# The tests that name this lab: every_lab.….of_lab_5, figures.of_lab_5, HardCaseOfLab5…, accuracy.of_lab_5…, tools.marks_of_lab_5.
test_lab() { # number
  lab_folder "$1" >/dev/null || fail 2 "there is no lab $1; ./run progress shows all labs"
  need "${packages[@]}" "${test_packages[@]}"
  build_tests
  # And what a change of any lab may forget: lines, mistakes, handouts, what renderers differ by.
  run_tests release --no-tests=error --tests-regex "[Ll]abs?_?0?$1([^0-9]|\$)|^tree\.(rooms|catalogue|handouts)|^tools\.renderers"
  say "The tests of lab $1 passed after $SECONDS s; ./run test asks for the formatting and all the others"
}

test_room() { # folder below common or teach
  local of=$root/tests/unit/$1
  compgen -G "${of}_*test.cpp" >/dev/null || fail 2 "there is no test of a folder '$1'; ./run test takes a lab's number, a folder below common or teach, or --all"
  need "${packages[@]}" "${test_packages[@]}"
  configure release -D TEXEL_TESTS=ON
  build release "unit_$1"
  (cd "$root" && "build/release/bin/unit_$1" --gtest_brief=1 && tests/rooms.py >/dev/null) ||
    fail 1 "tests of $1 failed"
  say "The tests of $1 passed after $SECONDS s; ./run test asks for the formatting and all the others"
}

run_all_tests() {
  local all=${1:-}
  need "${packages[@]}" "${format_packages[@]}" "${test_packages[@]}"
  check_format
  if [[ $all == --all ]]; then
    need "${all_packages[@]}"
    configure tidy
    # clang-tidy 14 does not understand the labs' consteval parameters that come from a template's.
    build tidy texel_{core,params,course,image,mesh,judge,check,sandbox,store,reports,grade,procedural,perception,gl}
    configure clang -D TEXEL_TESTS=ON
    build clang all
    export TEXEL_TEST_ALL=1
    "$root/run" web && "$root/run" web --starter
  fi
  build_tests
  local some=(--label-exclude exhaustive)
  exhaustive && some=()
  run_tests release "${some[@]}"
  configure asan-ubsan -D TEXEL_TESTS=ON
  build asan-ubsan tests/all
  run_tests asan-ubsan
  if [[ $all == --all ]]; then
    local try=$root/tests/machines/try
    { "$try" bookworm --user && "$try" trixie && "$try" sid; } || fail 1 "a bare machine failed"
  fi
  say "All tests passed after $SECONDS s"
}

run_bench() { # arguments of texel bench
  build_programs
  say "Measuring"
  texel bench --out "$root/out/bench" "$@"
}

run_performance() { # arguments of performance
  need "${packages[@]}" "${bench_packages[@]}"
  configure release -D TEXEL_BENCH=ON
  build release labs/all tests/bench/all texel
  if [[ " $* " != *" --only "* || " $* " == *" --only peers "* ]]; then
    "$root/run" web
    (cd "$root/tests/bench/peers" && npm ci --no-audit --no-fund --loglevel=error) || fail 3 "three.js cannot be installed"
  fi
  say "Measuring"
  "$root/teach/commands/performance.py" "$@"
}

run_mutants() { # arguments of mutants.py
  need "${packages[@]}" "${test_packages[@]}"
  "$root/teach/commands/mutants.py" "$@"
}

make_assets() {
  build_release assets/all texel
  say "Making the assets"
  case $* in
    '') "$root/build/release/bin/make_assets" "$root/assets" ;;
    --check) "$root/teach/assets/check_assets.py" "$root/build/release/bin" "$root/assets" ;;
    *) fail 2 "./run assets takes --check or nothing" ;;
  esac
}

renew_docs() {
  need "${packages[@]}" imagemagick
  build_programs
  draw_gallery
  "$root/teach/commands/drawings.py" "$root/docs/pictures/drawings"
  say "Drawing each step before and after"
  texel starter --pictures "$root/docs/pictures/steps"
  "$root/teach/commands/pictures.py"
}

# Runs one of these commands and ends; returns if there is none of that name.
course_command() { # command, arguments
  local command=$1
  shift
  [[ ! $command =~ ^(accuracy|docs|format)$ ]] || (($# == 0)) || fail 2 "./run $command takes no arguments"
  case $command in
    test)
      case $* in
        '' | --all) run_all_tests "$@" ;;
        [1-9] | [1-9][0-9]) test_lab "$1" ;;
        *) test_room "$*" ;;
      esac
      ;;
    bench) run_bench "$@" ;;
    web) web "$@" ;;
    course | expected | grade | marks)
      build_programs >&2
      [[ $command != marks ]] || (($#)) || set -- --markdown "$root/docs/marks.md"
      texel "$command" "$@"
      ;;
    starter)
      [[ $# -ge 1 && $1 != -* ]] || fail 2 "where to? Type ./run starter DIR with a new folder"
      build_programs
      texel starter --out "$@"
      ;;
    accuracy)
      run_bench --json "$root/docs/accuracy.json" --gpu "$root/docs/accuracy_gpu.json" \
        --markdown "$root/docs/accuracy.md"
      ;;
    sweep)
      build_programs
      say "Measuring"
      "$root/tests/figures/sweep.py" "${1:-112}" "$root"/build/release/bin/lab[0-9]*
      ;;
    performance)
      # A part, or with few rounds, is not the report.
      [[ " $* " == *' --only '* || " $* " == *' --rounds '* ]] || set -- --markdown "$root/docs/performance.md" "$@"
      run_performance "$@"
      ;;
    renderers)
      (($#)) || set -- --json "$root/docs/renderers.json" --markdown "$root/docs/accuracy/renderers.md"
      need "${packages[@]}" "${test_packages[@]}"
      configure release -D TEXEL_TESTS=ON
      build release all rsqrt
      texel renderers --out "$root/out/renderers" "$@"
      ;;
    mutants)
      if (($#)); then run_mutants "$@"; else run_mutants --resume; fi
      ;;
    format)
      need "${format_packages[@]}"
      sources | xargs -0 clang-format -i
      ;;
    assets) make_assets "$@" ;;
    docs) renew_docs ;;
    *) return 0 ;;
  esac
  exit 0
}

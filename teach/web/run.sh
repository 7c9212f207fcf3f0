# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# ./run web: the labs as pages with WebAssembly.

web_packages=(cmake ninja-build ccache emscripten node-acorn webp libglm-dev libfmt-dev libstb-dev libtomlplusplus-dev nlohmann-json3-dev)

# Compiles the labs of a tree into a build folder.
compile_engine() { # tree, build folder
  local log
  say "Compiling the labs for a browser"
  claim "${2##*/}"
  # Emscripten's own scripts need Debian's acorn, also where another node is first on the path.
  log=$(NODE_PATH=/usr/share/nodejs emcmake cmake -G Ninja -S "$root/teach/web/engine" -B "$2" -D CMAKE_BUILD_TYPE=Release -D TEXEL_TREE="$1" 2>&1) ||
    fail 3 "cmake failed:"$'\n'"$log"
  NODE_PATH=/usr/share/nodejs cmake --build "$2" --parallel "$(nproc)" 2>&1 | compiler_messages ||
    fail 3 "the build failed; the messages above say why"
  unclaim
}

# The steps that are written in C++: a page draws them as solved, and they are done on the desktop.
cpp_steps() { grep -rhoE '//@step [0-9]+\.[0-9]+' "$root/labs" --include='*.[ch]pp' | cut -d' ' -f2 | sort -uV | paste -sd,; }

web() { # --serve [PORT], --starter
  local serve='' port=8080 kind=course tree=$root program=$root build=$root/build/engine out=$root/out/web
  while (($#)); do
    case $1 in
      --serve)
        serve=yes
        [[ ! ${2:-} =~ ^[0-9]+$ ]] || { port=$2; shift; }
        ;;
      --starter) kind=starter ;;
      *) fail 2 "there is no option '$1'; ./run web takes --serve [PORT] and --starter" ;;
    esac
    shift
  done
  # Another node than Debian's, with its own npm, is as good.
  local programs=()
  command -v node >/dev/null || programs+=(nodejs)
  command -v npm >/dev/null || programs+=(npm)
  need "${web_packages[@]}" "${programs[@]}"
  # The small pictures of the looks are the gallery's.
  [[ -d $root/out/gallery ]] || { build_programs && draw_gallery; }
  if [[ $kind == starter ]]; then
    build_release texel
    build=$root/build/engine_starter
    tree=$build/tree program=$build/program out=$root/out/web_starter
    rm -rf "$tree"
    texel starter --out "$tree"
    # Files that are the same keep their time, and are not compiled again.
    rm -rf "$build/fresh"
    texel starter --out "$build/fresh" --solve "$(cpp_steps)"
    mkdir -p "$program"
    # A file that was renamed would be compiled under both names.
    (cd "$program" && find . -type f -print0) | while IFS= read -r -d '' file; do
      [[ -e $build/fresh/$file ]] || rm "$program/$file"
    done
    (cd "$build/fresh" && find . -type f -print0) | while IFS= read -r -d '' file; do
      cmp -s "$build/fresh/$file" "$program/$file" || { mkdir -p "$(dirname "$program/$file")" && mv "$build/fresh/$file" "$program/$file"; }
    done
    rm -rf "$build/fresh"
  fi
  compile_engine "$program" "$build"
  mkdir -p "$out"
  node "$root/teach/web/engine/pack.mjs" "$tree" "$build" "$out/engine" "$kind"
  if [[ -e $root/teach/web/site/package.json ]]; then
    say "Making the pages"
    (cd "$root/teach/web/site" && { [[ node_modules/.package-lock.json -nt package-lock.json ]] || npm ci --no-audit --no-fund --loglevel=error; } &&
      npm run --silent build -- --out "$out" --tree "$tree" --gallery "$root/out/gallery" --programs "$root/build/release/bin") || fail 3 "the pages could not be made"
  fi
  say "Ready after $SECONDS s"
  printf 'static files for any web server   %s\n' "$out"
  [[ -z $serve ]] || exec node "$root/teach/web/engine/serve.mjs" "$out" "$port"
  printf 'look at them here                 ./run web %s--serve\n' "$([[ $out != *_starter ]] || printf -- '--starter ')"
}

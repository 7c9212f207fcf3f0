#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# autograder.zip has the course and the seed, and nothing else that lies in the course's folder: pack.sh BIN FOLDER
set -euo pipefail
work=$2/pack
course=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
rm -rf "$work" && mkdir -p "$work" && cd "$work"
printf 'the seed of this assignment\n' >seed.txt
printf '%s\n' course/ course/CMakeLists.txt course/labs/ course/labs/05_normal_map/ course/labs/05_normal_map/lab.cpp course/run \
  labs.txt run_autograder seed.txt setup.sh | LC_ALL=C sort >expected

make_course() { # folder
  mkdir -p "$1"/{labs/05_normal_map,teach/commands} "$1"/{class,out,build}
  cp -r "$course/teach/commands/scripts" "$1/teach/commands/scripts"
  touch "$1"/{run,CMakeLists.txt,labs/05_normal_map/lab.cpp}
}
spoil() { # folder: what teachers leave there
  touch "$1"/{class/jane.zip,roster.csv,old_seed.txt,gradebook.csv,seed.txt,autograder.zip,out/class.csv,build/texel}
  touch "$1/labs/marks.csv" "$1/labs/seed.txt"
}
pack() { # folder
  "$1/teach/commands/scripts/gradescope" --labs 5 --seed-file seed.txt --out "$1.zip" >"$1.said" 2>&1
  cmake -E tar tf "$1.zip" | grep -v '^course/teach/' | LC_ALL=C sort -u
}

make_course plain && spoil plain
pack plain | diff expected -

make_course tracked
git -C tracked -c init.defaultBranch=main init --quiet
git -C tracked add run CMakeLists.txt labs teach
spoil tracked
mkdir tracked/labs/class && touch tracked/labs/class/doe.cpp
pack tracked | diff expected -
grep -q 'not packed, since git does not have it: labs/class/doe.cpp' tracked.said
echo passed

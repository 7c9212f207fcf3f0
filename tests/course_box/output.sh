#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Text that standard output does not take is told, with exit code 3, by every program of ours: output.sh BIN FOLDER
set -euo pipefail
bin=$1 work=$2/output
course=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
rm -rf "$work" && mkdir -p "$work"/{class,starter} && cd "$work"
export TEXEL_ROOT=$course
touch starter/run
mkfifo pipe
printf 'the seed of this assignment\n' >seed.txt
printf 'name,id,number,total,lab 1,step 1.1,begun,note\nann,ann-1,1,9,9,1,1,\n' >class.csv
printf 'number,sis,name\n1,s1,Ann\n' >roster.csv
pictures=("$course"/labs/01_texture_quad/expected/*.png)
lab=$bin/lab01_texture_quad texel=$bin/texel failed=0

expect() { # exit code, what standard output is, command
  if [[ $1 != 3 ]] || ! grep -q 'No space left\|Broken pipe\|write' said; then
    printf 'output.sh: exit code %s, %s: %s\n' "$1" "$2" "$3 ($(<said))"
    failed=1
  fi
}
try() {
  local code=0
  "$@" >/dev/full 2>said </dev/null || code=$?
  expect "$code" 'a full disk' "$*"
  code=0
  # Opened for both directions a pipe does not wait; once that end is closed, nobody reads.
  exec 4<>pipe 3>pipe 4<&-
  "$@" >&3 2>said </dev/null || code=$?
  exec 3>&-
  expect "$code" 'a closed pipe' "$*"
}
for option in '--stats -' '--measure - --size 32x32' '--frames 1' --print-shader --list-parameters '--list-parameters --json' --list-views --help \
  --version; do
  # shellcheck disable=SC2086
  try "$lab" $option
done
for command in list --help --version 'check --help' 'check 1' 'check 1 --json' 'progress --help' 'grade --help' \
  'grade class --print-steps' 'course gradebook --help' 'course similar --help'; do
  # shellcheck disable=SC2086
  try "$texel" $command
done
try "$texel" compare "${pictures[0]}" "${pictures[0]}"
try "$texel" compare "${pictures[0]}" "${pictures[0]}" --json
try "$texel" course gradebook class.csv --roster roster.csv --out book.csv
try "$texel" course gradescope --labs 1 --seed-file seed.txt --out autograder.zip
try "$texel" course classroom --labs 1 starter
try "$bin/make_assets" assets
try "$course/run" help
try "$course/run" packages
# The same of a file.
code=0
"$texel" course gradebook class.csv --roster roster.csv --out /dev/full >/dev/null 2>said || code=$?
expect "$code" 'a full disk' 'gradebook --out /dev/full'
((failed == 0))
echo passed

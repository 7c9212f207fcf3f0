#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Gradescope runs this once, as root, when it makes the container's image: everything that no submission changes.
set -euo pipefail
source=/autograder/source
chmod 700 "$source"
chmod +x "$source/course/run"
"$source/course/run" build
# Starter and references, which all submissions share: an empty submission is graded. It runs no student's program.
mkdir -p /texel/empty/nobody
"$source/course/build/release/bin/texel" grade /texel/empty --out /texel/first --cache /texel/cache \
  --labs "$(cat "$source/labs.txt")" --seed-file "$source/seed.txt" --unsafe
rm -rf /texel/first /texel/empty

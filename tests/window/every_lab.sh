# SPDX-License-Identifier: MIT
# Each lab opens, shows a picture, and closes.
source "$(dirname "${BASH_SOURCE[0]}")/window.bash"
export TEXEL_ROOT=$source_root

labs=("$source_root"/labs/*/lab.cpp)
check 'there are the nine labs, or more' test ${#labs[@]} -ge 9
shows_colours() { look "$work/now" $picture && has_colours "$work/now" 3000; }
draws_the_same() {
  "$bin/$1" --size 256x256 --snapshot "$work/alone.png" && "$bin/$1" --size 256x256 --context window --snapshot "$work/window.png" &&
    cmp "$work/alone.png" "$work/window.png"
}
for lab in "${labs[@]}"; do
  program=lab$(basename "$(dirname "$lab")")
  check "$program draws the same in a window's context" draws_the_same "$program"
  check "$program opens" open_lab "$program"
  check "$program shows a picture" eventually shows_colours
  check "$program quits with exit code 0" quits_with 0
  check "$program leaves standard error empty" test ! -s "$work/errors"
done

times_frames() { [[ $("$bin/lab01_texture_quad" --frames 2 --context window) == "the first after "*" ms, the panel after "*" ms"*"2 frames of "*"parameters: "*" %" ]]; }
check '--frames in a window times it and its panel' times_frames

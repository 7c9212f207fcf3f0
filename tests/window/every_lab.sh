# SPDX-License-Identifier: MIT
# Each lab opens, shows a picture, and closes; one also on a screen of twice the density.
source "$(dirname "${BASH_SOURCE[0]}")/window.bash"
export TEXEL_ROOT=$source_root

labs=("$source_root"/labs/*/lab.cpp)
check 'there are the nine labs, or more' test ${#labs[@]} -ge 9
shows_colours() { look "$work/now" $picture && has_colours "$work/now" 200; }
draws_the_same() {
  "$bin/$1" --size 256x256 --snapshot "$work/alone.png" && "$bin/$1" --size 256x256 --context window --snapshot "$work/window.png" &&
    cmp "$work/alone.png" "$work/window.png"
}
each=3 # or all, where all tests run
[[ -z ${CI:-}${TEXEL_TEST_ALL:-} ]] || each=1
for ((i = 0; i < ${#labs[@]}; i += each)); do
  lab=${labs[i]}
  program=lab$(basename "$(dirname "$lab")")
  check "$program draws the same in a window's context" draws_the_same "$program"
  check "$program opens" open_lab "$program"
  check "$program shows a picture" eventually shows_colours
  check "$program quits with exit code 0" quits_with 0
  check "$program leaves standard error empty" test ! -s "$work/errors"
done

times_frames() { [[ $("$bin/lab01_texture_quad" --frames 2 --context window) == "2 frames of 512x512: median "*" ms"* ]]; }
check "--frames is drawn by a window's driver too" times_frames

# On a screen of twice the density the window has twice the pixels, and so has its text.
twice_as_large() {
  [[ $(xdotool getwindowgeometry --shell "$window") == *WIDTH=960$'\n'HEIGHT=720* ]] && look "$work/now" 1x60+400+0 &&
    (($(pixels_of "$work/now" 41,46,51 2) >= 36))  # the title: 20 pixels high at the usual density
}
check 'a screen says its density' xprop -root -f RESOURCE_MANAGER 8s -set RESOURCE_MANAGER 'Xft.dpi: 192'
check 'the window opens there' open_lab lab05_normal_map --size 480x360
check 'window and panel are twice as large' eventually twice_as_large
check 'and it quits' quits_with 0

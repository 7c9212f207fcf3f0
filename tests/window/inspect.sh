# SPDX-License-Identifier: MIT
# A clicked pixel: its data, and the levels or faces of the textures that it reads.
source "$(dirname "${BASH_SOURCE[0]}")/window.bash"
own_tree 01_texture_quad 05_normal_map 06_cube_map

# framed: how much of a frame in amber stands over the picture: around levels that are read, and around a face.
framed() { look "$work/now" $picture && pixels_of "$work/now" 255,199,89 1; }
has_frames() { (($(framed) > $1)); }
has_no_frames() { (($(framed) < 20)); }

check 'lab 1 opens' open_lab lab01_texture_quad --distance 4 --method trilinear
check 'the picture comes to rest' settle "$work/first"
check 'nothing stands over it' has_no_frames
xdotool mousemove --window "$window" 550 390 click 1
# Two frames of 32x32, 2 wide; the levels' numbers.
check 'a click shows the levels that are read' eventually has_frames 150
settle "$work/two"
press r # the view's own distance, with another footprint
check 'another distance needs other levels' changed_from "$work/two"
check 'Esc quits with exit code 0' quits_with 0

check 'lab 6 opens' open_lab lab06_cube_map --turn 0 --method linear
check 'the picture comes to rest' settle "$work/first"
check 'nothing stands over it' has_no_frames
xdotool mousemove --window "$window" 650 560 click 1
check 'a click shows the level, the face, and that there are no mipmaps' eventually has_frames 200
look "$work/below" $picture
xdotool mousemove --window "$window" 650 350 click 1
check 'another pixel shows another face' changed_from "$work/below"
xdotool mousemove --window "$window" 400 30 click 1
check 'the background has none' eventually has_no_frames
check 'Esc quits with exit code 0' quits_with 0
check 'nothing stands on standard error' test ! -s "$work/errors"

# A key is held for some frames: the panel reads once a frame which are down.
hold() { xdotool keydown --window "$window" "$1" && sleep 0.3 && xdotool keyup --window "$window" "$1"; }
marks() { hold Tab && shows_other "$work/panel" 340x640+0+0; }
check 'lab 5 opens' open_lab lab05_normal_map --turn 0
check 'the panel comes to rest' settle "$work/panel" 340x640+0+0
check 'Tab marks a control without a click' eventually marks
until_pressed() { hold Tab && look "$work/marked" 340x640+0+0 && hold Return && shows_other "$work/marked" 340x640+0+0; }
check 'Enter presses one' eventually until_pressed
check 'and the lab still quits' quits_with 0

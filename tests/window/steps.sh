# SPDX-License-Identifier: MIT
# The list of steps in the window: figures follow what is saved, and a case that is picked sets its look and shows its
# expected picture.
source "$(dirname "${BASH_SOURCE[0]}")/window.bash"

stand_in_for_programs
export TEXEL_ROOT=$work/root
mkdir -p "$TEXEL_ROOT"
cp -r "$source_root"/{shaders,labs,common} "$TEXEL_ROOT"
ln -s "$source_root/assets" "$TEXEL_ROOT/assets"
shader=$TEXEL_ROOT/shaders/05_normal_map/decode_normal.glsl

click() { xdotool mousemove --window "$window" "$1" "$2" click 1; }

# has_text RGB: whether so coloured text stands in the panel's upper part.
has_text() {
  look "$work/now" 330x170+0+70 || return
  (($(pixels_of "$work/now" "$1" 4) > 20))
}
green=115,217,128 amber=255,199,89
shows_done() { has_text $green && ! has_text $amber; }

check 'the window opens' open_lab lab05_normal_map --turn 0
check 'all steps are done, in green' eventually shows_done
check 'and all of the course' eventually shows_course
settle "$work/first"
# The titles of 5.4 and 5.5 need two lines. Cut off, their letters reach the panel's edge.

sed -i 's/return color \* 2.0 - 1.0/return (color * 2.0 - 1.0) * vec3(1.0, -1.0, 1.0)/' "$shader"
check 'a step that a save has spoilt is in amber' eventually has_text $amber
check 'and the picture shows the mistake' changed_from "$work/first"
are_whole() { look "$work/now" 6x240+312+95 && (($(pixels_of "$work/now" $green 20) == 0)); }
check 'no title is cut off' eventually are_whole
settle "$work/wrong"

# The first step's triangle, then its first case: below two lines each of error and mistake, and the button for a hint.
click 19 103
sleep 1
pick_case() { click 70 234; }
pick_case
check 'a case that is picked sets its look' changed_from "$work/wrong"
settle "$work/case"
# The picture of the case stands at the lower right, with a white line between yours and the expected one.
white_line() { look "$work/corner" 340x380+600+330 && (($(pixels_of "$work/corner" 255,255,255 0) > 150)); }
check 'and shows the expected picture beside yours' eventually white_line

no_white_line() { ! white_line; }
# line_at X: the white line stands at this column of the window.
line_at() { look "$work/column" 3x200+$(($1 - 1))+436 && (($(pixels_of "$work/column" 255,255,255 0) >= 200)); }
check 'in the middle' eventually line_at 734
xdotool mousemove --window "$window" 734 540 mousedown 1 mousemove --window "$window" 690 540
check 'the line follows the mouse' eventually line_at 690
xdotool mouseup 1
settle "$work/split" 340x290+620+430

click 395 416
is_opened() { grep -qs 'shaders/05_normal_map/decode_normal.glsl' "$work/edited"; }
check 'Open in editor opens the step' eventually is_opened

# Of the scale, which ends where the error is largest.
shows_heat() { look "$work/corner" 310x280+640+430 && (($(pixels_of "$work/corner" 255,255,191 6) > 10)); }
click 785 419
check 'difference shows where the error is' eventually shows_heat
check 'in place of the two pictures' eventually no_white_line
click 641 419
check 'yours and expected come back' eventually line_at 690
press ctrl+z
press Escape
check 'Undo sets the look as it was' returned_to "$work/wrong"
pick_case
check 'the case again' eventually white_line
click 946 391
check 'its cross takes the step away' eventually no_white_line
check 'and keeps the look of the case' changed_from "$work/wrong"
pick_case
check 'the case again' eventually white_line
press Escape
check 'Esc takes the step away, too' eventually no_white_line
pick_case
check 'the case again' eventually white_line

settle "$work/case" 620x370+340+0
click 472 416
check 'See it sets the look of the handout' changed_from "$work/case" 620x370+340+0
pick_case
check 'and the case its own again' returned_to "$work/case" 620x370+340+0

settle "$work/button" 310x20+22+206
click 63 216
check 'a hint takes the place of its button' changed_from "$work/button" 310x20+22+206

press j  # the case's parameters stand in amber too
cp "$source_root/shaders/05_normal_map/decode_normal.glsl" "$shader"
check 'mended, all steps are done again' eventually shows_done

check 'Esc quits with exit code 0' quits_with 0

check 'the window opens at a step' open_lab lab05_normal_map --see 5.1
check 'and shows its pictures' eventually white_line
settle "$work/of_step" 340x290+620+430
check 'Esc quits with exit code 0' quits_with 0
check 'the window opens at a case' open_lab lab05_normal_map --see decode_exact_flat
check 'and shows its pictures' eventually white_line
check 'which are not those of the first case' changed_from "$work/of_step" 340x290+620+430
check 'Esc quits with exit code 0' quits_with 0

# Another lab whose program never ends, while the course is checked: nobody who saves waits for it.
mkdir "$work/bin"
ln -s "$bin"/lab0* "$work/bin"
cp --remove-destination "$bin"/{texel,lab05_normal_map} "$work/bin"
rm "$work/bin/lab01_texture_quad"
printf '#!/bin/sh\necho >%q\nexec sleep 60\n' "$work/waits" >"$work/bin/lab01_texture_quad"
chmod +x "$work/bin/lab01_texture_quad"
bin=$work/bin
check 'the window opens beside a lab that never ends' open_lab lab05_normal_map
check 'its own steps are done' eventually shows_done
check 'the course is being checked' eventually test -e "$work/waits"
sed -i 's/return color \* 2.0 - 1.0/return (color * 2.0 - 1.0) * vec3(1.0, -1.0, 1.0)/' "$shader"
check 'a step that a save spoils is in amber all the same' eventually has_text $amber
check 'Esc quits with exit code 0' quits_with 0
pkill -f "$work/bin/texel"
check 'nothing stands on standard error' test ! -s "$work/errors"

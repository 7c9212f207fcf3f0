# SPDX-License-Identifier: MIT
# The window's controls, each by its key or button, and each taken back: looks, undo, lines, light, clipboard, editor, …
source "$(dirname "${BASH_SOURCE[0]}")/window.bash"

own_tree 05_normal_map
stand_in_for_programs

panel=340x690+0+0 # without the status line
has_parameter() { grep -aq "$2" "$work/$1"; } # a snapshot names its parameters
has_no_parameter() { [[ -s $work/$1 ]] && ! has_parameter "$@"; }
snapshots=0
# snapshot: the picture of the look that the window shows now, in lab05_normal_map-00N.png.
snapshot() {
  press F12
  snapshots=$((snapshots + 1))
  snapshot=lab05_normal_map-00$snapshots.png
  eventually test -s "$work/$snapshot"
}

check 'the window opens' open_lab lab05_normal_map --turn 0
check 'the picture comes to rest' settle "$work/first"
check 'a snapshot is written' snapshot
check 'it opens with the lesson' has_parameter "$snapshot" method=raw
has_line() { look "$work/now" 1x300+650+20 && (($(pixels_of "$work/now" 235,235,235 8) > 250)); }
check 'on both sides of a line' eventually has_line

press g
check 'G shows the looks' changed_from "$work/first"
xdotool mousemove --window "$window" 800 90
sleep 1
xdotool click 1
# Between the first two looks their window is darker than the picture's background.
are_closed() { look "$work/now" 4x160+641+60 && (($(convert "$work/now" -colorspace gray -format '%[fx:mean>0.12]' info:) == 1)); }
check 'a click on the second look closes them' eventually are_closed
check 'a snapshot is written' snapshot
check 'a click on the second look has set it' has_parameter "$snapshot" model=gator
check 'the picture comes to rest' settle "$work/second"
press ctrl+z
check 'Ctrl+Z takes it back' returned_to "$work/first"
press ctrl+y
check 'Ctrl+Y brings it again' returned_to "$work/second"
press j
check 'J sets the look with which the window opened' returned_to "$work/first"
press g
check 'G shows the looks again' changed_from "$work/first"
press Escape
check 'Esc closes them' returned_to "$work/first"

press F1
check 'F1 shows the keys' changed_from "$work/first"
press F1
check 'and hides them' returned_to "$work/first"
press w
# Measured: 102337 pixels; 44704 where an edge that two triangles share is inverted twice.
has_edges() { settle "$work/edges" && (($(compare -metric AE "$work/first" "$work/edges" null: 2>&1) > 80000)); }
check 'W shows the edges of all triangles' eventually has_edges
press w
check 'and the surface again' returned_to "$work/first"
# shows_lines: red, green and blue lines of T, B and N.
shows_lines() {
  look "$work/now" $picture || return
  local colour
  for colour in 255,80,80 90,230,90 110,150,255; do (($(pixels_of "$work/now" $colour 4) > 100)) || return; done
}
press t
check 'T shows T, B and N' eventually shows_lines
press t
check 'and hides them' returned_to "$work/first"

xdotool mousemove --window "$window" 650 200 mousedown 3 mousemove_relative --sync -- -80 0 mousemove_relative --sync -- -80 40 mouseup 3
check 'a drag with the right button moves the light' changed_from "$work/first"
press ctrl+z
check 'Ctrl+Z moves it back' returned_to "$work/first"

press ctrl+c
check 'Ctrl+C copies a picture' eventually test -s "$work/clipboard.png"
check 'which is what the window shows' is_shown "$work/clipboard.png" "$work/first"

xdotool mousemove --window "$window" 500 420 click 1
check 'a click shows the pixel magnified' changed_from "$work/first"
press j # a window that stands over the picture keeps no key away
press Escape
check 'Esc closes it' returned_to "$work/first"
press Escape
check 'Esc ends the comparison' changed_from "$work/first"
settle "$work/whole"
press Escape
check 'with nothing open Esc asks' changed_from "$work/whole"
press r
check 'another key is no answer' returned_to "$work/whole"
press Escape
check 'Esc asks again' changed_from "$work/whole"
press g
press Escape
check 'and forgets it when it closes the looks' returned_to "$work/whole"
press j

look "$work/dark" $panel
in_menu 107
is_light() { look "$work/now" 340x60+0+640 && (($(convert "$work/now" -colorspace gray -format '%[fx:mean>0.6]' info:) == 1)); }
check 'the menu makes the panel light' eventually is_light
in_menu 107
is_dark() { ! is_light; }
check 'and Dark dark again' eventually is_dark

in_menu 184
has_turned() { [[ -s $work/lab05_normal_map-001-turntable/035.png ]]; }
check 'the turntable writes 36 pictures' eventually eventually has_turned
check 'that differ' eval '! cmp -s "$work"/lab05_normal_map-001-turntable/00[01].png'

python3 "$source_root/tests/window/drop_file.py" "$window" "$source_root/assets/textures/smile.png"
check 'a snapshot is written' snapshot
check 'a picture that is dropped is the texture' has_parameter "$snapshot" smile.png
python3 "$source_root/tests/window/drop_file.py" "$window" "$source_root/assets/models/cube.obj"
check 'a snapshot is written' snapshot
check 'an OBJ file that is dropped is the model' has_parameter "$snapshot" cube.obj
press j

shader=$TEXEL_ROOT/shaders/05_normal_map/decode_normal.glsl
cp "$shader" "$work/good"
sed -i 's/return color \* 2.0 - 1.0;/return color * 2.0 - 1.0/' "$shader"
line=$(grep -n 'return color \* 2.0 - 1.0$' "$shader" | cut -d: -f1)
shows_red() { look "$work/now" 620x80+340+0 && (($(pixels_of "$work/now" 255,115,102 15) > 50)); }
check 'a shader error stands over the picture' eventually shows_red
press e
opened() { [[ $(cat "$work/edited" 2>/dev/null) == "+"*"$1" ]]; }
check 'E opens its file in the editor' eventually opened "$shader"
is_at_line() { [[ $(head -n 1 "$work/edited") == *"+$line"* ]]; }
check 'at the line after which the ; is missing' is_at_line
cp "$work/good" "$shader"

check 'Esc quits with exit code 0' quits_with 0
check 'nothing stands on standard error' test ! -s "$work/errors"

# The default look's model comes from a file.
check 'the window opens with an error that nobody knows' open_lab lab05_normal_map --turn 0 --model gator --view error
look_below() { look "$work/now" 620x250+340+460 && look "$work/reason" 620x200+340+260; }
shows_reason() { look_below && (($(colours "$work/now") == 1 && $(colours "$work/reason") > 20)); }
check 'the reason stands over a picture of one colour' eventually shows_reason
check 'Esc quits with exit code 0' quits_with 0

# The exact answer takes longer than a frame.
check 'the window opens with the view error' open_lab lab05_normal_map --turn 0 --model torus --view error
shows_heat() { look "$work/now" $picture && (($(pixels_of "$work/now" 0,0,0 4) > 100000)); }
check 'in the end it shows the error' eventually shows_heat
check 'Esc quits with exit code 0' quits_with 0

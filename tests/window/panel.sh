# SPDX-License-Identifier: MIT
# The panel's buttons and widgets by the mouse alone, each taken back; the buttons of the error, and of the pixel's panel.
source "$(dirname "${BASH_SOURCE[0]}")/window.bash"

# A lab without steps: the widgets stand where they are below.
own_tree 01_texture_quad
find "$TEXEL_ROOT"/labs/* -mindepth 1 ! -name lab.toml -delete
stand_in_for_programs

panel=340x680+0+0 status=330x36+0+684
drag() { # from x y by dx
  xdotool mousemove --window "$window" "$1" "$2" sleep 0.3 mousedown 1 sleep 0.5 mousemove_relative --sync -- "$(($3 / 2))" 0 \
    mousemove_relative --sync -- "$(($3 / 2))" 0 sleep 0.5 mouseup 1
}
# is_back FILE [GEOMETRY]: as returned_to. The mouse leaves for the title when the click was seen: its help hides a part.
is_back_now() { shows "$@" || { sleep 1 && xdotool mousemove --window "$window" 300 10 && false; }; }
is_back() { eventually is_back_now "$@"; }
# opens X Y: a click there opens a list, or what stands in the middle of the panel changes otherwise. It rests before the
# next click: a list takes some frames to come, and a click in these closes it.
middle=300x300+8+210
opens() {
  xdotool mousemove --window "$window" 300 10 && settle "$work/closed" $middle && click_at "$@" &&
    changed_from "$work/closed" $middle && settle "$work/open" $middle && ! cmp -s "$work/open" "$work/closed"
}

check 'the window opens' open_lab lab01_texture_quad
check 'the picture comes to rest' settle "$work/first"

in_menu 91
check 'the menu shows the keys' changed_from "$work/first"
press F1
check 'and F1 hides them' is_back "$work/first"
click_at 29 57
check 'Looks shows the looks' changed_from "$work/first"
settle "$work/open"
kill -STOP "$pid" # as in a slow frame
click_at 936 21
xdotool mousemove --window "$window" 300 10
kill -CONT "$pid"
check 'and their cross closes them, though the mouse is gone before the click is seen' is_back "$work/first"

press Escape
check 'Esc ends the comparison with which the lab opens' changed_from "$work/first"
in_menu 72
check 'which the first look brings again' is_back "$work/first"
press Escape
check 'Esc ends it again' changed_from "$work/first"
settle "$work/first"
settle "$work/closed" $panel
click_at 100 177
check 'a heading opens its section' changed_from "$work/closed" $panel
settle "$work/first"
check 'a click opens the list of textures' opens 220 200
press Escape
check 'Esc closes the list alone' is_back "$work/closed" 300x300+8+210
check 'a click opens it again' opens 220 200
click_at 150 300
check 'another texture is shown' changed_from "$work/first"
click_at 79 57
check 'Undo takes it back' is_back "$work/first"
click_at 126 57
check 'Redo brings it again' changed_from "$work/first"
click_at 321 200
check 'its arrow sets the default' eventually shows_other "$work/first"
click_at 79 57
sleep 1
click_at 79 57
check 'Undo takes both back' is_back "$work/first"

click_at 138 224
check 'the box flips the texture' changed_from "$work/first"
click_at 138 224
check 'and back' is_back "$work/first"
drag 219 272 20
check 'the slider scales the texture' changed_from "$work/first"
click_at 79 57
check 'in one change' is_back "$work/first"
click_at 320 272
check 'reset sets the default scale' changed_from "$work/first"
click_at 79 57
check 'Undo takes it back' is_back "$work/first"

click_at 217 105
check 'the view depth is shown' changed_from "$work/first"
click_at 18 105
check 'and the colours again' is_back "$work/first"

check 'a click opens what can be compared' opens 220 153
click_at 155 251
has_line() { look "$work/now" 1x600+$1+20 && (($(pixels_of "$work/now" 235,235,235 8) > 500)); }
check 'the picture is split in the middle' eventually has_line 650
drag 650 400 100
check 'the line can be dragged' eventually has_line 750
look "$work/linear" 180x600+760+20
check 'a click opens the values of the right side' opens 220 177
click_at 180 259
check 'another value is shown there' changed_from "$work/linear" 180x600+760+20
check 'the list again' opens 220 153
click_at 155 179
check 'nothing is compared' is_back "$work/first"
check 'the list again' opens 220 153
click_at 155 251
check 'the picture is split again' eventually has_line 650
press Escape
check 'Esc ends that' is_back "$work/first"

click_at 174 57
sleep 0.5
click_at 250 209
# Until the field has the caret it does not hear this; a caret that blinks is no selection.
selects_all() {
  press ctrl+a && sleep 0.3 && look "$work/name" 200x18+185+200 && (($(pixels_of "$work/name" 140,100,79 3) > 500))
}
check "Ctrl+A selects the file's name" eventually selects_all
xdotool type --window "$window" --delay 60 mine.toml
press Return
click_at 215 231
check 'Save writes the file that was typed' eventually test -s "$work/mine.toml"
drag 219 272 20
check 'another scale' changed_from "$work/first"
in_menu 248
check 'Load reads it' is_back "$work/first"

in_menu 130
check 'Snapshot writes a picture' eventually test -s "$work/lab01_texture_quad-001.png"
in_menu 149
check 'Copy copies one' eventually test -s "$work/clipboard.png"
look "$work/status" $status
in_menu 166
check 'Command shows the command line' changed_from "$work/status" $status

settle "$work/open" $panel
click_at 100 496
check 'the section Camera opens' changed_from "$work/open" $panel
value_of() { sed -n "s/^$1 = //p" "$work/mine.toml"; }
saves_another() { in_menu 231 && sleep 0.3 && [[ $(value_of "$1") != "$2" ]]; }
for slider in 'yaw 189 520' 'pitch 198 544' 'distance 162 568' 'field of view 176 592'; do
  x=${slider% *}
  name=${x% *}
  name=${name// /_}
  before=$(value_of "$name")
  drag "${x##* }" "${slider##* }" 20
  check "the slider ${x% *} moves the camera" changed_from "$work/first"
  check "and the file has another value of it" saves_another "$name" "$before"
  click_at 79 57
  check 'Undo moves it back' is_back "$work/first"
done
click_at 320 544
check 'reset sets the default pitch' changed_from "$work/first"
click_at 79 57
check 'Undo takes it back' is_back "$work/first"
settle "$work/camera" 320x90+0+510
click_at 100 496
check 'the section closes' changed_from "$work/camera" 320x90+0+510

# Right of the edge, where the panel has no text.
is_panel() { look "$work/now" 20x50+350+610 && (($(colours "$work/now") == 1)); }
drag 336 716 60
check "the panel's corner can be dragged" eventually is_panel
drag 396 716 -60
check 'and back' is_back "$work/first"

shader=$TEXEL_ROOT/shaders/01_texture_quad/sample_color.glsl
cp "$shader" "$work/good"
printf 'float broken() { return nothing; }\nfloat more() { return nothing; }\n' >>"$shader"
shows_red() { look "$work/now" 620x60+340+0 && (($(pixels_of "$work/now" 255,115,102 15) > 50)); }
check 'an error stands over the picture' eventually shows_red
settle "$work/error"
click_at 503 64
check 'its button shows all messages' changed_from "$work/error"
click_at 503 64
check 'and only the first' is_back "$work/error"
click_at 406 64
check 'Open in editor opens the file' eventually test -s "$work/edited"
cp "$work/good" "$shader"
check 'mended, the picture is back' is_back "$work/first"

click_at 650 500
check 'a click shows the pixel' changed_from "$work/first"
check 'Esc quits with exit code 0' quits_with 0
check 'nothing stands on standard error' test ! -s "$work/errors"

rm -r "$TEXEL_ROOT"
own_tree 05_normal_map
check 'lab 5 opens' open_lab lab05_normal_map --turn 0
check 'the picture comes to rest' settle "$work/first"
press Escape
check 'Esc ends the comparison' changed_from "$work/first"
settle "$work/first"
click_at 650 520
check 'a click shows the pixel' changed_from "$work/first"
settle "$work/pixel"
click_at 721 127
check 'the cross closes the panel' is_back "$work/first"
click_at 650 520
check 'the pixel again' is_back "$work/pixel"
click_at 468 300
check 'a tab shows the other texture' changed_from "$work/pixel"
check 'Esc quits with exit code 0' quits_with 0
check 'nothing stands on standard error' test ! -s "$work/errors"

# SPDX-License-Identifier: MIT
# Lab 5 in a window, by keys and mouse as a user has them: everything that changes the picture can be taken back.
source "$(dirname "${BASH_SOURCE[0]}")/window.bash"
own_tree 05_normal_map

# A turn that was asked for pauses the model.
check 'the window opens' open_lab lab05_normal_map --turn 0
check 'the picture comes to rest' settle "$work/first"
check 'it has the colours of a lit brick wall' has_colours "$work/first" 5000

press m
check 'M switches the normal map off' changed_from "$work/first"
press m
check 'M switches it on again' returned_to "$work/first"

press l
check 'L takes the next texture' changed_from "$work/first"
press k
check 'K takes the previous texture' returned_to "$work/first"
press k
check 'K goes round to the last texture' changed_from "$work/first"
press m
press j
check 'J takes everything back' returned_to "$work/first"

look "$work/before" 340x720+0+0
press F5
check 'F5 says so in the panel' changed_from "$work/before" 340x720+0+0
check 'F5 draws the same picture' returned_to "$work/first"

press space
check 'space lets the model turn' changed_from "$work/first"
look "$work/turning" $picture
check 'it turns on' changed_from "$work/turning"
press space
check 'space pauses it' settle "$work/paused"
press r
check 'R resets the view' returned_to "$work/first"

drag() { # from x y by dx dy
  xdotool mousemove --window "$window" "$1" "$2" mousedown 1 mousemove_relative --sync -- "$(($3 / 2))" "$(($4 / 2))" \
    mousemove_relative --sync -- "$(($3 / 2))" "$(($4 / 2))" mouseup 1
}
drag 520 300 120 0
check 'a drag to the side turns the camera' changed_from "$work/first"
press r
check 'R takes it back' returned_to "$work/first"
drag 520 300 0 60
check 'a drag downwards raises the camera' changed_from "$work/first"
press r
check 'R takes it back' returned_to "$work/first"
xdotool mousemove --window "$window" 520 300 click 4
check 'the wheel brings the model nearer' changed_from "$work/first"
xdotool click 5
check 'and back' returned_to "$work/first"
drag 250 36 60 0
check 'a drag over the panel leaves the picture' returned_to "$work/first"

press h
check 'H hides the panel' changed_from "$work/first"
settle "$work/wide" 960x720+0+0
check 'the picture has its place' has_colours "$work/wide" 5000
press h
check 'H shows it again' returned_to "$work/first"

xdotool windowsize "$window" 1100 800
has_size() { look "$work/now" && [[ $(identify -format %wx%h "$work/now") == "$1" ]]; }
check 'the window becomes larger' eventually has_size 1100x800
settle "$work/large" 760x800+340+0
check 'the picture grows with it' has_colours "$work/large" 5000
xdotool windowsize "$window" 500 300
check 'the window becomes small' eventually has_size 500x300
xdotool windowsize "$window" 960 720
check 'at the first size the first picture is back' returned_to "$work/first"

press F12
snapshot=$work/lab05_normal_map-001.png
check 'F12 leaves a picture' eventually test -s "$snapshot"
# By its exit code, since what it prints differs between its versions.
check 'which is what the window shows' is_shown "$snapshot" "$work/first"
press F12
check 'F12 never writes over it' eventually test -s "$work/lab05_normal_map-002.png"

look "$work/before" 340x720+0+0
xdotool mousemove --window "$window" 520 300
settle "$work/now"
xdotool click 1
check 'a click marks the pixel' changed_from "$work/first"
check 'and the panel says what is there' changed_from "$work/before" 340x720+0+0

check 'Esc quits with exit code 0' quits_with 0
check 'nothing stands on standard error' test ! -s "$work/errors"

# SPDX-License-Identifier: MIT
# The plot of error and cost: it is measured while the window goes on, and a click on a name takes the method.
source "$(dirname "${BASH_SOURCE[0]}")/window.bash"
export TEXEL_ROOT=$source_root

check 'lab 1 opens' open_lab lab01_texture_quad
# The section stands below the steps, which are there when they are checked.
has_steps() { look "$work/now" 300x20+0+70 && (($(pixels_of "$work/now" 115,217,128 4) > 30)); }
check 'the steps are checked' eventually has_steps
check 'and those of the other labs' eventually shows_course
status=330x40+0+678
check 'the picture comes to rest' settle "$work/first"
look "$work/quiet" $status

xdotool mousemove --window "$window" 100 449 click 1
check 'the status line says that the methods are measured' changed_from "$work/quiet" $status
check 'and in the end nothing more' eventually eventually shows "$work/quiet" $status
plot=280x165+40+484
# dots RGB: how much of the plot has this colour. The present method is amber, the other four are white.
dots() { look "$work/plot" $plot && pixels_of "$work/plot" "$1" 0; }
has_dots() { (($(dots 255,199,89) > 20 && $(dots 255,255,255) > 100)); }
check 'the plot has the present method and the others' eventually has_dots
check 'the picture is as it was' returned_to "$work/first"

place=$(convert "$work/plot" -fill black +opaque white txt: 2>/dev/null | grep -m 1 -i 'white' | cut -d: -f1)
xdotool mousemove --window "$window" $((40 + ${place%,*})) $((484 + ${place#*,} + 1)) click 1
check 'a click on another takes it' changed_from "$work/first"
press F12
has_method() { [[ -s $work/lab01_texture_quad-001.png ]] && grep -aq 'method=' "$work/lab01_texture_quad-001.png"; }
check 'as the parameter has it' eventually has_method
check 'Esc quits with exit code 0' quits_with 0
check 'nothing stands on standard error' test ! -s "$work/errors"

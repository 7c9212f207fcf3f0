# SPDX-License-Identifier: MIT
# A student saves C++ in an open window: the lab is built, the compiler's message stands over the picture, and F5 opens
# the new program with the same look.
source "$(dirname "${BASH_SOURCE[0]}")/window.bash"

# A tree with its own build folder, and a stand-in for CMake: it refuses a text with the word "broken", and builds the
# same program again for another text than before.
own_tree 05_normal_map
build=$TEXEL_ROOT/build/release
mkdir -p "$build/bin" "$work/programs"
cp "$bin"/{lab05_normal_map,texel} "$build/bin"
printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\n' "$TEXEL_ROOT" >"$build/CMakeCache.txt"
text=$TEXEL_ROOT/labs/05_normal_map/triangle_frame.cpp
cat >"$work/programs/cmake" <<END
#!/bin/sh
echo "\$@" >>$work/asked
if line=\$(grep -n broken $text); then
  echo "../../labs/05_normal_map/triangle_frame.cpp:\${line%%:*}:1: error: 'broken' does not name a type"
  exit 1
fi
cmp -s $text $work/built && exit
cp $text $work/built
cp $bin/lab05_normal_map $build/bin/new && mv $build/bin/new $build/bin/lab05_normal_map
END
chmod +x "$work/programs/cmake"
export PATH=$work/programs:$PATH
bin=$build/bin

check 'the window opens' open_lab lab05_normal_map --turn 0 --model torus
check 'the picture comes to rest' settle "$work/first"
is_checked() { look "$work/now" 330x20+0+70 && (($(pixels_of "$work/now" 115,217,128 4) > 30)); }
check 'the steps are checked' eventually is_checked
check 'nothing was built' test ! -e "$work/asked"

cp "$text" "$work/good"
sed -i '1s/$/\nbroken/' "$text"
shows_red() { look "$work/now" 620x80+340+0 && (($(pixels_of "$work/now" 255,115,102 15) > 50)); }
check "the compiler's message stands over the picture" eventually shows_red
check 'the lab was asked for' grep -q -- "--build $build --target lab05_normal_map" "$work/asked"
cp "$work/good" "$text"
shows_no_red() { ! shows_red; }
check 'mended, it goes' eventually shows_no_red
check 'and the picture is as it was' returned_to "$work/first"

# Another build in the same folder comes first: the saved text is not built before its end.
exec 8>"$build/build.lock"
flock 8
printf './run watch 5' >"$build/build.lock"
# Only this line of the panel is so long.
is_waiting() { look "$work/now" 100x16+170+703 && has_colours "$work/now" 8; }
times() { (($(wc -l <"$work/asked") == $1)); }
asked=$(wc -l <"$work/asked")
sed -i '1s/$/\n/' "$text"
check 'while another builds, the window says so' eventually is_waiting
check 'and waits' times "$asked"
exec 8>&-
check 'then it builds' eventually times $((asked + 1))

# The process has a program that is there no more: another lies in its place.
is_replaced() { [[ $(readlink "/proc/$pid/exe") == *deleted* ]]; }
check 'it is built again' eventually is_replaced
says_so() { look "$work/now" 330x36+0+684 && (($(pixels_of "$work/now" 255,199,89 15) > 100)); }
check 'the window says so, in amber' eventually says_so
press t
check 'the window has lines of T, B and N' changed_from "$work/first"
# A press before the window knows of the new program only reads the shaders again.
reopened() {
  if is_replaced; then
    press F5
    sleep 1
    return 1
  fi
  find_window && shows "$work/first"
}
check 'F5 opens the new program with the same look' eventually reopened
check 'Esc quits with exit code 0' quits_with 0
check 'nothing stands on standard error' test ! -s "$work/errors"

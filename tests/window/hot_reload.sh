# SPDX-License-Identifier: MIT
# A student's edits while the window is open: an error stands over the last good picture, and goes when it is mended.
source "$(dirname "${BASH_SOURCE[0]}")/window.bash"

export TEXEL_ROOT=$work/root
mkdir -p "$TEXEL_ROOT/assets"
cp -r "$source_root/shaders" "$TEXEL_ROOT"
cp -r "$source_root/assets/textures" "$TEXEL_ROOT/assets"
shader=$TEXEL_ROOT/shaders/01_texture_quad/texture_quad.frag
included=$TEXEL_ROOT/shaders/01_texture_quad/sample_color.glsl
brick=$TEXEL_ROOT/assets/textures/brick.png

check 'the window opens' open_lab lab01_texture_quad
check 'the picture comes to rest' settle "$work/first"
# Messages stand at the top: below, the picture must stay as it was.
lower=620x480+340+240
look "$work/lower" $lower

# The message is light red on a dark plate, in a strip that else is slate.
shows_red() {
  look "$work/now" 620x60+340+0 || return
  (($(pixels_of "$work/now" 255,115,102 15) > 50))
}
# breaks NAME FILE command…: the command edits FILE, which is mended afterwards.
breaks() {
  local name=$1 file=$2 start
  cp -p "$file" "$work/good"
  start=$(date +%s%N)
  "${@:3}"
  check "$name: the message stands in red" eventually shows_red
  printf '      after %d ms\n' $((($(date +%s%N) - start) / 1000000))
  check "$name: the last good picture stays below it" eventually shows "$work/lower" $lower
  check "$name: the program runs on" kill -0 "$pid"
  # A new file takes the place of the old, as editors save.
  cp "$work/good" "$file.new" && mv "$file.new" "$file"
  check "$name: mended, the picture is back" returned_to "$work/first"
}
append() { printf '%s\n' "$2" >>"$1"; }

breaks 'a syntax error' "$shader" append "$shader" 'void broken( {'
breaks 'a type error' "$shader" append "$shader" 'vec3 broken() { return vec2(1.0); }'
breaks 'an error in an included file' "$included" append "$included" 'float broken() { return nothing; }'
breaks 'an included file that is missing' "$included" rm "$included"
breaks 'a picture that is cut off' "$brick" truncate -s 2000 "$brick"
breaks 'a picture that is missing' "$brick" rm "$brick"

cp "$brick" "$work/good.png"
cp "$TEXEL_ROOT/assets/textures/wood.png" "$brick"
check 'another picture in the file is shown' changed_from "$work/lower" $lower
cp "$work/good.png" "$brick"
check 'and the first again' returned_to "$work/first"

# fits: the first picture stands in a window that is 500 high, all of it and not stretched. Below the message, and smaller
# by another filter: the mean difference is 0.9 % then, and 6 % if it is stretched.
fits() {
  look "$work/now" 620x420+340+80 &&
    convert "$work/first" -resize 620x500 -gravity center -background 'rgb(52,57,66)' -extent 620x500 -gravity northwest \
      -crop 620x420+0+80 +repage "$work/smaller" &&
    (($(convert "$work/now" "$work/smaller" -compose difference -composite -format '%[fx:mean<0.03]' info:) == 1))
}
cp "$included" "$work/good"
append "$included" 'float broken() { return nothing; }'
check 'the message stands in red' eventually shows_red
xdotool windowsize "$window" 960 500
check 'the last good picture fits into a lower window' eventually fits
xdotool windowsize "$window" 960 720
cp "$work/good" "$included"
check 'mended, the picture is back' returned_to "$work/first"

sed -i 's/sample_color(color_map, fragment_texcoord).rgb/sample_color(color_map, fragment_texcoord).bgr/' "$shader"
check 'an edited shader is shown' changed_from "$work/lower" $lower

check 'Esc quits with exit code 0' quits_with 0
check 'nothing stands on standard error' test ! -s "$work/errors"

# SPDX-License-Identifier: MIT
# What the scripts beside this file share: open a lab, send it keys, look at its window, and count what was checked.
# Each script runs under an X server of its own, without a window manager, as `bash NAME.sh BIN_DIR`.
set -uo pipefail

bin=$(readlink -f "${1:?the folder of the programs}")
source_root=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
work=$(mktemp -d)
passed=0 failed=0 pid='' window=''

end() {
  [[ -z $pid ]] || kill "$pid" 2>/dev/null
  rm -rf "$work"
  printf '%d passed, %d failed\n' "$passed" "$failed"
  ((failed == 0 && passed > 0)) || exit 1
}
trap end EXIT

# check "what must hold" command…
check() {
  if "${@:2}"; then
    printf 'ok    %s\n' "$1"
    passed=$((passed + 1))
  else
    printf 'FAIL  %s\n' "$1"
    failed=$((failed + 1))
  fi
}

# Tries a command again and again for some 15 seconds at most: a quick machine waits no longer than it must.
eventually() {
  local i
  for ((i = 0; i < 100; ++i)); do
    "$@" && return
    sleep 0.1
  done
  return 1
}

# own_tree LAB…: a tree of these labs alone, as 05_normal_map, which may be edited. A window over the whole course checks all labs,
# which takes 3 to 4 s of processor time.
own_tree() {
  export TEXEL_ROOT=$work/root
  mkdir -p "$TEXEL_ROOT/labs"
  cp -r "$source_root/shaders" "$TEXEL_ROOT"
  cp -r "${@/#/$source_root/labs/}" "$TEXEL_ROOT/labs"
  ln -s "$source_root/assets" "$TEXEL_ROOT/assets"
}

# open_lab PROGRAM arguments…: starts it in $work and waits for its window.
open_lab() {
  # Not by a subshell: $! must be the program itself, whose exit code is waited for.
  pushd "$work" >/dev/null || exit 1
  "$bin/$1" "${@:2}" >"$work/output" 2>"$work/errors" &
  pid=$!
  popd >/dev/null || exit 1
  window=
  eventually find_window || {
    printf 'FAIL  no window: %s\n' "$(cat "$work/errors")"
    failed=$((failed + 1))
    exit 1
  }
}
find_window() {
  window=$(xdotool search --onlyvisible --name '^Texel Labs' 2>/dev/null | head -n 1)
  [[ -n $window ]]
}

# Stand-ins for the programs that the window calls, editor and clipboard: they keep what they are given, in $work/edited and
# $work/clipboard.png.
stand_in_for_programs() {
  mkdir -p "$work/programs"
  printf '#!/bin/sh\nprintf "%%s\\n" "$@" >%q\n' "$work/edited" >"$work/programs/editor"
  printf '#!/bin/sh\nfor last; do :; done\ncp "$last" %q\n' "$work/clipboard.png" >"$work/programs/xclip"
  chmod +x "$work"/programs/*
  export PATH=$work/programs:$PATH VISUAL=$work/programs/editor
  unset WAYLAND_DISPLAY
}

press() { xdotool key --window "$window" "$1"; }

# The exit code of the program after Esc, typed until it ends: it closes what is open, one after the other, and asks
# once. What the program wrote to standard error is in $work/errors.
quits_with() {
  local i
  for ((i = 0; i < 8; ++i)); do
    # The window may be gone before xdotool has released the key: held down, it would repeat in the next window.
    press Escape 2>/dev/null
    xdotool keyup Escape
    sleep 0.2
    kill -0 "$pid" 2>/dev/null || break
  done
  eventually eval "! kill -0 $pid 2>/dev/null" || kill "$pid"
  wait "$pid"
  local code=$?
  pid=
  ((code == $1))
}

# look FILE [GEOMETRY]: what the window shows, or a part of it such as 620x720+340+0, as a PPM.
# Without a window import would wait for a click that picks one.
look() { kill -0 "$pid" 2>/dev/null && timeout 10 import -silent -window "$window" ${2:+-crop "$2" +repage} "ppm:$1" 2>/dev/null; }
# The part that no panel covers, at the window's first size of 960x720.
picture=620x720+340+0

shows() { look "$work/now" "${2:-$picture}" && cmp -s "$work/now" "$1"; }
shows_other() { look "$work/now" "${2:-$picture}" && ! cmp -s "$work/now" "$1"; }
# changed_from FILE [GEOMETRY], returned_to FILE [GEOMETRY]: in the end the window shows something else, or this again.
changed_from() { eventually shows_other "$@"; }
returned_to() { eventually shows "$@"; }

# settle FILE [GEOMETRY]: keeps what the window shows once it is a picture and has not changed for a while.
settled() {
  look "$work/earlier" "${2:-$picture}" && has_colours "$work/earlier" 4 && sleep 0.4 &&
    look "$1" "${2:-$picture}" && cmp -s "$work/earlier" "$1"
}
settle() { eventually settled "$@"; }

# click_at X Y: with the left button.
click_at() { xdotool mousemove --window "$window" "$1" "$2" click 1; }
# in_menu Y: picks what stands at that height. The menu takes some frames to come, and a click in these closes it.
in_menu() {
  local below=120x100+160+74
  look "$work/no_menu" $below && click_at 174 57 && changed_from "$work/no_menu" $below && settle "$work/menu" $below &&
    click_at 215 "$1"
}

# is_shown PICTURE FILE: both have the same picture left of the line that the window opens with.
is_shown() { cmp -s <(convert "$1" -crop 230x640+0+0 +repage -depth 8 rgb:-) <(convert "$2" -crop 230x640+0+0 +repage -depth 8 rgb:-); }

colours() { identify -format %k "$1"; }
has_colours() { (($(colours "$1") > $2)); }
# pixels_of FILE RGB FUZZ: how many have this colour, such as 255,115,102, each channel off by so many percent at most.
pixels_of() {
  convert "$1" -fuzz "$3%" -fill black +opaque "rgb($2)" -fill white -opaque "rgb($2)" -format '%[fx:round(mean*w*h)]' info:
}

# Whether the line of the course stands at the panel's lower end, in green: the other labs are checked after the window's own.
shows_course() { look "$work/course" 320x60+8+610 && (($(pixels_of "$work/course" 115,217,128 4) > 1000)); }

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tries the autograder as Gradescope runs it: gradescope.sh BIN FOLDER. A bare Debian root, laid out as Gradescope's
# container, in which root has what Docker leaves it: no mounts and no namespaces. Gradescope's own image is an Ubuntu,
# which is not tried here. Needs root, mmdebstrap and the network; takes minutes.
set -euo pipefail
[[ -n ${TEXEL_TEST_ALL:-} ]] || { echo 'skipped: takes minutes; TEXEL_TEST_ALL=1 runs it'; exit 77; }
bin=$1 work=$2/gradescope root=$2/gradescope/root
export TEXEL_ROOT
TEXEL_ROOT=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
if [[ -z ${TEXEL_BOX_NAMESPACE:-} ]]; then
  ((EUID == 0)) && command -v mmdebstrap >/dev/null || { echo 'skipped: needs root and mmdebstrap'; exit 77; }
  TEXEL_BOX_NAMESPACE=1 exec unshare --mount --propagation private "$0" "$@"
fi
fail() {
  printf 'gradescope.sh: %s\n' "$*" >&2
  exit 1
}

mkdir -p "$work"
printf 'a seed that no student reads\n' >"$work/seed.txt"
"$bin/texel" course gradescope --labs 9 --seed-file "$work/seed.txt" --out "$work/autograder.zip"
if [[ ! -e $root/made ]]; then
  rm -rf --one-file-system "$root"
  mmdebstrap --quiet --variant=apt --include=ca-certificates bookworm "$root"
  touch "$root/made"
fi
mkdir -p "$root"/autograder/{source,submission,results} "$root/proc" "$root/dev"
mount -t proc proc "$root/proc"
mount -t tmpfs -o mode=755 tmpfs "$root/dev"
for device in null zero random urandom; do touch "$root/dev/$device" && mount --bind "/dev/$device" "$root/dev/$device"; done
ln -sfn /proc/self/fd "$root/dev/fd"
mkdir -p -m 1777 "$root/dev/shm"
# Docker's own list. Without CAP_SYS_ADMIN nothing is mounted, and who is in a chroot gets no user namespace.
capabilities=+chown,+dac_override,+fowner,+fsetid,+kill,+setgid,+setuid,+setpcap,+net_bind_service,+net_raw,+sys_chroot,+mknod,+audit_write,+setfcap
inside() {
  setpriv --bounding-set="-all,$capabilities" --inh-caps=-all chroot "$root" /usr/bin/env -i HOME=/root LANG=C.UTF-8 \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} "$@"
}
! inside unshare --user true 2>/dev/null || fail 'the container makes namespaces: this tries nothing'

rm -rf "${root:?}"/autograder/source/*
(cd "$root/autograder/source" && cmake -E tar xf "$work/autograder.zip")
cp "$root/autograder/source/run_autograder" "$root/autograder/run_autograder"
begin=$SECONDS
inside /autograder/source/setup.sh >"$work/setup.log" 2>&1 || fail "setup.sh: $(tail -n 20 "$work/setup.log")"
printf 'setup.sh: %s s\n' $((SECONDS - begin))

# The class's generator makes submissions whose marks are known.
"$TEXEL_ROOT/tests/tools/make_class.py" "$bin" --labs 9 --kinds solution,starter,mutant,threat --limit 2 --out "$work/class" >/dev/null
tried=0
for entry in "$work"/class/*; do
  case ${entry##*/} in solution*1* | starter*1* | mutant* | threat*) ;; *) continue ;; esac
  rm -rf "${root:?}"/autograder/{submission,results}
  mkdir "$root"/autograder/{submission,results}
  # Gradescope unpacks archives.
  [[ ! -d $entry ]] || cp -r "$entry/." "$root/autograder/submission"
  [[ -d $entry ]] || (cd "$root/autograder/submission" && cmake -E tar xf "$entry")
  for inner in "$root"/autograder/submission/*.zip; do
    [[ ! -e $inner ]] || (cd "$root/autograder/submission" && cmake -E tar xf "$inner" && rm "$inner")
  done
  begin=$SECONDS
  inside /autograder/run_autograder >"$work/run.log" 2>&1 || fail "${entry##*/}: $(tail -n 20 "$work/run.log")"
  python3 "$(dirname "$0")/check_gradescope.py" "$root/autograder/results/results.json" "$work/class.json" "${entry##*/}" ||
    fail "${entry##*/}: results.json"
  printf '%s: %s s\n' "${entry##*/}" $((SECONDS - begin))
  tried=$((tried + 1))
done
((tried >= 4)) || fail "only $tried submissions were tried"

# What does not hold is refused: two students, and a course that others can read.
mkdir -p "$root/texel/two"/{a,b}
grade() { inside /autograder/source/course/build/release/bin/texel grade "$@" --out /texel/refused --cache /texel/cache --labs 9 \
  --seed-file /autograder/source/seed.txt --walls user 2>&1; }
! said=$(grade /texel/two) && grep -q 'hold for one student' <<<"$said" || fail "two students: $said"
rm -r "$root/texel/two/b"
chmod 755 "$root/autograder/source"
! said=$(grade /texel/two) && grep -q 'could read the course.*/autograder/source/course/labs' <<<"$said" || fail "open course: $said"
chmod 700 "$root/autograder/source" && chmod 1777 "$root/tmp"
! said=$(grade /texel/two) && grep -q 'leave files in: /tmp' <<<"$said" || fail "open /tmp: $said"
chmod 755 "$root/tmp"
# With namespaces it would not start here at all.
! said=$(inside /autograder/source/course/build/release/bin/texel grade /texel/two --out /texel/refused2 2>&1) &&
  grep -q 'sandbox' <<<"$said" || fail "no namespaces: $said"
echo 'passed'

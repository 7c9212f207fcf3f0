#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Dockerfile without Docker: container.sh BIN FOLDER. Its list of packages is that of ./run, in the course's
# tree and in a student's. With TEXEL_TEST_ALL=1 its COPY and RUN lines are typed on a bare Debian 12, where ./run must then find
# nothing missing; this needs root, mmdebstrap and the network.
set -euo pipefail
course=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
bin=$1 work=$2/container
fail() {
  printf 'container.sh: %s\n' "$*" >&2
  exit 1
}
if [[ -n ${TEXEL_TEST_ALL:-} && -z ${TEXEL_BOX_NAMESPACE:-} ]]; then
  ((EUID == 0)) && command -v mmdebstrap >/dev/null || { echo 'skipped: needs root and mmdebstrap'; exit 77; }
  TEXEL_BOX_NAMESPACE=1 exec unshare --mount --propagation private "$0" "$@"
fi
mkdir -p "$work" && cd "$work" && rm -rf student
"$bin/texel" starter --out student >/dev/null
# ./run installs what its arrays name: the same that `packages` prints. A student's tree needs less.
"$course/run" packages >course.txt
student/run packages >student.txt
for package in g++ cmake libegl1; do grep -qx -- "$package" course.txt && grep -qx -- "$package" student.txt || fail "$package is not printed"; done
grep -qx libarchive-dev course.txt && ! grep -qx libarchive-dev student.txt || fail 'the lists are not those of ./run'
for tree in "$course" student; do
  # No package of the lists is named in the Dockerfile: one list, in ./run.
  for package in $(cat course.txt); do
    ! grep -qE "(^| )$package( |$)" <(grep -v '^#' "$tree/.devcontainer/Dockerfile") || fail "the Dockerfile names $package itself"
  done
  grep -q '\$(./run packages)' "$tree/.devcontainer/Dockerfile" || fail 'the Dockerfile does not take the list of ./run'
  python3 -c 'import json, sys; build = json.load(open(sys.argv[1]))["build"]; assert build["context"] == ".." and build["dockerfile"] == "Dockerfile"' \
    "$tree/.devcontainer/devcontainer.json"
done
[[ -n ${TEXEL_TEST_ALL:-} ]] || { echo passed; exit 0; }

root=$work/root
rm -rf --one-file-system "$root"
mmdebstrap --quiet --variant=apt --include=ca-certificates bookworm "$root"
mount -t proc proc "$root/proc"
mkdir -p "$root/opt/texel" "$root/tree"
# COPY run teach/commands*/run.sh /opt/texel/
copied=$(sed -n 's/^COPY \(.*\) \/opt\/texel\/$/\1/p' "$course/.devcontainer/Dockerfile")
(cd "$course" && cp $copied "$root/opt/texel")
python3 - "$course/.devcontainer/Dockerfile" >"$root/typed" <<'P'
import re, sys
text = re.sub(r"\\\n", "", open(sys.argv[1]).read())
print("set -e")
print("\n".join(line[4:] if line.startswith("RUN ") else "" for line in text.splitlines()))
P
inside() {
  chroot "$root" /usr/bin/env -i HOME=/root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} "$@"
}
inside sh /typed >typed.log 2>&1 || fail "a RUN line fails: $(tail -n 5 typed.log)"
inside id dev >/dev/null || fail 'there is no user dev'
mount --bind -o ro "$course" "$root/tree"
inside bash -c 'cp -r /tree/. /course 2>/dev/null; cd /course && rm -rf build && cmake --preset release' >configure.log 2>&1 ||
  fail "CMake finds not all: $(tail -n 5 configure.log)"
echo passed

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A starter that changes in mid-term, and a student's tree that keeps its steps: update.sh BIN FOLDER
set -euo pipefail
export course bin each
course=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
bin=$1 work=$2/update
rm -rf "$work" && mkdir -p "$work" && cd "$work"
holds() { # path, text
  grep -q "$2" "mine/$1" || { printf '%s does not hold %s\n' "$1" "$2"; return 1; }
}
lacks() { # path, text
  if grep -q "$2" "mine/$1"; then printf '%s holds %s\n' "$1" "$2"; return 1; fi
}
"$bin/texel" starter --out mine >/dev/null
cp -r mine new
step=shaders/05_normal_map/decode_normal.glsl other=shaders/08_reflection/fresnel.glsl
grep -q '  return color;' "mine/$step"
sed -i 's/^  return color;$/  return color * 2.0 - 1.0; \/\/ mine/' "mine/$step"
sed -i '0,/^  \/\/@end/s//  \/\/ mine too\n  \/\/@end/' "mine/$other"
echo '// mine' >>mine/common/core/include/core/error.hpp
echo 'my notes' >mine/notes.txt
# The teacher changes a comment above a step, a handout, another file, and adds one; in the tree and in .starter alike.
for tree in new new/.starter; do sed -i '1s/.*/&\n\/\/ A word of the teacher./' "$tree/$step"; done
for tree in new new/.starter; do sed -i '0,/^  \/\/@end/s//  \/\/ the teacher here\n  \/\/@end/' "$tree/$other"; done
echo 'One more question.' >>new/labs/05_normal_map/README.md
echo '// the teacher' >>new/common/core/include/core/error.hpp
echo '# the teacher' >>new/run
echo new >new/labs/new.txt
status=0
mine/run update new >said || status=$?
[[ $status == 1 ]] # the lines that both changed
grep -q "same lines of $other: yours stays" said
grep -q 'return color \* 2.0 - 1.0; // mine' "mine/$step"
grep -q 'A word of the teacher.' "mine/$step"
cmp "mine/.starter/$step" "new/.starter/$step"
holds "$other" 'mine too'
lacks "$other" '<<<<'
holds "$other.new" 'the teacher here'
grep -q 'One more question.' mine/labs/05_normal_map/README.md
grep -q 'the teacher' mine/common/core/include/core/error.hpp
grep -q '// mine' mine/.before-update/common/core/include/core/error.hpp
cmp mine/run new/run
[[ -x mine/run && -e mine/labs/new.txt && -e mine/notes.txt ]]
# A second time there is nothing to do.
mine/run update new >said
grep -q '0 files are new; 0 of them need your hand' said
status=0
mine/run update "$course" 2>/dev/null || status=$?
[[ $status == 2 ]]

# Git with core.autocrlf leaves what bash and byte by byte readers need.
git -c init.defaultBranch=main init -q origin
cp -r new/. origin
git -C origin -c core.autocrlf=true add . 2>/dev/null
git -C origin -c user.name=t -c user.email=t@t commit -qm t
git -c core.autocrlf=true clone -q origin cloned
diff -r -x .git new cloned

# Small trees: a file with a step, one without, and what the command itself needs.
small() { # folder
  rm -rf "$1"
  mkdir -p "$1/.starter/shaders" "$1/shaders" "$1/labs"
  cp "$course/run" "$1"
  printf '%s\n' one two three four five six seven eight >"$1/shaders/a step.glsl"
  cp "$1/shaders/a step.glsl" "$1/.starter/shaders"
  echo old >"$1/labs/README.md"
}
solve() { # sed script: the student does
  sed -i "$1" "mine/shaders/a step.glsl"
}
teach() { # sed script: the teacher changes the step
  sed -i "$1" "new/shaders/a step.glsl" "new/.starter/shaders/a step.glsl"
}
update() { # status, what is said
  local status=0
  mine/run update new >said 2>&1 || status=$?
  [[ $status == "$1" ]] && grep -q "$2" said || { printf 'exit code %s; expected %s and %s\n' "$status" "$1" "$2"; cat said; return 1; }
}
both() {
  small mine
  small new
}

# Each update keeps what it replaces under a name of its own, and so are what it cannot merge.
both
for i in 1 2 3; do
  echo "mine $i" >>mine/labs/README.md
  echo "new $i" >>new/labs/README.md
  solve "s/^three.*/three mine $i/"
  teach "s/^three.*/three new $i/"
  update 1 '2 files are new; 1 of them need'
  lacks labs/README.md mine
  holds 'shaders/a step.glsl' "three mine $i"
done
for i in 1 2 3; do
  number=${i/#1/}
  holds ".before-update${number:+-$i}/labs/README.md" "mine $i"
  holds "shaders/a step.glsl.new${number:+-$i}" "new $i"
done
# A merge, too, keeps what was there.
both
solve 's/^two/mine/'
teach 's/^seven/new/'
chmod 600 'mine/shaders/a step.glsl'
update 0 '1 files are new; 0 of'
holds 'shaders/a step.glsl' mine
holds 'shaders/a step.glsl' new
lacks '.before-update/shaders/a step.glsl' new
[[ $(stat -c %a 'mine/shaders/a step.glsl') == 600 ]]

# A file that has no step any more becomes the teacher's; what the student wrote there is kept.
both
solve 's/^two/mine/'
rm 'new/.starter/shaders/a step.glsl'
sed -i 's/^two/new/' 'new/shaders/a step.glsl'
update 0 '1 files are new; 0 of'
lacks 'shaders/a step.glsl' mine
holds '.before-update/shaders/a step.glsl' mine
[[ ! -e 'mine/.starter/shaders/a step.glsl' ]]

# The same change by both is none, also beside others.
both
solve 's/^two/alike/; s/^eight/mine/'
teach 's/^two/alike/; s/^five/new/'
update 0 '1 files are new; 0 of'
printf '%s\n' one alike three four new six seven mine | cmp - 'mine/shaders/a step.glsl'
both
solve 's/^two/alike/; s/^eight/mine/'
teach 's/^two/alike/'
update 0 '0 files are new; 0 of'

# Other line endings are no change. What bash reads has its own, and the student's file keeps what it has.
for tree in mine new; do
  both
  find $tree -type f -exec sed -i 's/$/\r/' {} +
  sed -i 's/\r$//' mine/run # else it does not start
  printf '\0\r\n' >mine/labs/binary
  printf '\0\n' >new/labs/binary
  update 0 '1 files are new; 0 of'
  cmp {mine,new}/labs/binary
  solve 's/^two/mine/'
  teach 's/^seven/new/'
  echo '# new' >>new/run
  chmod -x new/run
  update 0 '2 files are new; 0 of'
  cmp mine/run <(sed 's/\r$//' new/run)
  [[ -x mine/run ]]
  holds 'shaders/a step.glsl' '^mine'
  holds 'shaders/a step.glsl' '^new'
  [[ $(grep -c $'\r$' 'mine/shaders/a step.glsl') == $([[ $tree == mine ]] && echo 8 || echo 0) ]]
done

# What stands in a file's place: nothing, a folder, links; and a file where a folder is needed.
both
rm 'mine/shaders/a step.glsl' mine/labs/README.md
mkdir mine/labs/README.md new/labs/deep
echo own >elsewhere
for file in README.md/own.txt deep; do echo own >"mine/labs/$file"; done
for file in deep/new.txt link dangling; do echo new >"new/labs/$file"; done
ln -s ../../elsewhere mine/labs/link
ln -s nowhere/at/all mine/labs/dangling
chmod +x new/labs/link
touch -d 2000-01-01 new/labs/link
touch before
update 0 '5 files are new; 0 of'
diff -r -x '.before-update*' mine new
for file in README.md/own.txt deep link; do holds ".before-update/labs/$file" own; done
# The link stays one, and is newer than what was built before.
[[ -L mine/labs/link && -x elsewhere && elsewhere -nt before ]]
# A step that the newer starter no longer has: its file is merged no more.
rm 'new/.starter/shaders/a step.glsl'
update 0 '0 files are new'
[[ ! -e 'mine/.starter/shaders/a step.glsl' ]]
# The student's tree in the newer starter's folder is not taken for a part of it.
both
mv mine new/
echo new >new/labs/new.txt
new/mine/run update new >said
[[ -e new/mine/labs/new.txt && ! -e new/mine/mine ]]

# Two changes that stay apart, a new file, and one that is replaced.
changed() {
  both
  solve 's/^two/mine/'
  teach 's/^seven/new/'
  echo '// mine' >>mine/labs/README.md
  head -c 20000 /dev/zero >new/labs/new.bin
  echo '# new' >>new/run
}
whole() { # where
  diff -r -x '.before-update*' expected mine || { echo "not whole: $1"; return 1; }
  grep -rq '// mine' mine/.before-update*/labs && [[ ! -e mine/.before-update.part ]] || { echo "not kept: $1"; return 1; }
}
changed
update 0 '4 files are new; 0 of'
cp -r mine expected

# Cut off at any call of a program, the next update ends it. Ctrl-C changes nothing, or comes too late to. Each third call, and with
# ./run test --all and on a build server each.
each=3
[[ -z ${CI:-}${TEXEL_TEST_ALL:-} ]] || each=1
mkdir bin
cat >bin/shim <<'T'
#!/bin/bash
echo >>"$CALLS"
if (($(wc -l <"$CALLS") == AT)); then kill -"$SIGNAL" $PPID $$; fi
PATH=${PATH#*:} exec "${0##*/}" "$@"
T
chmod +x bin/shim
for program in cp diff3 ln mv; do ln -s shim "bin/$program"; done
for SIGNAL in KILL INT; do
  for ((AT = 1; ; AT += each)); do
    changed
    rm -rf untouched
    cp -r mine untouched
    : >calls
    status=0
    CALLS=$PWD/calls AT=$AT SIGNAL=$SIGNAL PATH=$PWD/bin:$PATH bash -c 'mine/run update new; exit' >said 2>&1 || status=$?
    (($(wc -l <calls) >= AT)) || break
    ((status)) || [[ $SIGNAL == INT ]]
    if ((status)) && [[ $SIGNAL == INT ]]; then diff -r mine untouched; fi
    update 0 'files are new; 0 of'
    whole "$SIGNAL at call $AT"
  done
  ((AT > 15))
done

# On a disk with little room nothing changes, or all.
little_room() {
  for ((room = 0, status = 3; status; room += 4096 * each)); do
    umount disk 2>/dev/null || true
    mount -t tmpfs -o size=4m tmpfs disk
    changed
    cp -r mine disk
    rm -rf untouched
    mv mine untouched
    ln -s disk/mine mine
    head -c "$(($(df -B1 --output=avail disk | tail -n 1) - room))" /dev/zero >disk/filler
    status=0
    mine/run update new >said 2>&1 || status=$?
    if ((status)); then
      [[ $status == 3 ]]
      diff -r mine/ untouched
      grep -q 'as before' said
    fi
    rm disk/filler
    update 0 'files are new; 0 of'
    whole "$room bytes of room"
  done
  ((room > 20000))
  # What a teacher wrote before stays, too.
  mkdir -p disk/.github/workflows
  for file in run autograder.zip .github/workflows/check.yml; do echo before >"disk/$file"; done
  echo 12345678 >seed.txt
  head -c 4M /dev/zero >disk/filler 2>/dev/null || true
  for command in "classroom --labs 1 disk" "gradescope --labs 1 --seed-file seed.txt --out disk/autograder.zip"; do
    status=0
    # shellcheck disable=SC2086 # words
    "$course/teach/commands/scripts/"$command >said 2>&1 || status=$?
    ((status))
  done
  for file in autograder.zip .github/workflows/check.yml; do echo before | cmp - "disk/$file"; done
  # There is a whole starter or none.
  rm -f disk/filler
  status=0
  "$bin/texel" starter --out disk/half >said 2>&1 || status=$?
  [[ $status == 3 && -z $(find disk -name 'half*') ]]
  [[ -z $(find disk -name '*.part') ]]
}
# A workflow that a teacher edited stays beside the new one, and is kept once.
mkdir -p taught/.github/workflows
touch taught/run
echo mine >taught/.github/workflows/check.yml
for _ in 1 2; do "$course/teach/commands/scripts/classroom" --labs 1 taught >/dev/null; done
[[ $(cat taught/.github/workflows/check.yml.before) == mine && $(ls taught/.github/workflows) == $'check.yml\ncheck.yml.before' ]]

if ((EUID != 0)) || ! unshare -m true 2>/dev/null; then
  echo 'passed, but for a full disk: only root may mount one'
  exit
fi
mkdir disk
unshare -m bash -euc "$(declare -f small both solve teach update changed whole little_room); little_room"
echo passed

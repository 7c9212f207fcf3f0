#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A starter that changes in mid-term, and a student's tree that keeps its steps: update.sh BIN FOLDER
set -euo pipefail
course=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
bin=$1 work=$2/update
rm -rf "$work" && mkdir -p "$work" && cd "$work"
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
grep -q 'mine too' "mine/$other" && ! grep -q '<<<<' "mine/$other" && grep -q 'the teacher here' "mine/$other.new"
grep -q 'One more question.' mine/labs/05_normal_map/README.md
grep -q 'the teacher' mine/common/core/include/core/error.hpp
grep -q '// mine' mine/.before-update/common/core/include/core/error.hpp
cmp mine/run new/run && [[ -x mine/run && -e mine/labs/new.txt && -e mine/notes.txt ]]
# A second time there is nothing to do.
mine/run update new >said
grep -q '0 files are new; 0 of them need your hand' said
status=0
mine/run update "$course" 2>/dev/null || status=$?
[[ $status == 2 ]]
echo passed

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A copied submission comes first, whatever its names and form are: similar.sh BIN FOLDER
set -euo pipefail
bin=$1 work=$2/similar
course=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
command -v sim_c >/dev/null || { echo 'skipped: there is no sim_c'; exit 77; }
rm -rf "$work" && mkdir -p "$work/class" && cd "$work"
"$course/tests/tools/make_class.py" "$bin" --labs 5 --kinds solution,starter --out "$work/class" >/dev/null
# A wrong answer of one student, and the same with other names, comments and spaces of another.
file=shaders/05_normal_map/tangent_frame.glsl
for student in first second; do
  mkdir -p "class/$student/${file%/*}"
done
write() { # student, a name, a comment
  cat >"class/$1/$file" <<X
//@step 5.6 begin
  vec3 $2 = vec3(0.0); $3
  for (int i = 0; i < 7; ++i) $2 += cross(vec3(float(i) * 0.25, 1.0, 0.0), dFdx(texcoord.sst)) * float(i + 3);
  if (length($2) < 1e-3) $2 = texcoord.x > 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  mat3 frame_$2 = mat3($2, cross($2, vec3(0.0, 0.0, 1.0)), vec3(0.0, 0.0, 1.0));
  return transpose(frame_$2) * inverse(frame_$2);
//@end
X
}
write first tangent '// by me'
write second t ''
# The grader takes a file that lies alone in an archive, and one whose markers are spoilt, too.
mkdir -p third "class/fourth/${file%/*}"
sed 's/$/\r/' "class/first/$file" >"third/${file##*/}"
(cd third && cmake -E tar czf ../class/third.tgz "${file##*/}")
sed 's/^.*@end/  \/\/end/' "class/first/$file" >"class/fourth/$file"
(cd class/second && cmake -E tar cf ../second.zip --format=zip shaders) && rm -r class/second
ln -s /etc/passwd class/link.zip
printf 'no archive' >class/broken.zip
"$bin/texel" course similar class --labs 5 --top 7 2>errors | tee said
for pair in 'first  fourth' 'first  second.zip' 'first  third.tgz' 'second.zip  third.tgz'; do
  sed -n 2,7p said | grep -q "100 %.*$pair" # before the solutions, which are alike too
done
grep -q '11 submissions' said
grep -q 'link.zip: not compared: is a symbolic link' errors
grep -q 'broken.zip: not compared: is a broken archive' errors
grep -q "fourth: $file: its new lines are compared" errors
! grep -q starter said
status=0
"$bin/texel" course similar nowhere --labs 5 2>/dev/null || status=$?
[[ $status == 2 ]]
echo passed

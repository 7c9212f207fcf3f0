#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Roster, due dates, the late policy and Canvas's files: gradebook.sh BIN FOLDER
set -euo pipefail
bin=$1 work=$2/gradebook
rm -rf "$work" && mkdir -p "$work" && cd "$work"

fail() {
  printf 'gradebook.sh: %s\n' "$*"
  exit 1
}
gradebook() { # exit code, arguments
  local status=0
  "$bin/texel" course gradebook "${@:2}" --out book.csv >said 2>errors || status=$?
  [[ $status == "$1" ]] || fail "${*:2}: exit code $status, not $1: $(cat errors said)"
  [[ ! -e book.csv ]] || tr -d '\r' <book.csv >book
}
cells() { # which: of the first student
  sed -n 2p book | cut -d, -f"$1"
}
same() { # what was tried
  diff expected.csv book || fail "$1"
}

cat >lab1.csv <<'X'
name,id,number,total,lab 1,step 1.1,note
janedoe,janedoe-11,11,9,9,1,
"O'Neil, Bob",oneil-12,12,8,8,1,
stranger,stranger-99,99,4,4,1,
broken,broken-13,13,,,,not graded: the disk is full
X
cat >lab5.csv <<'X'
name,id,number,total,lab 5,step 5.1,note
janedoe,janedoe-11,11,12,12,1,
"O'Neil, Bob",oneil-12,12,10,10,1,5.1 is right
X
printf 'Student,ID,SIS User ID,Section\n"Doe, Jane",11,s1001,A\n"O'\''Neil, Bob",12,s1002,A\n"Ill, Never",14,s1003,B\n=Broken,13,s1004,B\n' >roster.csv
printf 'lab,due\n1,2026-11-10T23:59+01:00\n5,2026-11-20T23:59+01:00\n' >due.csv
printf 'number,lab,submitted\n11,1,2026-11-10T22:59Z\n11,5,2026-11-21T23:58+01:00\n12,5,2026-11-30T12:00+01:00\n12,1,2026-11-11T00:10+01:00\n' >times.csv
gradebook 1 lab1.csv lab5.csv --roster roster.csv --due due.csv --times times.csv --late 10 --most 50 --grace 15
grep -q '1 of them not in the roster: 99' said
grep -q '99: lab 1: no time of submission' errors
cat >expected.csv <<'X'
Student,ID,SIS User ID,SIS Login ID,Section,lab 1,lab 5,total,number,note
"Doe, Jane",11,s1001,,A,9,10.8,19.8,11,"lab 5: 1 day late, -10 %"
"O'Neil, Bob",12,s1002,,A,8,5,13,12,"5.1 is right; lab 5: 10 days late, -50 %"
"Ill, Never",14,s1003,,B,0,0,0,14,nothing was handed in
'=Broken,13,s1004,,B,,0,,13,not graded: the disk is full; lab 5: nothing was handed in
stranger,99,,,,4,0,4,99,"lab 1: no time of submission, so not late; lab 5: nothing was handed in"
X
same 'two labs'

# One student with two entries, of the columns total, lab 1, lab 5, begun, note: in one file, and in two the other way round.
printf 'number,sis,name\n11,s1,Jane\n' >one.csv
head='name,id,number,total,lab 1,lab 5,begun,note'
while read -r code points first second; do
  printf "$head"'\njane,jane-11-a,11,%s\njane,jane-11-b,11,%s\n' "$first" "$second" >class.csv
  gradebook "$code" class.csv --roster one.csv
  [[ $(cells 6-7) == "$points" ]] || fail "$first and $second give $(cells 6-7)"
  printf "$head"'\njane,jane-11,11,%s\n' "$first" >first.csv
  printf "$head"'\njane,jane-11,11,%s\n' "$second" >second.csv
  gradebook "$code" second.csv first.csv --roster one.csv
  [[ $(cells 6-7) == "$points" ]] || fail "$second and $first give $(cells 6-7)"
done <<'X'
0 9,0 9,9,0,1, 0,0,0,,broken
0 9,12 9,9,0,1, 12,0,12,5,
0 9,3 12,9,3,1_5, 12,9,3,1_5,
0 0,0 0,0,0,,broken 0,0,0,,broken
1 ,3 12,9,3,1_5, 7,4,3,1_5,
1 ,0 9,9,0,1, 0,0,0,1,
1 , ,,,,unjudged 9,9,0,1,
X
grep -q '11: lab 1: entries differ: jane-11 in second.csv has 9, jane-11 in first.csv has no mark' errors
# Without a number, a folder and an archive of one name; and a file of an older grader.
printf 'name,id,number,total,lab 1,note\njane,jane-5e6f7a8b,,9,9,\njane,jane-1a2b3c4d,,0,0,is broken\n' >class.csv
printf 'id,sis,name\njane,s1,Jane\n' >ids.csv
gradebook 0 class.csv --roster ids.csv
[[ $(cells 6) == 9 ]]

# The points that are left of 10, with 10 % for each day by the calendar.
printf 'name,id,number,total,lab 5,note\njane,jane-11,11,10,10,\n' >class.csv
while IFS='|' read -r points lab due submitted options; do
  printf 'lab,due\n%s,%s\n' "$lab" "$due" >due.csv
  printf 'number,lab,submitted\n%b\n' "$submitted" >times.csv
  # shellcheck disable=SC2086
  gradebook 0 class.csv --roster one.csv --due due.csv --times times.csv --late 10 $options
  [[ $(cells 6) == "$points" ]] || fail "due $lab $due, handed in $submitted: $(cells 6), not $points"
done <<'X'
9|lab 5|2026-11-20T23:59+01:00|11,5,2026-11-21T00:30+01:00|
9|L5|2026-11-20T23:59+01:00|11,05,2026-11-21T00:30+01:00|
9|05|2026-11-20T23:59+01:00|11,Lab 05,2026-11-21T00:30+01:00|
9|5|2026-11-20T23:59+01:00|11,,2026-11-21T00:30+01:00|
7|5|2026-11-20T23:59+01:00|11,5,2026-11-23T00:30+01:00\n11,L5,2026-11-19T12:00+01:00|
10|5|2026-10-24T23:59+02:00|11,5,2026-10-24T23:59+02:00|
9|5|2026-10-24T23:59+02:00|11,5,2026-10-25T23:59+01:00|
8|5|2026-10-24T23:59+02:00|11,5,2026-10-26T00:00+01:00|
9|5|2026-10-24T23:59+02:00|11,5,2026-10-25T22:59Z|--zone Europe/Berlin
8|5|2026-10-24T21:59Z|11,5,2026-10-25T23:00Z|--zone Europe/Berlin
9|5|2026-10-24 23:59|11,5,2026-10-25 23:59|--zone Europe/Berlin
9|5|2026-03-28T23:59+01:00|11,5,2026-03-29T23:59+02:00|
8|5|2026-03-28T23:59+01:00|11,5,2026-03-30T00:00+02:00|
9|5|2026-10-25T02:30+02:00|11,5,2026-10-25T02:10+01:00|--zone Europe/Berlin
9|5|2026-11-20T23:59+01:00|11,5,2026-11-22T00:05+01:00|--grace 15
9|5|2026-11-20T22:59Z|11,5,2026-11-21T23:59+01:00|
9|5|2026-11-20T23:59+01:00|11,5,2026-11-22T00:30+09:00|
X
printf 'lab,due\n5,2026-11-20T23:59+01:00\n' >due.csv
printf 'number,lab,submitted\n11,5,2026-11-20T12:00Z\n77,5,2026-11-20T12:00Z\n' >times.csv
gradebook 1 class.csv --roster one.csv --due due.csv --times times.csv --late 10
grep -q '77 is neither in the class nor in the roster' errors
sed -i 3d times.csv
printf 'lab,due\n1,2026-11-20T23:59+01:00\n' >other.csv
gradebook 0 class.csv --roster one.csv --due other.csv --times times.csv --late 10
grep -q 'nobody is late with what has no due date there: lab 5' errors

# What is not understood is refused, with its place.
while IFS='|' read -r file text wanted options; do
  for each in due times class one; do cp $each.csv bad_$each.csv; done
  [[ -z $file ]] || printf '%b' "$text" >"bad_$file.csv"
  # shellcheck disable=SC2086
  gradebook 2 bad_class.csv --roster bad_one.csv --due bad_due.csv --times bad_times.csv --late 10 $options
  grep -q -- "$wanted" errors || fail "$text $options: $(<errors)"
done <<'X'
due|lab,due\n1,tomorrow\n|bad_due.csv:2: 'tomorrow' is no time
due|lab,due\n1,2026-11-20T23:59\n|bad_due.csv:2: '2026-11-20T23:59' has no time zone
due|lab,due\nfive,2026-11-20T23:59Z\n|bad_due.csv:2: 'five' is no lab
due|lab,due\n10,2026-11-20T23:59Z\n|bad_due.csv:2: '10' is no lab
due|lab,due\n5,2026-11-20T23:59Z\n05,2026-11-21T23:59Z\n|bad_due.csv:3: lab 5 has another due date
times|number,lab,submitted\n11,55,2026-11-20T23:59Z\n|bad_times.csv:2: '55' is no lab
times|number,lab,submitted\n,5,2026-11-20T23:59Z\n|bad_times.csv:2: there is no number
class|id,number,lab 5\njane-11,11,many\n|bad_class.csv:2: 'many' is no number of points
class|id,number,lab 5\njane-11,11,nan\n|bad_class.csv:2: 'nan' is no number of points
class|id,number,lab 5\njane-11,11,-3\n|bad_class.csv:2: '-3' is no number of points
one|number,lab,submitted\n|no column 'sis or SIS User ID'
one|sis,name\ns1,Jane\n|no column 'number or ID'
one|PK\0003\0004|is a workbook
||'-10' is no number from 0|--late -10
||'nan' is no number from 0|--late nan
||'inf' is no number from 0|--late inf
||'150' is no number from 0 to 100|--most 150
||'-1' is no number from 0|--grace -1
||no time zone 'Berlin'|--zone Berlin
X

# Canvas's gradebook as it is exported gives the file that Canvas imports, and that file is a roster again.
printf 'name,id,number,total,lab 5,note\njane,jane-11,11,10,10,\ntest,test-98,98,7,7,\n' >class.csv
cat >canvas.csv <<'X'
Student,ID,SIS User ID,SIS Login ID,Section,Lab 5 (4711),Current Score,Final Score
,,,,,Manual Posting,,
"    Points Possible",,,,,15,(read only),(read only)
"Müller, Jane",11,s1,jmueller,A and B,,,
"Blank, Ben",12,,,A,,,
"Student, Test",98,,,A,,,
"Student, Test",,,,A,,,
X
cat >expected.csv <<'X'
Student,ID,SIS User ID,SIS Login ID,Section,lab 5,total,number,note
"Müller, Jane",11,s1,jmueller,A and B,10,10,11,
"Blank, Ben",12,,,A,0,0,12,nothing was handed in
X
gradebook 0 class.csv --roster canvas.csv
same 'an export of Canvas'
cp book.csv import.csv
sed -i 3d class.csv # the test student
gradebook 0 class.csv --roster import.csv
same 'its import'

# The same from other programs.
sed 's/, /@/g; s/"//g; s/,/ ; /g; s/@/, /g; s/^Student/ student /; s/^ *Points/Points/' canvas.csv >semicolons.csv
(printf '\xef\xbb\xbf' && cat canvas.csv) >mark.csv
(printf 'sep=;\r\n' && cat semicolons.csv) >excel.csv
sed 's/, /@/g; s/"//g; s/,/\t/g; s/@/, /g' canvas.csv >tabs.csv
sed -e '1s/Student/LastName,FirstName/; 2s/^/,/; 3s/,/,,/; s/^"\([^,"]*\), \([^"]*\)"/\1,\2/' canvas.csv >names.csv
iconv -f UTF-8 -t LATIN1 canvas.csv >latin.csv
for kind in UTF-16 UTF-16LE UTF-16BE; do iconv -f UTF-8 -t $kind canvas.csv >$kind.csv; done
for file in semicolons mark excel tabs names latin UTF-16 UTF-16LE UTF-16BE; do
  gradebook 0 class.csv --roster $file.csv
  same "$file.csv"
  [[ $file != latin ]] || grep -q 'latin.csv: is not UTF-8; read as Latin-1' errors
done
printf 'Student,ID,SIS Login ID,Section\n"Doe, Jane",,jane,A\n"Roe, Ann",11,ann,A\n' >canvas.csv
gradebook 1 class.csv --roster canvas.csv
grep -q 'Doe, Jane: the roster has no number for this name' errors
[[ $(sed -n 2p book) == '"Doe, Jane",,,jane,A,,,,the roster has no number for this name' ]]
echo passed

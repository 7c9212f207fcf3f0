#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Roster, due dates and the late policy: gradebook.sh BIN FOLDER
set -euo pipefail
bin=$1 work=$2/gradebook
rm -rf "$work" && mkdir -p "$work" && cd "$work"
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
status=0
"$bin/texel" course gradebook lab1.csv lab5.csv --roster roster.csv --due due.csv --times times.csv --late 10 --most 50 \
  --grace 15 --out book.csv >said || status=$?
[[ $status == 1 ]]
grep -q '1 of them not in the roster: 99' said
cat >expected.csv <<'X'
SIS User ID,Student,number,lab 1,lab 5,total,note
s1001,"Doe, Jane",11,9,10.8,19.8,"lab 5: 1 day late, -10 %"
s1002,"O'Neil, Bob",12,8,5,13,"5.1 is right; lab 5: 10 days late, -50 %"
s1003,"Ill, Never",14,0,0,0,nothing was handed in
s1004,'=Broken,13,,0,,not graded: the disk is full; lab 5: nothing was handed in
,stranger,99,4,0,4,lab 5: nothing was handed in
X
tr -d '\r' <book.csv | diff expected.csv -
status=0
printf 'lab,due\n1,tomorrow\n' >due.csv
"$bin/texel" course gradebook lab1.csv --roster roster.csv --due due.csv --times times.csv --late 10 --out x.csv 2>said || status=$?
[[ $status == 2 ]] && grep -q "due.csv: 'tomorrow' is no time" said
"$bin/texel" course gradebook lab1.csv --roster times.csv --out x.csv 2>said || status=$?
[[ $status == 2 ]] && grep -q "no column 'sis or SIS User ID'" said
echo passed

#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The guide's script on a real slurmctld and slurmd of this machine: an array of three, of which one task is killed and
# requeued; merged, it is equal to one run. slurm.sh BIN FOLDER. Needs root and the packages slurmctld, slurmd, munge.
set -euo pipefail
[[ -n ${TEXEL_TEST_ALL:-} ]] || { echo 'skipped: takes minutes; TEXEL_TEST_ALL=1 runs it'; exit 77; }
bin=$1 work=$2/slurm
course=$(readlink -f "$(dirname "${BASH_SOURCE[0]}")/../..")
for program in slurmctld slurmd munged sbatch; do
  ((EUID == 0)) && command -v $program >/dev/null || { echo "skipped: needs root and $program"; exit 77; }
done
rm -rf "$work" && mkdir -p "$work"/{ctld,d,run} && cd "$work"
fail() {
  printf 'slurm.sh: %s\n' "$*" >&2
  tail -n 20 "$work"/*.log >&2 || true
  exit 1
}
host=$(hostname -s)
# In folders and on ports of our own, beside whatever this machine runs.
head -c 1024 /dev/urandom >munge.key && chown munge munge.key && chmod 400 munge.key
sockets=$(mktemp -d) && chmod 711 "$sockets" && chown munge "$sockets"
cat >slurm.conf <<X
ClusterName=texel
SlurmctldHost=$host(127.0.0.1)
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$sockets/munge
SlurmUser=root
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation=$work/ctld
SlurmdSpoolDir=$work/d
SlurmctldPidFile=$work/run/slurmctld.pid
SlurmdPidFile=$work/run/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
JobRequeue=1
KillWait=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES State=UP
X
export SLURM_CONF=$work/slurm.conf
processes=()
stop() {
  for process in "${processes[@]}"; do kill "$process" 2>/dev/null || true; done
  wait || true
  rm -rf "$sockets"
}
trap stop EXIT
setpriv --reuid munge --regid munge --clear-groups munged --foreground --force --key-file="$work/munge.key" \
  --socket="$sockets/munge" --pid-file="$sockets/pid" --log-file="$sockets/log" --seed-file="$sockets/seed" &>munge.out.log &
processes+=($!)
for _ in {1..50}; do [[ -S $sockets/munge ]] && break || sleep 0.1; done
slurmctld -D -i &>ctld.out.log &
processes+=($!)
slurmd -D &>d.out.log &
processes+=($!)
for _ in {1..100}; do sinfo -h -o %T 2>/dev/null | grep -q idle && break || sleep 0.3; done
sinfo -h -o %T | grep -q idle || fail "the node does not come up: $(sinfo 2>&1)"

"$course/tests/tools/make_class.py" "$bin" --labs 9 --kinds solution,starter,prefix,mutant --limit 1 --out class >/dev/null
printf 'a seed of the course\n' >seed.txt
export TEXEL=$bin/texel TEXEL_CACHE=${3:-$work/cache}
grade() { "$TEXEL" grade class --labs 9 --seed-file seed.txt --cache "$TEXEL_CACHE" "$@"; }
grade --out one --format csv >one.log 2>&1 || fail "one run: $(tail -n 5 one.log)"

job=$(sbatch --parsable --array=1-3 --cpus-per-task=1 --output="$work/task%a.log" --open-mode=append \
  "$course/teach/commands/scripts/slurm.sh" "$work/class" "$work" 9 "$work/seed.txt")
# The first task is killed as soon as it has judged something. Slurm starts it again after two minutes.
for _ in {1..600}; do [[ -n $(find part1/pictures -type f 2>/dev/null | head -n 1) ]] && break || sleep 0.1; done
scontrol requeue "${job}_1" || fail 'the first task was too fast to be requeued'
for _ in {1..1200}; do [[ -z $(squeue -h -j "$job" 2>/dev/null) ]] && break || sleep 0.5; done
[[ -z $(squeue -h -j "$job") ]] || fail "the job does not end: $(squeue)"
grep -q 'JOB REQUEUE' task1.log || fail 'the first task was not killed'
"$TEXEL" grade merge part1 part2 part3 --out merged --format csv >merge.log 2>&1 || fail "merge: $(tail -n 3 merge.log)"
cmp one/class.csv merged/class.csv || fail 'the merged class is another than that of one run'
grep -c graded task?.log
echo passed

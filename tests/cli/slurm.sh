#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# slurm.sh ODEUM ROOT FOLDER: a sweep through a real Slurm (scripts/slurm-here), whose tasks are cancelled, killed,
# requeued and lose their node, whose disk is full, and whose program changes, is submitted again and merges to the bytes
# of one run. Exit code 77: Slurm cannot run here. scripts/slurm-campaign is the long one.
set -eu
odeum=$1 root=$2 folder=$3
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
"$root/scripts/slurm-here" start "$folder/slurm" || exit $?
trap '"$root/scripts/slurm-here" stop "$folder/slurm"; umount "$folder/small" 2> /dev/null || true' EXIT
. "$folder/slurm/environment"

fail() { echo "$*" >&2; exit 1; }
# Until no job is in the queue.
settle() {
  tries=0
  while [ -n "$(squeue -h -o %i)" ]; do
    tries=$((tries + 1))
    [ $tries -lt 600 ] || fail "jobs are still in the queue: $(squeue -a)"
    # A task that is requeued waits for two minutes unless it is told to begin.
    for task in $(squeue -h -r -t PD -o '%i %r' | sed -n 's/ BeginTime$//p'); do
      scontrol update JobId="$task" StartTime=now || true
    done
    sleep 0.2
  done
}

cat > oscillator.yaml <<'TEXT'
parameters: {w: 1, d: 0.1}
states: {x: 1, v: 0}
equations: {x: v, v: -w^2*x - d*v}
time: {end: 20}
TEXT
words="sweep oscillator.yaml --over w=1..3:100 --over d=0..1:100 --solver dormand_prince54 --tol 1e-8 --check 0"
"$odeum" $words --out one > one.txt 2> one.err
"$odeum" plan $words --shards 12 --out run
grep -q '^submit "0-' run/submit.sh && fail "the whole array was written into the script"

sh run/submit.sh || fail "sbatch refused"
# A task that is cancelled, one that is killed, and a node that goes away while others run.
job=$(squeue -h -o %A | sort -u | head -n 1)
scancel "${job}_11" || true
tries=0
until pkill -9 -f "shard $folder/run" || [ $tries -gt 100 ]; do tries=$((tries + 1)); sleep 0.05; done
task=$(squeue -h -r -t R -o %i | tail -n 1)
[ -z "$task" ] || scontrol requeue "$task" || true
"$root/scripts/slurm-here" node n2 stop "$folder/slurm"
sleep 1
"$root/scripts/slurm-here" node n2 start "$folder/slurm"
scontrol update NodeName=n2 State=RESUME 2> /dev/null || true
settle

"$odeum" status run > status.txt || true
if "$odeum" merge run --out merged --resubmit > missing.txt 2>&1; then
  fail "nothing was missing, though a task was cancelled"
fi
grep -q "missing shard 11: " missing.txt || fail "shard 11 is not named: $(cat missing.txt)"
sh run/resubmit.sh || fail "sbatch refused"
settle
"$odeum" merge run --out merged > merged.txt 2> merged.err || fail "$(cat merged.txt merged.err)"
cmp one/members.csv merged/members.csv || fail "the bytes differ"

# A damaged shard is named, and made again where it is run again.
results=$(ls run/shards/3/results/* | head -n 1)
printf 'x' | dd of="$results" bs=1 seek=200 conv=notrunc 2> /dev/null
"$odeum" merge run --out merged > missing.txt 2>&1 && fail "a damaged shard was merged"
grep -q "missing shard 3: .* is damaged" missing.txt || fail "$(cat missing.txt)"
"$odeum" shard run 3 2> /dev/null
"$odeum" merge run --out merged > /dev/null 2>&1
cmp one/members.csv merged/members.csv

# A program that changes in the middle: no shard of another one is made or merged.
cp "$odeum" changing
./changing plan $words --shards 3 --out changed
./changing shard changed 0
printf x >> changing
sh changed/submit.sh
settle
[ "$(grep -l "another build of odeum" changed/logs/*.log | wc -l)" = 3 ] || fail "a changed program ran"
./changing merge changed > changed.txt 2>&1 && fail "a changed program merged"
grep -q "another build of odeum" changed.txt || fail "$(cat changed.txt)"
cp "$odeum" changing
sh changed/submit.sh
settle
./changing merge changed > changed.txt 2>&1 || fail "$(cat changed.txt)"
cmp one/members.csv changed/out/members.csv

# A disk that is full: shards fail, and once there is space they go on.
mkdir small
if mount -t tmpfs -o size=500k none small 2> /dev/null; then
  "$odeum" plan $words --shards 3 --out small/run
  sh small/run/submit.sh
  settle
  "$odeum" merge small/run --out small/merged --resubmit > full.txt 2>&1 && fail "a full disk was not noticed"
  grep -q "missing shard" full.txt || fail "$(cat full.txt)"
  mount -o remount,size=64m small
  "$odeum" merge small/run --out small/merged --resubmit > full.txt 2>&1 && fail "nothing was missing"
  sh small/run/resubmit.sh
  settle
  "$odeum" merge small/run --out small/merged > full.txt 2>&1 || fail "$(cat full.txt)"
  cmp one/members.csv small/merged/members.csv
else
  echo "a full disk is not tested: no file system can be mounted"
fi

# Arrays as long as the site allows: offsets reach the rest.
most=$(scontrol show config | sed -n 's/^MaxArraySize *= *\([0-9]*\).*/\1/p')
[ "$most" = 1001 ] || fail "MaxArraySize is $most"
echo "12 shards through Slurm, merged to the bytes of one run"

#!/usr/bin/env bash
# Slurm on this machine runs a suite of 200 cases as an array of 8 jobs; their merged results are those of one process.
# usage: slurm_test.sh SOURCE SYMPLANT CC INCLUDE
set -euo pipefail
source=$1 symplant=$2 cc=$3 include=$4
export PATH=$PATH:/usr/sbin:/sbin
for needed in munged slurmctld slurmd sbatch; do
  command -v "$needed" >/dev/null || { echo "$needed is not installed: skipped"; exit 77; }
done

work=$(mktemp -d /tmp/slurm.XXXXXX) # short: paths of sockets have at most 107 bytes
daemons=()
end() {
  local code=$?
  ((${#daemons[@]} == 0)) || kill "${daemons[@]}" 2>/dev/null || true
  wait
  if ((code != 0)); then tail -n 20 "$work"/*.log; fi
  rm -rf "$work"
}
trap end EXIT

free_port() {
  local port
  for ((port = 20000 + RANDOM % 10000; ; ++port)); do
    (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || break
  done
  echo "$port"
}

# A cluster of this machine, which uses no file of the system.
start_cluster() {
  local user host
  user=$(id -un) host=$(hostname -s)
  chmod 755 "$work"
  dd if=/dev/urandom of="$work/key" bs=128 count=1 status=none
  chmod 400 "$work/key"
  munged --force --foreground --socket="$work/munge" --key-file="$work/key" --pid-file="$work/munged.pid" \
    --seed-file="$work/seed" >"$work/munged.log" 2>&1 &
  daemons+=($!)
  mkdir "$work/state" "$work/spool"
  export SLURM_CONF=$work/slurm.conf
  cat >"$SLURM_CONF" <<TEXT
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$work/munge
CredType=cred/munge
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
TEXT
  slurmctld -D >"$work/slurmctld.out.log" 2>&1 &
  daemons+=($!)
  slurmd -D >"$work/slurmd.out.log" 2>&1 &
  daemons+=($!)
  for ((i = 0; i < 60; ++i)); do
    [[ $(sinfo --noheader --format=%t 2>/dev/null) != idle ]] || return 0
    sleep 1
  done
  echo "Slurm does not start"
  return 1
}

# 200 cases with a cold start of the program, each at another time. Some end before the late program shows.
make_suite() {
  mkdir "$work/suite"
  printf '{ "symplant-suite": 1, "plant": "%s", "align": "follow" }\n' "$source/examples/excell/excell.csv" >"$work/suite/suite.json"
  for ((i = 1; i <= 200; ++i)); do
    printf '{ "symplant-scenario": 1, "steps": [ { "at": "%s ms", "restart": true }, { "at": "30s" } ] }\n' $((i * 100)) \
      >"$work/suite/$(printf 'restart-%03d.json' "$i")"
  done
  "$cc" -std=c99 -O1 -shared -fPIC -I"$include" "$source/examples/excell/program/cell.c" -o "$work/cell.so"
  "$cc" -std=c99 -O1 -shared -fPIC -I"$include" -DWORK_MS=310 "$source/examples/excell/program/cell.c" -o "$work/late.so"
  "$symplant" test "$work/suite" --program "$work/cell.so" --update >/dev/null
  rm "$work"/suite/*7.reference.jsonl
}

results() { # FILE: the report without the times that the cases took
  sed -E 's/ time="[^"]*"//g' "$1"
}

make_suite
start_cluster
"$symplant" test "$work/suite" --program "$work/late.so" --junit "$work/one.xml" >"$work/one.txt" || (($? == 1))
cat >"$work/job.sh" <<TEXT
#!/bin/sh
#SBATCH --array=1-8
#SBATCH --output=$work/job-%a.log
"$symplant" test "$work/suite" --program "$work/late.so" --jobs 1 --shard "\$SLURM_ARRAY_TASK_ID/8" -o "$work/part\$SLURM_ARRAY_TASK_ID.jsonl" || test \$? -eq 1
TEXT
sbatch --wait "$work/job.sh"
"$symplant" test --merge "$work"/part?.jsonl --junit "$work/merged.xml" >"$work/merged.txt" || (($? == 1))
tail -n 1 "$work/merged.txt"
diff <(tail -n 1 "$work/one.txt") <(tail -n 1 "$work/merged.txt")
diff <(results "$work/one.xml") <(results "$work/merged.xml")
[[ $(tail -n 1 "$work/merged.txt") == "200 cases: 41 passed, 159 failed; 20 without a reference trace" ]]

#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a command beside a Slurm cluster of one node, this machine, that it starts before and stops after.
# Usage: slurm_node.sh FOLDER COMMAND...   (FOLDER gets keys, logs and state)
# Exit code: that of the command; 77 where the cluster does not start.
set -euo pipefail

folder=$(realpath -m "$1")
shift
mkdir -p "$folder"/{state,spool}
PATH=$PATH:/usr/sbin
host=$(hostname -s)
user=$(id -un)

free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'; }

stop() {
  local name
  for name in slurmd slurmctld munged; do
    if [[ -s $folder/$name.pid ]]; then kill "$(<"$folder/$name.pid")" 2>/dev/null || true; fi
  done
}
trap stop EXIT

umask 077 # munged takes no key that others can read
mkdir -p "$folder/munge"
head -c 1024 /dev/urandom >"$folder/munge/key"
umask 022
chmod 711 "$folder/munge"
munged --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munged.pid" \
  --seed-file="$folder/munge/seed" --log-file="$folder/munge/log" --force 2>"$folder/munged.err" || {
  echo "skipped: munged does not start: $(tail -n 1 "$folder/munged.err")" >&2
  exit 77
}

cat >"$folder/slurm.conf" <<EOF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
EOF
export SLURM_CONF=$folder/slurm.conf
slurmctld
slurmd
for _ in {1..100}; do
  [[ $(sinfo --noheader --format=%t 2>/dev/null) == idle ]] && ready=yes && break
  sleep 0.1
done
if [[ -z ${ready:-} ]]; then
  echo "skipped: the Slurm node does not start: $(tail -n 1 "$folder/slurmd.log")" >&2
  exit 77
fi
"$@"

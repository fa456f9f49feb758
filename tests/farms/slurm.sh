#!/usr/bin/env bash
# Runs examples/farms/slurm.sh on a cluster of one node, which this starts and ends: slurm.sh QUELL_DENOISE QUELL_TRACE SOURCE_FOLDER
# One of six parts is killed and runs again; the frames are those of one run. Skips (77) where Slurm is missing or does not start here.
set -euo pipefail
denoise=$1 trace=$2 source=$3

skip() {
    echo "skipped: $1"
    exit 77
}
PATH=$PATH:/usr/sbin
for program in slurmctld slurmd sbatch scontrol squeue scancel; do
    command -v "$program" >/dev/null || skip "there is no $program (apt-get install slurm-wlm)"
done

folder=$(mktemp -d)
daemons=()
finish() {
    [ ${#daemons[@]} -eq 0 ] || kill "${daemons[@]}" 2>/dev/null || true
    wait 2>/dev/null || true
    rm -rf "$folder"
}
trap finish EXIT

# Ports of its own, so that a cluster of the machine and other tests are left alone.
port=$((20000 + RANDOM % 20000))
node=$(hostname -s)
mkdir "$folder/state" "$folder/spool" "$folder/frames"
cat >"$folder/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$node(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/none
CredType=cred/none
SlurmctldPort=$port
SlurmdPort=$((port + 1))
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
KillWait=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES State=UP
END
export SLURM_CONF=$folder/slurm.conf
unset "${!SBATCH_@}" "${!SQUEUE_@}"

slurmctld -D >"$folder/slurmctld.log" 2>&1 &
daemons+=($!)
slurmd -D -N "$node" >"$folder/slurmd.log" 2>&1 &
daemons+=($!)

# wait_for what seconds command...: until the command succeeds.
wait_for() {
    local what=$1 end=$((SECONDS + $2))
    shift 2
    until "$@"; do
        if [ "$SECONDS" -ge "$end" ]; then
            echo "waited in vain for $what"
            return 1
        fi
        sleep 0.1
    done
}
node_is_idle() { [ "$(sinfo -h -o %T 2>/dev/null)" = idle ]; }
wait_for "the node" 20 node_is_idle || skip "Slurm does not start here: $(grep -h -i -m 1 -E 'error|fatal' "$folder"/*.log || echo 'no message')"

cd "$folder"
"$trace" --scene room --frames 48 --size 48x27 --quiet --out frames
"$denoise" --in 'frames/frame.%04d.exr' --out 'one/out.%04d.exr' --quiet

# The first time, the third part makes two of its eight frames and then waits until it is killed, however fast the machine is.
cat >denoise.sh <<END
#!/usr/bin/env bash
if [ "\$SLURM_ARRAY_TASK_ID" = 3 ] && mkdir "$folder/begun" 2>/dev/null; then
    "$denoise" "\${@/#3\/6/9\/24}" && mkdir "$folder/waits"
    sleep 600
fi
exec "$denoise" "\$@"
END
chmod +x denoise.sh
export QUELL_DENOISE=$folder/denoise.sh
job=$(sbatch --parsable --array=1-6 "$source/examples/farms/slurm.sh" 6 --in 'frames/frame.%04d.exr' --out 'farm/out.%04d.exr' --frames 0-47)
state_of() { scontrol show job "${job}_$1" 2>/dev/null | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p'; }
has_state() { [[ "$(state_of "$1")" =~ ^($2) ]]; }

wait_for "the third part" 60 test -d waits
scancel --signal=KILL --full "${job}_3"
wait_for "the third part to be killed" 30 has_state 3 'FAILED|CANCELLED|NODE_FAIL'
scontrol requeue "${job}_3"
sleep 2                                         # a start in the second of the kill would be taken for the one that was killed
scontrol update "JobId=${job}_3" StartTime=now # and not two minutes later
for part in 1 2 3 4 5 6; do
    wait_for "part $part" 60 has_state "$part" COMPLETED || {
        scontrol show job "${job}_$part"
        cat quell-denoise.*.log slurmd.log
        exit 1
    }
done

[ "$(ls farm | wc -l)" = 48 ] || { echo "there are other files than 48 frames:"; ls farm; exit 1; }
for file in one/*.exr; do
    cmp "$file" "farm/${file#one/}"
done
grep -q '"skipped":\[16' quell-denoise.3.log || { echo "the third part did not go on behind its frames:"; cat quell-denoise.3.log; exit 1; }
echo "48 frames in six parts, one of them killed and run again, are those of one run"

#!/usr/bin/env bash
#SBATCH --job-name=quell-denoise
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=quell-denoise.%a.log
# Denoises a sequence as a job array of Slurm: each task has one part of the frames.
#
#     sbatch --array=1-6 --cpus-per-task=8 examples/farms/slurm.sh 6 --in 'shot/frame.%04d.exr' --out 'shot/clean.%04d.exr' --frames 1-48
#
# The first argument is the number of parts; the others go to quell-denoise. A part that was killed or preempted goes on behind the frames
# that it has written: by itself, by "scontrol requeue JOB_3", or by sbatch --array=3 with the same arguments. Give --frames where the
# sequence is still being rendered: the parts must be of the same frames. QUELL_DENOISE names the program where PATH does not have it.
set -euo pipefail

if [ $# -lt 1 ] || ! [[ $1 =~ ^[1-9][0-9]*$ ]]; then
    echo "slurm.sh: give the number of parts first: sbatch --array=1-6 slurm.sh 6 --in ... --out ..." >&2
    exit 2
fi
parts=$1
shift
exec "${QUELL_DENOISE:-quell-denoise}" "$@" --chunk "${SLURM_ARRAY_TASK_ID:?submit it with --array=1-$parts}/$parts" \
    --threads "${SLURM_CPUS_PER_TASK:-1}" --skip-existing --json

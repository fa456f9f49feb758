#!/usr/bin/env bash
# What can be tested of the executor Cuda without a GPU: every preset compiles for a device, no kernel traps, the device's compiler lays jobs
# out as the host's does, and what is built says so where there is no GPU. Skipped with one line, and status 77, without nvcc.
#   tests/build/cuda.sh [folder]
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=${1:-build/cuda}
bench/cuda.sh build "$folder"

fail() { echo "FAILED: $1" >&2; exit 1; }

# The compiler plants one, without a word, where a kernel would read what the device cannot reach.
! grep -n '\btrap;' "$folder"/*.ptx || fail "a kernel traps"
[ "$(cat "$folder"/unit_*.ptx | grep -c 'entry .*each_pixel')" -gt 50 ] || fail "PTX has few kernels"
"$folder/quell-cuda" --layouts "$folder"/unit_*.ptx || fail "a device would find arguments elsewhere than the host puts them"

# The check itself must be able to fail.
if "$folder/shifted" "$folder/shifted.ptx"; then fail "a job that is laid out in two ways was not found"; fi

[ "$(du -m "$folder/quell-cuda" | cut -f1)" -lt 60 ] || fail "quell-cuda is larger than 60 MiB"
# Programs end with a sentence, and status 1, where there is no GPU.
if [ ! -e /dev/nvidiactl ]; then
    for program in quell-cuda example; do
        status=0
        "$folder/$program" 2>"$folder/$program.said" >&2 || status=$?
        [ "$status" = 1 ] || fail "$program ended with status $status where there is no GPU"
        grep -q 'NVIDIA GPU and a driver' "$folder/$program.said" || fail "$program does not say that there is no GPU: $(cat "$folder/$program.said")"
    done
fi
echo "CUDA: all presets compile, none traps, layouts are equal"

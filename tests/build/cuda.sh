#!/usr/bin/env bash
# What can be tested of the executor Cuda without a GPU: every preset but the published ones compiles for a device, no kernel traps, spills
# registers or has a large stack frame, the device's compiler lays jobs out as the host's does, and what is built says so where there is no
# GPU. Skipped with one line, and status 77, without nvcc.
#   tests/build/cuda.sh [folder]
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=${1:-build/cuda}
bench/cuda.sh build "$folder"

fail() { echo "FAILED: $1" >&2; exit 1; }

# The compiler plants one, without a word, where a kernel would read what the device cannot reach.
! grep -n '\btrap;' "$folder"/*.ptx || fail "a kernel traps"
[ "$(cat "$folder"/unit_*.ptx | grep -c 'entry .*each_pixel')" -gt 50 ] || fail "PTX has few kernels"
# Local memory is slow, and makes registers scarce.
awk -v limit=64 -v exceptions=tests/build/cuda/large_frames.txt '
    BEGIN { while ((getline line < exceptions) > 0) if (line !~ /^#/ && split(line, part, " ") > 1) allowed[part[2]] = part[1] }
    FNR > 1 { pass = $4; sub(/<.*/, "", pass); most = pass in allowed ? allowed[pass] : limit
              if ($2 > most || $3 > 0) { print "  " $0; bad = 1 } }
    END { exit bad }' "$folder/kernels.txt" || fail "kernels above have a stack frame of more than 64 bytes, or spill registers; see tests/build/cuda/large_frames.txt"
"$folder/quell-cuda" --layouts "$folder"/unit_*.ptx || fail "a device would find arguments elsewhere than the host puts them"

# The check itself must be able to fail.
if "$folder/shifted" "$folder/shifted.ptx"; then fail "a job that is laid out in two ways was not found"; fi

[ "$(du -m "$folder/quell-cuda" | cut -f1)" -lt 60 ] || fail "quell-cuda is larger than 60 MiB"
# Programs end with a sentence, and status 1, where there is no GPU.
if [ ! -e /dev/nvidiactl ]; then
    for program in quell-cuda example cuda_host quell-library; do
        status=0
        "$folder/$program" 2>"$folder/$program.said" >&2 || status=$?
        [ "$status" = 1 ] || fail "$program ended with status $status where there is no GPU"
        grep -q 'NVIDIA GPU and a driver' "$folder/$program.said" || fail "$program does not say that there is no GPU: $(cat "$folder/$program.said")"
    done
fi
awk 'FNR > 1 { ++kernels; if ($1 > registers) registers = $1; if ($2 > stack) stack = $2 }
    END { printf "CUDA: all presets compile, none traps or spills, layouts are equal; %d passes, at most %d registers and %d bytes of stack\n",
          kernels, registers, stack }' "$folder/kernels.txt"

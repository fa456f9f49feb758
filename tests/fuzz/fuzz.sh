#!/usr/bin/env bash
# Runs a fuzzer for QUELL_FUZZ_SECONDS (25 of them): fuzz.sh program write_seeds kind-of-seeds
# What it learns stays in corpus/ of the build folder, for the next run to go on from. A finding is written there too; to see it again:
#     the program, with the finding's path as its argument
set -euo pipefail
program=$1 seeds=$2 kind=$3
here=$(dirname "$0")
work=$(dirname "$program")/corpus/$(basename "$program")
mkdir -p "$work/learnt" "$work/seeds"
"$seeds" "$work/seeds"
dictionary=()
[ ! -f "$here/$kind.dict" ] || dictionary=("-dict=$here/$kind.dict")
"$program" "-max_total_time=${QUELL_FUZZ_SECONDS:-25}" -max_len=4096 -len_control=0 -timeout=60 -rss_limit_mb=3000 -malloc_limit_mb=2000 -verbosity=1 \
    -print_final_stats=1 "-artifact_prefix=$work/" "${dictionary[@]}" "$work/learnt" "$work/seeds/$kind" 2>&1 | grep -vE '^#[0-9]+\s+(NEW|REDUCE|RELOAD|pulse)|NEW_FUNC'

#!/usr/bin/env bash
# Seconds and peak memory to compile an empty file that includes quell/quell.hpp, each example that is one file, and a host of libquell;
# with g++ also with flags that shorten it:
#   bench/compile_time.sh [g++ or another compiler]
set -euo pipefail
cd "$(dirname "$0")/.."
source .ci/packages.sh

compiler=${1:-g++}
need_packages g++ libglm-dev libxsimd-dev libtbb-dev time
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo '#include <quell/quell.hpp>' >"$work/empty.cpp"

# measure label source flag...: the quickest of three, since other programs only add to the time.
measure() {
    local label=$1 source=$2 seconds best="" peak
    shift 2
    for _ in 1 2 3; do
        /usr/bin/time -f '%U %S %M' -o "$work/times" "$compiler" -std=c++20 -O2 "$@" -I include -I examples -c "$source" -o "$work/object.o"
        read -r seconds peak < <(awk '{ printf "%.2f %.0f\n", $1 + $2, $3 / 1024 }' "$work/times")
        if [ -z "$best" ] || awk "BEGIN { exit !($seconds < $best) }"; then best=$seconds; fi
    done
    printf '%-34s %-16s %8s s %6s MB\n' "$label" "$*" "$best" "$peak"
}

echo "$("$compiler" --version | head -1), -std=c++20 -O2, processor time"
all_flags=("" -march=native)
[[ $("$compiler" --version) == *"Free Software"* ]] && all_flags+=("-march=native -fno-tree-pta --param=sccvn-max-alias-queries-per-access=20")
for flags in "${all_flags[@]}"; do
    # shellcheck disable=SC2086 # no flags are no argument
    measure "#include <quell/quell.hpp>" "$work/empty.cpp" $flags
    for example in examples/*.cpp; do
        # shellcheck disable=SC2086
        [ ! -f "$example" ] || measure "$example" "$example" $flags
    done
    # shellcheck disable=SC2086
    measure "examples/library/denoise.cpp" examples/library/denoise.cpp -I packaging/library $flags
done

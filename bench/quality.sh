#!/usr/bin/env bash
# Figures of quality in docs/figures.md that no chart has: svgf with its history in float and in half, on `room` (frame 32, 480x270, against a
# converged reference, which takes long the first time and is kept in ~/.cache/quell), and presets on the Cycles sequence where it is there:
#   bench/quality.sh [folder of the built programs] [folder of the Cycles sequence]
set -euo pipefail
cd "$(dirname "$0")/.."

build=${1:-build/release}
cycles=${2:-../shared/data/sequences/cycles_occlusion}
trace=$build/examples/tracer/quell-trace
denoise=$build/examples/denoise/quell-denoise
work=out/quality
presets=(none surface surface-clamp atrous svgf)
for program in "$trace" "$denoise"; do
    [ -x "$program" ] || { echo "There is no $program. Build it: cmake --preset release && cmake --build --preset release" >&2; exit 2; }
done

# row label quell-denoise-option...: the means that quell-denoise prints last.
row() {
    local label=$1
    shift
    printf '%-14s %s\n' "$label" "$("$denoise" --quiet "$@" | sed -n 's/^mean,//p' | tr ',' ' ')"
}

"$trace" --quiet --scene room --size 480x270 --frames 33 --out "$work/room"
"$trace" --scene room --size 480x270 --first 32 --frames 1 --reference 65536 --out "$work/reference"
echo "svgf, history in float and in half"
cmake --build "$build" --target quell-half-history
"$build/bench/quell-half-history" "$work/room/frame.%04d.exr" 32 "$work/reference/reference.0032.exr"

[ -d "$cycles" ] || { echo "skipped: there is no Cycles sequence at $cycles"; exit 0; }
echo "Cycles, mean of frames 40 and 48:  RMSE SSIM FLIP"
for preset in "${presets[@]}"; do
    row "$preset" --preset "$preset" --in "$cycles/frame_%04d.exr" --reference "$cycles/reference_%04d.exr"
done

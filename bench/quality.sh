#!/usr/bin/env bash
# The rows of docs/figures.md about presets on the Cycles sequence, where that is there:
#   bench/quality.sh [folder of the built programs] [folder of the Cycles sequence]
set -euo pipefail
cd "$(dirname "$0")/.."

denoise=${1:-build/release}/examples/denoise/quell-denoise
cycles=${2:-../shared/data/sequences/cycles_occlusion}
[ -x "$denoise" ] || { echo "There is no $denoise. Build it: cmake --preset release && cmake --build --preset release" >&2; exit 2; }
[ -d "$cycles" ] || { echo "skipped: there is no Cycles sequence at $cycles"; exit 0; }
echo "Cycles, mean of frames 40 and 48:  RMSE SSIM FLIP"
for preset in none surface surface-clamp atrous svgf; do
    printf '%-14s ' "$preset"
    "$denoise" --quiet --preset "$preset" --in "$cycles/frame_%04d.exr" --reference "$cycles/reference_%04d.exr" |
        sed -n 's/^mean,//p' | tr ',' ' '
done

#!/usr/bin/env bash
# The table of presets in docs/figures.md: milliseconds per frame at 1280x720 and 1920x1080, bytes per pixel at the latter, and errors at 480x270 on a
# scene that was made for the effect, of a chart of all scenes:
#   quell-chart --scene all --out out/chart && bench/preset_table.sh [folder of the chart] [folder of the built programs] [threads]
set -euo pipefail
cd "$(dirname "$0")/.."

charted=${1:-out/chart}/chart.csv
chart=${2:-build/release}/bench/chart/quell-chart
threads=${3:-0}
work=out/preset_table
cases=("fence shadow" "temple glossy" "boxes indirect" "room composite" "mixed blur")
[ -f "$charted" ] || { echo "There is no $charted. Make it: $chart --scene all --out ${1:-out/chart}" >&2; exit 2; }

for size in 1280x720 1920x1080; do
    for case in "${cases[@]}"; do
        read -r scene effect <<<"$case"
        "$chart" --quiet --times --frames 11 --threads "$threads" --size "$size" --scene "$scene" --effect "$effect" --out "$work/$size-$scene"
    done
done

echo "| scene, effect | preset | ms, 720p | ms, 1080p | bytes per pixel | RMSE | in the mask | FLIP | front |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"
# The columns of chart.csv, by name.
awk -F, -v charted="$charted" '
    FNR == 1 { delete at; for (i = 1; i <= NF; ++i) at[$i] = i; next }
    { key = $at["scene"] ", " $at["effect"] "|" $at["method"] }
    FILENAME != charted { ms[key, $at["height"]] = $at["ms_per_frame"]; bytes[key] = $at["bytes_per_pixel"]; next }
    (key, 1080) in ms && key !~ /[0-9]spp|=/ {
        split(key, name, "|")
        printf "| %s | `%s` | %.1f | %.1f | %.0f | %.4f | %.4f | %.4f | %s |\n", name[1], name[2], ms[key, 720], ms[key, 1080],
            bytes[key], $at["rmse"], $at["mask_rmse"], $at["flip"], $at["pareto"] == 1 ? "yes" : ""
    }' "$work"/*/chart.csv "$charted"

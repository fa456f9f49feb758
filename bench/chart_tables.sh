#!/usr/bin/env bash
# Tables of docs/figures.md, all of one run (bench/figures.py --record all_presets inside_the_effect motion_blur): times, bytes and errors of
# every preset at 480x270 and 1920x1080, errors inside the effects, and motion blur. What the folder has already is not charted again. It took
# 27 minutes on 2 cores of a Zen 4 where all references were cached:
#   bench/chart_tables.sh [folder for the charts] [folder of the built programs] [threads]
# With OIDN=1 Open Image Denoise's networks (bench/oidn.sh) are charted on the scene room too, at all sizes.
set -euo pipefail
cd "$(dirname "$0")/.."

work=${1:-out/chart_tables}
chart=${2:-build/release}/bench/chart/quell-chart
threads=${3:-0}
# Scene, effect, and the tolerance of its reference at 1920x1080, where those of 480x270 would take far more samples than are needed.
cases=("fence shadow 0.02" "temple glossy 0.02" "restaurant glossy 0.02" "boxes indirect 0.04" "room composite 0.04" "mixed blur 0.01"
    "spheres blur 0.01")
[ -x "$chart" ] || { echo "There is no $chart. Build it: cmake --build --preset release --target quell-chart" >&2; exit 2; }

# run folder option...
run() {
    local folder=$1
    shift
    local networks=() kind
    if [ -n "${OIDN:-}" ] && [[ $folder == */room ]]; then
        for kind in base large; do networks+=(--external "oidn-$kind=$PWD/bench/oidn.sh $kind {in} {out}"); done
    fi
    [ -f "$folder/done" ] || { "$chart" --quiet --threads "$threads" --out "$folder" "$@" "${networks[@]}" >&2 && touch "$folder/done"; }
}
for scene in $("$chart" --list); do
    run "$work/480x270/$scene" --few --scene "$scene"
done
for case in "${cases[@]}"; do
    read -r scene effect tolerance <<<"$case"
    run "$work/1280x720/$scene" --times --frames 11 --size 1280x720 --scene "$scene" --effect "$effect"
    run "$work/1920x1080/$scene" --few --frames 25 --size 1920x1080 --scene "$scene" --effect "$effect" --tolerance "$tolerance"
done

# cells program: an awk program over all rows, which has the function of(column) and names a case by `key` and a row of it by `method`.
cells() {
    awk -F, 'function of(column) { return $at[column] }
        FNR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
        of("method") ~ /=/ { next }
        { key = of("scene") ", " of("effect"); method = of("method"); height = of("height") }
        '"$1" "$work"/480x270/*/chart.csv "$work"/1280x720/*/chart.csv "$work"/1920x1080/*/chart.csv
}

echo "| scene, effect | preset | ms, 720p | ms, 1080p | bytes per pixel | RMSE | in the mask | SSIM | FLIP | front | 1080p: RMSE | 1080p: in the mask | 1080p: SSIM | 1080p: FLIP |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
cells 'function errors() { return sprintf("%.4f | %.4f | %.3f | %.4f", of("rmse"), of("mask_rmse"), of("ssim"), of("flip")) }
    method ~ /[0-9]spp/ { next }
    height == 270 { small[key, method] = errors() " | " (of("pareto") == 1 ? "yes" : "") }
    height == 720 { ms[key, method] = of("ms_per_frame") }
    height == 1080 { printf "| %s | `%s` | %.1f | %.1f | %.0f | %s | %s |\n", key, method, ms[key, method], of("ms_per_frame"),
        of("bytes_per_pixel"), small[key, method], errors() }'

# table heading effects value method...: a column per method, where a case has it.
table() {
    local heading=$1 effects=$2 value=$3
    shift 3
    printf '\n| %s |' "$heading"
    printf ' `%s` |' "$@"
    printf '\n| --- |'
    printf ' --- |%.0s' "$@"
    printf '\n'
    cells 'BEGIN { count = split("'"$*"'", columns, " ") }
        height != 270 || of("effect") !~ /^('"$effects"')$/ { next }
        of("'"$value"'") == "" { next } # nothing in the mask
        !(key in seen) { seen[key] = 1; keys[++rows] = key }
        { found[key, method] = sprintf("%.4f", of("'"$value"'")) }
        END { for (r = 1; r <= rows; ++r) {
            printf "| %s |", keys[r]
            for (c = 1; c <= count; ++c) printf " %s |", found[keys[r], columns[c]]
            printf "\n" } }'
}
table "RMSE in the mask" "shadow|glossy|curved|indirect" mask_rmse \
    surface-clamp mirror-clamp svgf asvgf general dual-color shadow glossy dual-cone
table "FLIP" blur flip none none-8spp none-8spp-random none-16spp-random gather-blur tilemax-blur svgf general blur-paper blur-wavelet \
    blur-fixed-step blur-one-step blur blur-straight blur-bent blur-split

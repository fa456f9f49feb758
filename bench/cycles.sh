#!/usr/bin/env bash
# Renders scenes with Blender's Cycles, which quell was not made for, at several numbers of samples, denoises them by every preset that
# wants no more than colour and guides, and prints the table of docs/figures.md: FLIP (RMSE) of frames 41 to 48 against 512 samples.
#   bench/cycles.sh [FOLDER [SCENES [FILTERS [SAMPLES]]]]          for instance: bench/cycles.sh out/cycles "lamp brass" box "1 16"
# Scenes: lamp, train, brass at 480x270; at 240x135 and frames 5 to 10 fog, dof, leaves, film, glass, mblur, gamut (filter default), and tiles
# (box), by 1 and 8 samples. cycles_scenes.py says what is in them. The last row denoises the picture as one signal.
# FILTERS: box (samples anywhere within their pixel) and default (Cycles' own, anywhere within a pixel and a half). The first sample of a pixel
# lies at its centre with both.
# What has been rendered stays in the folder and is not rendered again. On 2 cores: references 40 to 60 s a frame, 64 samples 6 to 12 s,
# 1 sample 0.4 s.
set -euo pipefail
folder=$(realpath -m "${1:-out/cycles}")
read -ra scenes <<<"${2:-lamp train brass}"
read -ra filters <<<"${3:-box}"
read -ra samples <<<"${4:-1 4 16 64}"
cd "$(dirname "$0")/.."
source bench/render_cycles.sh
[[ " ${scenes[*]} " != *" gamut "* ]] || [ -e /usr/share/doc/python3-openimageio ] || install_packages python3-openimageio
denoise=build/release/examples/denoise/quell-denoise
[ -x "$denoise" ] || { cmake --preset release && cmake --build --preset release --target quell-denoise; }

# shape scene samples: width, height, first frame, last frame, first frame of the references.
# What is shorter than a history of 24 frames costs less to render where there is little noise.
shape() {
    case $1 in
    lamp | train | brass) echo 480 270 $(($2 >= 64 ? 33 : 17)) 48 41 ;;
    *) echo 240 135 1 10 5 ;;
    esac
}

# score scene filter samples preset [options]: FLIP (RMSE).
score() {
    local at=$folder/$1/$2 count=$3 preset=$4 first last
    read -r _ _ first last _ <<<"$(shape "$1" "$3")"
    shift 4
    "$denoise" --quiet --preset "$preset" "$@" --in "$at/$count/frame_%04d.exr" --reference "$at/512/frame_%04d.exr" --first \
        "$first" --last "$last" | awk -F, '$1 == "mean" { printf " %.4f (%.4f) |", $4, $2 }'
}

for filter in "${filters[@]}"; do
    for scene in "${scenes[@]}"; do
        for count in "${samples[@]}"; do
            read -r width height first last reference <<<"$(shape "$scene" "$count")"
            render "$scene" "$folder/$scene/$filter/512" 512 "$reference" "$last" "$width" "$height" "$filter"
            render "$scene" "$folder/$scene/$filter/$count" "$count" "$first" "$last" "$width" "$height" "$filter"
        done
    done
    printf '| filter %s: FLIP (RMSE) |' "$filter"
    for scene in "${scenes[@]}"; do for count in "${samples[@]}"; do printf ' %s, %s |' "$scene" "$count"; done; done
    printf '\n| --- |'
    for scene in "${scenes[@]}"; do for count in "${samples[@]}"; do printf ' --- |'; done; done
    printf '\n'
    for preset in none surface surface-clamp atrous svgf dual-color "general --extra-frames 0 --quick" "general --quick" "final-frame --extra-frames 0" final-frame "final-frame --map bench/cycles_one_signal.json"; do
        printf '| `%s` |' "$preset"
        read -ra words <<<"$preset"
        for scene in "${scenes[@]}"; do for count in "${samples[@]}"; do score "$scene" "$filter" "$count" "${words[@]}"; done; done
        printf '\n'
    done
done

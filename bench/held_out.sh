#!/usr/bin/env bash
# Renders sequences that nothing is fitted to, denoises them by Open Image Denoise's networks and by quell-denoise, and prints the tables of
# docs/figures.md, "Held out".
#   bench/held_out.sh [FOLDER [SCENES [PARTS]]]            for instance: bench/held_out.sh out/held "kitchen stairs" 4
# Scenes: kitchen, market, stairs, workshop, garden of cycles_scenes.py, a window of 240x135 of frames of 480x270. The reference, of frames 37
# to 41, is the mean of PARTS renders of 256 samples, each with a seed of its own (default: 4). Input: 1 sample from frame 21 on, 16 from 32
# on, 64 from 37 and 256 from 40. What has been made stays in the folder and isn't made again; measuring alone: bench/held_out.py FOLDER.
# Numbers and choices are never to be fitted to these scenes: figures of them then say nothing of others.
set -euo pipefail
folder=$(realpath -m "${1:-out/held}")
read -ra scenes <<<"${2:-kitchen market stairs workshop garden}"
parts=${3:-4}
cd "$(dirname "$0")/.."
source bench/render_cycles.sh
denoise=${DENOISE:-build/release/examples/denoise/quell-denoise}
[ -x "$denoise" ] || { cmake --preset release && cmake --build --preset release --target quell-denoise; }

filter() { case $1 in kitchen | stairs) echo box ;; *) echo default ;; esac; }

for scene in "${scenes[@]}"; do
    how=(480 270 "$(filter "$scene")")
    for frames in "1 21 45" "16 32 43" "64 37 42" "256 40 42"; do
        read -r samples first last <<<"$frames"
        render "$scene" "$folder/$scene/$samples" "$samples" "$first" "$last" "${how[@]}" 0 window
    done
    for ((part = 1; part <= parts; ++part)); do render "$scene" "$folder/$scene/part_$part" 256 37 41 "${how[@]}" "$part" window; done
    mkdir -p "$folder/$scene"/{reference,half_1,half_2}
    for frame in 37 38 39 40 41; do
        to=$folder/$scene/reference/frame_00$frame.exr
        if [ ! -s "$to" ]; then
            parts_of=("$folder/$scene"/part_*/"frame_00$frame.exr")
            half=$((${#parts_of[@]} / 2))
            [ "$half" = 0 ] || /usr/bin/python3 bench/average_exr.py "${to/reference/half_1}" "${parts_of[@]:0:half}"
            [ "$half" = 0 ] || /usr/bin/python3 bench/average_exr.py "${to/reference/half_2}" "${parts_of[@]:half:half}"
            /usr/bin/python3 bench/average_exr.py "$to" "${parts_of[@]}"
        fi
        for samples in 1 16; do
            for kind in base large; do
                at=$folder/$scene/$samples/oidn
                mkdir -p "$at"
                [ -s "$at/${kind}_00$frame.exr" ] || bench/oidn.sh "$kind" "$folder/$scene/$samples/frame_%04d.exr" "$at/${kind}_%04d.exr" "$frame" "$frame" >/dev/null
            done
        done
    done
done
/usr/bin/python3 bench/held_out.py "$folder" "${scenes[@]}" --denoise "$denoise"

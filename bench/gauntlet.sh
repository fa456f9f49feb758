#!/usr/bin/env bash
# Renders sequences of Blender's Cycles in each of which one thing is not in the vectors, and holds quell-denoise against --quick on them.
#   bench/gauntlet.sh [FOLDER [SCENES [SAMPLES]]]          for instance: bench/gauntlet.sh out/gauntlet_cycles "horizon zoom" "4 16"
# Scenes: horizon (a sky with a pattern while the camera turns), screen (a film is played), zoom (the lens becomes longer), drips (metaballs
# before the sky) of cycles_scenes.py, 192x108, frames 1 to 8. References, of frames 4 to 6, are means of two renders of 256 samples. What has
# been made stays in the folder and isn't made again.
set -euo pipefail
folder=$(realpath -m "${1:-out/gauntlet_cycles}")
read -ra scenes <<<"${2:-horizon screen zoom drips}"
read -ra counts <<<"${3:-4}"
cd "$(dirname "$0")/.."
source bench/render_cycles.sh
gauntlet=${GAUNTLET:-build/release/bench/gauntlet/quell-gauntlet}
[ -x "$gauntlet" ] || { cmake --preset release && cmake --build --preset release --target quell-gauntlet; }

sequences=()
for scene in "${scenes[@]}"; do
    for samples in "${counts[@]}"; do
        render "$scene" "$folder/$scene/$samples" "$samples" 1 8 192 108 box
        sequences+=(--sequence "$folder/$scene/$samples")
    done
    for part in 1 2; do render "$scene" "$folder/$scene/part_$part" 256 4 6 192 108 box "$part"; done
    mkdir -p "$folder/$scene/reference"
    for frame in 4 5 6; do
        to=$folder/$scene/reference/frame_000$frame.exr
        [ -s "$to" ] || /usr/bin/python3 bench/average_exr.py "$to" "$folder/$scene"/part_*/"frame_000$frame.exr"
    done
done
exec "$gauntlet" "${sequences[@]}" --out "$folder/report"

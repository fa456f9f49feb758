#!/usr/bin/env bash
# Prints quell beside Open Image Denoise: FLIP (RMSE) on sequences, and geometric means of the ratios to OIDN's large network.
#   bench/scoreboard.sh FOLDER [SCENE...]       SAMPLES="1 16" DENOISE=other/quell-denoise bench/scoreboard.sh out/cycles office lamp
# A sequence is FOLDER/SCENE/SAMPLES/frame_0001.exr and so on, its references FOLDER/SCENE/512 or 2048 of some of the frames, which are
# measured. What the networks made, and what they and the input scored, is kept in FOLDER/SCENE/SAMPLES/oidn; ROWS="input svgf quell" chooses
# rows, of which those that are not named below are presets.
# The row "accumulated" is the large network on light and guides that quell has accumulated (--preset accumulated).
set -euo pipefail
here=$(realpath "$(dirname "$0")")
folder=$(realpath "${1:?a folder of sequences}")
shift
denoise=${DENOISE:-$here/../build/release/examples/denoise/quell-denoise}
read -ra counts <<<"${SAMPLES:-1 16}"
read -ra rows <<<"${ROWS:-input real-time final-alone quell accumulated base large}"
[ $# -gt 0 ] || { cd "$folder" && set -- */ && set -- "${@%/}"; }
echo '{"signals": [{"radiance": "ViewLayer.Combined"}], "picture": "ViewLayer.Combined", "channels": {}}' >"${TMPDIR:-/tmp}/scoreboard_plain.json"

# score at reference in options...: FLIP RMSE SSIM, means over the frames that have a reference.
score() {
    local reference=$1 frames=$2 in=$3
    shift 3
    "$denoise" --quiet "$@" --in "$in" --reference "$reference/frame_%04d.exr" --frames "$frames" | awk -F, '$1 == "mean" { m = $4 " " $2 " " $3 } $1 != "frame" { l = $4 " " $2 " " $3 } END { print m == "" ? l : m }'
}
# row scene samples: one line of figures for each row
row() {
    local at=$folder/$1/$2 name=$3 reference=$folder/$1/512 frames kept
    [ -d "$folder/$1/2048" ] && reference=$folder/$1/2048
    frames=$(cd "$reference" && ls frame_*.exr | sed 's/frame_0*//; s/\.exr//' | paste -sd,)
    kept=$at/oidn/$name.score
    case $name in
    input | base | large)
        mkdir -p "$at/oidn"
        if [ ! -s "$kept" ]; then
            if [ "$name" = input ]; then score "$reference" "$frames" "$at/frame_%04d.exr" --preset none >"$kept"; else
                local n
                for n in ${frames//,/ }; do "$here/oidn.sh" "$name" "$at/frame_%04d.exr" "$at/oidn/${name}_%04d.exr" "$n" "$n" >/dev/null; done
                score "$reference" "$frames" "$at/oidn/${name}_%04d.exr" --preset none >"$kept"
            fi
        fi
        cat "$kept"
        ;;
    accumulated)
        local made n
        made=$(mktemp -d)
        "$denoise" --quiet --preset accumulated --in "$at/frame_%04d.exr" --out "$made/light_%04d.exr" --frames "$frames"
        for n in ${frames//,/ }; do "$here/oidn.sh" large "$made/light_%04d.exr" "$made/%04d.exr" "$n" "$n" >/dev/null; done
        score "$reference" "$frames" "$made/%04d.exr" --preset none
        rm -r "$made"
        ;;
    real-time) score "$reference" "$frames" "$at/frame_%04d.exr" --preset general --extra-frames 0 --quick ;;
    final-alone) score "$reference" "$frames" "$at/frame_%04d.exr" --preset final-frame --extra-frames 0 ;;
    quell) score "$reference" "$frames" "$at/frame_%04d.exr" ;;
    *) score "$reference" "$frames" "$at/frame_%04d.exr" --preset "$name" ;;
    esac
}
for scene in "$@"; do
    for count in "${counts[@]}"; do
        [ -d "$folder/$scene/$count" ] || continue
        for name in "${rows[@]}"; do echo "$scene $count $name $(row "$scene" "$count" "$name")"; done
        [[ " ${rows[*]} " == *" large "* ]] || echo "$scene $count large $(row "$scene" "$count" large)"
    done
done | awk -v rows="${rows[*]}" '
    { key = $1 ", " $2; if (!(key in seen)) { seen[key] = 1; order[++n] = key } flip[key, $3] = $4; rmse[key, $3] = $5; ssim[key, $3] = $6 }
    BEGIN { # titles as in docs/figures.md; other rows are presets
        title["input"] = "input"; title["base"] = "base"; title["large"] = "large"; title["quell"] = "`quell-denoise`"
        title["accumulated"] = "`accumulated`, large"; title["real-time"] = "`general --extra-frames 0 --quick`"
        title["final-alone"] = "`final-frame --extra-frames 0`"
    }
    END {
        count = split(rows, name, " ")
        printf "| FLIP (RMSE) |"; for (i = 1; i <= count; ++i) printf " %s |", name[i] in title ? title[name[i]] : "`" name[i] "`"; printf "\n|"
        for (i = 0; i <= count; ++i) printf " --- |"; printf "\n"
        for (k = 1; k <= n; ++k) {
            printf "| %s |", order[k]
            for (i = 1; i <= count; ++i) {
                f = flip[order[k], name[i]]; r = rmse[order[k], name[i]]; printf " %.4f (%.4f) |", f, r
                lf[i] += log(f / flip[order[k], "large"]); lr[i] += log(r / rmse[order[k], "large"]); s[i] += ssim[order[k], name[i]]
            }
            printf "\n"
        }
        printf "| geometric mean, over that of the large one |"; for (i = 1; i <= count; ++i) printf " %.3f (%.3f) |", exp(lf[i] / n), exp(lr[i] / n); printf "\n"
        printf "| SSIM, mean |"; for (i = 1; i <= count; ++i) printf " %.4f |", s[i] / n; printf "\n"
    }'

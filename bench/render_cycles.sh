# shellcheck shell=bash
# For scripts to source, from the repository's root: installs Blender where it is missing.
source .ci/packages.sh
command -v blender >/dev/null || install_packages blender

# render SCENE FOLDER SAMPLES FIRST LAST WIDTH HEIGHT FILTER [SEED [window]]: those of the frames that aren't there, see cycles_scenes.py.
render() {
    local scene=$1 to=$2 samples=$3 number first=0 last=0
    mkdir -p "$to"
    for ((number = $4; number <= $5; ++number)); do
        [ -s "$to/frame_$(printf %04d "$number").exr" ] && continue
        [ "$first" -gt 0 ] || first=$number
        last=$number
    done
    [ "$first" -gt 0 ] || return 0
    echo "rendering $scene, $samples samples, frames $first to $last" >&2
    blender -b --factory-startup -noaudio -P bench/cycles_scenes.py -- "$scene" "$to" "$samples" "$first" "$last" "${@:6}" >"$to.log" 2>&1 ||
        { tail -3 "$to.log" >&2 && exit 1; }
}

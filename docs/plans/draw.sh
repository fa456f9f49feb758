#!/usr/bin/env bash
# Draws the pictures of how_a_frame_runs.md anew, from what the headers plan. Needs Graphviz (apt install graphviz).
set -euo pipefail
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${CXX:-g++}" -std=c++20 -I../../include draw.cpp -o "$folder/draw"
"$folder/draw" .
for plan in *.dot; do dot -Tsvg "$plan" -o "${plan%.dot}.svg"; done

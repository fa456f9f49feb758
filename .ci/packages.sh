#!/usr/bin/env bash
# shellcheck disable=SC2034 # the lists are for the scripts that source this
# For scripts to source: installs what they need on a fresh Debian or Ubuntu machine.

build_packages=(g++ cmake ninja-build)
library_packages=(libglm-dev libxsimd-dev libtbb-dev)
program_packages=(libembree-dev libopenexr-dev libtinygltf-dev libstb-dev libcli11-dev nlohmann-json3-dev libpng-dev zlib1g-dev)
test_packages=(doctest-dev libbenchmark-dev clang)

# need_packages package...: installs those that are missing, or names them and ends the script with status 2.
need_packages() {
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        # Another system knows them by other names; CMake says which it does not find.
        [ -n "${QUELL_PACKAGES_INSTALLED:-}" ] && return
        echo "This system has no apt. Install what Debian calls $*, then set QUELL_PACKAGES_INSTALLED=1 and run this again." >&2
        exit 2
    fi
    local package missing=()
    for package in "$@"; do
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] && return
    install_packages "${missing[@]}"
}

install_packages() {
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "Missing packages, and neither root nor sudo to install them. As root: apt-get install $*" >&2
            exit 2
        fi
        as_root=(sudo)
    fi
    echo "Installing $*"
    "${as_root[@]}" apt-get update -q &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y "$@" && return
    echo "apt could not install all of: $*. See its message above." >&2
    exit 2
}

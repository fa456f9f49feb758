#!/usr/bin/env bash
# shellcheck disable=SC2034 # the lists are for the scripts that source this
# For scripts to source: installs what they need on a fresh Debian or Ubuntu machine. The names hold from Debian 12 and Ubuntu 22.04 on;
# libembree-dev is Embree 3 in Debian 12, Embree 4 in Ubuntu 24.04 and Debian 13, and either will do.

build_packages=(g++ cmake ninja-build)
library_packages=(libglm-dev libxsimd-dev libtbb-dev)
program_packages=(libembree-dev libopenexr-dev libtinygltf-dev libstb-dev libcli11-dev libfmt-dev nlohmann-json3-dev libpng-dev zlib1g-dev)
python_packages=(python3-dev python3-numpy python3-pip python3-setuptools python3-wheel pybind11-dev python3-pybind11)
test_packages=(doctest-dev libbenchmark-dev clang doxygen cmark-gfm python3 pkgconf dpkg-dev file)

# oldest_version package: the oldest one that will do. Ubuntu 22.04 has xsimd 7 and OpenEXR 2, with other interfaces.
oldest_version() {
    case $1 in
    cmake) echo 3.22 ;;
    libxsimd-dev) echo 8 ;;
    libtbb-dev) echo 2021 ;;
    libembree-dev | libopenexr-dev) echo 3 ;;
    *) echo 0 ;;
    esac
}

# project_of package: what to install by hand where apt has nothing that will do.
project_of() {
    case $1 in
    libglm-dev) echo "GLM (github.com/g-truc/glm)" ;;
    libxsimd-dev) echo "xsimd (github.com/xtensor-stack/xsimd)" ;;
    libtbb-dev) echo "oneTBB (github.com/uxlfoundation/oneTBB)" ;;
    libembree-dev) echo "Embree (github.com/RenderKit/embree)" ;;
    libopenexr-dev) echo "OpenEXR and Imath (github.com/AcademySoftwareFoundation/openexr)" ;;
    libtinygltf-dev) echo "tinygltf (github.com/syoyo/tinygltf)" ;;
    libstb-dev) echo "stb (github.com/nothings/stb)" ;;
    libcli11-dev) echo "CLI11 (github.com/CLIUtils/CLI11)" ;;
    libfmt-dev) echo "{fmt} (github.com/fmtlib/fmt)" ;;
    nlohmann-json3-dev) echo "JSON for Modern C++ (github.com/nlohmann/json)" ;;
    doctest-dev) echo "doctest (github.com/doctest/doctest)" ;;
    libbenchmark-dev) echo "Google Benchmark (github.com/google/benchmark)" ;;
    python3-numpy) echo "NumPy (numpy.org)" ;;
    pybind11-dev | python3-pybind11) echo "pybind11 (github.com/pybind/pybind11)" ;;
    doxygen) echo "Doxygen (doxygen.nl)" ;;
    cmark-gfm) echo "cmark-gfm (github.com/github/cmark-gfm)" ;;
    cmake) echo "CMake (cmake.org)" ;;
    *) echo "$1" ;;
    esac
}

# will_do package version: whether that version is one, and new enough.
will_do() { [ -n "$2" ] && [ "$2" != "(none)" ] && dpkg --compare-versions "$2" ge "$(oldest_version "$1")"; }

# need_packages package...: installs those that are missing, or names them and ends the script with status 2.
need_packages() {
    # Who installed them by hand says so; CMake then names what it does not find.
    [ -z "${QUELL_PACKAGES_INSTALLED:-}" ] || return 0
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        echo "This system has no apt. Install what Debian calls $*, then set QUELL_PACKAGES_INSTALLED=1 and run this again." >&2
        exit 2
    fi
    local package missing=()
    for package in "$@"; do
        will_do "$package" "$(dpkg-query -W -f='${db:Status-Status} ${Version}' "$package" 2>/dev/null | sed -n 's/^installed //p')" ||
            missing+=("$package")
    done
    [ ${#missing[@]} -eq 0 ] || install_packages "${missing[@]}"
}

# wish_for_browser: what opens pages in tests. Where it can't be had, the script goes on, and those tests are skipped.
wish_for_browser() {
    local missing=()
    command -v node >/dev/null || missing+=(nodejs)
    command -v chromium google-chrome >/dev/null || missing+=(chromium)
    [ ${#missing[@]} -gt 0 ] && [ -z "${QUELL_PACKAGES_INSTALLED:-}" ] || return 0
    # In a shell of its own, since it ends where something can't be installed.
    (without_recommended=1 install_packages "${missing[@]}" 2>/dev/null) ||
        echo "apt could not install ${missing[*]}: tests that open pages in a browser are skipped." >&2
}

# wish_for_shaders: what checks shaders and runs them where there is no GPU. Without it those tests are skipped.
wish_for_shaders() { wish_for "tests of shaders by other programs" glslang-tools spirv-tools spirv-cross libvulkan-dev mesa-vulkan-drivers; }

# wish_for_emscripten: what compiles the live page. It is large, so that only machines of continuous integration get it.
wish_for_emscripten() { [ -z "${CI:-}" ] || wish_for "tests of the live page" emscripten; }

# wish_for tests package...: packages without which those tests are skipped.
wish_for() {
    local tests=$1 package missing=()
    shift
    [ -z "${QUELL_PACKAGES_INSTALLED:-}" ] || return 0
    for package in "$@"; do
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    (without_recommended=1 install_packages "${missing[@]}" 2>/dev/null) ||
        echo "apt could not install ${missing[*]}: $tests are skipped." >&2
}

# wish_for_slurm: the farm that jobs are tested on. It brings services, so that only machines of continuous integration get it.
wish_for_slurm() {
    [ -n "${CI:-}" ] && [ -z "${QUELL_PACKAGES_INSTALLED:-}" ] && ! command -v sbatch >/dev/null || return 0
    (without_recommended=1 install_packages slurm-wlm 2>/dev/null) ||
        echo "apt could not install slurm-wlm: the test of Slurm's job is skipped." >&2
}

# wish_for_aarch64, wish_for_mingw: what compiles for another machine, and what runs its programs here. Status 1, after one line, where
# that can't be had.
wish_for_aarch64() { wish_for_target aarch64-linux-gnu-g++ qemu-aarch64 g++-aarch64-linux-gnu qemu-user; }
wish_for_mingw() { wish_for_target x86_64-w64-mingw32-g++-posix wine g++-mingw-w64-x86-64-posix wine wine64; }

# wish_for_target compiler emulator package...
wish_for_target() {
    local compiler=$1 emulator=$2
    shift 2
    has_target() { command -v "$compiler" >/dev/null && command -v "$emulator" >/dev/null; }
    has_target && return
    [ -n "${QUELL_PACKAGES_INSTALLED:-}" ] || (without_recommended=1 install_packages "$@" 2>/dev/null) || true
    has_target && return
    echo "skipped: there is no $compiler or no $emulator, and apt could not install $*" >&2
    return 1
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
    "${as_root[@]}" apt-get update -q || echo "apt could not update its lists; trying with those that it has." >&2
    check_candidates "$@"
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y ${without_recommended:+--no-install-recommends} "$@" && return
    echo "apt could not install all of: $*. See its message above." >&2
    exit 2
}

# check_candidates package...: ends the script, naming what to install by hand, where apt has no package of the name or too old a one.
check_candidates() {
    local package candidate by_hand=()
    for package in "$@"; do
        candidate=$(LC_ALL=C apt-cache policy "$package" | sed -n 's/^ *Candidate: //p')
        will_do "$package" "$candidate" && continue
        [ "$candidate" != "(none)" ] || candidate=""
        by_hand+=("$(project_of "$package")$([ "$(oldest_version "$package")" = 0 ] || echo " $(oldest_version "$package") or newer"): apt has $package ${candidate:-in no version}")
    done
    [ ${#by_hand[@]} -gt 0 ] || return 0
    echo "This distribution lacks some of what quell needs. Install by hand, where CMake finds it:" >&2
    printf '  %s\n' "${by_hand[@]}" >&2
    echo "and the rest with: apt-get install $*" >&2
    echo "Then set QUELL_PACKAGES_INSTALLED=1 and run this again." >&2
    exit 2
}

#!/usr/bin/env bash
# The presets on an NVIDIA GPU: whether they agree with Serial over 8 frames, and what they cost.
#   bench/cuda.sh build [folder]    with nvcc and without a GPU: makes folder/quell-cuda (and folder/example, the program of
#                                   docs/using.md, folder/cuda_host, and folder/quell-library, which wants oneTBB), which run on
#                                   any machine with an NVIDIA driver, and folder/kernels.txt
#   bench/cuda.sh run [folder]      on a machine with a GPU; a minute. The folder is build/cuda unless it is given.
# NVCC names another compiler, NVCC_FLAGS has more flags for it.
set -euo pipefail
command=${1:-}
folder=$(realpath -m "${2:-$(dirname "$0")/../build/cuda}")
cd "$(dirname "$0")/.."
units=2
# One PTX for all GPUs since Ampere, and machine code for Hopper. 20012: GLM marks defaulted functions for the device, which nvcc remarks
# on and ignores.
flags=(-std=c++20 --expt-relaxed-constexpr -ftz=true -prec-div=false -prec-sqrt=false -diag-suppress 20012 -Werror all-warnings -O1
    -Iinclude -Ibench -Xptxas -v
    -gencode "arch=compute_80,code=[compute_80,sm_90]" ${NVCC_FLAGS:-})
static=(-cudart static -Xcompiler -static-libstdc++ -Xcompiler -static-libgcc)

find_nvcc() {
    nvcc=${NVCC:-$(PATH=$PATH:${CUDA_PATH:-/usr/local/cuda}/bin command -v nvcc || true)}
    [ -n "$nvcc" ] || { echo "skipped: there is no nvcc; CUDA 12 or newer has it" >&2; exit 77; }
    local release
    release=$("$nvcc" --version | sed -n 's/.*release \([0-9]*\)\..*/\1/p')
    [ "${release:-0}" -ge 12 ] || { echo "skipped: $nvcc is older than CUDA 12, the first with C++20" >&2; exit 77; }
}

# compile object flags...: with its PTX beside the object.
compile() {
    local object=$1
    shift
    mkdir -p "$object.parts"
    if ! "$nvcc" "${flags[@]}" "$@" -keep -keep-dir "$object.parts" -c -o "$object" >"$object.log" 2>&1; then
        cat "$object.log"
        return 1
    fi
    cat "$object.parts"/*.ptx >"${object%.o}.ptx" 2>/dev/null || rm "${object%.o}.ptx" # a .cpp has none
    rm -r "$object.parts"
}

# The programs that docs/using.md shows.
write_examples() {
    awk -v folder="$folder" '/^```cuda$/ { file = folder "/" (++count == 1 ? "example" : "vulkan_memory") ".cu"; next }
        /^```$/ { file = "" } file != "" { print >file }' docs/using.md
}

# Registers, bytes of the stack frame and of spilled registers of each kernel, as ptxas says; the greatest where several kernels are of one
# pass. Grids behind the ingest are named "grid".
list_kernels() {
    echo "registers, stack bytes, spilled bytes per thread, pass, of sm_90:"
    sed -n "s/.*Compiling entry function '\([^']*\)'.*/name \1/p; s/.* \([0-9]*\) bytes spill stores, \([0-9]*\) bytes spill loads.*/spill \1 \2/p
        s/.*Used \([0-9]*\) registers.*, \([0-9]*\) bytes cumulative stack.*/used \1 \2/p
        s/.*Used \([0-9]*\) registers.*/used \1 0/p" "$@" |
        awk '$1 == "name" { name = $2; spilled = 0 } $1 == "spill" { spilled += $2 + $3 }
             $1 == "used" && name ~ /each_pixel|whole_grid/ { print $2, $3, spilled, name }' | c++filt -r |
        sed -E 's/void quell::cuda::detail::whole_grid<.*/grid/; s/void quell::cuda::detail::each_pixel<//; s/quell::cuda::(detail::)?//g
            s/^([0-9]+ [0-9]+ [0-9]+) (LateJob<)?(PassJob<)?/\1 /' |
        awk '{ depth = 0; pass = ""; text = $0; sub(/^[0-9]+ [0-9]+ [0-9]+ /, "", text)
               for (i = 1; i <= length(text); ++i) { c = substr(text, i, 1)
                   if (c == "<") ++depth; if (c == ">") --depth; if (depth < 0 || (depth == 0 && c == ",")) break; pass = pass c }
               if ($1 > registers[pass]) registers[pass] = $1; if ($2 > stack[pass]) stack[pass] = $2
               if (!(pass in spilled) || $3 > spilled[pass]) spilled[pass] = $3 }
             END { for (pass in spilled) printf "%4d %6d %6d  %s\n", registers[pass], stack[pass], spilled[pass], pass }' | sort -k4
}

build() {
    find_nvcc
    rm -rf "$folder"
    mkdir -p "$folder"
    write_examples
    # Longest first, two or more at once.
    local unit jobs
    jobs=$(nproc)
    export -f compile
    export folder nvcc
    {
        for ((unit = units - 1; unit >= 0; --unit)); do echo "unit_$unit.o -DUNIT=$unit -DUNITS=$units -Ipackaging bench/cuda/presets.cu"; done
        echo "example.o $folder/example.cu"
        echo "vulkan_memory.o $folder/vulkan_memory.cu"
        echo "cuda_host.o -Iexamples examples/cuda_host/main.cu"
        echo "library.o -Ipackaging -Ipackaging/library bench/cuda/library.cu"
        echo "quell_h.o -Ipackaging -Ipackaging/library -Iexamples bench/cuda/quell_h.cpp"
        echo "main.o bench/cuda/main.cpp"
        echo "check_layouts.o bench/cuda/check_layouts.cpp"
        echo "shifted.o tests/build/cuda/shifted.cu"
    } | QUELL_FLAGS="$(printf '%q ' "${flags[@]}")" xargs -P "$jobs" -L 1 bash -c \
        'eval "flags=($QUELL_FLAGS)"; object=$1; shift; compile "$folder/$object" "$@"' compile
    "$nvcc" "${static[@]}" "$folder"/{main,check_layouts}.o "$folder"/unit_*.o -o "$folder/quell-cuda"
    "$nvcc" "${static[@]}" "$folder/example.o" -o "$folder/example"
    "$nvcc" "${static[@]}" "$folder/cuda_host.o" -o "$folder/cuda_host"
    "$nvcc" "${static[@]}" "$folder"/{library,quell_h}.o -ltbb -o "$folder/quell-library"
    "$nvcc" "${static[@]}" "$folder"/{shifted,check_layouts}.o -o "$folder/shifted"
    list_kernels "$folder"/{unit_*,library,cuda_host}.o.log >"$folder/kernels.txt"
    rm "$folder"/*.o "$folder"/*.log
    du -h "$folder"/{quell-cuda,example}
}

case $command in
build) build ;;
run)
    [ -x "$folder/quell-cuda" ] || { echo "there is no $folder/quell-cuda: make it with bench/cuda.sh build" >&2; exit 2; }
    "$folder/quell-cuda"
    echo
    echo "The program of docs/using.md says:"
    "$folder/example"
    echo
    echo "examples/cuda_host says:"
    (cd "$folder" && for preset in general trmv; do echo "$preset:"; ./cuda_host --preset "$preset"; done)
    echo
    if ldd "$folder/quell-library" | grep -q 'not found'; then
        echo "skipped: libquell on a device, which wants oneTBB on this machine"
    else
        "$folder/quell-library"
    fi
    ;;
*) sed -n '2,7s/^# \{0,1\}//p' "bench/cuda.sh" >&2; exit 2 ;;
esac

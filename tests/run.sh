#!/usr/bin/env bash
# Installs what is missing, builds everything and tests it:
#   tests/run.sh                  g++ with the whole suite, and the kernels under sanitizers
#   tests/run.sh ci               what CI runs: clang++, threads and Windows too, in the time that CI has
#   tests/run.sh all              all steps below
#   tests/run.sh clang fuzz       these steps only
#   tests/run.sh filter gcc       one folder of tests, built and run in one step (or several: tests/run.sh filter gcc asan)
# g++ builds first. Then its tests and the other steps run two at a time, so that no core waits for the last file or test of a step; what a
# step prints is in build/STEP.log, and shown when it ends. The first that fails ends all, with its status.
set -euo pipefail
cd "$(dirname "$0")/.."
source .ci/packages.sh

all_steps=(gcc clang asan fuzz tsan aarch64 mingw cuda)
usual_steps=(gcc asan)
# Without steps that emulate or wait: Arm in qemu, fuzzing, device code by nvcc. They are run by hand before a release.
ci_steps=(gcc clang asan tsan mingw)
# The folders of tests to run, where some are named: then nothing else is built.
only=()
# What each of the other builds compiles and runs, as far as it exists: the library, and no slow programs. The clang build, at -O2, has
# whole pipelines ("same_bits", "fast_math") and what the sanitizers' builds, which are clang's too, leave out.
clang_tests=(blur execute two_units fast_math same_bits no_exceptions)
# Filters, kernels of the slow presets, and the motion sources of effects meet the sanitizers in the fuzz step.
asan_tests=(core image frame blend pipeline io metrics report)
tsan_tests=(races)
# What differs between instruction sets is packs, which "core" has, and "cross" has two whole pipelines. Kernels and stages are written on
# packs alone, and take longest to compile and run: "tests/run.sh filter pipeline aarch64" has them.
cross_tests=(core image cross)
sse2_tests=(core cross)
# With AVX2 on Windows, packs lie on the stack as calling conventions say, which executors are tested with.
avx2_tests=(core image execute cross)

all_jobs=$(nproc)
[ "$all_jobs" -gt 2 ] || all_jobs=2
jobs=$all_jobs

# existing_tests build-folder name...: those that are targets there.
existing_tests() {
    local folder=$1 targets name
    shift
    targets=$(ninja -C "$folder" -t targets all)
    for name in "$@"; do
        grep -q "^test_$name: phony" <<<"$targets" && echo "$name"
    done
    return 0
}

# build folder argument...: by as many jobs as the step may have; alone, by as many as the generator thinks right.
build() {
    local parallel=()
    [ "$jobs" -eq "$all_jobs" ] || parallel=(--parallel "$jobs")
    cmake --build "$@" "${parallel[@]}"
}
# build_and_test build-folder name...
build_and_test() {
    local folder=$1 names
    shift
    mapfile -t names < <(existing_tests "$folder" "$@")
    [ ${#names[@]} -gt 0 ] || return 0
    build "$folder" --target "${names[@]/#/test_}"
    ctest --test-dir "$folder" --output-on-failure -j "$jobs" -R "^($(IFS='|'; echo "${names[*]}"))(_shared_data)?\$"
}

build_gcc() {
    # The compiler goes by CXX, which a folder that the demo has configured already ignores: CMake would start such a folder afresh for
    # another CMAKE_CXX_COMPILER, and forget all that stands on this line.
    CXX=g++ cmake --preset release -D QUELL_LIBRARY=ON -D QUELL_PYTHON=ON
    [ ${#only[@]} -gt 0 ] || build build/release
}
# Tests that wait for a browser or a farm leave a core to others.
step_gcc_tests() {
    if [ ${#only[@]} -gt 0 ]; then
        build_and_test build/release "${only[@]}"
    else
        ctest --preset release -j "$all_jobs" 2>&1 | tee build/release/ctest.log
    fi
}
step_clang() {
    # These take longest to compile, and most of their kernels meet clang++ in the fuzz step too.
    local without="blur/layers.cpp;blur/paper_steps.cpp;blur/post_process.cpp;blur/turns.cpp;blur/two_motions.cpp"
    [ ${#only[@]} -eq 0 ] || without=
    cmake --preset release -B build/clang -D CMAKE_CXX_COMPILER=clang++ -D QUELL_TEST_WITHOUT_FILES="$without"
    build_and_test build/clang "${clang_tests[@]}"
}
# clang for these two: g++ takes four times as long to instrument kernels whose every function is inlined.
step_asan() {
    cmake --preset asan -D CMAKE_CXX_COMPILER=clang++
    build_and_test build/asan "${asan_tests[@]}"
}
# 25 seconds for each program; for longer: QUELL_FUZZ_SECONDS=600 tests/run.sh fuzz
step_fuzz() {
    cmake --preset asan -D CMAKE_CXX_COMPILER=clang++
    build build/asan --target fuzz
    # Of two cores, each program has two thirds, whether or not another step has one job.
    ctest --test-dir build/asan --output-on-failure -j $((jobs + 1)) -R '^fuzz_(exr|gltf|frames)$'
}
step_tsan() {
    cmake --preset tsan -D CMAKE_CXX_COMPILER=clang++
    build_and_test build/tsan "${tsan_tests[@]}"
}
# 64-bit Arm in qemu-user, by Debian's cross compiler.
step_aarch64() {
    cmake --preset aarch64
    build_and_test build/aarch64 "${cross_tests[@]}"
}
# 64-bit Windows in wine, with SSE2 and with AVX2.
step_mingw() {
    # A C: of its own, and not in here: it links to the whole disk, through which doxygen would look for headers.
    WINEPREFIX=$(mktemp -d)
    export WINEPREFIX
    trap 'wineserver -k 2>/dev/null || true; wineserver -w 2>/dev/null || true; rm -rf "$WINEPREFIX"' EXIT
    # Made before tests run side by side, which would each start to make it.
    WINEDEBUG=-all WINEDLLOVERRIDES="mscoree,mshtml=" wine wineboot --init
    cmake --preset mingw
    if ! grep -qw avx2 /proc/cpuinfo; then
        build_and_test build/mingw "${cross_tests[@]}"
        echo "skipped: Windows with AVX2, which this machine lacks" >&2
        return
    fi
    build_and_test build/mingw "${sse2_tests[@]}"
    cmake --preset mingw-avx2
    build_and_test build/mingw-avx2 "${avx2_tests[@]}"
}

# What can be tested of CUDA without a GPU.
step_cuda() {
    local status=0
    tests/build/cuda.sh build/cuda || status=$?
    [ "$status" = 77 ] || return "$status" # 77: without nvcc
}

# start_task number: in the background, as a group of processes that can be ended together. It writes its number and status to descriptor 3.
start_task() {
    local task=${tasks[$1]}
    # The last two may outlast all others, and then have all cores.
    if [ "$1" -lt $((${#tasks[@]} - 2)) ]; then jobs=$((all_jobs / 2)); else jobs=$all_jobs; fi
    echo "== $task begins: build/${task// /_}.log"
    (
        # shellcheck disable=SC2086 # words are steps
        run_task $task >"build/${task// /_}.log" 2>&1 </dev/null &
        status=0
        wait $! || status=$?
        echo "$1 $status" >&3
    ) &
    groups[$1]=$!
}
end_groups() {
    local group
    for group in "${groups[@]}"; do kill -- "-$group" 2>/dev/null || true; done
}
# Runs all tasks, two at a time.
run_two_at_a_time() {
    local next=0 folder number status task
    local -A began=()
    declare -gA groups=()
    trap end_groups EXIT
    folder=$(mktemp -d)
    mkfifo "$folder/ended"
    exec 3<>"$folder/ended"
    rm -r "$folder"
    mkdir -p build
    set -m # a group for each
    while [ "$next" -lt ${#tasks[@]} ] || [ ${#groups[@]} -gt 0 ]; do
        while [ "$next" -lt ${#tasks[@]} ] && [ ${#groups[@]} -lt 2 ]; do
            began[$next]=$SECONDS
            start_task "$next"
            next=$((next + 1))
        done
        read -r number status <&3
        task=${tasks[$number]}
        cat "build/${task// /_}.log"
        [ "$status" -eq 0 ] || { echo "== $task failed with status $status" >&2; exit "$status"; }
        note_time "$task" $((SECONDS - began[$number]))
        unset "groups[$number]"
    done
    set +m
    trap - EXIT
}

need_packages "${build_packages[@]}" "${library_packages[@]}" "${program_packages[@]}" "${python_packages[@]}" "${test_packages[@]}"
wish_for_browser
wish_for_shaders
wish_for_emscripten
wish_for_slurm
steps=()
left_out=
for word in "$@"; do
    if [ "$word" = all ]; then
        steps+=("${all_steps[@]}")
    elif [ "$word" = ci ]; then
        steps+=("${ci_steps[@]}")
    elif [[ " ${all_steps[*]} " == *" $word "* ]]; then
        steps+=("$word")
    elif [ -f "tests/$word/CMakeLists.txt" ]; then
        only+=("$word")
        [ "$word" != pipeline ] || only+=(many_frames) # of the same folder
    else
        echo "No step and no folder of tests '$word'; steps: ci all ${all_steps[*]}; folders: $(cd tests && echo */ | tr -d /)" >&2
        exit 2
    fi
done
if [ ${#only[@]} -gt 0 ]; then
    clang_tests=("${only[@]}") asan_tests=("${only[@]}") tsan_tests=("${only[@]}") cross_tests=("${only[@]}") sse2_tests=("${only[@]}") avx2_tests=("${only[@]}")
    [ ${#steps[@]} -gt 0 ] || steps=(gcc)
fi
[ ${#steps[@]} -gt 0 ] || steps=("${usual_steps[@]}")
has_step() { [[ " ${steps[*]} " == *" $1 "* ]]; }
# Packages are installed one after the other.
for step in aarch64 mingw; do
    ! has_step "$step" || "wish_for_$step" || left_out+=" $step "
done

# What runs side by side: the longest first, steps that share a folder one after the other.
tasks=()
for task in gcc_tests "asan fuzz" clang aarch64 cuda mingw tsan; do
    chosen=()
    for step in $task; do
        ! has_step "${step%_tests}" || [[ "$left_out" == *" $step "* ]] || chosen+=("$step")
    done
    [ ${#chosen[@]} -eq 0 ] || tasks+=("${chosen[*]}")
done

times=""
# note_time name seconds
note_time() { times+="$(printf '%-9s %4d s' "$1" "$2")"$'\n'; }
# run_task step...
run_task() {
    local step
    for step in "$@"; do
        echo "== $step"
        "step_$step"
    done
}
if has_step gcc; then
    echo "== gcc"
    started=$SECONDS
    build_gcc
    note_time gcc $((SECONDS - started))
fi
if [ ${#tasks[@]} -eq 1 ]; then
    started=$SECONDS
    # shellcheck disable=SC2086 # words are steps
    run_task ${tasks[0]}
    note_time "${tasks[0]}" $((SECONDS - started))
else
    run_two_at_a_time
fi

echo "== all steps passed"
printf '%s' "$times"
# The full suite's own summary comes last.
# What was left out for want of data or programs, a line each.
cat build/*/Testing/Temporary/LastTest.log 2>/dev/null | grep -o 'skipped: .*' | sort -u || true
[ ${#only[@]} -gt 0 ] || ! has_step gcc || sed -n '/tests passed/,$p' build/release/ctest.log

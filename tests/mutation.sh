#!/usr/bin/env bash
# Breaks kernels one line at a time, on a copy, and shows that the tests notice each:
#     tests/mutation.sh [part-of-a-name]
#     tests/mutation.sh --lines            only that every line is still there, which takes no time
# Prints a table; ends with 1 where a broken line was not noticed, with 2 where something else is wrong: a line that is no longer there,
# a break that doesn't compile, tests that fail without one. Compiles a test for each, so it is no part of tests/run.sh.
set -euo pipefail
cd "$(dirname "$0")/.."

only=${1:-}
lines_only=
[ "$only" != --lines ] || lines_only=yes only=
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -r include tests "$copy"
cp -r include "$copy/unbroken" # so that this tree may be worked in meanwhile
compiler=("${CXX:-g++}" -std=c++20 -O1 -march=native -w -D QUELL_TEST_THREADS "-I$copy/include" -Ibench)
[ -n "$lines_only" ] || "${compiler[@]}" -c "$copy/tests/main.cpp" -o "$copy/main.o"

mutants=0 survivors=0
declare -A passes_unbroken

stop() { printf 'mutation.sh: %s\n' "$1" >&2; exit 2; }

# build test: compiles tests/$test.cpp alone; a test's file stands for itself.
build() { "${compiler[@]}" "$copy/tests/$1.cpp" "$copy/main.o" -ltbb -o "$copy/test" 2>"$copy/messages"; }

check_unbroken() {
    [ -z "${passes_unbroken[$1]:-}" ] || return 0
    build "$1" || stop "tests/$1.cpp doesn't compile: $(head -n 3 "$copy/messages")"
    "$copy/test" >"$copy/messages" || stop "tests/$1.cpp fails as it is: $(tail -n 3 "$copy/messages")"
    passes_unbroken[$1]=yes
}

# break_line file pattern replacement: in the copy. The pattern is plain text.
break_line() {
    local file=$copy/include/quell/$1 content count
    content=$(<"$file")
    count=$({ grep -oF -- "$2" || true; } <<<"$content" | wc -l)
    [ "$count" = 1 ] || stop "$1 has '$2' $count times, not once: name the line that took its place"
    printf '%s\n' "${content/"$2"/"$3"}" >"$file"
}

# mutant what test file pattern replacement
mutant() {
    [[ "$1" == *"$only"* ]] || return 0
    mutants=$((mutants + 1))
    [ -n "$lines_only" ] || check_unbroken "$2"
    [ -f "$copy/tests/$2.cpp" ] || stop "there is no tests/$2.cpp"
    break_line "$3" "$4" "$5"
    if [ -n "$lines_only" ]; then
        cp "$copy/unbroken/quell/$3" "$copy/include/quell/$3"
        return 0
    fi
    build "$2" || stop "'$1' doesn't compile: $(grep -m 1 error "$copy/messages")"
    # A test that hangs has noticed.
    local verdict=noticed
    if timeout 300 "$copy/test" >"$copy/messages" 2>&1; then verdict=SURVIVES survivors=$((survivors + 1)); fi
    cp "$copy/unbroken/quell/$3" "$copy/include/quell/$3"
    printf '%-9s  %-58s  %-32s  %s\n' "$verdict" "$1" "$3" "tests/$2.cpp"
}

mutant "the sign of motion" motion/sources motion/surface_motion.hpp '{{p.x + m.x, p.y + m.y}' '{{p.x - m.x, p.y + m.y}'
mutant "uv motion's unit" motion/sources frame/motion_convention.hpp '? 0.5f : 1.f;' '? 2.f : 1.f;'
mutant "the weight of a tap between pixels" motion/sources motion/history_fetch.hpp '(i == 0 ? 1.f - u : u)' '(i == 0 ? u : 1.f - u)'
mutant "the slope in the depth test" motion/sources motion/surface_test.hpp 'z + slope_x * dx' 'z - slope_x * dx'
mutant "the image's lower border in the past" motion/sources frame/cursor/past_pixel.hpp \
    'row < Real(static_cast<float>(scope.size.height)));' 'row <= Real(static_cast<float>(scope.size.height)));'
mutant "misses find misses" motion/sources motion/surface_test.hpp 'invert(either(hit, hit_then))' 'both(hit, invert(hit))'
mutant "on which side of a mirror the image is" motion/mirror motion/reflection/mirror_motion.hpp 'height * -2.f' 'height * 2.f'
mutant "a shadow's blocker before its receiver" motion/shadow motion/shadow_motion.hpp 't >= Real(0.999f)' 't >= Real(0.f)'
mutant "the angle off the plane" blend/non_planar_falloff blend/non_planar_falloff.hpp '-0.5f / (deviation * deviation)' '-0.5f / deviation'
mutant "a clamp's upper bound" blend/policies blend/clamped.hpp 'return m + r; }, middle' 'return m + 1.1f * r; }, middle'
mutant "history that is wrong for the light of now" filter/history_bias filter/change/history_bias.hpp \
    'px[history_bias] * gain' 'px[history_bias] * 0.f'
mutant "rare bright samples that the history has seen" filter/conserving_atrous filter/change/history_bias.hpp \
    'max(max(seen, expected), Real(1e-37f))' 'max(seen, Real(1e-20f))'
mutant "light exchanged by the noise of both pixels" filter/conserving_atrous filter/conserving_atrous.hpp \
    'fma(its_noise, sigma_squared, tolerated)' 'tolerated'
mutant "regressors of a fit" filter/local_regression filter/local_regression.hpp \
    'there.x - centre.n_here.x' 'there.x'
mutant "a window as wide as there is noise" filter/local_regression filter/local_regression.hpp \
    'auto const w = clamp(root * width' 'auto const w = clamp(root * 0.f'
mutant "what is in front in the next frame" motion/invert_motion motion/invert_motion.hpp \
    'now.depth < so_far.depth * 0.95f' 'now.depth > so_far.depth * 1.05f'
mutant "frames from after run backwards" pipeline/two_sided pipeline/two_sided.hpp \
    'frame.number = -*number' 'frame.number = *number'
mutant "the cap of a history's age" blend/policies blend/running_mean.hpp \
    'accumulate(px, past, now / n)' 'accumulate(px, past, 1.f / (past[history_length] * past.validity + 1.f))'
mutant "the weight of the newest frame" blend/policies blend/exponential.hpp '(1.f - alpha)' 'alpha'
mutant "a term of the variance" blend/policies blend/variance_over_time.hpp 'off * off * alpha' 'off * off'
mutant "a distance in depth without its sign" filter/kernels filter/edge_weights.hpp 'fma(abs(neighbour[depth] - z), inverse, sum)' 'fma(neighbour[depth] - z, inverse, sum)'
mutant "the squared weights of the variance" filter/kernels filter/atrous.hpp 'w * w, noise' 'w, noise'
mutant "columns outside the image" filter/kernels filter/edge_taps.hpp 'Real(base), Real(too_far)' 'Real(base), Real(base)'
mutant "rows outside the image" filter/kernels filter/edge_taps.hpp 'below.row_inside ? 0.f : too_little' 'below.row_inside ? 0.f : 0.f'
mutant "the test for NaN behind a filter" pipeline/history filter/atrous.hpp 'return select(all_finite(v), v, centre);' 'return v;'
mutant "negative samples" pipeline/history core/light.hpp 'luminance(v) >= Real(0.f)' 'Real(0.f) == Real(0.f)'
mutant "albedo comes back" pipeline/history frame/modulation.hpp 'return a * d;' 'return a;'
mutant "the test for what is no light in a picture's factors" pipeline/composite pipeline/composite.hpp 'return select(is_light(f), f,' 'return select(Real(0.f) == Real(0.f), f,'
mutant "what a filter before Temporal does with missing samples" pipeline/stages frame/cursor/missing_mark.hpp 'select(missing, encoded(value), light)' 'light'
mutant "the length of normals" pipeline/guides frame/repair.hpp 'select(points, unit,' 'select(points, n,'
mutant "holes among missing samples" pipeline/missing pipeline/fill_holes.hpp 'select(filled, Mark::marked' 'select(invert(hole), Mark::marked'
mutant "a past that never had a sample" pipeline/stages motion/history_fetch.hpp 'then[history_length] > Real(0.f)' 'then[history_length] >= Real(0.f)'
mutant "the order of a pipeline's end: what is remembered is still read" pipeline/stages pipeline/graph/run_passes.hpp 'last.reads_remembered.size() == 0' 'last.reads_remembered.size() > 0'
mutant "blur: when a sample passes" blur/two_motions blur/trajectory/sample_trajectory.hpp 'when = time() + along;' 'when = time() - along;'
mutant "blur: motions too unlike to be of one surface" blur/two_motions blur/two_motions/pair_guide.hpp \
    'difference > unlike_by * unlike_by,' 'difference > difference,'
mutant "blur: how far the shutter's ends are soft" blur/layers blur/two_motions/pair_gather.hpp 'Real(2.f), Real(0.5f)' 'Real(2.f), Real(2.f)'
mutant "blur: what is guessed behind what moves" blur/two_motions blur/two_motions/pair_gather.hpp \
    'both(back_moves, moving)' 'both(back_moves, invert(back_moves))'
mutant "blur: what an empty part counts for" blur/part_means blur/two_motions/stratified_mean.hpp 'fma(after[i], Real(-0.5f), Real(1.f))' 'fma(after[i], Real(-0.4f), Real(1.f))'
mutant "blur: what shows of the background" blur/two_motions blur/two_motions/pair_gather.hpp 'return behind.mean(exposed);' 'return behind.mean();'
mutant "blur: how like a neighbour's sweep is" blur/layers blur/two_motions/directional_mean.hpp 'Real(-2.f), Real(2.f))' 'Real(0.f), Real(2.f))'
mutant "blur: the past of what is in front" blur/two_motions blur/two_motions/pair_history.hpp 'at_most(front_cap * min(px.shutter_now() / short_shutter, 1.f), px[foreground_sweep])' 'Real(0.f)'
mutant "blur: what of the past moves otherwise" blur/two_motions blur/path_search.hpp '- length) <= length_tolerance' '- length) >= Real(0.f)'
mutant "blur: where the past is looked for" blur/layers blur/path_search.hpp '{{p.x - v.x, p.y - v.y}' '{{p.x + v.x, p.y - v.y}'

[ "$mutants" -gt 0 ] || stop "no broken line has '$only' in its name"
[ "$survivors" = 0 ] || { echo "$survivors broken lines were not noticed" >&2; exit 1; }

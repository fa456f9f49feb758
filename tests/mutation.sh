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

# Options of the compiler for the tests of the lines that follow, behind those above: an -O, what includes or links a library.
options=()
with() { options=("$@"); }

stop() { printf 'mutation.sh: %s\n' "$1" >&2; exit 2; }

# build test: compiles tests/$test.cpp alone; a test's file stands for itself.
build() { "${compiler[@]}" "$copy/tests/$1.cpp" "$copy/main.o" "${options[@]}" -ltbb -o "$copy/test" 2>"$copy/messages"; }

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

# Links of a chain.
with -O0
mutant "sums: blocks that stick out of the frame" link/feedback_stages link/blocks.hpp '* finer < Real(width)' '* finer <= Real(width)'
mutant "sums: blocks below the frame" link/feedback_stages link/blocks.hpp '* finer < Real(height)' '* finer <= Real(height)'
mutant "sums: how large a block's blocks are" link/feedback_stages link/blocks.hpp 'finer = static_cast<float>(Px::Scope::fraction / blocks_side)' 'finer = 1.f'
mutant "sums: pixels of a block" link/feedback_stages link/frame_brightness.hpp 'pixels = pixels + weight' 'pixels = pixels + 1.f'
mutant "sums: the brightness of a black frame" link/feedback_stages link/frame_brightness.hpp 'select(mean > Real(1e-30f), mean, Real(1.f))' 'mean'
mutant "sums: rows that begin in the image" link/feedback_stages link/window.hpp 'px.x >= radius &&' 'px.x + 1 >= radius &&'
mutant "sums: rows that end in the image" link/feedback_stages link/window.hpp 'radius <= px.size().width' 'radius <= px.size().width + 1'
mutant "sums: what of a row lies in the image" link/feedback_stages link/window.hpp 'sum = add_scaled(sum, tap[channel], masked(tap.inside(), Real(1.f)))' 'sum = add_scaled(sum, tap[channel], Real(1.f))'
mutant "sums: what of a column lies in the image" link/feedback_stages link/window.hpp 'else if (tap.row_inside)' 'else if (tap.row_inside || radius > 0)'
mutant "sums: how many pixels a window has" link/feedback_stages link/window.hpp 'max(at - reach, Real(0.f)) + 1.f' 'max(at - reach, Real(1.f)) + 1.f'
mutant "residual: bright samples are limited" link/feedback_stages link/residual/residual.hpp 'min(s * per_unit, most)' 's * per_unit'
mutant "residual: the unit of light" link/feedback_stages link/residual/residual.hpp 'per_unit = 1.f / frame_brightness(px)' 'per_unit = Real(1.f)'
mutant "residual: where the picture has no sample" link/feedback_stages link/residual/residual.hpp 'invert(px.missing()), ' ''
mutant "residual: its mean square is of pixels that have a sample" link/feedback_stages link/residual/residual.hpp 'max(around.y, Real(1.f))' '49.f'
mutant "residual: from when on it is a spike" link/feedback_stages link/residual/residual.hpp '(limits.spike * limits.spike)' 'limits.spike'
mutant "residual: a spike stays in its half of the checkerboard" link/feedback_stages link/residual/residual.hpp 'int i = -radius + (radius + j) % 2;' 'int i = -radius + (radius + j + 1) % 2;'
mutant "residual: spikes outside of the image" link/feedback_stages link/residual/residual.hpp 'tap[Spikes{}], masked(tap.inside(), Real(1.f))' 'tap[Spikes{}], Real(1.f)'
mutant "residual: spikes go where there are samples" link/feedback_stages link/residual/residual.hpp 'own.w / max(sum.w, Real(1.f))' '1.f / max(sum.w, Real(1.f))'
mutant "residual: what is a checkerboard" link/feedback_stages link/checkerboard.hpp 'sum = column + row' 'sum = column'
mutant "residual: light around is never none" link/feedback_stages link/residual/residual.hpp '+ (.02f + 1e-6f);' ';'
mutant "residual: light beside the image" link/feedback_stages link/residual/residual.hpp 'masked(tap.inside(), abs(luminance(tap.signal())))' 'abs(luminance(tap.signal()))'
mutant "residual: what is a piece of like light" link/feedback_stages link/residual/residual_levels.hpp 'per_light_range = 1.f / .15f' 'per_light_range = 1.f'
mutant "residual: a half's part of the weights" link/feedback_stages link/residual/residual_levels.hpp 'scale(second, per_whole)' 'second'
mutant "residual: which half was held out" link/feedback_stages link/residual/residual_levels.hpp 'px[FirstHalf{}], px[SecondHalf{}]);' 'px[SecondHalf{}], px[FirstHalf{}]);'
mutant "residual: where no other sample tells" link/feedback_stages link/residual/residual_levels.hpp 'masked(others.w > Real(.02f)' 'masked(others.w > Real(.1f)'
mutant "residual: the logarithm of a dark pixel's light" link/feedback_stages link/residual/residual_feedback.hpp 'fma(around, Real(.05f), own)' 'fma(around, Real(.02f), own)'
mutant "residual: the square of a texture's light" link/feedback_stages link/residual/residual_feedback.hpp 'fma(its, its, texture.y)' 'texture.y + its'
mutant "residual: the halves that are set out" link/feedback_stages link/residual/residual_feedback.hpp 'select(is_second, none, residual)' 'residual'
mutant "residual: the finest band is what the next level has not" link/feedback_stages link/residual/finest_band.hpp 'px[FinestLevel{}] - smoothed(px)' 'px[FinestLevel{}]'
mutant "residual: a band's share is of held-out samples" link/feedback_stages link/residual/finest_band.hpp 'products(px, of_others, of_others)' 'products(px, band, of_others)'
mutant "residual: shares of frames with a past" link/feedback_stages link/residual/residual_feedback.hpp 'px.has_past() ? later : first' 'px.has_past() ? first : later'
mutant "residual: no level comes back more than whole" link/feedback_stages link/residual/residual_feedback.hpp 'Real(by.wide))), Real(1.f))' 'Real(by.wide))), Real(9.f))'
mutant "residual: no band comes back more than whole" link/feedback_stages link/residual/residual_feedback.hpp 'by.fine_held, Real(1.f))' 'by.fine_held, Real(9.f))'
mutant "residual: the variance is of one component" link/feedback_stages link/residual/residual_feedback.hpp 'px[MeanSquare{}] * (1.f / 3.f)' 'px[MeanSquare{}]'
mutant "residual: texture is what light varies by, not what it is" link/feedback_stages link/residual/residual_feedback.hpp 'sums.y * per_pixel - mean * mean' 'sums.y * per_pixel'
mutant "residual: how sure held-out samples are" link/feedback_stages link/residual/finest_band.hpp 'fma(sums.z, Real(2.f), Real(1e-20f))' 'fma(sums.z, Real(1.f), Real(1e-20f))'
mutant "residual: a level that is not finite" link/feedback_stages link/residual/residual_feedback.hpp 'masked(is_finite(a), share * clamp(a, -limit, limit))' 'share * clamp(a, -limit, limit)'
mutant "residual: the variance of what samples bear out" link/feedback_stages link/residual/residual_feedback.hpp 'Real(2.f / variance)' 'Real(1.f / variance)'
mutant "residual: what is known of that before samples" link/feedback_stages link/residual/residual_feedback.hpp '(sums.x / whole + doubt) / (1.f + doubt)' 'sums.x / whole / (1.f + doubt)'
mutant "residual: less where neighbours share their noise" link/feedback_stages link/residual/residual_feedback.hpp '* trust * frame_brightness(px)' '* frame_brightness(px)'
mutant "residual: what stays of the light" link/feedback_stages link/residual/residual_feedback.hpp 'min(a, a * darkest)' 'a * darkest'
mutant "residual: samples that chose a picture with history" link/residual_feedback link/residual/residual_feedback.hpp '!shares && !is_judged' '!shares'
mutant "residual: a link's frames behind others" link/residual_feedback pipeline/graph/run_passes.hpp '(frame.follows && !list.has_past)' 'false'
mutant "residual: shares between 1 and 16 samples" link/residual_feedback link/residual/residual_feedback_shares.hpp '.25f * 1.44269504f' '.2f * 1.44269504f'
mutant "residual: shares beside a history" link/residual_feedback link/residual/residual_feedback_shares.hpp 'plus(of_samples(samples), detail::between_1_and_16(samples))' 'plus(of_samples(samples), 1.f)'
mutant "residual: how far windows reach" pipeline/list_executor link/residual/residual_feedback.hpp 'farthest_tap() const { return radius; }' 'farthest_tap() const { return 0; }'
mutant "shared noise: the lesser of two directions" link/feedback_stages link/residual/shared_noise.hpp 'min(by_right, by_below)' 'by_right'
mutant "shared noise: less a window's mean" link/feedback_stages link/residual/shared_noise.hpp 's.by_below - s.here * s.below * per_pixel' 's.by_below'
mutant "shared noise: windows without noise" link/feedback_stages link/residual/shared_noise.hpp 'square > raw * 1e-5f' 'square >= Real(0.f)'
mutant "shared noise: the middle between its limits" link/feedback_stages link/residual/shared_noise.hpp '.5f * (rule.least + rule.most)' 'rule.least'
mutant "shared noise: neighbours at the right border" link/feedback_stages link/residual/shared_noise.hpp 'column < Real(right)' 'column <= Real(right)'
mutant "shared noise: the quartile of windows" link/feedback_stages link/residual/shared_noise.hpp 'sums.w * .25f' 'sums.w * .5f'
mutant "shared noise: between its limits" link/feedback_stages link/residual/shared_noise.hpp 'along(sums.x, sums.y) + along(sums.y, sums.z)' '2.f * along(sums.x, sums.z)'
mutant "repeated: what a picture lacks" link/repeated_stages link/residual/lacking.hpp 'masked(is_known, s - p)' 'masked(is_known, p - s)'
mutant "repeated: what it may lack" link/repeated_stages link/residual/lacking.hpp 'around * frame_brightness(px) * most' 'around * most'
mutant "repeated: how wide a Gaussian is" link/repeated_stages link/residual/residual_bands.hpp 'decay(.5f *' 'decay(1.f *'
mutant "repeated: how far a Gaussian goes" link/repeated_stages link/residual/residual_bands.hpp '>= 3.f * deviation' '>= 2.f * deviation'
mutant "repeated: a Gaussian at the border" link/repeated_stages link/residual/residual_bands.hpp 'inside = masked(tap.inside(), Real(1.f))' 'inside = Real(1.f)'
mutant "repeated: what a pixel has of itself in a Gaussian's mean" link/repeated_stages link/residual/residual_bands.hpp 'weights[0] * weights[0] / (whole * whole)' 'weights[0] / whole'
mutant "repeated: the middle band" link/repeated_stages link/residual/residual_bands.hpp 'finer - wider, wider' 'finer, wider'
mutant "repeated: the unit of blurs of now" link/repeated_stages link/residual/residual_bands.hpp 'per_unit = frame == Around::now ? 1.f / frame_brightness(px) : Real(1.f)' 'per_unit = Real(1.f)'
mutant "repeated: rows of an image that is moved" link/repeated_stages link/residual/new_witness.hpp 'j == 0 ? 1.f - lower_part : lower_part' 'j == 1 ? 1.f - lower_part : lower_part'
mutant "repeated: where a moved image ends" link/repeated_stages link/residual/new_witness.hpp 'column > Real(-.5f)' 'column >= Real(0.f)'
mutant "repeated: pixels beside a moved image" link/repeated_stages link/residual/new_witness.hpp 'both(x >= Real(0.f), x < width,' 'both(x >= Real(0.f), x <= width,'
mutant "repeated: what a frame around may lack" link/repeated_stages link/residual/new_witness.hpp 'limited(value, px[LightAround{}] * most)' 'limited(value, Real(1e9f))'
mutant "repeated: what is not known of a frame around" link/repeated_stages link/residual/new_witness.hpp 'both(is_inside, all_finite(value))' 'is_inside'
mutant "repeated: a residual on the screen" link/repeated_stages link/residual/new_witness.hpp 'c = on_screen(px)' 'c = b'
mutant "repeated: noise that stays on the screen" link/repeated_stages link/residual/new_witness.hpp 'of_window[4]) - alike' 'of_window[4])'
mutant "repeated: a frame that is the same" link/repeated_stages link/residual/new_witness.hpp 'ramp(alike, rule.same, rule.alike)' 'ramp(alike, rule.same, .5f * rule.alike)'
mutant "repeated: what white noise leaves of neighbours" link/repeated_stages link/residual/new_witness.hpp '- of_white) * (1.f / (1.f - of_white))' '- of_white)'
mutant "repeated: what may be common by chance" link/repeated_stages link/residual/new_witness.hpp '.4f * rule.common' '.8f * rule.common'
mutant "repeated: what counts nothing is known" link/repeated_stages link/residual/new_witness.hpp 'max(is_new * is_detail, Real(1e-6f))' '(is_new * is_detail)'
mutant "repeated: the squares of the mean frame" link/repeated_stages link/residual/repeated_residual.hpp ', mean.squares = mean.squares * part;' ';'
mutant "repeated: two frames around count as one" link/repeated_stages link/residual/repeated_residual.hpp 'min(all.known, Real(1.f))' 'all.known'
mutant "repeated: caution is in standard errors" link/repeated_stages link/residual/repeated_residual.hpp 'sqrt(of_window[1]) * caution' 'of_window[1] * caution'
mutant "repeated: residuals that are too much alike" link/repeated_stages link/residual/repeated_residual.hpp '* .98f' '* .5f'
mutant "repeated: the noise of a mean is less than that of a frame" link/repeated_stages link/residual/repeated_residual.hpp 'w = max(of_window[4], u)' 'w = u'
mutant "repeated: the share of the mean of frames around" link/repeated_stages link/residual/repeated_residual.hpp 'of_u * (1.f - b_of_v)' 'of_u * (1.f - of_v)'
mutant "repeated: surfaces that no frame around sees" link/repeated_stages link/residual/repeated_residual.hpp 'select(around.known > Real(0.f), around.known, Real(1.f))' 'around.known'
mutant "repeated: less where neighbours share their noise" link/repeated_stages link/residual/repeated_residual.hpp 'known * trust *' 'known *'
mutant "repeated: how far frames have the same noise" link/repeated_stages link/residual/repeated_residual.hpp '.w - px[Witness<frame>{}].y' '.w'
mutant "repeated: what stays of the light" link/repeated_stages link/residual/repeated_residual.hpp 'min(old, old * darkest)' 'old * darkest'
mutant "repeated: of single samples the finest band" link/repeated_residual link/residual/repeated_residual.hpp 'band == 0 ? 1.f - 1.f / samples : 1.f' '1.f'
mutant "repeated: of few samples more by chance" link/repeated_residual link/residual/repeated_residual.hpp '1.f + 2.f / few' '1.f + 0.f / few'
mutant "repeated: the frame after" link/repeated_residual link/residual/repeated_residual.hpp 'if constexpr (has_next) add.template' 'if constexpr (has_next && false) add.template'
with -O0 -Ipackaging '-DQUELL_TESTED_PRESETS="svgf"'
mutant "sums: how far blocks of neighbours reach" pipeline/farthest_tap link/residual/shared_noise.hpp 'farthest_tap = 1;' 'farthest_tap = 0;'
mutant "repeated: how far blurs reach" pipeline/farthest_tap link/residual/residual_bands.hpp 'farthest_tap = BandGaussian::most;' 'farthest_tap = 3;'

with -O1
# What stands behind a pipeline.
mutant "planes: how wide a Gaussian is" resolve/planes resolve/gaussian_blur.hpp '-0.5f * static_cast<float>(i * i)' '-1.f * static_cast<float>(i * i)'
mutant "planes: how far a Gaussian goes" resolve/planes resolve/gaussian_blur.hpp 'std::ceil(3.f * deviation)' 'std::ceil(2.f * deviation)'
mutant "planes: a Gaussian at the border" resolve/planes resolve/gaussian_blur.hpp 'whole += taps(i);' 'whole += 2.f * taps(i);'
mutant "planes: a window at the upper border" resolve/planes resolve/window_sums.hpp 'y - radius > 0 ? -radius : -y' 'y - radius > 0 ? -radius : 1 - y'
mutant "planes: how many pixels a window has" resolve/planes resolve/window_sums.hpp 'max(at - reach, Real(0.f)) + 1.f' 'max(at - reach, Real(1.f)) + 1.f'
mutant "planes: rows of an image that is moved" resolve/planes resolve/moved_image.hpp '+ lower_part * row_at(1)' '+ lower_part * row_at(0)'
mutant "planes: where a moved image ends" resolve/planes resolve/moved_image.hpp 'column > -0.5f' 'column >= 0.f'
mutant "evidence: the noise of a sample" link/evidence link/evidence/choose_by_evidence.hpp 'its - .5f * (first + second)' 'its - second'
mutant "evidence: what is known before samples" link/evidence link/evidence/choose_by_evidence.hpp 'Real(1.f / (rule.spread * rule.spread))' 'Real(1.f)'
mutant "evidence: caution counts above and below" link/evidence link/evidence/choose_by_evidence.hpp 'square = square + fma(off, off, of_own)' 'square = square + off * off'
mutant "evidence: doubt" link/evidence link/evidence/choose_by_evidence.hpp 'rule.doubt * (1.f - part(sums, Real(1.f)))' 'rule.doubt * part(sums, Real(1.f))'
mutant "evidence: how bright a bright sample may be" link/evidence link/evidence/choose_by_evidence.hpp 'min(s, bright * rule.most)' 'min(s, bright * 1e30f)'
mutant "evidence: which half a pixel is judged by" link/evidence link/evidence/choose_by_evidence.hpp 'select(is_odd, as_colour(px[SecondWithoutOdd' 'select(invert(is_odd), as_colour(px[SecondWithoutOdd'
mutant "evidence: of one half the other says nothing" link/evidence link/evidence/choose_by_evidence.hpp 'rule.both_halves ? 2.f : .5f' '2.f'
mutant "evidence: alpha stays" link/evidence link/evidence/choose_by_evidence.hpp 'c < 3 ? select' 'c < 4 ? select'
mutant "evidence: samples that share their noise" link/evidence link/evidence/choose_by_evidence.hpp 'trust * (1.f - part(sums, less))' '1.f - part(sums, less)'
mutant "evidence: which samples are held out" link/evidence link/evidence/held_out.hpp 'off * off < Real(.25f)' 'off < Real(.25f)'
mutant "evidence: a judge's history" link/by_evidence link/evidence/by_evidence.hpp 'images.learn(*from);' 'images.forget();'
mutant "evidence: the judge sees no held-out sample" link/by_evidence link/evidence/by_evidence.hpp 'hold_out(half);' 'hold_out(none_held_out);'
mutant "evidence: caution of many samples" link/evidence link/evidence/evidence.hpp 'octaves - 5.f' 'octaves - 4.f'
mutant "evidence: where one half is enough" link/evidence link/evidence/evidence.hpp 'samples < 2.f' 'samples < 9.f'
mutant "residual: bright light is no part of the limit" link/feedback_stages link/residual/residual.hpp 'light * light * 1e-4f' 'light * 1e-4f'
mutant "residual: texture counts up to a share" link/feedback_stages link/residual/residual_feedback.hpp 'Real(0.f))), Real(1.5f))' 'Real(0.f))), Real(9.f))'
mutant "residual: normals that are turned away" link/feedback_stages link/residual/residual_levels.hpp 'vec3<Real>(near_by[normal])), Real(0.f))' 'vec3<Real>(near_by[normal])), Real(-1.f))'
mutant "light given back: both parts know the samples" link/light_given_back link/light_given_back.hpp 'RepeatedResidual<Samples>{.samples = samples}' 'RepeatedResidual<Samples>{}'
mutant "colours: three surfaces" resolve/anti_alias link/colours/anti_aliased_pixel.hpp '2.f * nearest / (1.f + nearest / farthest)' '.5f * (nearest + farthest)'
mutant "kept frames: none after forget()" resolve/kept_frames resolve/kept_frames.hpp '!std::exchange(complete, false)' '!complete'
mutant "chain: a link has the shutter" pipeline/chain pipeline/stand_ins.hpp 'seen.shutter = frame.shutter' 'seen.shutter = seen.shutter'
mutant "frames from after are accumulated anew" pipeline/two_sided pipeline/two_sided.hpp 'history.after.forget();' ''
mutant "frames from after: one of another size ends them" pipeline/two_sided pipeline/two_sided.hpp 'window[i].size == frame.size' 'frame.size == frame.size'
mutant "frames from after: the variance of a single sample" pipeline/two_sided pipeline/two_sided.hpp 'select(n > Real(1.f), over_time, Real(0.f))' 'over_time'
mutant "chain: a link's camera" pipeline/chain pipeline/chain.hpp 'First::needs_camera || (Links::needs_camera || ...)' 'First::needs_camera'
mutant "unfinished: a frame that an error ends is forgotten" link/out_of_memory pipeline/unfinished.hpp 'if (history) history->forget();' ''
mutant "evidence: a gap in the numbers" link/by_evidence pipeline/stand_ins.hpp 'seen.number = frame.number' 'seen.number = seen.number'
mutant "evidence: what another judge makes of all samples" link/by_evidence link/evidence/by_evidence.hpp ': judged);' ': second);'
mutant "residual: noise counts up to a share" link/feedback_stages link/residual/residual_feedback.hpp 'Real(-2.f), Real(1.5f))' 'Real(-2.f), Real(9.f))'
mutant "colours: what goes elsewhere" resolve/anti_alias link/colours/anti_aliased_pixel.hpp '0.16f' '1.6f'
mutant "colours: the jitter of the frame before" link/anti_aliased link/colours/anti_aliased.hpp 'visit(FrameBefore{px, px.jitter_then()})' 'visit(FrameBefore{px, px.jitter_now()})'
mutant "colours: brightness whatever its sign" resolve/planes resolve/picture_brightness.hpp 'abs(light)' 'light'
mutant "agreement: noise of n samples of an edge" resolve/agreement resolve/agreement.hpp '1.6f / (n * std::sqrt(n))' '1.6f / n'
mutant "agreement: the variogram's nugget" resolve/agreement resolve/agreement.hpp 'fma(g, Real(2.f), -of_window[2])' 'fma(g, Real(1.5f), -of_window[2])'
mutant "agreement: where frames around tell nothing" resolve/agreement resolve/agreement.hpp 'half_difference<Real>(own, x, y, 2) * known' 'half_difference<Real>(own, x, y, 2) * per_square'
mutant "agreement: neighbours at the right border" resolve/agreement resolve/agreement.hpp 'masked(columns < Real(' 'masked(columns + 1.f < Real('
mutant "anti-alias: where a frame's samples lie in their pixels" resolve/anti_alias resolve/anti_alias_pass.hpp 'static_cast<float>(i % 3 - 1) + jitter.x' 'static_cast<float>(i % 3 - 1) - jitter.x'
mutant "anti-alias: where those of frames around lie" resolve/anti_alias link/colours/anti_aliased_pixel.hpp 'from.x) - frame.jitter.x' 'from.x) + frame.jitter.x'
mutant "anti-alias: the Gaussian" resolve/anti_alias link/colours/anti_aliased_pixel.hpp '-0.5f / (policy.deviation * policy.deviation)' '-0.5f / policy.deviation'
mutant "anti-alias: samples on both sides" resolve/anti_alias link/colours/anti_aliased_pixel.hpp 'weight(off - 1.f)), weight(off)' 'weight(off + 1.f)), weight(off)'
mutant "anti-alias: what goes elsewhere" resolve/anti_alias link/colours/anti_aliased_pixel.hpp 'amiss_x = fma(its.x, sign, step.x)' 'amiss_x = Real(0.f)'
mutant "anti-alias: a gap in the surface in front" resolve/anti_alias link/colours/anti_aliased_pixel.hpp 'either(found, d >= surface.behind)' 'found'
mutant "anti-alias: each surface has its light" resolve/anti_alias link/colours/anti_aliased_pixel.hpp 'select(is_here, own_light, surface.light())' 'own_light'
mutant "anti-alias: what changes by itself" resolve/anti_alias link/colours/anti_aliased_pixel.hpp 'mark * less <= surface.most * weights * more' 'mark >= Real(0.f)'
mutant "anti-alias: a pixel's own sample of many" resolve/anti_alias link/colours/anti_aliased_pixel.hpp '1.f / (weights + policy.own)' '1.f / (weights + 1.f)'
mutant "anti-alias: colours that are alike" resolve/anti_alias link/colours/seen_surface.hpp 'most - least > abs(most) * (1.f / 256.f)' 'most - least > abs(most)'
mutant "anti-alias: motion goes on from frame to frame" resolve/anti_alias link/colours/anti_aliased_pixel.hpp 'where = where + onward, step = onward;' 'step = onward;'
mutant "anti-alias: the light of a picture" link/anti_aliased link/colours/anti_aliased.hpp 'return p / c;' 'return p;'
mutant "anti-alias: a frame that does not follow" resolve/kept_frames resolve/kept_frames.hpp '*frame_number == *number + 1' '*frame_number >= *number'
mutant "resolve: a sample's place in the frame" resolve/resolved resolve/resolve_passes.hpp 'place.x * (1.f / ratio.x) - frame.jitter.x' 'place.x * (1.f / ratio.x) + frame.jitter.x'
mutant "resolve: the depth of what was hidden" resolve/resolved link/resolve/resolve_pixel.hpp 'depth <= farthest)' 'depth >= nearest)'
mutant "resolve: motion of a frame of another size" resolve/resolved resolve/resolve_passes.hpp 'visit(of(i), of(i - 1))' 'visit(of(i), of(0))'
mutant "resolve: the nearest surface's motion" resolve/resolved link/resolve/resolve_pixel.hpp 'both(inside, depth < nearest)' 'both(inside, depth > nearest)'
mutant "resolve: where no sample is near" resolve/resolved link/resolve/resolve_pixel.hpp 'fma(b - a, best, a)' 'b'
mutant "resolve: a link's samples lie off the pixels" link/resolve link/resolve/resolve.hpp '{at.x - jitter.x, at.y - jitter.y}' '{at.x, at.y}'
mutant "resolve: a link's vectors have jitter" link/resolve link/resolve/resolve.hpp 'around.vector.x + (now.x - then.x)' 'around.vector.x'
mutant "resolve: a link's first frame was nowhere before" link/resolve link/resolve/resolve.hpp 'vector{Real(1e9f), Real(1e9f)}' 'vector{Real(0.f), Real(0.f)}'
mutant "resolve: a link's sharpening at the border" link/resolve link/resolve/sharpening.hpp 'V(tap.signal()), centre)' 'V(tap.signal()), zero<V>())'
mutant "earlier: images are handed on" pipeline/earlier pipeline/graph/run_passes.hpp 'history.then.kept.find(each->later)) history.now' 'history.then.kept.find(each)) history.now'
mutant "earlier: the first frame stands for those before" pipeline/earlier pipeline/graph/run_passes.hpp '= history.now.kept[each->later]; !' '= history.now.kept[each]; !'
mutant "colours: a link's own weights" link/anti_aliased link/colours/anti_aliased.hpp 'across[dx + 1] * down[dy + 1]' 'across[1] * down[1]'
mutant "colours: a link keeps colours that light is divided by" link/anti_aliased link/colours/anti_aliased.hpp 'Demodulate{}.outward(px, splat<vec3<Real>>(Real(1.f)))' 'px[albedo]'
mutant "pipelines: jitter of a policy that checks it" link/anti_aliased pipeline/graph/check_frame.hpp 'a >= -most_jitter' 'a >= -9.f'
mutant "resolve: sharpening" resolve/resolved link/resolve/sharpening.hpp 'fma(c - mean, real_of<V>(amount), c)' 'fma(c - mean, real_of<V>(amount), mean)'
mutant "resolve: a spline's rows" resolve/resolved link/resolve/spline_interpolation.hpp 'across.at[i] * down.at[j]' 'across.at[i] * down.at[i]'

with -O0
mutant "shader: the lesser of two numbers" shader/operations shader/shader_expression.hpp 'choose(a + " < " + b, a, b)' 'choose(a + " < " + b, b, a)'
mutant "shader: a selection in WGSL" shader/operations shader/shader_expression.hpp '"select(" + other + ", " + one' '"select(" + one + ", " + other'
mutant "shader: how large a pass of a part of the size is" shader/operations shader/shader_writer.hpp 'number_text(fraction - 1)' 'number_text(fraction)'
mutant "shader: matrices lie column by column" shader/operations shader/frame_block.hpp 'm[i / 4][i % 4]' 'm[i % 4][i / 4]'
mutant "shader: rays to the right and down" shader/operations shader/frame_block.hpp 'put_vector(word + 8, r.right), put_vector(word + 12, r.down)' 'put_vector(word + 8, r.down), put_vector(word + 12, r.right)'
mutant "shader: the jitter of the frame before" shader/operations shader/frame_block.hpp 'put(jitter_then_word, camera_then.jitter.x)' 'put(jitter_then_word, camera.jitter.x)'
mutant "shader: where members of the block lie, in bytes" shader/operations shader/write_plan.hpp 'std::to_string(4 * member.word)' 'std::to_string(member.word)'
mutant "shader: both of two truth values" shader/operations shader/interpreter.hpp '(i & j) != 0' '(i | j) != 0'
mutant "shader: a shift with the sign" shader/operations shader/recorded_integer.hpp 'static_cast<Bits>(static_cast<std::int32_t>(i) >> j)' 'i >> j'
mutant "shader: a selection by a constant" shader/operations shader/recorded.hpp 'm.is_constant() && !m.constant() ? b : a' 'm.is_constant() && !m.constant() ? a : b'
mutant "shader: sums and products joined" shader/operations shader/interpreter.hpp 'joins ? quell::fma(a, b, c) : a * b + c' 'joins ? a * b + c : quell::fma(a, b, c)'
mutant "shader: the end of a loop" shader/graph shader/pass_graph.hpp 'static_cast<std::uint32_t>(i - begin)' 'static_cast<std::uint32_t>(i - begin + 1)'
mutant "shader: a loop that nothing needs" shader/graph shader/pass_graph.hpp '(is_effect(node) && is_live(node.of[0]))' 'is_effect(node)'
mutant "shader: in which loop a step stands" shader/graph shader/pass_graph.hpp 'depth > innermost ? depth : innermost' 'depth'
mutant "shader: which half of a word" shader/graph shader/pack_halves.hpp 'part == WordPart::lower ?' 'part == WordPart::upper ?'
mutant "shader: buffers in parts" shader/graph shader/shader_plan.hpp 'number % most_slots}' 'number}'
mutant "shader: how many slots a part has" shader/graph shader/shader_plan.hpp 'rest > most_slots ? most_slots : rest' 'rest > most_slots ? rest : most_slots'
mutant "shader: when a slot of the scratch is free" shader/against_serial shader/assign_planes.hpp 'return last < image.first;' 'return last <= image.first;'
mutant "shader: rows above the image" shader/against_serial shader/recorded_cursor.hpp 'dy < 0 ? row >= 0 : row < height' 'dy < 0 ? row > 0 : row < height'

with -O1
mutant "cones: the angle at which they no longer touch" radiance/cones radiance/cones.hpp '(18.f / 11.f)' '(18.f / 10.f)'
mutant "cones: axes of the ring" radiance/cones radiance/cones.hpp '0.50903696f, -0.50903696f, -0.82363910f' '-0.50903696f, 0.50903696f, -0.82363910f'
mutant "cones: normals that point down" radiance/cones radiance/cones.hpp 'select(n.z < Real(0.f), Real(-1.f), Real(1.f))' 'Real(1.f)'
mutant "cones: the nearest" radiance/cones radiance/cones.hpp 'best = select(nearer, closeness, best);' ''
mutant "cones: the part of the one in the middle" radiance/cones radiance/cones.hpp 'middle_part = 0.27728066f' 'middle_part = 0.2f'
mutant "cones: what one without samples borrows" radiance/cones radiance/cones.hpp 'max(samples(value) * 1e-3f' 'max(samples(value) * 1e-1f'
with -O0
mutant "cones: a mean's newest sample" radiance/luminance_in_cones radiance/with_cones.hpp 'mix(before, sample, result.alpha)' 'mix(sample, before, result.alpha)'
mutant "cones: luminance is kept relative to the mean" radiance/luminance_in_cones radiance/cones.hpp 'stored.at[i] * (stored.at[i + 1] * mean)' 'stored.at[i] * stored.at[i + 1]'
mutant "cones: light goes to those of now" radiance/luminance_in_cones radiance/cone_fetch.hpp 'past[cone_luminance], after = cone::transferred(before, then, now)' 'past[cone_luminance], after = before'
mutant "cones: colours of a gathered pixel" radiance/gather radiance/cone_gather.hpp '(max(mean, Real(1e-30f)) * weight)' 'max(mean, Real(1e-30f))'
mutant "cones: light that a clamp added" radiance/clamped radiance/with_cones.hpp 'added * cones.at[i + 1]' 'added'
mutant "cones: what a clamp made darker" radiance/clamped radiance/with_cones.hpp 'Real(0.f), Real(1.f)), added' 'Real(1.f), Real(1.f)), added'
mutant "cones: the nearest past that was accepted" radiance/edges radiance/cone_fetch.hpp 'both(detail::counts<Real>(then, found), distance < minimum)' 'distance < minimum'
mutant "cones: no component beyond those around" radiance/gather radiance/cone_gather.hpp 'seen.limited(shaded)' 'shaded'
mutant "cones: how much a neighbour counts" radiance/gather radiance/cone_gather.hpp 'profile[tap.column != 0] * profile[tap.row != 0]' 'profile[tap.column != 0] * profile[0]'
mutant "cones: turned light is limited to what is around" radiance/gather radiance/cone_fetch.hpp 'limited = seen.limited(turned)' 'limited = turned'
mutant "cones: a turned past counts for fewer samples" radiance/gather radiance/cone_fetch.hpp 'select(differs, min(samples, Real(1.f)), Real(1.f))' 'Real(1.f)'

with -O0 $([ -n "$lines_only" ] || pkg-config --cflags --libs OpenEXR)
mutant "files: an offset outside of the data window" io/parts io/frame_image.hpp 'return !stored || (x >= stored->x0' 'return !stored || (x >= 0'
mutant "files: depths of at most a miss" io/parts io/frame_image.hpp 'z <= names.miss_to' 'z < names.miss_to'
mutant "files: a name that several parts of a view have" io/parts io/part_names.hpp 'of_views == 1 ? of_view : nullptr' 'nullptr'
mutant "files: motion in parts of the image" io/frames io/frame_image.hpp 'C::Unit::ndc ? extent / 2.f : extent' 'C::Unit::ndc ? extent : extent'
mutant "files: motion with y up" io/frames io/frame_image.hpp 'axis == 1 && from.y' 'axis == 0 && from.y'
mutant "files: jitter that is left in" io/frames io/frame_image.hpp '"quell:jitter_previous") - jitter_in' '"quell:jitter_previous") + jitter_in'
mutant "files: motion to the next frame points there" io/frames io/frame_image.hpp 'motion.points = MotionConvention::Points::to_previous' 'motion.points = MotionConvention::Points::from_previous'
mutant "files: rays go through samples" io/frames io/frame_image.hpp '0.5f + camera->jitter.x' '0.5f - camera->jitter.x'
mutant "files: from when on a depth is a miss" io/frames io/frame_image.hpp 'z >= names.miss_from' 'z > names.miss_from'
mutant "files: the right end of a data window" io/foreign io/exr_file.hpp 'clip(data.max.x, display.min.x - 1, width)' 'clip(data.max.x, display.min.x, width)'
mutant "files: rows of a data window" io/foreign io/exr_file.hpp 'std::int64_t(y) + display.min.y - data.min.y' 'std::int64_t(y) + display.min.y'
mutant "files: numbers that a float does not hold" io/foreign io/exr_file.hpp 'exact && static_cast<std::int64_t>(numbers.back()) ==' 'exact && static_cast<std::int64_t>(id) =='
mutant "files: how large a picture may be" io/bad_input io/exr_file.hpp 'height <= max_pixels && width * height <= max_pixels' 'height <= max_pixels'
mutant "files: the order of bytes" io/bad_input io/exr/exr_header_check.hpp 'std::size_t i = 4; i-- > 0;' 'std::size_t i = 0; i < 4; ++i'
mutant "files: whole numbers alone are whole" io/bad_input io/write_exr.hpp '&& value == static_cast<float>(static_cast<std::uint32_t>(value))' ''
mutant "files: the sign of infinity" io/round_trip io/write_exr.hpp '(bits >> 16) & 0x8000u' '(bits >> 16) & 0u'
mutant "files: a matrix has its rows" io/round_trip io/exr/exr_attributes.hpp 'result[i][j] = static_cast<float>(m.x[i][j])' 'result[j][i] = static_cast<float>(m.x[i][j])'
mutant "files: the other eye" io/views io/file_views.hpp 'names[0] == "left" ? "right" : "left"' 'names[0] == "right" ? "right" : "left"'
mutant "files: layers whose name begins as another's" io/views io/file_views.hpp 'prefix.size() > longest.size()' 'longest.empty()'
mutant "files: parts that are views" io/views io/file_views.hpp 'complete < 2 ? layers_of(whole) : found' 'complete < 3 ? layers_of(whole) : found'
mutant "files: Blender's motion to the next frame" io/cycles io/sequence_names.hpp 'source.scale = -1.f' 'source.scale = 1.f'
mutant "files: the sky of a half" io/cycles io/sequence_names.hpp 'depth->type == SampleType::half ? 65504.f : 1e9f' '1e9f'
mutant "files: the y of a vector" io/copy io/exr/packing_loss.hpp 'return has("X") || (' 'return false || ('
mutant "files: where new numbers lie on the canvas" io/copy io/exr/copied_part.hpp '(data.x0 - canvas.x0)' '(canvas.x0 - data.x0)'
mutant "files: the far corner of all parts" io/copy io/exr/exr_original.hpp 'std::max(all.y1, data.y1)' 'all.y1'
mutant "files: light that packing made infinite" io/copy io/exr/packing_loss.hpp 'is_finite(light[i]) && !is_finite(packed[i])' '!is_finite(light[i]) && !is_finite(packed[i])'

[ "$mutants" -gt 0 ] || stop "no broken line has '$only' in its name"
[ "$survivors" = 0 ] || { echo "$survivors broken lines were not noticed" >&2; exit 1; }

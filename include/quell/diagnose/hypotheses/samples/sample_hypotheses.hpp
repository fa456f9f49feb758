#pragma once

#include <quell/diagnose/noise.hpp>

#include <cmath>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Luminance as quell computes it; of any components but three, their mean.
inline float input_luminance(SignalSeen const& signal, int x, int y) {
    if (signal.components == 3) return luminance(glm::vec3(signal.input(0, x, y), signal.input(1, x, y), signal.input(2, x, y)));
    float sum = 0;
    for (int c = 0; c < signal.components; ++c) sum += signal.input(c, x, y);
    return sum / static_cast<float>(signal.components);
}

/// In every pixel: a single one shows a mistake in shading. A negative component of light is a colour outside the gamut, and none.
inline void find_bad_samples(Observation const& seen, SignalSeen const& signal, std::vector<Finding>& findings) {
    long long not_finite = 0, negative = 0;
    int first_x = 0, first_y = 0;
    for (int y = 0; y < seen.size.height; ++y)
        for (int x = 0; x < seen.size.width; ++x) {
            auto const found_before = not_finite + negative;
            int bad = 0;
            for (int c = 0; c < signal.components; ++c) bad += !is_finite(signal.input(c, x, y));
            not_finite += bad, negative += bad == 0 && input_luminance(signal, x, y) < 0.f;
            if (found_before == 0 && not_finite + negative > 0) first_x = x, first_y = y;
        }
    if (not_finite + negative == 0) return;
    findings.push_back(
        {Mistake::bad_samples,
         "'" + signal.name + "' has " + std::to_string(not_finite) + " components that are NaN or infinite and " +
             std::to_string(negative) + " pixels of negative luminance, the first at pixel (" + std::to_string(first_x) + ", " +
             std::to_string(first_y) + ")",
         "look for divisions by a probability of 0 and for roots of negative numbers where it is shaded; quell leaves them out"});
}

/// Guides that are not finite on a surface. Without depth, surfaces are unknown. find_bad_samples checks signals.
inline void find_bad_guides(Observation const& seen, std::vector<Finding>& findings) {
    if (!seen.depth) return;
    for (auto const& guide : seen.guides) {
        if (std::ranges::find(seen.of_signals, guide.name, &SignalSeen::name) != seen.of_signals.end()) continue;
        Tally bad;
        for_each_hit(seen, [&](int x, int y) {
            bool good = true;
            for (int c = 0; c < guide.components; ++c) good = good && is_finite(guide.image(c, x, y));
            bad.add(!good);
        });
        if (bad.share() > guide.allowed)
            findings.push_back({Mistake::bad_guides,
                                "'" + guide.name + "' is NaN or infinite in " + percent(bad.share()) + " of the surface pixels",
                                "fill the channel wherever depth is finite"});
    }
}

/// The signal at the sampled pixels.
inline std::vector<float> values_of(Observation const& seen, SignalSeen const& signal, Lookup const& image) {
    std::vector<float> values;
    for_each_place(seen.size, [&](int x, int y) {
        for (int c = 0; c < signal.components; ++c) values.push_back(image(c, x, y));
    });
    return values;
}

/// Identical noise: the renderer made no new frame, or reuses its random numbers. A signal without noise may stay the same.
inline void find_identical_frames(Observation const& seen, SignalSeen const& signal, std::vector<float> const& now,
                                  std::vector<Finding>& findings) {
    auto const same = [](float a, float b) { return bits(a) == bits(b); };
    if (!std::ranges::equal(now, signal.notes->input, same) || !looks_noisy(seen, signal)) return;
    findings.push_back({Mistake::identical_frames,
                        "'" + signal.name + "' is noisy and the last frame's, bit for bit, at all " +
                            std::to_string(now.size() / static_cast<std::size_t>(signal.components)) + " places that were looked at",
                        "give the random numbers a new seed in every frame, and fill the frame before every run()"});
}

/// Share of the last run's output that equals its input, among samples that changed since.
inline Tally unchanged_by_run(Observation const& seen, SignalSeen const& signal, std::vector<float> const& now) {
    Tally same;
    auto const& in = signal.notes->input;
    // The first frame of a history has no past to blend.
    if (!signal.has_stages || signal.blurs || !signal.output_then || in.size() != now.size() || (signal.has_past && signal.frames < 2))
        return same;
    auto const out = values_of(seen, signal, signal.output_then);
    double sum = 0.;
    for (float const value : in) sum += is_finite(value) ? static_cast<double>(std::abs(value)) : 0.;
    auto const hardly = static_cast<float>(2e-4 * sum / static_cast<double>(in.size())); // of light in any unit
    for (std::size_t i = 0; i < in.size(); ++i)
        if (is_finite(in[i]) && in[i] >= 0.f && std::abs(now[i] - in[i]) > 0.1f * in[i] + hardly)
            same.add(std::abs(out[i] - in[i]) <= 2e-3f * in[i]);
    return same;
}

/// Three consecutive runs that returned their input: a single one may be a cut that only motion tells.
inline void find_output_is_input(Observation const& seen, SignalSeen const& signal, std::vector<float> const& now,
                                 std::vector<Finding>& findings) {
    auto const same = unchanged_by_run(seen, signal, now);
    // If few values change, they are moving edges, and disoccluded pixels have no past.
    // Without noise there is nothing to remove.
    bool const idle =
        same.asked >= 100 && 5 * same.asked >= static_cast<long long>(now.size()) && same.share() >= 0.95 && looks_noisy(seen, signal);
    auto& in_a_row = signal.notes->idle_in_a_row;
    in_a_row = idle ? in_a_row + 1 : 0;
    if (in_a_row < 3) return;
    findings.push_back({Mistake::output_is_input,
                        percent(same.share()) + " of the values of '" + signal.name +
                            "' that change from frame to frame came out as they went in, in " + std::to_string(in_a_row) + " runs in a row",
                        "look at what keeps the past and the neighbours out: motion that leads nowhere, depth or normals that never match, "
                        "weights of 0"});
}

/// What the samples show by themselves.
inline void find_sample_mistakes(Observation const& seen, std::vector<Finding>& findings) {
    find_bad_guides(seen, findings);
    for (auto const& signal : seen.of_signals) {
        find_bad_samples(seen, signal, findings);
        find_identical_frames(seen, signal, values_of(seen, signal, signal.input), findings);
    }
}

/// What the last run made of its frame. Comes last, as most other mistakes cause it. Stores this frame for the next call.
inline void find_output_mistakes(Observation const& seen, std::vector<Finding>& findings) {
    bool const explained = !findings.empty();
    for (auto const& signal : seen.of_signals) {
        auto now = values_of(seen, signal, signal.input);
        if (!explained) find_output_is_input(seen, signal, now, findings);
        signal.notes->input = std::move(now);
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

#pragma once

#include <quell/diagnose/noise.hpp>

#include <cmath>

namespace quell::detail {

/// Where a pixel stands out from its neighbours: 1 brighter, -1 darker, 0 neither. Divided by albedo where the pipeline does so.
inline int standing_out(Observation const& seen, SignalSeen const& signal, int x, int y) {
    if (x < 1 || y < 1 || x + 1 >= seen.size.width || y + 1 >= seen.size.height) return 0;
    bool const divide = signal.demodulated && seen.albedo;
    auto const at = [&](int i, int j) {
        float sum = 0.f, of_albedo = 0.f;
        for (int c = 0; c < signal.components; ++c) {
            sum += signal.input(c, i, j);
            if (divide) of_albedo += seen.albedo(c, i, j);
        }
        return divide ? sum / std::max(of_albedo, 0.01f) : sum;
    };
    float const here = at(x, y), around = 0.25f * (at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1));
    if (!(std::abs(here - around) > 0.1f * std::max(here, around))) return 0;
    return here > around ? 1 : -1;
}

/// The same pixels stand out as in the last frame although other surfaces are seen in them: the noise stays on the screen. Three frames.
inline void find_repeated_noise(Observation const& seen, SignalSeen const& signal, std::vector<Finding>& findings) {
    auto& notes = *signal.notes;
    std::vector<int> noise;
    for_each_place(seen.size, [&](int x, int y) { noise.push_back(standing_out(seen, signal, x, y)); });
    auto const before = std::exchange(notes.noise, std::move(noise));
    if (!seen.motion || !seen.has_then || before.size() != notes.noise.size()) return;
    Tally same;
    std::size_t i = 0;
    for_each_place(seen.size, [&](int x, int y) {
        int const one = notes.noise[i], other = before[i];
        ++i;
        auto const moved = vec2_at(seen.motion, x, y);
        if (one != 0 && other != 0 && seen.hit(x, y) && all_finite(moved) && glm::length(moved) > 0.75f) same.add(one == other);
    });
    if (std::getenv("EDGES")) std::printf(" seed %.3f (%lld)", same.share(), same.asked);
    bool const repeats = same.asked >= 200 && same.share() > 0.65;
    notes.repeats_in_a_row = repeats ? notes.repeats_in_a_row + 1 : 0;
    if (notes.repeats_in_a_row < 3) return;
    findings.push_back({Mistake::seed_repeats,
                        "of " + std::to_string(same.asked) + " pixels of '" + signal.name +
                            "' that stand out from their neighbours in this frame and the last, and whose surface moved on, " +
                            percent(same.share()) + " do so in the same direction; without a common seed it is half of them",
                        "give the random numbers a new seed in every frame: noise that stays does not average out"});
}

} // namespace quell::detail

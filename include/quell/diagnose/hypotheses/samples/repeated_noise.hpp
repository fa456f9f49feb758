#pragma once

#include <quell/diagnose/hypotheses/samples/albedo_edges.hpp>
#include <quell/diagnose/noise.hpp>

#include <cmath>
#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Where a pixel stands out from its neighbours of the same surface: 1 brighter, -1 darker, 0 neither. Divided by albedo where the pipeline
/// does so. Edges of things stand out too, and stay where things are thin and many.
inline int standing_out(Observation const& seen, SignalSeen const& signal, int x, int y) {
    if (x < 1 || y < 1 || x + 1 >= seen.size.width || y + 1 >= seen.size.height) return 0;
    for (glm::ivec2 const at : {glm::ivec2(x - 1, y), glm::ivec2(x + 1, y), glm::ivec2(x, y - 1), glm::ivec2(x, y + 1)})
        if (!one_surface(seen, x, y, at.x, at.y)) return 0;
    bool const divide = signal.demodulated && seen.albedo;
    auto const value = [&](int i, int j) {
        float sum = 0.f, of_albedo = 0.f;
        for (int c = 0; c < signal.components; ++c) {
            sum += signal.input(c, i, j);
            if (divide) of_albedo += seen.albedo(c, i, j);
        }
        return divide ? sum / std::max(of_albedo, 0.01f) : sum;
    };
    float const here = value(x, y), around = 0.25f * (value(x - 1, y) + value(x + 1, y) + value(x, y - 1) + value(x, y + 1));
    if (!(std::abs(here - around) > 0.1f * std::max(here, around))) return 0;
    return here > around ? 1 : -1;
}

/// How often two frames agree on the pixels that stand out in both, beyond what chance makes of noise that is mostly dark or mostly bright:
/// 0 by chance, 1 always (Cohen's kappa).
struct SameSide {
    Tally same, bright_now, bright_then;

    void add(int now, int then) { same.add(now == then), bright_now.add(now > 0), bright_then.add(then > 0); }
    [[nodiscard]] double beyond_chance() const {
        double const a = bright_now.share(), b = bright_then.share(), chance = a * b + (1. - a) * (1. - b);
        return chance < 1. ? (same.share() - chance) / (1. - chance) : 0.;
    }
};

/// Where a surface of the last frame is now, if this frame's motion leads back from there.
/// @param x, y where it was
inline std::optional<glm::ivec2> moved_on(Observation const& seen, int x, int y, glm::vec2 motion) {
    auto const to = glm::ivec2(glm::round(glm::vec2(x, y) - motion));
    if (to.x < 0 || to.y < 0 || to.x >= seen.size.width || to.y >= seen.size.height) return std::nullopt;
    auto const back = vec2_at(seen.motion, to.x, to.y);
    bool const leads_back = all_finite(back) && glm::length(glm::vec2(to) + back - glm::vec2(x, y)) < 0.75f;
    return leads_back ? std::optional(to) : std::nullopt;
}

/// The same pixels stand out as in the last frame although other surfaces are seen in them, and more so than where the surfaces went to:
/// the noise stays on the screen. A texture that looks alike a little farther on does both. Three frames.
inline void find_repeated_noise(Observation const& seen, SignalSeen const& signal, std::vector<Finding>& findings) {
    auto& notes = *signal.notes;
    std::vector<int> noise;
    for_each_place(seen.size, [&](int x, int y) { noise.push_back(standing_out(seen, signal, x, y)); });
    auto const before = std::exchange(notes.noise, std::move(noise));
    if (!seen.motion || !seen.has_then || before.size() != notes.noise.size()) return;
    SameSide agreement;
    long long on_screen = 0, on_surface = 0; // where only the pixel, or only the surface, still stands out in the same direction
    std::size_t i = 0;
    for_each_place(seen.size, [&](int x, int y) {
        int const one = notes.noise[i], other = before[i];
        ++i;
        auto const moved = vec2_at(seen.motion, x, y);
        if (one == 0 || other == 0 || !seen.hit(x, y) || !all_finite(moved) || !(glm::length(moved) > 0.75f)) return;
        agreement.add(one, other);
        auto const to = moved_on(seen, x, y, moved);
        int const there = to ? standing_out(seen, signal, to->x, to->y) : 0;
        if (there != 0) on_screen += one == other && there != other, on_surface += one != other && there == other;
    });
    auto const& same = agreement.same;
    // A texture agrees as often on the surface alone as on the screen alone, noise that stays more often on the screen.
    bool const stays = agreement.beyond_chance() > 0.3 && 2 * on_screen > 3 * on_surface;
    bool const repeats = same.asked >= 150 && stays && looks_noisy(seen, signal);
    notes.repeats_in_a_row = repeats ? notes.repeats_in_a_row + 1 : 0;
    if (notes.repeats_in_a_row < 3) return;
    findings.push_back({Mistake::seed_repeats,
                        "of " + std::to_string(same.asked) + " pixels of '" + signal.name +
                            "' that stand out from their neighbours in this frame and the last, and whose surface moved on, " +
                            percent(same.share()) + " do so in the same direction, which is " + percent(agreement.beyond_chance()) +
                            " of the way from chance to always",
                        "give the random numbers a new seed in every frame: noise that stays does not average out"});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

#include "survey.hpp"

#include <glm/geometric.hpp>

#include <fmt/format.h>

#include <cmath>

namespace quell::bench {
namespace {

/// Less than this part of the pixels is nothing.
constexpr double min_share = 0.001;

std::string percent(double share) { return fmt::format("{:.1f}%", 100 * share); }

struct Look {
    FitFrame const& frame;
    std::vector<float> const& depth_before;
    float pixel_angle; ///< world units per unit of depth

    [[nodiscard]] Traces operator()(int x, int y) const {
        Traces seen;
        bool const surface_moved = moved(position, receiver_previous, x, y);
        seen.shadowed = frame[visibility].view().get(0, x, y) < 0.5f;
        seen.shadow_moves =
            seen.shadowed > 0 && (surface_moved || moved(blocker, blocker_previous, x, y) || moved(light, light_previous, x, y));
        seen.reflecting = sum(glossy, x, y) > 0;
        seen.reflection_moves = seen.reflecting > 0 && (glm::length(vector_at(motion, x, y)) > 0.25f || surface_moved ||
                                                        moved(glossy_hit, glossy_hit_previous, x, y));
        seen.lit_indirectly = sum(indirect, x, y) > 0;
        seen.uncovered = is_uncovered(x, y);
        seen.swept = glm::length(vector_at(sweep, x, y)) > 0.5f;
        return seen;
    }

private:
    [[nodiscard]] float sum(auto channel, int x, int y) const {
        auto const view = frame[channel].view();
        return view.get(0, x, y) + view.get(1, x, y) + view.get(2, x, y);
    }
    [[nodiscard]] glm::vec2 vector_at(auto channel, int x, int y) const {
        auto const view = frame[channel].view();
        return {view.get(0, x, y), view.get(1, x, y)};
    }
    /// By more than a quarter of what a pixel sees; false for points at infinity.
    [[nodiscard]] bool moved(auto now, auto before, int x, int y) const {
        auto const a = frame[now].view(), b = frame[before].view();
        glm::vec3 const way{a.get(0, x, y) - b.get(0, x, y), a.get(1, x, y) - b.get(1, x, y), a.get(2, x, y) - b.get(2, x, y)};
        return glm::length(way) > 0.25f * pixel_angle * frame[depth].view().get(0, x, y);
    }
    [[nodiscard]] bool is_uncovered(int x, int y) const {
        auto const way = vector_at(motion, x, y);
        float const from_x = std::floor(static_cast<float>(x) + 0.5f + way.x), from_y = std::floor(static_cast<float>(y) + 0.5f + way.y);
        auto const [width, height] = std::pair(frame.size.width, frame.size.height);
        if (!(from_x >= 0 && from_y >= 0 && from_x < static_cast<float>(width) && from_y < static_cast<float>(height))) return true;
        auto const i = static_cast<std::size_t>(from_y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(from_x);
        // Something far nearer was there.
        return depth_before[i] < 0.9f * frame[depth].view().get(0, x, y);
    }
};

std::vector<float> depths_of(FitFrame const& frame) {
    std::vector<float> depths;
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) depths.push_back(frame[depth].view().get(0, x, y));
    return depths;
}

void add(Traces& sum, Traces const& seen) {
    sum.shadowed += seen.shadowed, sum.shadow_moves += seen.shadow_moves;
    sum.reflecting += seen.reflecting, sum.reflection_moves += seen.reflection_moves;
    sum.lit_indirectly += seen.lit_indirectly, sum.uncovered += seen.uncovered;
    sum.swept += seen.swept;
}

Traces divided(Traces t, double by) {
    return {t.shadowed / by,       t.shadow_moves / by, t.reflecting / by, t.reflection_moves / by,
            t.lit_indirectly / by, t.uncovered / by,    t.swept / by};
}

float pixel_angle_of(FitFrame const& frame, bool has_camera) {
    float const scale = has_camera ? std::abs(frame.camera.projection[1][1]) : 2.f; // without one, half as wide as high is usual
    return 2 / (scale * static_cast<float>(frame.size.height));
}

Traces traces_of(FitSequence& sequence) {
    FitFrame frame(sequence.size);
    Traces sum;
    std::vector<float> before;
    for (auto const number : sequence.numbers) {
        sequence.load(number, frame);
        Look const look{frame, before, pixel_angle_of(frame, sequence.has_camera)};
        for (int y = 0; y < frame.size.height && !before.empty(); ++y)
            for (int x = 0; x < frame.size.width; ++x) add(sum, look(x, y));
        before = depths_of(frame);
    }
    return divided(sum, static_cast<double>(sequence.size.pixels()) * static_cast<double>(sequence.numbers.size() - 1));
}

Verdict verdict(double here, double moving, std::string const& nothing, std::string const& shows, std::string const& moves) {
    if (here < min_share) return {false, false, nothing};
    auto const there = percent(here) + " of the pixels " + shows;
    if (moving < min_share) return {true, false, there + ", and in none it " + moves + ": what follows that is left out"};
    return {true, true, there + ", and in " + percent(moving) + " it " + moves};
}

Verdict without_channels(std::set<std::string> const& channels, std::initializer_list<char const*> wanted, char const* what_for) {
    for (auto const* name : wanted)
        if (!channels.contains(name)) return {false, false, std::string("the frames have no channel '") + name + "' to " + what_for};
    return {};
}

} // namespace

std::array<Verdict, effects.size()> detail::verdicts_on(Traces const& t, std::set<std::string> const& channels) {
    constexpr auto split_off = "split it off by";
    std::array verdicts{without_channels(channels, {"visibility", "direct"}, split_off), without_channels(channels, {"glossy"}, split_off),
                        without_channels(channels, {"indirect", "albedo"}, split_off)};
    if (verdicts[0].present) verdicts[0] = verdict(t.shadowed, t.shadow_moves, "no pixel is in shadow", "are in shadow", "moves");
    if (verdicts[1].present) verdicts[1] = verdict(t.reflecting, t.reflection_moves, "no pixel reflects", "reflect", "moves");
    if (verdicts[2].present)
        verdicts[2] = verdict(t.lit_indirectly, t.uncovered, "no pixel has any", "have some", "was hidden a frame ago");
    return verdicts;
}

Verdict detail::verdict_on_blur(Traces const& t, std::set<std::string> const& channels) {
    auto const verdict = without_channels(channels, {"sweep", "time"}, "make it of");
    if (!verdict.present) return verdict;
    if (t.swept < min_share) return {false, false, "nothing moves by more than half a pixel while the shutter is open"};
    return {true, true, percent(t.swept) + " of the pixels move by more than half a pixel while the shutter is open"};
}

Survey::Survey(Traces const& traces, std::set<std::string> const& channels)
    : verdicts(detail::verdicts_on(traces, channels)), blur_verdict(detail::verdict_on_blur(traces, channels)) {
    if (!blur_verdict.present) return;
    for (auto& verdict : verdicts)
        if (verdict.present) verdict.splits = false, verdict.evidence += ", at another time in each sample";
}

Survey::Survey(FitSequence& sequence) : Survey(traces_of(sequence), sequence.channels) {}

} // namespace quell::bench

#pragma once

#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Which signal is held against which albedo.
enum class Pairing {
    as_given,
    turned, ///< the signal with its rows in the other order
    behind, ///< this frame's signal, the last frame's albedo
    ahead,  ///< the last frame's signal, this frame's albedo
    plain,  ///< as given, a pixel away from the edge on either side
};

/// How the signal follows albedo: it goes like albedo to this power. 1 where all is right.
struct Exponent {
    double value = 0., error = 0.; ///< the error is a standard one
};

/// Of some groups.
inline double exponent_without(EdgeSums const& edges, int left_out) {
    double sum = 0., weight = 0.;
    for (std::size_t strength = 0; strength < EdgeSums::strengths; ++strength) {
        EdgeSums::Sum all;
        for (int group = 0; group < EdgeSums::groups; ++group) {
            if (group == left_out) continue;
            auto const& one = edges.sums[static_cast<std::size_t>(group)][strength];
            all.bright += one.bright, all.dark += one.dark, all.logarithms += one.logarithms, all.edges += one.edges;
        }
        if (all.edges < 20 || !(all.bright > 0.) || !(all.dark > 0.)) continue;
        double const mean = all.logarithms / static_cast<double>(all.edges), w = all.logarithms * mean;
        sum += w * std::log(all.bright / all.dark) / mean, weight += w;
    }
    return weight > 0. ? sum / weight : 0.;
}
/// By leaving out one group after the other; empty if there are few edges.
inline std::optional<Exponent> exponent_of(EdgeSums const& edges) {
    if (edges.edges < 150) return std::nullopt;
    Exponent result{exponent_without(edges, -1), 0.};
    double variance = 0.;
    for (int group = 0; group < EdgeSums::groups; ++group) {
        double const off = exponent_without(edges, group) - result.value;
        variance += off * off * (EdgeSums::groups - 1.) / EdgeSums::groups;
    }
    result.error = std::sqrt(variance);
    return result;
}

/// Adds the edge of one channel between two pixels, if there is one, and if the other albedo has none.
inline void add_edge(EdgeSums& edges, int group, float albedo, float beside, float other, float other_beside, float signal,
                     float signal_beside) {
    auto const [dark, bright] = std::minmax(albedo, beside);
    auto const [low, high] = std::minmax(other, other_beside);
    if (!(dark > 0.02f) || !(bright <= 1.001f) || bright < 1.3f * dark || high > 1.05f * low + 1e-3f) return;
    if (!(signal >= 0.f) || !(signal_beside >= 0.f) || !is_finite(signal + signal_beside)) return;
    double const logarithm = std::log(static_cast<double>(bright / dark));
    auto const strength = std::min(static_cast<std::size_t>(logarithm / 0.5), std::size_t{EdgeSums::strengths - 1});
    auto& sum = edges.sums[static_cast<std::size_t>(group)][strength];
    // A single firefly must not outweigh the rest.
    if (sum.edges >= 30 && static_cast<double>(signal + signal_beside) * static_cast<double>(sum.edges) > 30. * (sum.bright + sum.dark))
        return;
    sum.bright += static_cast<double>(albedo > beside ? signal : signal_beside);
    sum.dark += static_cast<double>(albedo > beside ? signal_beside : signal);
    sum.logarithms += logarithm, ++sum.edges, ++edges.edges;
}

inline Patch patch_at(Lookup const& signal, Lookup const& albedo, int x, int y, int step) {
    Patch patch;
    glm::ivec2 const places[] = {{x, y}, {x + 1, y}, {x, y + step}};
    for (std::size_t i = 0; i < 3; ++i) {
        patch.signal[i] = vec3_at(signal, places[i].x, places[i].y);
        patch.albedo[i] = vec3_at(albedo, places[i].x, places[i].y);
    }
    return patch;
}

/// Whether two pixels show the same smooth surface, so that only albedo tells them apart.
inline bool one_surface(Observation const& seen, int x, int y, int i, int j) {
    if (!seen.depth || !seen.hit(x, y) || !seen.hit(i, j)) return false;
    float const here = seen.depth(0, x, y), there = seen.depth(0, i, j), pixels = static_cast<float>(std::abs(x - i) + std::abs(y - j));
    if (std::abs(here - there) > 0.03f * pixels * here) return false;
    return !seen.normal || glm::dot(vec3_at(seen.normal, x, y), vec3_at(seen.normal, i, j)) > 0.98f;
}

/// Whether albedo is the same in the pixels around.
inline bool is_plain(Observation const& seen, Lookup const& albedo, int x, int y) {
    if (x < 1 || y < 1 || x + 1 >= seen.size.width || y + 1 >= seen.size.height) return false;
    for (int c = 0; c < 3; ++c) {
        float const here = albedo(c, x, y), margin = 0.02f * here + 1e-3f;
        for (int j = y - 1; j <= y + 1; ++j)
            for (int i = x - 1; i <= x + 1; ++i)
                if (!(std::abs(albedo(c, i, j) - here) < margin)) return false;
    }
    return true;
}

/// Adds edges between pixels that are some way apart. A sample may lie anywhere in its pixel, and albedo be that of the centre: next to an
/// edge the signal then shows the colours of both sides. A pixel away from it, on either side, it does not.
inline void add_plain_edges(Observation const& seen, SignalSeen const& signal, Lookup const& albedo, int group, int x, int y) {
    constexpr int step = 3;
    for (glm::ivec2 const at : {glm::ivec2(x + step, y), glm::ivec2(x, y + step)}) {
        if (at.x >= seen.size.width || at.y >= seen.size.height || !one_surface(seen, x, y, at.x, at.y)) continue;
        auto const here = vec3_at(albedo, x, y), there = vec3_at(albedo, at.x, at.y);
        bool const differs = glm::any(glm::greaterThan(glm::max(here, there), 1.3f * glm::min(here, there)));
        if (!differs || !is_plain(seen, albedo, x, y) || !is_plain(seen, albedo, at.x, at.y)) continue;
        for (int c = 0; c < 3; ++c)
            add_edge(signal.notes->edges[static_cast<std::size_t>(Pairing::plain)], group, here[c], there[c], 0.f, 0.f,
                     signal.input(c, x, y), signal.input(c, at.x, at.y));
    }
}

/// Adds this frame's edges to all sums, and keeps its patches for the next one.
/// @param albedo what the signal is held against
inline void add_edges(Observation const& seen, SignalSeen const& signal, Lookup const& albedo) {
    auto& notes = *signal.notes;
    std::vector<Patch> patches;
    auto const edges = [&](Pairing pairing) -> EdgeSums& { return notes.edges[static_cast<std::size_t>(pairing)]; };
    bool const has_then = seen.has_then;
    int const height = seen.size.height;
    for_each_place(seen.size, [&](int x, int y) {
        if (x + 1 >= seen.size.width || y + 1 >= height) return;
        auto const now = patch_at(signal.input, albedo, x, y, 1), turned = patch_at(signal.input, albedo, x, height - 1 - y, -1);
        auto const count = patches.size();
        patches.push_back(now);
        auto const* const then = has_then && count < notes.patches.size() ? &notes.patches[count] : nullptr;
        int const group = static_cast<int>(count / 7 % EdgeSums::groups);
        add_plain_edges(seen, signal, albedo, group, x, y);
        for (std::size_t const i : {std::size_t{1}, std::size_t{2}}) {
            if (!one_surface(seen, x, y, x + (i == 1), y + (i == 2))) continue;
            for (int c = 0; c < 3; ++c) {
                auto const add = [&](Pairing pairing, Patch const& by, Patch const& other, Patch const& of) {
                    add_edge(edges(pairing), group, by.albedo[0][c], by.albedo[i][c], other.albedo[0][c], other.albedo[i][c],
                             of.signal[0][c], of.signal[i][c]);
                };
                Patch const none{};
                add(Pairing::as_given, now, none, now), add(Pairing::turned, now, turned, turned);
                if (then) add(Pairing::behind, *then, now, now), add(Pairing::ahead, now, *then, *then);
            }
        }
    });
    notes.patches = std::move(patches);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

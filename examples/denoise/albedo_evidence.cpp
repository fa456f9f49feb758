#include <denoise/albedo_evidence.hpp>

#include <quell/core/light.hpp>
#include <quell/core/real.hpp>

#include <algorithm>
#include <cmath>

namespace quell::examples {

namespace {

constexpr float alike = .02f;     ///< part by which albedos differ that are taken for the same: files round them
constexpr float brightest = 1e6f; ///< light, times the mean

/// What is known of a pixel.
struct Seen {
    float light; ///< luminance; -1: none that counts
    float divisor;
};

/// Light is brought to a mean near 1 by a power of two: its fourth power is a float, and its unit does not matter.
std::vector<Seen> seen_in(std::vector<glm::vec3> const& light, std::vector<glm::vec3> const& by) {
    std::vector<Seen> seen;
    double sum = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        float const divisor = luminance(by[i]);
        bool const is_usable = detail::is_light(light[i]) && is_finite(divisor) && divisor >= 0.f;
        seen.push_back({is_usable ? luminance(light[i]) : -1.f, divisor});
        if (is_usable) sum += static_cast<double>(seen.back().light);
    }
    int power = 0;
    static_cast<void>(std::frexp(sum / static_cast<double>(std::max<std::size_t>(light.size(), 1)), &power));
    for (auto& each : seen)
        if (each.light >= 0.f) each.light = std::min(std::ldexp(each.light, -power), brightest);
    return seen;
}

AlbedoEvidence of_pair(Seen const& a, Seen const& b) {
    if (a.light < 0.f || b.light < 0.f) return {};
    float const variation = .5f * (a.light - b.light) * (a.light - b.light), larger = std::max(a.divisor, b.divisor);
    if (std::abs(a.divisor - b.divisor) <= alike * larger) return {0.f, 0.f, variation};
    // Divided first: squares of small numbers are none.
    float const by_albedo = (a.light + b.light) * ((a.divisor - b.divisor) / (a.divisor + b.divisor));
    float const difference = by_albedo * (.5f * by_albedo - (a.light - b.light));
    return {difference, difference * difference, variation};
}

} // namespace

bool AlbedoDoubt::holds(AlbedoEvidence const& sum) const {
    return sum.difference > deviations * std::sqrt(sum.squared) && sum.difference > part * sum.variation;
}

std::vector<AlbedoEvidence> albedo_evidence(SurfaceLinks const& surfaces, std::vector<glm::vec3> const& light,
                                            std::vector<glm::vec3> const& by) {
    auto const seen = seen_in(light, by);
    std::vector<AlbedoEvidence> of(light.size());
    surfaces.for_each_pair([&](std::size_t pixel, std::size_t other) { of[pixel] += of_pair(seen[pixel], seen[other]); });
    return of;
}

} // namespace quell::examples

#include "sample_range.hpp"

#include <quell/core/real.hpp>
#include <quell/core/value.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quell::stability {
namespace {

/// A channel of three components, or of one in all three.
std::vector<glm::vec3> colours(io::ExrImage const& image, std::string const& channel) {
    std::string const layer = channel == "radiance" ? "" : channel + ".";
    bool const one = channel == "visibility";
    auto const &r = image[layer + (one ? "V" : "R")].values, &g = image[layer + (one ? "V" : "G")].values,
               &b = image[layer + (one ? "V" : "B")].values;
    std::vector<glm::vec3> all;
    for (std::size_t i = 0; i < r.size(); ++i) all.emplace_back(r[i], g[i], b[i]);
    return all;
}

/// docs/channels.md, bad values.
bool is_sample(glm::vec3 v) {
    for (int c = 0; c < 3; ++c)
        if (!is_finite(v[c]) || std::abs(v[c]) > 1e16f) return false;
    return luminance(v) >= 0.f;
}
/// docs/channels.md, impossible guides.
glm::vec3 repaired_albedo(glm::vec3 a) {
    for (int c = 0; c < 3; ++c)
        if (!is_finite(a[c]) || a[c] < 0.f) return glm::vec3(0);
    return glm::min(a, glm::vec3(1));
}
/// docs/channels.md, albedo.
glm::vec3 divisor(glm::vec3 a) {
    a = repaired_albedo(a);
    return luminance(a) < 0.02f ? glm::vec3(1) : glm::max(a, glm::vec3(0.02f));
}

} // namespace

void Range::add(double a) {
    low = empty ? a : std::min(low, a), high = empty ? a : std::max(high, a);
    empty = false;
}
double Range::magnitude() const { return std::max(std::abs(low), std::abs(high)); }
Range operator*(Range const& a, Range const& b) {
    Range all;
    for (double const one : {a.low, a.high})
        for (double const other : {b.low, b.high}) all.add(one * other);
    return all;
}
Range operator+(Range const& a, Range const& b) { return {a.low + b.low, a.high + b.high, false}; }

SampleRange::SampleRange(examples::Preset const& preset) {
    // The picture is direct * visibility + glossy + albedo * indirect, or a part of that; a factor with a pipeline of its own is no term.
    for (auto const& each : preset.of_signals)
        terms.push_back({each.name, each.name == "visibility" ? "direct" : each.name == "indirect" ? "albedo" : ""});
    for (auto& term : terms)
        for (auto const& other : terms)
            if (term.factor == other.signal) term.of_factor = &other;
    auto const planes = examples::denoiser_of(preset, {1, 1}, 1)->planes({});
    divides = terms[0].signal == "radiance" && std::ranges::find(planes, "albedo.R") != planes.end();
}

void SampleRange::start_over() {
    for (auto& term : terms) term.seen = {};
}

void SampleRange::see(io::ExrImage const& frame) {
    for (auto& term : terms) {
        auto const samples = colours(frame, term.signal);
        term.divisors.assign(samples.size(), glm::vec3(1));
        if (divides) std::ranges::transform(colours(frame, "albedo"), term.divisors.begin(), divisor);
        term.factors = term.divisors;
        if (!term.factor.empty() && !term.of_factor) term.factors = colours(frame, term.factor);
        for (auto& factor : term.factors) {
            if (term.factor == "albedo") factor = repaired_albedo(factor);
            if (!is_sample(factor)) factor = glm::vec3(0);
        }
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (is_sample(samples[i]))
                for (int c = 0; c < 3; ++c)
                    term.seen[static_cast<std::size_t>(c)].add(static_cast<double>(samples[i][c]) /
                                                               static_cast<double>(term.divisors[i][c]));
    }
}

Range SampleRange::possible(std::size_t pixel, std::size_t component) const {
    Range sum{0, 0, false};
    for (auto const& term : terms) {
        auto const given = static_cast<double>(term.factors[pixel][static_cast<int>(component)]);
        auto const factor = term.of_factor ? term.of_factor->seen[component] : Range{given, given, false};
        bool const is_factor = std::ranges::any_of(terms, [&](auto const& other) { return other.of_factor == &term; });
        if (!is_factor) sum = sum + term.seen[component] * factor;
    }
    return sum;
}

double SampleRange::beyond(metrics::Picture const& picture) const {
    double farthest = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            auto const range = possible(i, c);
            float const shown = picture.pixels[i][static_cast<int>(c)];
            auto const a = static_cast<double>(shown);
            double const out = std::max({range.low - a, a - range.high, 0.}) / std::max(range.magnitude(), 1e-30);
            farthest = is_finite(shown) ? std::max(farthest, out) : std::numeric_limits<double>::infinity();
        }
    return farthest;
}

} // namespace quell::stability

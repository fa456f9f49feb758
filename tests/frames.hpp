#pragma once

#include "images.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

// Sequences of frames, and ways to compare what comes out.
namespace quell::tests {

/// What the Error says that f throws.
template <class F> std::string message(F&& f) {
    try {
        f();
    } catch (Error const& e) {
        return e.what();
    }
    return "nothing thrown";
}

/// What a pipeline makes of the last of three frames of random guides and signals. `change` is called with each frame, once it is filled,
/// and its number: it sets the camera, for instance.
template <class P> std::vector<float> sequence(P const& denoise, Extent size, auto const& executor, auto&& change) {
    Frame frame{size, denoise};
    History history{size, denoise};
    std::vector<float> out;
    for (unsigned i = 0; i < 3; ++i) {
        fill_randomly(frame, i);
        change(frame, i);
        out = copy_of(run(denoise, frame, history, executor));
    }
    return out;
}
template <class P> std::vector<float> sequence(P const& denoise, Extent size, auto const& executor) {
    return sequence(denoise, size, executor, [](auto&, unsigned) {});
}

/// The greatest difference relative to max(1, |a|).
inline double difference(std::vector<float> const& a, std::vector<float> const& b) {
    REQUIRE(a.size() == b.size());
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        double const scale = std::max(1.0, std::abs(static_cast<double>(a[i])));
        double const d = std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])) / scale;
        worst = d > worst || d != d ? d : worst;
    }
    return worst;
}

inline double root_mean_square(std::vector<float> const& a, std::vector<float> const& b) {
    REQUIRE(a.size() == b.size());
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (static_cast<double>(a[i]) - b[i]) * (static_cast<double>(a[i]) - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

inline bool all_finite(std::vector<float> const& all) {
    for (float const a : all)
        if (!is_finite(a)) return false;
    return true;
}

} // namespace quell::tests

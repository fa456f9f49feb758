#pragma once

#include <cmath>
#include <numbers>

namespace quell::gauntlet {

// Sine, cosine and exponential of the standard library have other bits on other machines. These are made of sums, products and floor alone,
// and their files are compiled without joining products and sums.

inline double sine(double angle) {
    constexpr double pi = std::numbers::pi;
    double const turns = angle / pi, whole = std::floor(turns + 0.5);
    double const x = (turns - whole) * pi, square = x * x;
    double term = x, sum = x;
    for (int n = 1; n < 10; ++n) term *= -square / static_cast<double>(2 * n * (2 * n + 1)), sum += term;
    return whole / 2 == std::floor(whole / 2) ? sum : -sum;
}
inline double cosine(double angle) { return sine(angle + std::numbers::pi / 2); }

/// Of numbers up to a hundred or so.
inline double exponential(double x) {
    double const small = x / 1024;
    double term = 1, sum = 1;
    for (int n = 1; n < 8; ++n) term *= small / n, sum += term;
    for (int n = 0; n < 10; ++n) sum *= sum;
    return sum;
}

/// From 0 to 1 and smooth between two numbers.
inline double smooth_step(double from, double to, double x) {
    double const t = x <= from ? 0. : x >= to ? 1. : (x - from) / (to - from);
    return t * t * (3 - 2 * t);
}

} // namespace quell::gauntlet

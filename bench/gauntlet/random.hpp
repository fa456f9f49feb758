#pragma once

#include <cmath>
#include <cstdint>

namespace quell::gauntlet {

inline std::uint64_t mixed(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return bits ^ (bits >> 31);
}
/// From 0 to 1, without 1.
inline double fraction_of(std::uint64_t bits) { return static_cast<double>(mixed(bits) >> 11) * 0x1p-53; }

/// How the random numbers of pixels go together.
enum class Dither {
    none, ///< each has its own
    blue, ///< those of neighbours are as far from each other as they can be, so that noise has no low frequencies
};

/// Whose random numbers.
struct Draw {
    std::int64_t seed = 1, frame = 0;
    int x = 0, y = 0, sample = 0;
    Dither dither = Dither::none;
};

/// The random numbers of a sample: integers alone, so that they are the same everywhere.
class Random {
    std::uint64_t state;
    int x, y, count = 0;
    bool is_blue;

public:
    explicit Random(Draw const& of) : x(of.x), y(of.y), is_blue(of.dither == Dither::blue) {
        auto const add = [&](std::int64_t number) { state = mixed(state + 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(number)); };
        state = 0;
        add(of.seed), add(of.frame), add(of.sample);
        if (!is_blue) add(of.x), add(of.y);
    }
    /// From 0 to 1, without 1.
    double next() {
        state += 0x9e3779b97f4a7c15u;
        double const own = fraction_of(state);
        if (!is_blue) return own;
        // A lattice whose neighbours differ much (the plastic number's), moved by a number of the whole frame.
        ++count;
        double const place = 0.7548776662466927 * (x + 19 * count) + 0.5698402909980532 * (y + 7 * count) + own;
        return place - std::floor(place);
    }
};

} // namespace quell::gauntlet

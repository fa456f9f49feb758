#pragma once

#include "machine.hpp"

#include <string_view>

namespace quell::bench {

/// What one pixel of a pass costs at least: every value is moved between memory and caches once, however many taps look at it.
struct Cost {
    double operations = 0.;    ///< floating-point: + - * / sqrt min max, comparison, conversion 1, fma 2; masks, selects and bits 0
    double full_values = 0.;   ///< read or written in 32 bits whatever the storage: the frame's channels, remembered depth and normal
    double stored_values = 0.; ///< read or written in the history's storage: signal, kept and emitted channels

    double bytes(int stored_size) const { return 4. * full_values + stored_size * stored_values; }
    /// The time that no program for this machine can be under, in seconds for one pixel.
    double bound(Machine const& m, int stored_size) const;

    friend constexpr Cost operator+(Cost a, Cost b) {
        return {a.operations + b.operations, a.full_values + b.full_values, a.stored_values + b.stored_values};
    }
};

/// Of a pass, by the names under which it is reported; nothing for those of presets that nobody has counted.
Cost cost_of(std::string_view preset, std::string_view pass, bool last);

} // namespace quell::bench

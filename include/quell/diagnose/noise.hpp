#pragma once

#include <quell/diagnose/observation.hpp>
#include <quell/diagnose/statistics.hpp>

#include <algorithm>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Whether the signal is noisy in this frame. Of the pixels that differ from their four neighbours, noise makes many stand out from all
/// four; edges and textures differ on two or three sides. In the built-in scenes the share is 5% or more with noise and up to 3% without,
/// for light and for visibility, which is 0 or 1 and noisy only in penumbrae.
inline bool looks_noisy(Observation const& seen, SignalSeen const& signal) {
    auto const at = [&](int x, int y) {
        float sum = 0.f;
        for (int c = 0; c < signal.components; ++c) sum += signal.input(c, x, y);
        return sum;
    };
    Tally standing_out;
    for_each_place(seen.size, [&](int x, int y) {
        if (x < 1 || y < 1 || x + 1 >= seen.size.width || y + 1 >= seen.size.height) return;
        auto const [minimum, maximum] = std::minmax({at(x - 1, y), at(x + 1, y), at(x, y - 1), at(x, y + 1)});
        float const here = at(x, y), margin = 0.1f * std::max(here, maximum);
        if (std::max(here, maximum) - std::min(here, minimum) > margin)
            standing_out.add(here > maximum + margin || here < minimum - margin);
    });
    return standing_out.yes >= 20 && standing_out.share() > 0.04;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

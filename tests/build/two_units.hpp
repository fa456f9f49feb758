#pragma once

#include "all_headers.hpp"

/// What two translation units must agree on: addresses of what the headers define, and what they compute.
struct Seen {
    void const *channel, *table;
    float pixel;
    int width = 9;
};

Seen seen_by_other_unit();
Seen seen_by_older_unit(); ///< where there is one

/// Static on purpose: each unit has its own copy that uses its own view of the headers.
static Seen seen_here() {
    quell::Extent const size{9, 5};
    constexpr auto denoise = quell::presets::surface_clamp(quell::radiance);
    quell::Frame frame{size, denoise};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            frame[quell::radiance].set(x, y, {1.f, 0.5f, static_cast<float>(x) * 0.125f});
            frame[quell::normal].set(x, y, {0.f, 0.f, 1.f});
            frame[quell::depth].set(x, y, 2.f);
        }
    quell::History history{size, denoise};
    quell::run(denoise, frame, history);
    auto const clean = quell::run(denoise, frame, history);
    return {&quell::radiance, quell::detail::counting, clean.get(2, 7, 3)};
}

#pragma once

#include <quell/quell.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace quell::tests {

inline constexpr Extent image_size{37, 21}; // not a whole number of packs

/// Prints what does not hold, and counts it.
void check(bool holds, std::string const& what);

/// Looks from (0, 0, 0) along -z.
Camera usual_camera();

/// What presets::trmv() makes of three frames seen by this camera.
std::vector<float> images_by_trmv(Camera const& camera);
void check_presets();
void check_opt_in();

/// Fills every channel: guides as of a wall head-on that does not move, and noise from 0 to 1 in all others.
template <class F> void fill(F& frame, std::uint32_t seed) {
    for_each_channel(typename F::channels{}, [&](auto c) {
        using C = decltype(c);
        auto const view = frame[c].view();
        for (int y = 0; y < view.size.height; ++y)
            for (int x = 0; x < view.size.width; ++x)
                for (int k = 0; k < C::components; ++k) {
                    seed = seed * 1664525u + 1013904223u;
                    float const noise = static_cast<float>(seed >> 8) * 0x1p-24f;
                    if constexpr (std::is_same_v<C, Depth>)
                        view.set(k, x, y, 4.f);
                    else if constexpr (std::is_same_v<C, Normal>)
                        view.set(k, x, y, k == 2 ? 1.f : 0.f);
                    else if constexpr (std::is_same_v<C, Motion>)
                        view.set(k, x, y, 0.f);
                    else
                        view.set(k, x, y, noise);
                }
    });
    frame.camera = usual_camera();
}

/// All components of an image, row by row.
template <ImageView View> std::vector<float> copy_of(View const& view) {
    std::vector<float> all;
    for (int y = 0; y < view.size.height; ++y)
        for (int x = 0; x < view.size.width; ++x)
            for (int c = 0; c < View::components; ++c) all.push_back(view.get(c, x, y));
    return all;
}

} // namespace quell::tests

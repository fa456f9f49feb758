#pragma once

#include "../views.hpp"

#include <quell/execute/threads.hpp>
#include <quell/presets/named.hpp>

namespace quell::tests {

/// Packs, on as many threads as is said at run time: kernels are compiled once for Simd and Threads.
struct Packs {
    struct Outlined {
        [[gnu::noinline]] void for_each_pixel(Region region, auto const& job) const { Simd{}.for_each_pixel(region, job); }
    };
    int threads = 1; ///< 1: Simd
    Extent tile{};

    void for_each_pixel(Region region, auto const& job) const {
        if (threads == 1) return Outlined{}.for_each_pixel(region, job);
        Threads<Outlined>{.count = threads, .tile = tile}.for_each_pixel(region, job);
    }
};

/// Frames are seen by a camera that moves.
template <class P> std::vector<float> seen_by_moving_camera(P const& denoise, Extent size, auto const& executor) {
    return sequence(denoise, size, executor, [&](auto& frame, unsigned i) {
        frame.camera = View({0.1 * i, 1, 8}, {1, 1, 0}, size).camera();
    });
}

template <class Preset> void check_same_everywhere(Preset const& preset) {
    CAPTURE(preset.name);
    auto const denoise = Preset::usual();
    for (Extent const size : {Extent{61, 24}, Extent{16, 5}, Extent{3, 7}}) {
        CAPTURE(to_string(size));
        auto const serial = seen_by_moving_camera(denoise, size, Serial{}), simd = seen_by_moving_camera(denoise, size, Packs{});
        CHECK(all_finite(serial));
        CHECK(difference(serial, simd) < 2e-5);
        CHECK(seen_by_moving_camera(denoise, size, Packs{3, {5, 3}}) == simd);
        CHECK(seen_by_moving_camera(denoise, size, Packs{2, {256, 32}}) == simd);
    }
}

/// Presets of any signal are found to compile and run for one of one component.
template <class Preset> void check_one_component(Preset const& preset) {
    if constexpr (std::is_same_v<typename Preset::signal_type, AnySignal>) {
        CAPTURE(preset.name);
        CHECK(all_finite(seen_by_moving_camera(preset.make(visibility), {16, 5}, Serial{})));
    }
}

} // namespace quell::tests

#pragma once

#include "../threads.hpp"
#include "../views.hpp"

#include <quell/execute/outlined.hpp>
#include <quell/presets/named.hpp>

#include <support/name_list.hpp>

namespace quell::tests {

/// Calls function(preset) for each preset of a unit that is among QUELL_TESTED_PRESETS.
template <std::size_t unit, std::size_t units> void for_each_tested_preset(auto const& function) {
    for_each_preset_index<unit, units>([&](auto i) {
        constexpr auto const& preset = std::get<i>(named_presets);
        if constexpr (examples::is_chosen(QUELL_TESTED_PRESETS, preset.name)) function(preset);
    });
}

/// Frames are seen by a camera that moves.
template <class P> std::vector<float> seen_by_moving_camera(P const& denoise, Extent size, auto const& executor) {
    return sequence(denoise, size, executor, [&](auto& frame, unsigned i) {
        frame.camera = View({0.1 * i, 1, 8}, {1, 1, 0}, size).camera();
    });
}

template <class Preset> void check_same_everywhere(Preset const& preset) {
    CAPTURE(preset.name);
    // Their cones are in half: what differs in the last bit of a float may be rounded to another half.
    double const allowed = preset.name == "dual-cone" || preset.name == "trmv" ? 2e-4 : 2e-5;
    auto const denoise = Preset::usual();
    for (Extent const size : {Extent{61, 24}, Extent{16, 5}, Extent{3, 7}}) {
        CAPTURE(to_string(size));
        auto const serial = seen_by_moving_camera(denoise, size, Serial{}), simd = seen_by_moving_camera(denoise, size, Outlined<>{});
        CHECK(all_finite(serial));
        CHECK(difference(serial, simd) < allowed);
#if defined(QUELL_TEST_THREADS)
        CHECK(seen_by_moving_camera(denoise, size, Threads<Outlined<>>{.count = 3, .tile = {5, 3}}) == simd);
        CHECK(seen_by_moving_camera(denoise, size, Threads<Outlined<>>{.count = 2, .tile = {256, 32}}) == simd);
#endif
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

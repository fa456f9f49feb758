#pragma once

#include "../threads.hpp"
#include "../views.hpp"

#include <baselines/named.hpp>

#include <library/images_of_frame.hpp>
#include <library/name_list.hpp>
#include <library/own_threads.hpp>
#include <library/preset_share.hpp>

namespace quell::tests {

/// Whether QUELL_TESTED_PRESETS names a preset.
inline constexpr auto is_tested = [](auto const& preset) { return quell_library::is_chosen(QUELL_TESTED_PRESETS, preset.name); };

/// Calls function(preset) for a share of the presets that QUELL_TESTED_PRESETS names, number `unit` of `units`.
template <std::size_t unit, std::size_t units> void for_each_tested_preset(auto const& function) {
    for_each_preset_index(all_presets, [&](auto i) {
        constexpr auto const& preset = std::get<i>(all_presets);
        if constexpr (is_tested(preset))
            if constexpr (quell_library::share_of_preset<units>(i, is_tested) == unit) function(preset);
    });
}

/// Frames are seen by a camera that moves.
template <class P> std::vector<float> seen_by_moving_camera(P const& denoise, Extent size, auto const& executor) {
    return sequence(denoise, size, executor, [&](auto& frame, unsigned i) {
        frame.camera = View({0.1 * i, 1, 8}, {1, 1, 0}, size).camera();
    });
}

/// The same by the compiled preset.
template <class P>
std::vector<float> seen_by_moving_camera(quell_library::Way const& compiled, P const& denoise, Extent size, int threads) {
    quell_library::OwnThreads own(threads);
    auto const run = threads > 0 ? quell_library::OwnThreads::run : quell_library::run_here;
    auto const denoiser = compiled.make(size, {.run = run, .user = &own, .threads = 7}, {});
    Frame frame{size, denoise};
    std::vector<float> out;
    for (unsigned i = 0; i < 3; ++i) {
        fill_randomly(frame, i);
        frame.camera = View({0.1 * i, 1, 8}, {1, 1, 0}, size).camera();
        std::vector const window{quell_library::images_of(compiled, frame)};
        denoiser->run(window, quell_library::image_of(out, compiled.output_components, size));
    }
    return out;
}
/// Null where QUELL_PRESETS leaves it out.
inline quell_library::Way const* compiled_preset(std::string_view name) {
    auto const& all = quell_library::compiled_presets();
    auto const found = std::ranges::find(all, name, &quell_library::CompiledPreset::name);
    return found != all.end() ? &found->usual : nullptr;
}

template <class Preset> void check_same_everywhere(Preset const& preset) {
    CAPTURE(preset.name);
    // Their cones are in half: what differs in the last bit of a float may be rounded to another half.
    double const allowed = preset.name == "dual-cone" || preset.name == "trmv" ? 2e-4 : 2e-5;
    auto const denoise = Preset::usual();
    auto const* const compiled = compiled_preset(preset.name);
    if (!compiled) return;
    for (Extent const size : {Extent{61, 24}, Extent{16, 5}, Extent{3, 7}}) {
        CAPTURE(to_string(size));
        auto const serial = seen_by_moving_camera(denoise, size, Serial{}), simd = seen_by_moving_camera(*compiled, denoise, size, 0);
        CHECK(all_finite(serial));
        CHECK(difference(serial, simd) < allowed);
        CHECK(seen_by_moving_camera(*compiled, denoise, size, 3) == simd);
        CHECK(seen_by_moving_camera(*compiled, denoise, size, 2) == simd);
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

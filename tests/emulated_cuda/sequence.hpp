#pragma once

#include "../../bench/cuda/scene.hpp"

#include <quell/link/light_given_back.hpp>
#include <quell/link/resolve/resolve.hpp>
#include <quell/presets/anti_aliased.hpp>
#include <quell/presets/by_evidence.hpp>
#include <quell/presets/effects.hpp>

#include <string>
#include <vector>

// A sequence of frames in which everything happens that changes how a frame is run, for Serial and for Cuda.
namespace emulated_cuda {

/// What happens before a frame.
struct Step {
    int number = 0; ///< of the frame; the camera goes by it
    int width = 75, height = 43;
    bool spoiled = false; ///< holes, impossible guides
    bool forgotten = false;
};
inline std::vector<Step> const steps = {{.number = 0},
                                        {.number = 1},
                                        {.number = 2, .spoiled = true},
                                        {.number = 3},
                                        {.number = 4, .forgotten = true},
                                        {.number = 5},
                                        {.number = 6, .width = 33, .height = 70},
                                        {.number = 7, .width = 33, .height = 70, .spoiled = true},
                                        {.number = 9, .width = 33, .height = 70}, // not the next one
                                        {.number = 10},
                                        {.number = 11}};

/// What comes of a frame.
struct Result {
    std::vector<float> picture;
    long long missing = 0, repaired = 0, resets = 0;
    double suppressed = 0;
    bool operator==(Result const&) const = default;
};

/// The presets under test, by number.
template <int number> constexpr auto preset() {
    using namespace quell;
    if constexpr (number == 0) return presets::general(radiance, Demodulate{});
    if constexpr (number == 1) return presets::surface_clamp(radiance, SuppressFireflies{});
    if constexpr (number == 2) return presets::svgf(radiance, Demodulate{});
    if constexpr (number == 3) return presets::glossy();
    if constexpr (number == 4) return presets::by_evidence(presets::surface_clamp(radiance, SuppressFireflies{}));
    if constexpr (number == 5) return Chain{presets::svgf(radiance, Demodulate{}), light_given_back(radiance, 4.f)};
    if constexpr (number == 6) return presets::anti_aliased(presets::svgf(radiance, Demodulate{}), AntiAliased::of_samples(4));
    if constexpr (number == 7) return Chain{presets::svgf(radiance, Demodulate{}), Pipeline{denoised, Spatial{Resolve{}}}};
    // Those that take long to compile: preset.cpp.
    if constexpr (number == 8) return presets::shadow();
    if constexpr (number == 9) return presets::dual_cone();
    if constexpr (number == 10) return presets::final_frame(radiance, Demodulate{});
    if constexpr (number == 11) return presets::trmv();
}

template <class F> void spoil_a_part(F& frame) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    quell::for_each_channel(typename F::channels{}, [&]<class C>(C) {
        constexpr bool is_light =
            std::is_same_v<C, quell::Radiance> || std::is_same_v<C, quell::Glossy> || std::is_same_v<C, quell::Indirect>;
        for (int y = 9; y < 31; ++y)
            for (int x = 6; x < 29; ++x) {
                if constexpr (is_light) frame[C{}].set(x, y, glm::vec3(nan));
                if constexpr (std::is_same_v<C, quell::Visibility>) frame[C{}].set(x, y, nan);
            }
    });
    if constexpr (F::template has<quell::Depth>) frame[quell::depth].set(10, 3, -1.f);
    if constexpr (F::template has<quell::Normal>) frame[quell::normal].set(11, 31, glm::vec3(nan));
    if constexpr (F::template has<quell::Albedo>) frame[quell::albedo].set(12, 32, glm::vec3(2.f, 0.5f, 0.5f));
}
/// Fills a frame of the host's for a step.
template <class F> void fill(F& frame, Step const& step) {
    quell::bench::fill_frame(frame, step.number);
    frame.camera.jitter = {0.25f * static_cast<float>(step.number % 3) - 0.25f, 0.1f * static_cast<float>(step.number % 2)};
    frame.number = step.number;
    if (step.spoiled) spoil_a_part(frame);
}
template <class View> std::vector<float> components_of_picture(View const& view) {
    std::vector<float> all;
    for (int y = 0; y < view.size.height; ++y)
        for (int x = 0; x < view.size.width; ++x)
            for (int c = 0; c < View::components; ++c) all.push_back(view.get(c, x, y));
    return all;
}
template <class History, class View> Result result_of(History const& history, View const& view) {
    Result result;
    auto const counted = history.statistics();
    result.missing = counted.missing_samples, result.repaired = counted.repaired_guides.pixels;
    result.resets = counted.resets, result.suppressed = counted.suppressed;
    result.picture = components_of_picture(view);
    return result;
}

/// What Serial makes of all steps, compiled for the host. In files of their own.
template <int number, class Format = quell::Float32> std::vector<Result> results_by_serial() {
    constexpr auto denoise = preset<number>();
    std::vector<Result> all;
    quell::History history{{steps[0].width, steps[0].height}, denoise, quell::Planar<Format>{}};
    for (auto const& step : steps) {
        quell::Frame frame{{step.width, step.height}, denoise};
        fill(frame, step);
        if (step.forgotten) history.forget();
        auto const view = quell::run(denoise, frame, history, quell::Serial{});
        all.push_back(result_of(history, view));
    }
    return all;
}
std::vector<Result> by_serial(int preset);
/// Of preset 1 with a history in 16 bits.
std::vector<Result> by_serial_in_halves();
/// Of one of those that take long to compile.
template <int number> std::vector<Result> by_serial_of();

} // namespace emulated_cuda

#include <doctest/doctest.h>
#include <live/core/scenes.hpp>
#include <live/core/trace.hpp>
#include <quell/presets/general.hpp>
#include <quell/quell.hpp>

#include <algorithm>
#include <cmath>

using namespace quell;

// What a history in 16 bits costs, in the live page's scenes.
namespace {

constexpr auto denoise = presets::general(radiance, Demodulate{});
using Traced = Frame<decltype(denoise)::reads>;

live::Cameras cameras_at(int scene, int number, Extent size) {
    auto const camera = [&](int i) {
        auto orbit = live::first_orbit(scene);
        orbit.yaw += 0.004f * static_cast<float>(i);
        return live::camera_of(live::within_reach(scene, orbit), size.width, size.height);
    };
    return {camera(number), camera(std::max(0, number - 1))};
}
live::Moment moment_of(int number) { return {.time = static_cast<float>(number) / 30}; }

void trace(Traced& frame, live::Scene const& scene, live::Cameras const& cameras, live::Tracing const& tracing) {
    auto const vector = [](live::Vector a) { return glm::vec3(a.x, a.y, a.z); };
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) {
            auto const value = live::trace_pixel(scene, cameras, tracing, x, y);
            frame[radiance].set(x, y, vector(value.radiance)), frame[albedo].set(x, y, vector(value.albedo));
            frame[normal].set(x, y, vector(value.normal)), frame[depth].set(x, y, value.depth);
            frame[motion].set(x, y, glm::vec2(value.motion.x, value.motion.y));
        }
}
double rmse(auto const& picture, auto const& truth) {
    double sum = 0;
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x)
            for (int c = 0; c < 3; ++c) {
                double const off = static_cast<double>(picture.get(c, x, y)) - static_cast<double>(truth.get(c, x, y));
                sum += off * off;
            }
    return std::sqrt(sum / (3. * static_cast<double>(picture.size.pixels())));
}

} // namespace

TEST_CASE("a history in 16 bits takes little more than half of the memory, and leaves the error as it is") {
    Extent const size{128, 72};
    Traced frame{size}, reference{size};
    for (int const which : {0, 1}) {
        CAPTURE(which);
        History whole{size, denoise};
        History halves{size, denoise, Planar<Float16>{}};
        for (int i = 0; i < 24; ++i) {
            auto const scene = live::moving_scene(which, moment_of(i), moment_of(std::max(0, i - 1)));
            trace(frame, scene, cameras_at(which, i, size), {.samples = 1, .frame = static_cast<std::uint32_t>(i + 1)});
            auto const by_whole = run(denoise, frame, whole);
            auto const by_halves = run(denoise, frame, halves);
            if (i < 23) continue;
            trace(reference, scene, cameras_at(which, i, size), {.samples = 128, .frame = 1000});
            auto const truth = reference[radiance].view();
            double const error = rmse(by_whole, truth), error_in_halves = rmse(by_halves, truth);
            CHECK(error > 0.01);
            CHECK(std::abs(error_in_halves / error - 1) < 0.01);
            CHECK(halves.bytes_per_pixel() < 0.6 * whole.bytes_per_pixel());
        }
    }
}

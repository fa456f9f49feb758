#include <cuda_host/renderer.hpp>
#include <doctest/doctest.h>
#include <live/core/scenes.hpp>
#include <live/core/trace.hpp>
#include <quell/presets/effects.hpp>
#include <quell/presets/general.hpp>
#include <quell/quell.hpp>

#include <algorithm>
#include <cmath>

using namespace quell;

// The live page's scenes, denoised: with a history in 16 bits, and by the parts of their light.
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
    auto const views = frame.views(Traced::channels{});
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) live::TracedPixel(views, x, y).trace(scene, cameras, tracing);
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

namespace {

constexpr auto by_parts = presets::trmv();

/// The renderer of cuda_host, in memory of the host.
template <class P> struct OnHost {
    Extent size;
    cuda_host::Renderer<P, Planar<>> renderer;

    OnHost(P const& p, Extent s) : size(s), renderer(p, s) {}
    /// @param scene of which frame
    /// @param sample other random numbers for each
    void trace(int number, int scene, int sample = 0) {
        auto pass = renderer.trace(number, &renderer.scene_of(scene));
        pass.tracing.frame += static_cast<std::uint32_t>(1000 * sample);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) pass(at_once<float>, x, y, 1);
    }
    /// The picture that a frame shows.
    [[nodiscard]] glm::vec3 traced(int x, int y) const {
        auto const at = [&](auto channel) { return renderer[channel].get(x, y); };
        return at(direct) * at(visibility) + at(glossy) + at(albedo) * at(indirect);
    }
};

Planar<>::Image<3> image_of(Extent size, auto const& value) {
    Planar<>::Image<3> image(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) image.set(x, y, value(x, y));
    return image;
}
/// The mean of a value over many samples.
Planar<>::Image<3> mean_of(auto& host, int number, int scene, int samples, auto const& value) {
    Planar<>::Image<3> sum(host.size);
    for (int i = 1; i <= samples; ++i) {
        host.trace(number, scene, i);
        sum = image_of(host.size, [&](int x, int y) { return glm::vec3(sum.get(x, y)) + value(x, y) / static_cast<float>(samples); });
    }
    return sum;
}

} // namespace

TEST_CASE("where shadows have moved, trmv is nearer to the truth than general: the renderer of cuda_host, on a CPU") {
    Extent const size{96, 54};
    constexpr int last = 23;
    OnHost<std::remove_const_t<decltype(by_parts)>> parts{by_parts, size};
    OnHost<std::remove_const_t<decltype(denoise)>> whole{denoise, size};
    Planar<>::Image<3> by_trmv(size), by_general(size);
    for (int i = 0; i <= last; ++i) {
        parts.trace(i, i), whole.trace(i, i);
        auto const of_parts = parts.renderer.denoise(Serial{});
        auto const of_whole = whole.renderer.denoise(Simd{});
        if (i < last) continue;
        by_trmv = image_of(size, [&](int x, int y) { return of_parts.get(x, y); });
        by_general = image_of(size, [&](int x, int y) { return of_whole.get(x, y); });
    }
    auto const noisy = image_of(size, [&](int x, int y) { return parts.traced(x, y); });
    auto const picture = [&](int x, int y) { return parts.traced(x, y); };
    auto const shadow = [&](int x, int y) { return glm::vec3(parts.renderer[visibility].get(x, y)); };
    auto const truth = mean_of(parts, last, last, 256, picture);
    auto const shadows = mean_of(parts, last, last, 64, shadow), shadows_before = mean_of(parts, last, last - 4, 64, shadow);
    double noise = 0, of_trmv = 0, of_general = 0;
    int count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (std::abs(shadows.get(0, x, y) - shadows_before.get(0, x, y)) < 0.25f) continue;
            auto const error = [&](auto const& image) {
                auto const off = image.get(x, y) - truth.get(x, y);
                return static_cast<double>(glm::dot(off, off));
            };
            ++count, noise += error(noisy), of_trmv += error(by_trmv), of_general += error(by_general);
        }
    CHECK(count > 50);
    CHECK(of_trmv < 0.35 * noise);
    CHECK(of_trmv < 0.7 * of_general);
    CHECK(rmse(by_trmv.view(), truth.view()) < 0.5 * rmse(noisy.view(), truth.view()));
}

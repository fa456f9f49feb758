#include "no_exceptions.hpp"

#include <quell/diagnose/debug_images.hpp>
#include <quell/diagnose/diagnose.hpp>
#include <quell/metrics/error_map.hpp>
#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/metrics/ssim.hpp>
#include <quell/metrics/stability.hpp>
#include <quell/motion/invert_motion.hpp>
#include <quell/pipeline/two_sided.hpp>
#include <quell/presets/named.hpp>

#include <deque>

namespace quell::tests {
namespace {

constexpr auto debug = watched(presets::surface_clamp(radiance, Demodulate{}));
constexpr auto counted = Pipeline{radiance, KnownSamples{}, Temporal{SurfaceMotion{}, WithVariance{RunningMean{}}}};

void check_diagnosis() {
    Frame frame{image_size, debug};
    History history{image_size, debug};
    fill_still(frame);
    frame.camera = usual_camera();
    fill(frame[normal], [](int, int) { return glm::vec3(0.f, 0.f, 3.f); });
    check(diagnose(frame, history).size() == 1, "diagnose names normals of length 3");
    run(debug, frame, history);
    check(debug_images(debug_rejection, history).size() == 1, "a watched pipeline has a debug image");
}

void check_metrics() {
    using namespace metrics;
    Frame frame{image_size, debug};
    fill_randomly(frame, 2);
    auto const picture = displayed(picture_of(frame[radiance].view()));
    check(rmse(picture, picture) == 0., "rmse of equal pictures");
    check(ssim(picture, picture) > 0.999, "ssim of equal pictures");
    auto const difference = flip(picture, picture);
    check(difference.mean() < 1e-6, "FLIP of equal pictures");
    check(error_map(difference).pixels.size() == picture.pixels.size(), "error map");
    Flicker flicker;
    flicker.add(picture, picture), flicker.add(picture, picture);
    check(flicker.mean() == 0., "flicker of equal pictures");
}

void check_two_sided() {
    using F = decltype(Frame{image_size, TwoSided{counted}});
    std::deque<F> window;
    for (unsigned i = 0; i < 2; ++i) fill_randomly(window.emplace_back(image_size, TwoSided{counted}), i);
    invert_motion(window[0][motion_next].view(), window[1][motion].view(), window[1][depth].view());
    History history{image_size, TwoSided{counted}};
    auto const clean = run(TwoSided{counted}, window, history);
    check(is_finite(clean.get(0, 5, 5)), "two-sided time is finite");
}

} // namespace

void check_opt_in() {
    check_diagnosis();
    check_metrics();
    check_two_sided();
}

} // namespace quell::tests

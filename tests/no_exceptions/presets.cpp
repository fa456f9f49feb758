#include "no_exceptions.hpp"

#include <quell/execute/outlined.hpp>
#include <quell/presets/blur.hpp>
#if defined(QUELL_TEST_THREADS)
#include <quell/execute/threads.hpp>
#endif

#include <algorithm>
#include <iterator>

namespace quell::tests {
namespace {

template <class P> std::vector<float> images_by(P const& denoise, Camera const& camera, auto const& executor) {
    Frame frame{image_size, denoise};
    History history{image_size, denoise};
    std::vector<float> images;
    for (unsigned i = 0; i < 3; ++i) {
        fill_randomly(frame, i);
        frame.camera = camera;
        std::ranges::copy(copy_of(run(denoise, frame, history, executor)), std::back_inserter(images));
    }
    return images;
}

void check_images(std::vector<float> const& images, std::string const& preset) {
    check(std::ranges::all_of(images, [](float a) { return is_finite(a); }), preset + " is finite");
    check(std::ranges::any_of(images, [](float a) { return a > 0.f; }), preset + " is not black");
}

constexpr auto svgf = presets::svgf(radiance, Demodulate{});
constexpr auto general = presets::general(radiance, Demodulate{});
constexpr auto blur = presets::blur(radiance);

} // namespace

std::vector<float> images_by_trmv(Camera const& camera) { return images_by(presets::trmv(), camera, Outlined<>{}); }

void check_presets() {
    auto const one_thread = images_by(svgf, usual_camera(), Outlined<>{});
    check_images(one_thread, "svgf");
    check_images(images_by(general, usual_camera(), Outlined<>{}), "general");
    check_images(images_by(blur, usual_camera(), Outlined<>{}), "blur");
    check_images(images_by_trmv(usual_camera()), "trmv");
#if defined(QUELL_TEST_THREADS)
    auto const threads = images_by(svgf, usual_camera(), Threads<Outlined<>>{.count = 3, .tile = {8, 4}});
    check(threads == one_thread, "several threads make the same image");
#endif
}

} // namespace quell::tests

// Colours that libquell anti-aliases behind a preset: what the headers' link makes of what it makes without.
#include "link_pictures.hpp"

#include <quell/link/colours/anti_aliased.hpp>

#include <cmath>

using namespace wall_test;

namespace {

constexpr unsigned frames = 4;

/// A wall in two paints with a slanted edge between them, seen from other places of the pixels in each frame.
struct PaintedWall : Wall {
    quell_camera camera{};

    void look(unsigned number) {
        shine(number);
        float const x_of[] = {0.f, -.25f, .25f, -.375f}, y_of[] = {-.17f, .17f, -.39f, -.06f};
        camera.jitter[0] = x_of[number % 4], camera.jitter[1] = y_of[number % 4];
        for (std::size_t p = 0; p < pixels; ++p) {
            auto const x = static_cast<float>(p % width) + camera.jitter[0], y = static_cast<float>(p / width) + camera.jitter[1];
            bool const is_left = x + .31f * y < 30.f;
            for (std::size_t c = 0; c < 3; ++c) albedo[3 * p + c] = is_left ? .25f : .75f;
            depth[p] = y < 12.f ? 4.f : 2.f, motion[2 * p] = .3f;
        }
        frame.camera = &camera, frame.number = number, frame.has_number = 1;
    }
};
std::vector<std::vector<float>> pictures_of(quell_settings const& settings) {
    return wall_test::pictures_of<PaintedWall>(settings, frames);
}

} // namespace

TEST_CASE("colours: bit for bit what the headers make of the preset's picture, in C, on any threads") {
    using namespace quell;
    auto settings = settings_of();
    auto const plain = pictures_of(settings);
    constexpr Pipeline link{denoised, Spatial{AntiAliased::of_samples(1)}};
    auto const wanted = behind<PaintedWall>(plain, link);
    settings.stages = "colours";
    CHECK(pictures_of(settings) == wanted);
    CHECK(plain != wanted);
    for (int32_t const threads : {1, 3}) {
        settings.threads = threads;
        CHECK(pictures_of(settings) == wanted);
    }
}

TEST_CASE("colours: they need the camera's jitter, albedo, and no resolve") {
    auto settings = settings_of();
    settings.stages = "colours";
    auto const denoiser = made(settings);
    CHECK(quell_needs_camera(denoiser.get()) == 1);
    PaintedWall wall;
    wall.look(0);
    wall.frame.camera = nullptr;
    check_refused(quell_run(denoiser.get(), wall.ready()), QUELL_INVALID_ARGUMENT, {"frame.camera", "'colours' needs its jitter"});
    wall.look(0);
    wall.camera.jitter[0] = 9.f;
    check_refused(quell_run(denoiser.get(), wall.ready()), QUELL_INVALID_ARGUMENT, {"frame.camera", "a jitter of 9"});
    quell_denoiser* none = nullptr;
    settings.stages = "colours,resolve";
    check_refused(quell_create(&settings, &none), QUELL_NOT_SUPPORTED, {"settings.stages", "leave one of the two out"});
    settings.preset = "none", settings.stages = "colours";
    check_refused(quell_create(&settings, &none), QUELL_NOT_SUPPORTED, {"settings.stages", "'none'", "leave 'colours' out"});
}

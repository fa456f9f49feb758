#include "session.hpp"

namespace quell::live {
namespace {

constexpr MakeDenoiser makers[] = {make_general, make_svgf, make_surface_clamp};
constexpr int preset_count = sizeof makers / sizeof *makers;

glm::vec3 glm_of(Vector a) { return {a.x, a.y, a.z}; }

Camera camera_for(View const& view, Extent size) {
    auto orbit = first_orbit(view.scene);
    orbit.yaw = view.yaw, orbit.pitch = view.pitch, orbit.distance = view.distance;
    return camera_of(within_reach(view.scene, orbit), size.width, size.height);
}

/// Whether nothing has moved.
bool shows_the_same(View const& a, View const& b) {
    return a.scene == b.scene && a.at.time == b.at.time && a.at.light == b.at.light && a.yaw == b.yaw && a.pitch == b.pitch &&
           a.distance == b.distance;
}

} // namespace

Session::Session(Extent s) : size(s), frame(s), denoised(s), sums(static_cast<std::size_t>(s.pixels())) {}

void Session::advance(View const& view) {
    bool const is_cut = !has_last || view.scene != last.scene;
    choose(view.preset);
    if (is_cut && denoiser) denoiser->forget();
    auto const& before = is_cut ? view : last;
    if (is_cut || !shows_the_same(view, last)) clear_reference();
    scene = moving_scene(view.scene, view.at, before.at);
    cameras = {camera_for(view, size), camera_for(before, size)};
    double const start = seconds_now();
    trace(view.samples);
    double const traced = seconds_now();
    if (denoiser) denoiser->run(frame, denoised);
    trace_seconds = traced - start, denoise_seconds = seconds_now() - traced;
    last = view, has_last = true;
}

void Session::choose(int number) {
    if (number == preset) return;
    preset = number;
    denoiser = number >= 0 && number < preset_count ? makers[number](size) : nullptr;
}

void Session::trace(int samples) {
    ++frame_number;
    bool const starts = samples_in_sums == 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const value = trace_pixel(scene, cameras, {.samples = samples, .frame = frame_number}, x, y);
            frame[radiance].set(x, y, glm_of(value.radiance));
            frame[albedo].set(x, y, glm_of(value.albedo));
            frame[normal].set(x, y, glm_of(value.normal));
            frame[depth].set(x, y, value.depth);
            frame[motion].set(x, y, {value.motion.x, value.motion.y});
            auto& sum = sums[static_cast<std::size_t>(y * size.width + x)];
            sum = (starts ? Vector{} : sum) + value.radiance * static_cast<float>(samples);
        }
    samples_in_sums += samples;
}

void Session::refine(int samples) {
    // Numbers that no frame has.
    Tracing const tracing{.samples = samples, .frame = 0x80000000u + ++reference_number};
    bool const starts = samples_in_sums == 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto& sum = sums[static_cast<std::size_t>(y * size.width + x)];
            auto const value = trace_pixel(scene, cameras, tracing, x, y);
            sum = (starts ? Vector{} : sum) + value.radiance * static_cast<float>(samples);
        }
    samples_in_sums += samples;
}

Vector Session::colour(Picture picture, int x, int y) const {
    if (picture == Picture::reference) {
        float const share = samples_in_sums > 0 ? 1 / static_cast<float>(samples_in_sums) : 0;
        return sums[static_cast<std::size_t>(y * size.width + x)] * share;
    }
    auto const value = picture == Picture::noisy ? frame[radiance].get(x, y) : denoised.get(x, y);
    return {value.x, value.y, value.z};
}

} // namespace quell::live

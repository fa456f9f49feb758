#include "session.hpp"

namespace quell::live {
namespace {

constexpr MakeDenoiser makers[] = {make_general, make_svgf, make_surface_clamp};
constexpr int preset_count = sizeof makers / sizeof *makers;

Vector vector_of(glm::vec3 a) { return {a.x, a.y, a.z}; }

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

/// A number from 0 to 1, far from those of the numbers before: the digits of `n` to a base, the other way round.
float halton(uint32_t n, uint32_t base) {
    float value = 0, digit = 1;
    for (; n > 0; n /= base) digit /= static_cast<float>(base), value += digit * static_cast<float>(n % base);
    return value;
}
ScreenPoint place_in_pixel(uint32_t number) { return {halton(number, 2) - 0.5f, halton(number, 3) - 0.5f}; }

} // namespace

Session::Session(Extent s) : size(s), frame(s), denoised(s), sums(static_cast<std::size_t>(s.pixels())), denoised_frame(s) {}

void Session::advance(View const& view) {
    bool const is_cut = !has_last || view.scene != last.scene;
    choose(view.preset);
    if (is_cut && denoiser) denoiser->forget();
    auto const& before = is_cut ? view : last;
    if (is_cut || !shows_the_same(view, last)) clear_reference();
    jitter_then = jitter, jitter = view.anti_aliased ? place_in_pixel(1 + frame_number % 16) : ScreenPoint{};
    if (is_cut) jitter_then = jitter;
    frame.camera.jitter = {jitter.x, jitter.y};
    if (!view.anti_aliased || is_cut) smoother.reset(); // it starts anew
    scene = moving_scene(view.scene, view.at, before.at);
    cameras = {camera_for(view, size), camera_for(before, size)};
    double const start = seconds_now();
    trace(view.samples);
    double const traced = seconds_now();
    last = view, has_last = true;
    times.clear();
    if (denoiser) {
        denoiser->run(frame, denoised);
        times = denoiser->times;
        smooth();
    }
    trace_seconds = traced - start, denoise_seconds = seconds_now() - traced;
}

void Session::for_each_pixel(auto const& task) const {
    share_rows(0, size.height, [&](int y0, int y1) {
        for (int y = y0; y < y1; ++y)
            for (int x = 0; x < size.width; ++x) task(x, y);
    });
}

void Session::smooth() {
    if (!last.anti_aliased) return;
    if (!smoother) smoother = make_anti_aliasing(size);
    denoised_frame.camera.jitter = frame.camera.jitter;
    auto const copy = [&](auto const& from, auto& to) { for_each_pixel([&](int x, int y) { to.set(x, y, from.get(x, y)); }); };
    copy(denoised, denoised_frame[radiance]), copy(frame[depth], denoised_frame[depth]), copy(frame[motion], denoised_frame[motion]);
    smoother->run(denoised_frame, denoised);
    times.insert(times.end(), smoother->times.begin(), smoother->times.end());
}

void Session::choose(int number) {
    if (number == preset) return;
    preset = number;
    denoiser = number >= 0 && number < preset_count ? makers[number](size) : nullptr;
}

/// @param starts whether what the sum was before counts no more
void Session::add_to_sum(int x, int y, Vector radiance, int samples, bool starts) {
    auto& sum = sums[static_cast<std::size_t>(y * size.width + x)];
    sum = (starts ? Vector{} : sum) + radiance * static_cast<float>(samples);
}

void Session::trace(int samples) {
    Tracing const tracing{.samples = samples, .frame = ++frame_number, .jitter = jitter};
    auto const views = frame.views(decltype(frame)::channels{});
    bool const starts = samples_in_sums == 0;
    for_each_pixel([&](int x, int y) {
        TracedPixel(views, x, y).trace(scene, cameras, tracing);
        add_to_sum(x, y, vector_of(frame[radiance].get(x, y)), samples, starts);
    });
    samples_in_sums += samples;
}

void Session::refine(int samples) {
    // Numbers that no frame has.
    Tracing tracing{.samples = samples, .frame = 0x80000000u + ++reference_number};
    if (last.anti_aliased) tracing.jitter = place_in_pixel(reference_number);
    bool const starts = samples_in_sums == 0;
    for_each_pixel([&](int x, int y) {
        auto const seen = seen_at(scene, cameras, tracing, x, y);
        add_to_sum(x, y, radiance_of(scene, seen, tracing, x, y), samples, starts);
    });
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

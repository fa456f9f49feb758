// What the page calls: numbers in, numbers and places in memory out.
#include "session.hpp"

#include <cmath>
#include <cstring>

#define QUELL_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace quell::live {
namespace {

/// All that the page has of the program.
struct Page {
    Session session;
    std::vector<uint32_t> pixels; // of the picture that was asked for last
    std::vector<float> planes;    // what goes to a device and comes back: a component behind the other, without padding

    explicit Page(Extent size) : session(size), pixels(static_cast<std::size_t>(size.pixels())) {}

    struct Columns {
        int from, to; ///< the one after the last
    };
    uint32_t const* for_each_pixel(Columns columns, auto&& make) {
        auto const size = session.size;
        share_rows(0, size.height, [&](int y0, int y1) {
            for (int y = y0; y < y1; ++y)
                for (int x = columns.from; x < columns.to; ++x) pixels[static_cast<std::size_t>(y * size.width + x)] = make(x, y);
        });
        return pixels.data();
    }
};
std::unique_ptr<Page> page;

} // namespace

/// How many threads a frame is traced and denoised by from now on. The first call says how many there are.
QUELL_EXPORT(use_threads) void use_threads(int count) { set_thread_count(count); }

/// Pictures of another size from now on.
QUELL_EXPORT(resize) void resize(int width, int height) {
    page.reset();
    page = std::make_unique<Page>(Extent{width, height});
}

/// How a scene's camera starts: yaw, pitch, distance.
QUELL_EXPORT(first_view) float first_view(int scene, int which) {
    auto const orbit = first_orbit(scene);
    return which == 0 ? orbit.yaw : which == 1 ? orbit.pitch : orbit.distance;
}

/// Traces and denoises the next frame.
QUELL_EXPORT(advance)
void advance(int scene, int preset, int samples, float time, float light, float yaw, float pitch, float distance, int anti_aliased) {
    page->session.advance({scene, preset, samples, {time, light}, yaw, pitch, distance, anti_aliased != 0});
}

/// Where the frame's samples lie, from the pixels' middles: x and y; then of the frame before.
QUELL_EXPORT(jitter) float jitter(int which) {
    auto const at = which < 2 ? page->session.jitter : page->session.jitter_before;
    return which % 2 == 0 ? at.x : at.y;
}

/// Room for the three components of a picture.
QUELL_EXPORT(planes) float* planes() {
    page->planes.resize(static_cast<std::size_t>(3 * page->session.size.pixels()));
    return page->planes.data();
}

/// Puts a component of a channel that was traced there: 0 radiance, 1 albedo, 2 normal, 3 depth, 4 motion.
QUELL_EXPORT(take_channel) void take_channel(int channel, int component) {
    auto const& frame = page->session.frame;
    auto const size = page->session.size;
    float* to = planes();
    auto const copy = [&](auto const& image) {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) *to++ = image.view().get(component, x, y);
    };
    if (channel == 0) copy(frame[radiance]);
    if (channel == 1) copy(frame[albedo]);
    if (channel == 2) copy(frame[normal]);
    if (channel == 3) copy(frame[depth]);
    if (channel == 4) copy(frame[motion]);
}

/// Takes what lies there for the denoised picture.
QUELL_EXPORT(put_denoised) void put_denoised() {
    auto const view = page->session.denoised.view();
    auto const size = page->session.size;
    float const* from = planes();
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) view.set(c, x, y, *from++);
    page->session.smooth();
}

QUELL_EXPORT(refine) void refine(int samples) { page->session.refine(samples); }
QUELL_EXPORT(clear_reference) void clear_reference() { page->session.reference_samples = 0; }
QUELL_EXPORT(reference_samples) int reference_samples() { return page->session.reference_samples; }

/// Columns of the noisy, denoised or reference picture, as RGBA of 8 bits; the others are left over.
QUELL_EXPORT(picture) uint32_t const* picture(int which, float exposure, int from, int to) {
    ToneMap const tone{exposure};
    auto const shown = static_cast<Picture>(which);
    return page->for_each_pixel({from, to}, [&](int x, int y) { return packed(tone(page->session.colour(shown, x, y))); });
}

namespace {
/// Mean square of how far a pixel's shown colour is from the reference's.
float square_error(ToneMap const& tone, Picture which, int x, int y) {
    auto const off = tone(page->session.colour(which, x, y)) - tone(page->session.colour(Picture::reference, x, y));
    return dot(off, off) / 3;
}
} // namespace

/// A picture's error map: an error of `full` has the last colour.
QUELL_EXPORT(error_map) uint32_t const* error_map(int which, float exposure, float full) {
    auto const off = [&](int x, int y) { return sqrtf(square_error({exposure}, static_cast<Picture>(which), x, y)); };
    return page->for_each_pixel({0, page->session.size.width}, [&](int x, int y) { return packed(error_colour(off(x, y) / full)); });
}

/// Root of the mean square error of a picture, as it is shown, 0 to 1.
QUELL_EXPORT(rmse) float rmse(int which, float exposure) {
    double sum = 0;
    auto const size = page->session.size;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) sum += static_cast<double>(square_error({exposure}, static_cast<Picture>(which), x, y));
    return static_cast<float>(std::sqrt(sum / static_cast<double>(size.pixels())));
}

QUELL_EXPORT(trace_milliseconds) double trace_milliseconds() { return page->session.trace_seconds * 1e3; }
QUELL_EXPORT(denoise_milliseconds) double denoise_milliseconds() { return page->session.denoise_seconds * 1e3; }
QUELL_EXPORT(pass_count) int pass_count() { return static_cast<int>(page->session.times.size()); }
QUELL_EXPORT(pass_name) char const* pass_name(int i) { return page->session.times[static_cast<std::size_t>(i)].name; }
QUELL_EXPORT(pass_milliseconds) double pass_milliseconds(int i) { return page->session.times[static_cast<std::size_t>(i)].seconds * 1e3; }

} // namespace quell::live

#include "cases.hpp"
#include "still.hpp"
#include "watch.hpp"

#include <tracer/jitter.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

// Temporal anti-aliasing behind presets, at twice the frames' width and height, on pictures of which all is known: one even wall that is
// painted, in even light.
namespace quell::stability {
namespace {

constexpr int ratio = 2;

/// What is painted on the wall: at places that are counted in pixels of the frame.
struct Painting {
    std::function<float(glm::vec2 place)> albedo;
    glm::vec2 speed{0.f};                                             ///< pixels a frame
    std::function<float(int frame)> light = [](int) { return 0.5f; }; ///< on it
    float noise = 0;                                                  ///< part of the light by which samples differ, at most

    [[nodiscard]] float at(glm::vec2 place, int frame) const { return albedo(place - speed * static_cast<float>(frame)); }
};

/// A frame of one sample a pixel, all of them at the frame's jitter.
io::ExrImage frame_of(Painting const& painting, io::ExrImage frame, int number, std::mt19937& random) {
    auto const jitter = tracer::camera_jitter(tracer::Jitter::frame, number);
    std::uniform_real_distribution<float> noise(1 - painting.noise, 1 + painting.noise);
    auto const fill = [&](std::string const& name, float value) { std::ranges::fill(plane(frame, name), value); };
    fill("depth.Z", 4), fill("motion.X", -painting.speed.x), fill("motion.Y", -painting.speed.y);
    fill("normal.X", 0), fill("normal.Y", 0), fill("normal.Z", 1);
    std::size_t i = 0;
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x, ++i) {
            float const painted = painting.at(glm::vec2(x, y) + 0.5f + jitter, number);
            float const light = painting.light(number) * noise(random);
            for (auto const* const c : {"R", "G", "B"})
                plane(frame, std::string("albedo.") + c)[i] = painted, plane(frame, c)[i] = painted * light;
        }
    frame.attributes["quell:jitter"] = jitter;
    return frame;
}

/// What comes out should be: the mean over each of its pixels.
metrics::Picture truth_of(Painting const& painting, Extent size, int number) {
    constexpr int steps = 6;
    metrics::Picture picture{{ratio * size.width, ratio * size.height}, {}};
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) {
            float sum = 0;
            for (int j = 0; j < steps; ++j)
                for (int i = 0; i < steps; ++i) {
                    glm::vec2 const within{(static_cast<float>(i) + 0.5f) / steps, (static_cast<float>(j) + 0.5f) / steps};
                    sum += painting.at((glm::vec2(x, y) + within) / static_cast<float>(ratio), number);
                }
            picture.pixels.emplace_back(sum * painting.light(number) / (steps * steps));
        }
    return picture;
}

/// Pictures of the frames from `first` on: with all that was resolved, and enlarged each by itself.
struct Watched {
    static constexpr int first = 12, frames = 28;
    Pictures truth, resolved, alone;
    FrameErrors errors, errors_alone;

    Watched(std::string const& name, std::string const& preset, Painting const& painting, Making const& making, Results& results) {
        auto const blank = even_frame(0.5f, making);
        auto const& way = examples::preset_of(preset).usual;
        Extent const output{ratio * making.size.width, ratio * making.size.height};
        examples::Denoiser denoiser(way, making.size, making.threads, output), plain(way, making.size, making.threads);
        examples::Denoiser enlarging(examples::preset_of("none").usual, making.size, making.threads, output);
        std::mt19937 random(making.seed + 11);
        for (int i = 0; i < frames; ++i) {
            auto frame = frame_of(painting, blank, i, random);
            metrics::Picture const picture = denoiser.denoise(frame, {}, i);
            metrics::Picture const denoised = plain.denoise(frame, {}, i);
            for (std::size_t p = 0; p < denoised.pixels.size(); ++p)
                for (int c = 0; auto const* const component : {"R", "G", "B"}) plane(frame, component)[p] = denoised.pixels[p][c++];
            metrics::Picture const by_itself = enlarging.denoise(frame, {}, 2LL * i);
            if (i < first) continue;
            truth.push_back(truth_of(painting, making.size, i)), resolved.push_back(picture), alone.push_back(by_itself);
        }
        auto const compare = [&](std::string const& method, Pictures const& pictures) {
            FrameErrors all;
            for (int i = first; auto const& picture : pictures)
                record(all, name, method, i, truth[static_cast<std::size_t>(i - first)], picture), ++i;
            results.frames.insert(results.frames.end(), all.begin(), all.end());
            return all;
        };
        errors = compare(preset + "-upsampled", resolved), errors_alone = compare(preset + "-bicubic", alone);
    }
};

/// The slope of the line through (true, shown) brightness: 1 keeps all contrast, 0 none.
double contrast_kept(Pictures const& truth, Pictures const& shown) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        for (std::size_t p = 0; p < truth[i].pixels.size(); ++p) {
            double const a = truth[i].pixels[p].y, b = shown[i].pixels[p].y;
            n += 1, x += a, y += b, xx += a * a, xy += a * b;
        }
    return (n * xy - x * y) / (n * xx - x * x);
}

/// The standard deviation over time of what should stand still.
double flicker(Pictures const& pictures) {
    double sum = 0;
    auto const pixels = pictures.front().pixels.size();
    for (std::size_t p = 0; p < pixels; ++p) {
        double mean = 0, squares = 0;
        for (auto const& picture : pictures) mean += picture.pixels[p].y / static_cast<double>(pictures.size());
        for (auto const& picture : pictures) squares += std::pow(picture.pixels[p].y - mean, 2);
        sum += squares / static_cast<double>(pictures.size());
    }
    return std::sqrt(sum / static_cast<double>(pixels));
}

/// How wide the distance to the nearest line is, of lines so far apart, each of them so wide.
float lines(float place, float apart, float wide) {
    float const from = std::abs(place - apart * std::round(place / apart));
    return from < 0.5f * wide ? 0.9f : 0.1f;
}

/// Lines of three quarters of a frame's pixel, at a slope.
float thin(glm::vec2 place) { return lines(place.x + 0.37f * place.y, 5.3f, 0.75f); }
/// Bars of a grid, somewhat wider.
float grid(glm::vec2 place) { return std::max(lines(place.x, 6.1f, 1.5f), lines(place.y, 6.1f, 1.5f)); }

void thin_lines(std::string const& name, Making const& making, Results& results) {
    for (std::string const preset : {"none", "general"}) {
        Watched const seen(name, preset, {.albedo = thin, .noise = preset == "none" ? 0.f : 0.5f}, making, results);
        auto const method = preset + "-upsampled";
        results.promises.push_back({name, method, "contrast_over_reference", contrast_kept(seen.truth, seen.resolved), 0.7, true});
        results.promises.push_back({name, method, "flicker_over_bicubic", flicker(seen.resolved) / flicker(seen.alone), 0.5});
        results.promises.push_back({name, method, "worst_frame_over_bicubic", worst_ratio(seen.errors, seen.errors_alone), 0.7});
    }
}

void moving_grid(std::string const& name, Making const& making, Results& results) {
    for (std::string const preset : {"none", "general"}) {
        Watched const seen(name, preset, {.albedo = grid, .speed = {0.61f, 0.23f}, .noise = preset == "none" ? 0.f : 0.5f}, making,
                           results);
        auto const method = preset + "-upsampled";
        results.promises.push_back({name, method, "contrast_over_reference", contrast_kept(seen.truth, seen.resolved), 0.85, true});
        results.promises.push_back({name, method, "worst_frame_over_bicubic", worst_ratio(seen.errors, seen.errors_alone), 0.8});
    }
}

/// Light that is half as bright in every third frame.
void flickering_light(std::string const& name, Making const& making, Results& results) {
    auto const light = [](int frame) { return frame % 3 == 0 ? 0.25f : 0.5f; };
    Watched const seen(name, "none", {.albedo = grid, .light = light}, making, results);
    results.promises.push_back({name, "none-upsampled", "worst_frame_over_bicubic", worst_ratio(seen.errors, seen.errors_alone), no_worse});
}

} // namespace

std::vector<Case> upsampling_cases() {
    return {{"thin-lines", "Lines thinner than a pixel stand still, and the picture is made twice as large. They stay, and do not flicker.",
             thin_lines},
            {"moving-grid", "A grid moves by parts of a pixel, and the picture is made twice as large. It stays sharp.", moving_grid},
            {"flickering-light", "The same grid stands in light that flickers. No worse than each frame by itself.", flickering_light}};
}

} // namespace quell::stability

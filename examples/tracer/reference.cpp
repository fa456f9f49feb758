#include "reference.hpp"
#include "digest.hpp"
#include "reference_cache.hpp"

#include <quell/metrics/flip.hpp>

#include <algorithm>

namespace quell::tracer::detail {
namespace {

/// Counts whenever what a reference holds, or how it is rendered, changes.
constexpr int version = 1;

/// Mean over passes, channel by channel.
struct Half {
    PassPictures mean;
    int passes = 0;

    void add(PassPictures pass) {
        ++passes;
        if (passes == 1) {
            mean = std::move(pass);
            return;
        }
        for (auto& [name, picture] : mean) {
            auto const& next = pass.at(name);
            for (std::size_t i = 0; i < picture.pixels.size(); ++i)
                picture.pixels[i] += (next.pixels[i] - picture.pixels[i]) / static_cast<float>(passes);
        }
    }
};

metrics::Picture product(metrics::Picture a, metrics::Picture const& b) {
    for (std::size_t i = 0; i < a.pixels.size(); ++i) a.pixels[i] *= b.pixels[i];
    return a;
}

/// What a channel adds to the image; empty for channels that aren't effects.
metrics::Picture contribution(PassPictures const& pictures, std::string const& name) {
    auto const& picture = pictures.at(name);
    if (name == Visibility::name) return product(picture, pictures.at(Direct::name));
    if (name == Indirect::name) return product(picture, pictures.at(Albedo::name));
    return name == Glossy::name || name == Radiance::name ? picture : metrics::Picture{};
}

double difference(PassPictures const& first, PassPictures const& second) {
    double worst = 0;
    for (auto const& [name, picture] : first) {
        auto const a = contribution(first, name), b = contribution(second, name);
        if (a.pixels.empty()) continue;
        worst = std::max(worst, static_cast<double>(metrics::flip(metrics::displayed(a), metrics::displayed(b)).mean()));
    }
    return worst;
}

Reference joined(Half const& first, Half const& second, int samples, double half_difference) {
    Reference result{first.mean, samples, half_difference, false};
    for (auto& [name, picture] : result.pictures)
        for (std::size_t i = 0; i < picture.pixels.size(); ++i)
            picture.pixels[i] = (picture.pixels[i] + second.mean.at(name).pixels[i]) * 0.5f;
    return result;
}

/// Both settings' members are all named here, so that a new one doesn't compile before somebody has decided whether references depend on
/// it. The scene stands at the frame, and has the shutter and its moments in its hash.
std::uint64_t key_of(PreparedScene const& scene, RenderSettings const& render_settings, ReferenceSettings const& settings, int min_samples,
                     std::string const& channels) {
    auto const& [size, frame, samples_per_pixel, guide_samples, seed, threads, shutter, first_sample, shutter_keys, stratified_times,
                 frozen_at, jitter] = render_settings;
    auto const& [tolerance, max_samples, min_samples_of_blur, samples_per_pass, cache, use_cache, progress] = settings;
    Digest key;
    key.add(scene.content_hash());
    key.add(channels);
    for (int number : {version, size.width, size.height, frame, max_samples, min_samples, samples_per_pass}) key.add(number);
    key.add(seed);
    key.add(tolerance);
    key.add(name_of(jitter));
    return key.value();
}

} // namespace

Reference converged(RenderPass const& render_pass, int min_samples, ReferenceSettings const& settings) {
    Half halves[2];
    double apart = 1;
    // Comparing costs as much as several samples, so it's done only after every growth by a quarter.
    for (int passes = 1, next_comparison = 1;; ++passes) {
        for (int half : {0, 1}) halves[half].add(render_pass(half, (passes - 1) * settings.samples_per_pass));
        int const samples = 2 * passes * settings.samples_per_pass;
        bool const is_last = samples + 2 * settings.samples_per_pass > settings.max_samples;
        if (passes == next_comparison || is_last) {
            apart = difference(halves[0].mean, halves[1].mean);
            next_comparison = std::max(passes + 1, static_cast<int>(std::lround(1.25 * passes)));
        }
        if (settings.progress) settings.progress({samples, apart, settings.tolerance});
        if ((apart < settings.tolerance && samples >= min_samples) || is_last) return joined(halves[0], halves[1], samples, apart);
    }
}

Reference cached_or_converged(PreparedScene& scene, RenderSettings const& render_settings, ReferenceSettings const& settings,
                              std::string const& channels, RenderPass const& render_pass) {
    scene.move_to(static_cast<float>(render_settings.frame), render_settings.shutter, render_settings.shutter_keys);
    int const min_samples = one_ray_per_pixel(scene, render_settings) ? 0 : settings.min_samples_of_blur;
    if (!settings.use_cache) return converged(render_pass, min_samples, settings);
    auto const key = key_of(scene, render_settings, settings, min_samples, channels);
    ReferenceCache const cache{settings.cache, scene.description().name, render_settings.frame, key};
    if (auto found = cache.load()) return *found;
    auto result = converged(render_pass, min_samples, settings);
    cache.store(result);
    return result;
}

void merge(Reference& whole, Reference part) {
    whole.pictures.merge(part.pictures);
    whole.samples = std::max(whole.samples, part.samples);
    whole.half_difference = std::max(whole.half_difference, part.half_difference);
    whole.from_cache = whole.from_cache && part.from_cache;
}

metrics::Picture composite(Reference const& reference) {
    auto sum = product(reference[direct], reference[visibility]);
    auto const indirect_part = product(reference[albedo], reference[indirect]);
    for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += reference[glossy].pixels[i] + indirect_part.pixels[i];
    return sum;
}

} // namespace quell::tracer::detail

#pragma once

#include "pictures.hpp"
#include "render.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace quell::tracer {

struct ReferenceProgress {
    int samples = 0;       ///< per pixel so far, both halves together
    double difference = 0; ///< between the halves, of the worst effect; 1 before the first comparison
    double tolerance = 0;
};

struct ReferenceSettings {
    double tolerance = 0.005; ///< converged when the mean FLIP between two independent halves is below it, for every effect
    int max_samples = 16384;  ///< per pixel, both halves together; the end even where it hasn't converged
    /// Per pixel, both halves together, with an open shutter or jitter of the samples: what is soft may be so small that the mean over the
    /// image is below the tolerance while the blur itself is not smooth yet.
    int min_samples_of_blur = 128;
    int samples_per_pass = 16;     ///< per pixel and half, between two looks at the clock
    std::filesystem::path cache{}; ///< empty: $QUELL_CACHE, else ~/.cache/quell
    bool use_cache = true;
    std::function<void(ReferenceProgress const&)> progress{}; ///< called after every pass
};

/// Converged pictures, linear, by channel name: the effects that were asked for, with `direct` and `albedo` where these scale them.
struct Reference {
    std::map<std::string, metrics::Picture, std::less<>> pictures;
    int samples = 0;            ///< per pixel, of the effect that took most
    double half_difference = 0; ///< mean FLIP between the two halves, of the worst effect
    bool from_cache = true;     ///< whether nothing had to be rendered

    template <class C> [[nodiscard]] metrics::Picture const& operator[](C) const { return pictures.at(std::string{C::name}); }
};

namespace detail {

/// Pictures of one pass, by channel name.
using PassPictures = std::map<std::string, metrics::Picture, std::less<>>;
/// Renders a pass of one half (0 or 1), starting at this sample.
using RenderPass = std::function<PassPictures(int half, int first_sample)>;

[[nodiscard]] Reference converged(RenderPass const& render_pass, int min_samples, ReferenceSettings const& settings);
[[nodiscard]] Reference cached_or_converged(PreparedScene& scene, RenderSettings const& render_settings, ReferenceSettings const& settings,
                                            std::string const& channels, RenderPass const& render_pass);

template <class Wanted> PassPictures render_pass(PreparedScene& scene, RenderSettings const& settings) {
    Pictures<Wanted> pictures{settings.size};
    render<Wanted>(scene, settings, pictures);
    PassPictures named;
    for_each_channel(Wanted{}, [&]<class C>(C channel) { named.emplace(std::string{C::name}, std::move(pictures[channel])); });
    return named;
}

/// What is wanted, and what scales it where it is displayed.
template <class Wanted>
using WithFactors = union_of<Wanted, std::conditional_t<Wanted::template has<Visibility>, Channels<Direct>, Channels<>>,
                             std::conditional_t<Wanted::template has<Indirect>, Channels<Albedo>, Channels<>>>;

/// Converges the channels in `Traced` together.
template <class Traced> Reference converge(PreparedScene& scene, RenderSettings settings, ReferenceSettings const& reference_settings) {
    std::string names;
    for_each_channel(Traced{}, [&]<class C>(C) { names += std::string{C::name} + " "; });
    auto const seed = settings.seed;
    settings.samples_per_pixel = reference_settings.samples_per_pass;
    settings.guide_samples = 0;
    settings.frozen_at.reset();
    settings.stratified_times = true;
    auto const pass = [&](int half, int first_sample) {
        // Seeds that no noisy frame uses, and different ones for the halves.
        settings.seed = combine(seed, half == 0 ? 0x5eed0001u : 0x5eed0002u);
        settings.first_sample = first_sample;
        // Primary rays start the sequence from its beginning: the first 2^n samples fill 2^n strata of the open shutter and of the pixel
        // filter, one each, which those amid the sequence don't. Frames differ by their seeds instead.
        if (!one_ray_per_pixel(scene, settings)) {
            settings.first_sample -= settings.frame * settings.samples_per_pixel;
            settings.seed = combine(settings.seed, static_cast<std::uint32_t>(settings.frame));
        }
        return render_pass<Traced>(scene, settings);
    };
    return cached_or_converged(scene, settings, reference_settings, names, pass);
}

/// Adds the pictures of one effect to those of others.
void merge(Reference& whole, Reference part);
/// direct * visibility + glossy + albedo * indirect.
[[nodiscard]] metrics::Picture composite(Reference const& reference);

} // namespace detail

/// The reference of each effect in `Wanted` (of visibility, glossy, indirect, radiance) at a frame. Each effect takes the samples that it
/// needs by itself, in two independent halves, until these differ by less than the tolerance as displayed pictures of what the effect adds
/// to the image: direct * visibility, glossy, albedo * indirect. Radiance is put together from these three; with an open shutter or jitter
/// of the samples, where that isn't possible, all converges as a whole.
template <class Wanted>
Reference reference(PreparedScene& scene, RenderSettings const& settings, ReferenceSettings const& reference_settings = {}) {
    scene.move_to(static_cast<float>(settings.frame), settings.shutter, settings.shutter_keys);
    if (!detail::one_ray_per_pixel(scene, settings))
        return detail::converge<detail::WithFactors<Wanted>>(scene, settings, reference_settings);
    constexpr bool whole = Wanted::template has<Radiance>;
    Reference result;
    auto const add = [&]<class Traced>(Traced) { detail::merge(result, detail::converge<Traced>(scene, settings, reference_settings)); };
    if constexpr (whole || Wanted::template has<Visibility>) add(Channels<Visibility, Direct>{});
    if constexpr (whole || Wanted::template has<Glossy>) add(Channels<Glossy>{});
    if constexpr (whole || Wanted::template has<Indirect>) add(Channels<Indirect, Albedo>{});
    if constexpr (whole) result.pictures.insert_or_assign(std::string{Radiance::name}, detail::composite(result));
    return result;
}

} // namespace quell::tracer

#include "mask.hpp"
#include "digest.hpp"
#include "mask_tests.hpp"
#include "reference_cache.hpp"

#include <algorithm>
#include <string>

namespace quell::tracer {
namespace {

using metrics::Mask;

/// Counts whenever what a mask holds changes.
constexpr int version = 1;
/// How many frames back a mask looks: an exponential history of alpha 0.2 has then lost two thirds of what was wrong in it.
constexpr int trail = 4;
/// Uncovered pixels take longer: their history starts with a single sample.
constexpr int uncovering = 8;

int frames_back(Effect effect) {
    if (effect == Effect::blur) return 0;
    return effect == Effect::indirect ? uncovering : trail;
}

/// Calls f(i, x, y) for every pixel, which is the i-th, from several threads.
void for_each_pixel(RenderSettings const& settings, auto const& f) {
    tbb::task_arena arena{settings.threads > 0 ? settings.threads : tbb::task_arena::automatic};
    arena.execute([&] {
        tbb::parallel_for(0, settings.size.height, [&](int y) {
            auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(settings.size.width);
            for (int x = 0; x < settings.size.width; ++x) f(i++, x, y);
        });
    });
}

/// What every pixel sees at the frame of the mask; later steps follow these points back in time.
struct Seen {
    std::vector<Hit> hits;
    std::vector<Surface> surfaces;
};

Seen look(PreparedScene const& scene, RenderSettings const& settings) {
    auto const count = static_cast<std::size_t>(settings.size.pixels());
    Seen seen{std::vector<Hit>(count), std::vector<Surface>(count)};
    View const view{scene.camera(0, When::now), settings.size};
    for_each_pixel(settings, [&](std::size_t i, int x, int y) {
        Ray const ray{view.eye(), view.direction({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}), infinity, 0};
        seen.hits[i] = scene.intersect(ray);
        if (seen.hits[i]) seen.surfaces[i] = surface_at(scene, ray, seen.hits[i], view.pixel_angle());
    });
    return seen;
}

/// The test that decides a mask; `ago`: how many frames lie between the mask's and the one where the scene stands.
bool is_touched(Effect effect, int ago, detail::MaskPoint const& point) {
    if (effect == Effect::shadow) return detail::has_moving_shadow(point);
    if (effect == Effect::indirect) return ago > 0 && detail::is_hidden(point);
    return detail::has_moving_reflection(point);
}

/// Adds the pixels that are touched at the frame where the scene stands.
void add_touched(PreparedScene const& scene, RenderSettings const& settings, Seen const& seen, Effect effect, int ago, Mask& mask) {
    View const view{scene.camera(0, When::now), settings.size}, view_before{scene.camera(0, When::before), settings.size};
    for_each_pixel(settings, [&](std::size_t i, int, int) {
        if (mask[i] != 0 || !seen.hits[i] || seen.surfaces[i].is_emitter) return;
        if (is_touched(effect, ago, {scene, settings.size, view, view_before, seen.hits[i]})) mask[i] = 1;
    });
}

/// Whether the normal turns between two neighbours on one object: more than rounding can make it, less than an edge does.
bool turns(Seen const& seen, std::size_t a, std::size_t b) {
    if (seen.hits[a].instance != seen.hits[b].instance) return false;
    float const angle = glm::degrees(std::acos(glm::clamp(glm::dot(seen.surfaces[a].normal, seen.surfaces[b].normal), -1.f, 1.f)));
    return angle > 0.2f && angle < 30;
}

bool is_curved(Seen const& seen, Extent size, std::size_t i, int x, int y) {
    auto const row = static_cast<std::size_t>(size.width);
    return (x > 0 && turns(seen, i, i - 1)) || (x + 1 < size.width && turns(seen, i, i + 1)) || (y > 0 && turns(seen, i, i - row)) ||
           (y + 1 < size.height && turns(seen, i, i + row));
}

Mask computed(PreparedScene& scene, RenderSettings const& settings, Effect effect) {
    bool const is_blur = effect == Effect::blur;
    Mask mask(static_cast<std::size_t>(settings.size.pixels()));
    scene.move_to(static_cast<float>(settings.frame), is_blur ? settings.shutter : 0, settings.shutter_keys);
    if (is_blur) {
        detail::OpenShutter const shutter{scene, settings.size};
        for_each_pixel(settings, [&](std::size_t i, int x, int y) { mask[i] = shutter.has_motion({x, y}) ? 1 : 0; });
        return mask;
    }
    auto const seen = look(scene, settings);
    for (int ago = 0; ago <= frames_back(effect); ++ago) {
        scene.move_to(static_cast<float>(settings.frame - ago));
        add_touched(scene, settings, seen, effect, ago, mask);
    }
    if (effect == Effect::curved)
        for_each_pixel(settings, [&](std::size_t i, int x, int y) {
            if (!is_curved(seen, settings.size, i, x, y)) mask[i] = 0;
        });
    return mask;
}

/// All frames that a mask looks at, and the one before the first of them, have a say.
std::uint64_t key_of(PreparedScene& scene, RenderSettings const& settings, Effect effect) {
    Digest key;
    for (int number : {version, static_cast<int>(effect), settings.size.width, settings.size.height}) key.add(number);
    for (int ago = 0; ago <= frames_back(effect) + 1; ++ago) {
        scene.move_to(static_cast<float>(settings.frame - ago), effect == Effect::blur ? settings.shutter : 0, settings.shutter_keys);
        key.add(scene.content_hash());
    }
    return key.value();
}

Mask cached_or_computed(PreparedScene& scene, RenderSettings const& settings, Effect effect, MaskSettings const& how) {
    std::string const name{name_of(effect)};
    detail::ReferenceCache const cache{how.cache, scene.description().name + "-mask-" + name, settings.frame,
                                       key_of(scene, settings, effect)};
    Mask mask;
    if (auto const found = cache.load()) {
        for (auto const& pixel : found->pictures.at(name).pixels) mask.push_back(pixel.x > 0 ? 1 : 0);
        return mask;
    }
    mask = computed(scene, settings, effect);
    metrics::Picture picture{settings.size, {}};
    for (auto const entry : mask) picture.pixels.emplace_back(static_cast<float>(entry));
    cache.store(Reference{.pictures = {{name, std::move(picture)}}});
    return mask;
}

} // namespace

std::string_view name_of(Effect effect) {
    constexpr std::string_view names[]{"shadow", "glossy", "indirect", "curved", "blur"};
    return names[static_cast<std::size_t>(effect)];
}

Mask effect_mask(PreparedScene& scene, RenderSettings const& settings, Effect effect, MaskSettings const& how) {
    detail::check(settings);
    auto mask = how.use_cache ? cached_or_computed(scene, settings, effect, how) : computed(scene, settings, effect);
    scene.move_to(static_cast<float>(settings.frame), settings.shutter, settings.shutter_keys);
    return mask;
}

double share_of(Mask const& mask) {
    auto const selected = std::ranges::count_if(mask, [](auto entry) { return entry != 0; });
    return mask.empty() ? 0 : static_cast<double>(selected) / static_cast<double>(mask.size());
}

} // namespace quell::tracer

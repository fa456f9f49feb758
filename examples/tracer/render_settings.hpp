#pragma once

#include "jitter.hpp"
#include "prepared.hpp"

#include <quell/core/error.hpp>
#include <quell/image/extent.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace quell::tracer {

struct RenderSettings {
    Extent size{480, 270};
    int frame = 0;
    int samples_per_pixel = 1;
    /// Of normal, albedo, roughness and motion, where samples of a pixel see different points: more than the signals have, if it is more.
    int guide_samples = 0;
    std::uint32_t seed = 0;
    int threads = 0;                         ///< 0: as many as the machine has
    float shutter = 0;                       ///< part of the frame time during which the shutter is open; 0: a frozen moment
    int first_sample = 0;                    ///< number of the first sample, to continue an earlier rendering of the same frame
    int shutter_keys = default_shutter_keys; ///< moments of the open shutter between which all moves straight: 2 as in MB, more for arcs
    bool stratified_times = true;            ///< false: each sample's time takes no notice of the pixel's others, as in MB
    /// The time of every sample, in [0, 1] over the open shutter: a sharp picture, whose sweeps still last as long as the shutter is open.
    /// References are blurred nevertheless.
    std::optional<float> frozen_at{};
    Jitter jitter = Jitter::none;
};

namespace detail {

inline void check(RenderSettings const& settings) {
    if (settings.size.width <= 0 || settings.size.height <= 0)
        throw Error{"render size", to_string(settings.size), "give a width and a height of at least 1"};
    if (settings.samples_per_pixel <= 0) throw Error{"samples per pixel", std::to_string(settings.samples_per_pixel), "give at least 1"};
    if (!(settings.shutter >= 0 && settings.shutter <= 1))
        throw Error{"shutter", std::to_string(settings.shutter), "give a part of the frame time from 0 to 1"};
    if (settings.shutter_keys < 2 || settings.shutter_keys > max_shutter_keys)
        throw Error{"shutter keys", std::to_string(settings.shutter_keys), "give 2 to " + std::to_string(max_shutter_keys)};
    if (settings.frozen_at && !(*settings.frozen_at >= 0 && *settings.frozen_at <= 1))
        throw Error{"time of a frozen frame", std::to_string(*settings.frozen_at), "give a time from 0 to 1 over the open shutter"};
}

} // namespace detail

} // namespace quell::tracer

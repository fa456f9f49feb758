#pragma once

#include "prepared.hpp"
#include "render.hpp"

#include <quell/metrics/picture.hpp>

#include <filesystem>
#include <string_view>

namespace quell::tracer {

/// What can be hard about a pixel.
enum class Effect {
    shadow,   ///< now or in one of the last four frames, a shadow lies on it that moves over its surface
    glossy,   ///< now or in one of the last four frames, it reflects something whose image moves differently from the reflector itself
    indirect, ///< what it shows was hidden, or outside the image, in one of the last eight frames
    curved,   ///< the part of `glossy` on reflectors that aren't flat
    blur,     ///< while the shutter is open, something that moves in the image passes over it, or such a thing's shadow or reflection
};

[[nodiscard]] std::string_view name_of(Effect effect);

struct MaskSettings {
    std::filesystem::path cache{}; ///< empty: $QUELL_CACHE, else ~/.cache/quell
    bool use_cache = true;
};

/// The pixels of a frame that an effect touches, from the scene alone, so that no denoiser has a say in where it is judged. Non-zero
/// entries count; all are zero where nothing moves. The shutter counts as closed, but for `blur`, and samples as lying in the
/// pixels' centres, whatever the jitter. Afterwards the scene stands at the frame.
[[nodiscard]] metrics::Mask effect_mask(PreparedScene& scene, RenderSettings const& settings, Effect effect, MaskSettings const& how = {});

/// The part of all pixels that count.
[[nodiscard]] double share_of(metrics::Mask const& mask);

} // namespace quell::tracer

#pragma once

#include "preset_code.hpp"

#include <quell/frame/channels.hpp>
#include <quell/frame/motion_convention.hpp>
#include <quell/image/extent.hpp>

// In the inline namespace of quell's headers: code for a device and code for an instruction set are in one library.
namespace quell_library::inline QUELL_INSTRUCTION_SET {

[[nodiscard]] inline quell::MotionConvention convention_of(Motion const& given) {
    using C = quell::MotionConvention;
    constexpr C::Unit units[] = {C::Unit::pixel, C::Unit::uv, C::Unit::ndc};
    return {.points = given.from_previous != 0 ? C::Points::from_previous : C::Points::to_previous,
            .unit = units[given.unit],
            .y = given.y_up != 0 ? C::Y::up : C::Y::down,
            .jitter = given.has_jitter != 0 ? C::Jitter::left_in : C::Jitter::left_out};
}

/// The jitter of a frame, in its pixels.
struct JitterOf {
    glm::vec2 jitter{0.f};
    quell::Extent size{1, 1};
};

/// Says what the vectors of a frame must be multiplied by, and what added to them, to be in quell's convention. A sample offset by +jitter
/// shifts the image by -jitter. A vector between jittered images is therefore off by the change of jitter.
/// @param channels the names of the images
/// @param before   of the frame before it
template <class Channels>
void convert_motion(quell::MotionConvention const& convention, Channels const& channels, std::vector<Image>& images, JitterOf const& now,
                    JitterOf const& before) {
    if (convention == quell::MotionConvention{}) return;
    auto const ratio = [](int length, int then) { return static_cast<float>(length) / static_cast<float>(then); };
    auto const jitter_then =
        before.jitter * glm::vec2(ratio(now.size.width, before.size.width), ratio(now.size.height, before.size.height));
    for (std::size_t i = 0; i < images.size(); ++i) {
        bool const is_next = channels[i].name == quell::motion_next.name;
        if (!is_next && channels[i].name != quell::motion.name) continue;
        auto its_own = convention;
        if (is_next) its_own.points = quell::MotionConvention::Points::to_previous;
        auto const scale = quell::detail::to_pixels(its_own, now.size);
        bool const has_jitter = !is_next && convention.jitter == quell::MotionConvention::Jitter::left_in;
        auto const offset = has_jitter ? jitter_then - now.jitter : glm::vec2(0.f);
        for (int c = 0; c < 2; ++c) images[i].scale[c] = scale[c], images[i].offset[c] = offset[c];
    }
}

} // namespace quell_library::inline QUELL_INSTRUCTION_SET

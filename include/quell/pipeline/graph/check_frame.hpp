#pragma once

#include <quell/frame/frame.hpp>
#include <quell/frame/repair.hpp>

#include <glm/matrix.hpp>

#include <string>
#include <string_view>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Stands for a target where the output goes to the history's own image.
struct NoTarget {};

inline bool usable(glm::mat4 const& m) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!is_finite(m[c][r])) return false;
    return abs(glm::determinant(m)) > 0.f;
}

/// @throws Error where the host's image is not of the frame's size
inline void check_target(Extent target, Extent frame) {
    if (!(target == frame))
        raise_error<Failure>("run_into: the target", to_string(target) + " for a frame of " + to_string(frame), "give it the frame's size");
}

inline std::string quoted_channel(std::string_view name) { return "channel '" + std::string(name) + "'"; }

/// @throws Error where an image of the host has no memory, or rows without a length
/// @param name of the channel; the sentence is made where it is wanted, as a frame allocates nothing
template <class Storage> void check_memory(std::string_view name, ImageView auto const& view) {
    if constexpr (requires { requires std::is_pointer_v<decltype(view.data)> && !owns_memory<Storage>(); })
        if (!view.data) raise_error<Failure>(quoted_channel(name), "no memory", "point the channel at the host's image before run()");
    if constexpr (requires { requires std::is_integral_v<decltype(view.pixel_stride + view.row_stride)>; })
        if (view.row_stride == 0 && view.pixel_stride != 0 && view.size.height > 1)
            raise_error<Failure>(quoted_channel(name), "row_stride 0", "give the distance from a row to the next, in elements");
}

/// @throws Error where an image of fewer samples than pixels has another size than its pattern
template <class View> void check_samples(std::string_view name, View const& view) {
    auto const found = view.stored.size;
    if (found == view.size || View::samples.fits(found, view.size)) return;
    auto const block = to_string(Extent{View::columns, View::rows});
    raise_error<Failure>(
        quoted_channel(name), "samples of " + to_string(found) + " in a frame of " + to_string(view.size) + ", one for each " + block,
        "give it " + to_string(View::samples.stored(view.size)) + ", or an image of the frame's size, whose other pixels are not read");
}

/// How far samples may lie from their pixels' centres, in pixels, where somebody looks.
inline constexpr float most_jitter = 8.f;
/// @throws Error for a jitter beyond that, or one that is not finite
inline void check_jitter(glm::vec2 jitter) {
    auto const is_in_range = [](float a) { return is_finite(a) && a >= -most_jitter && a <= most_jitter; };
    if (!is_in_range(jitter.x) || !is_in_range(jitter.y))
        raise_error<Failure>("run: frame.camera.jitter", std::to_string(jitter.x) + ", " + std::to_string(jitter.y),
                             "give the samples' offset from the pixels' centres, in pixels of the frame");
}

/// @throws Error that names the channel, matrix, jitter or shutter at fault
template <class P, class Set, class Storage> void check_frame(Frame<Set, Storage> const& frame) {
    for_each_channel(typename P::reads{}, [&](auto c) {
        auto const view = frame[c].view();
        if (auto const wanted = divided(frame.size, c.fraction); !(view.size == wanted))
            raise_error<Failure>(quoted_channel(c.name), to_string(view.size) + " in a frame of " + to_string(frame.size),
                                 c.fraction == 1 ? "give every channel the frame's size"
                                                 : "give it 1/" + std::to_string(c.fraction) +
                                                       " of the frame's width and height: " + to_string(wanted));
        if constexpr (requires { decltype(view)::samples.columns; }) {
            static_assert(
                !c.is_guide,
                "Subsampled<pattern, Channels<...>>: albedo, normal, depth, motion and motion_next must be there for every pixel");
            check_samples(c.name, view);
            check_memory<Storage>(c.name, view.stored);
        } else
            check_memory<Storage>(c.name, view);
    });
    if (!(is_finite(frame.shutter) && frame.shutter >= 0.f))
        raise_error("frame.shutter", std::to_string(frame.shutter),
                    "give the fraction of the frame time during which the shutter is open: finite, 0 or more");
    if constexpr (requires { requires P::checks_jitter; }) check_jitter(frame.camera.jitter);
    if constexpr (P::needs_camera) {
        if (!usable(frame.camera.view))
            raise_error("camera.view", "a singular or non-finite matrix", "set frame.camera to the host's camera");
        if (!usable(frame.camera.projection))
            raise_error("camera.projection", "a singular or non-finite matrix", "set frame.camera to the host's camera");
        auto const& p = frame.camera.projection;
        if (p[0][3] == 0.f && p[1][3] == 0.f && p[2][3] == 0.f)
            raise_error("camera.projection", "a matrix without perspective, such as the identity of a camera that was never set",
                        "set frame.camera to the host's camera; orthographic ones are not supported");
    }
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

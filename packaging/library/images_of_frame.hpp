#pragma once

#include "compiled_preset.hpp"

#include <quell/frame/frame.hpp>

namespace quell_library {

/// A planar image of quell's own, for compiled code, which reads it where it lies.
template <class View> Image image_of_view(View const& view) {
    std::ptrdiff_t constexpr element = sizeof(float);
    Image image{.data = reinterpret_cast<std::byte*>(view.planes[0])};
    if constexpr (View::components > 1) image.component_stride = (view.planes[1] - view.planes[0]) * element;
    image.pixel_stride = element, image.row_stride = view.row_stride() * element;
    image.is_padded = true;
    return image;
}
/// The images of a frame of planar floats, for compiled code. They stay in the frame. Channels that it lacks have no data.
template <class Set> FrameImages images_of(Way const& way, quell::Frame<Set> const& frame) {
    FrameImages images{.size = frame.size, .camera = frame.camera, .number = frame.number, .shutter = frame.shutter};
    images.channels.resize(way.channels.size());
    for_each_channel(Set{}, [&](auto c) {
        if (auto const place = way.place_of(c.name)) images.channels[*place] = image_of_view(frame[c].view());
    });
    return images;
}
/// An image of floats, pixel by pixel, for compiled code to write.
inline Image image_of(std::vector<float>& pixels, int components, quell::Extent size) {
    std::ptrdiff_t constexpr element = sizeof(float);
    pixels.resize(static_cast<std::size_t>(size.pixels()) * static_cast<std::size_t>(components));
    return {.data = reinterpret_cast<std::byte*>(pixels.data()),
            .component_stride = element,
            .pixel_stride = components * element,
            .row_stride = components * element * size.width};
}
/// Runs all tasks on the calling thread.
inline void run_here(void*, std::int32_t count, void (*task)(void* context, std::int32_t index), void* context) {
    for (std::int32_t i = 0; i < count; ++i) task(context, i);
}

} // namespace quell_library

#include <denoise/canvas.hpp>

#include <quell/frame/channels.hpp>
#include <quell/io/exr/exr_original.hpp>
#include <quell/io/frame_image.hpp>

#include <array>

namespace quell::examples {

io::SequenceNames names_on_canvas(io::SequenceNames names, Extent size, Region const& canvas) {
    auto const whole = io::detail::size_of(canvas);
    std::array const parts{static_cast<float>(size.width) / static_cast<float>(whole.width),
                           static_cast<float>(size.height) / static_cast<float>(whole.height)};
    auto const scale = [&](auto channel, io::ChannelNames& channels) {
        auto sources = io::sources_of(channels, channel);
        for (std::size_t c = 0; c < 2; ++c) sources[c].scale *= parts[c], sources[c].offset *= parts[c];
        channels.sources.insert_or_assign(channel.name, sources);
    };
    for (auto& signal : names.of_signals)
        if (!(whole == size) && signal.channels.motion.unit != MotionConvention::Unit::pixel)
            scale(motion, signal.channels), scale(motion_next, signal.channels);
    return names;
}

void check_field_of_view(io::ExrListing const& file, io::SequenceNames const& map, Region const& canvas) {
    bool const has_camera = file.attributes.contains("quell:view") && file.attributes.contains("quell:projection");
    if (io::detail::size_of(canvas) == file.size || has_camera) return;
    for (auto const& signal : map.of_signals)
        if (signal.channels.depth.along == io::DepthConvention::Along::ray)
            throw Error(file.name, "its data window is not its display window, and only the map says what the camera sees",
                        "write the attributes quell:view and quell:projection, or leave out what lies outside of the display window");
}

void put_cameras_on_canvas(io::ExrImage& image, Extent size, Region const& canvas) {
    auto const part = [](int of, int whole) { return static_cast<float>(of) / static_cast<float>(whole); };
    float const x = part(size.width, image.size.width), y = part(size.height, image.size.height);
    glm::mat4 to_canvas(1.f);
    to_canvas[0][0] = x, to_canvas[3][0] = x - 1.f - 2.f * part(canvas.x0, image.size.width);
    to_canvas[1][1] = y, to_canvas[3][1] = 1.f - y + 2.f * part(canvas.y0, image.size.height);
    if (image.size == size) return;
    for (auto const* const name : {"quell:projection", "quell:projection_previous"})
        if (auto const* const projection = image.attribute<glm::mat4>(name)) image.attributes[name] = to_canvas * *projection;
}

} // namespace quell::examples

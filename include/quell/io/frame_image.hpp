#pragma once

#include <quell/frame/frame.hpp>
#include <quell/frame/pixel_rays.hpp>
#include <quell/io/camera_attributes.hpp>
#include <quell/io/channel_names.hpp>
#include <quell/io/exr_image.hpp>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quell::inline QUELL_INSTRUCTION_SET::io {

namespace detail {

inline Plane const& plane_for(ExrImage const& image, std::string const& name, bool may_be_uint) {
    auto const& plane = image[name];
    auto const subject = image.name + " channel '" + name + "'";
    if (plane.values.size() != image.pixels())
        throw Error(subject, std::to_string(plane.values.size()) + " values in an image of " + to_string(image.size), "give one per pixel");
    if (plane.type == SampleType::uint32 && !may_be_uint)
        throw Error(subject, "it is stored as uint", "store it as half or float; only instance numbers are uint");
    if (!plane.exact) throw Error(subject, "it holds numbers that are not exact in float", "number objects from 0 to 2^24");
    return plane;
}

/// Adds `offset` to the pixels that at least one of the source's planes holds: outside of a data window there is nothing.
inline void add_offset(std::vector<float>& values, ExrImage const& image, Source const& source) {
    auto const held = [&](int x, int y) {
        return std::ranges::any_of(source.sum, [&](auto const& name) {
            auto const& stored = image[name].stored;
            return !stored || (x >= stored->x0 && x < stored->x1 && y >= stored->y0 && y < stored->y1);
        });
    };
    auto value = values.begin();
    for (int y = 0; y < image.size.height; ++y)
        for (int x = 0; x < image.size.width; ++x, ++value)
            if (held(x, y)) *value += source.offset;
}

} // namespace detail

/// One component of an image, row by row: a constant, or a scaled sum of planes and an offset.
/// @param image the file's contents
/// @param source what to sum
/// @param may_be_uint whether integer planes are allowed
/// @throws Error naming the file and the plane that is missing or of a wrong type
[[nodiscard]] inline std::vector<float> component_of(ExrImage const& image, Source const& source, bool may_be_uint = false) {
    if (source.sum.empty()) return std::vector<float>(image.pixels(), source.scale);
    auto values = detail::plane_for(image, source.sum[0], may_be_uint).values;
    for (std::size_t k = 1; k < source.sum.size(); ++k) {
        auto const& plane = detail::plane_for(image, source.sum[k], may_be_uint);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] += plane.values[i];
    }
    if (source.scale != 1.f)
        for (auto& value : values) value *= source.scale;
    if (source.offset != 0.f) detail::add_offset(values, image, source);
    return values;
}

namespace detail {

/// Replaces depths of misses by +infinity.
inline void mark_misses(std::vector<float>& depth, ExrImage const& image, Source const& source, ChannelNames const& names) {
    auto const miss = std::numeric_limits<float>::infinity();
    for (auto& z : depth)
        if (z >= names.miss_from || z <= names.miss_to) z = miss;
    for (auto const& name : source.sum) {
        auto const& stored = image[name].stored;
        if (!stored) continue;
        for (int y = 0; y < image.size.height; ++y)
            for (int x = 0; x < image.size.width; ++x)
                if (x < stored->x0 || x >= stored->x1 || y < stored->y0 || y >= stored->y1)
                    depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width) + static_cast<std::size_t>(x)] = miss;
    }
}

/// Turns distances along rays into distances along the view axis. Rays go through the samples' places.
/// @throws Error naming the file where neither it nor the convention says what the camera sees
inline void to_view_axis(std::vector<float>& depth, ExrImage const& image, DepthConvention from) {
    if (from.along == DepthConvention::Along::view_axis) return;
    auto camera = camera_of(image);
    if (!camera && from.vertical_field_of_view == 0.f)
        throw Error(image.name, "it has no camera, and its depth is said to be the length of rays",
                    "write the attributes quell:view and quell:projection, or say --field-of-view, or vertical_field_of_view in the map");
    if (!camera) {
        float const aspect = static_cast<float>(image.size.width) / static_cast<float>(image.size.height);
        camera = Camera{.projection = glm::perspective(glm::radians(from.vertical_field_of_view), aspect, 1.f, 2.f)};
    }
    if (camera->projection[3][3] != 0.f) return; // orthographic: rays go along the view axis
    PixelRays const rays(*camera, image.size);
    if (!is_finite(rays.pixel_size))
        throw Error(image.name, "no ray can be made of its camera, and its depth is said to be the length of rays",
                    "write the attributes quell:view and quell:projection of a perspective camera");
    auto z = depth.begin();
    for (int y = 0; y < image.size.height; ++y)
        for (int x = 0; x < image.size.width; ++x) {
            auto const to_depth_1 = rays.direction(
                vec2<float>{static_cast<float>(x) + 0.5f + camera->jitter.x, static_cast<float>(y) + 0.5f + camera->jitter.y});
            *z++ /= std::sqrt(dot(to_depth_1, to_depth_1));
        }
}

/// Jitter of this or the last frame, in pixels. It is required: a wrong 0 would leave the jitter in the vectors.
/// @throws Error naming the file and the attribute
inline glm::vec2 jitter_in(ExrImage const& image, std::string const& attribute) {
    if (auto const* const jitter = image.attribute<glm::vec2>(attribute)) return *jitter;
    throw Error(image.name, "it has no attribute " + attribute + " of two floats, and motion vectors are said to have jitter left in",
                "write the sample's offset from the pixel's centre, in pixels, y down, or say that jitter is left_out");
}

/// How a component of motion vectors becomes that of quell's convention: own = factor * theirs + offset.
struct ToOwnMotion {
    float factor, offset;
};
inline ToOwnMotion to_own_motion(int axis, ExrImage const& image, MotionConvention from) {
    using C = MotionConvention;
    auto const extent = static_cast<float>(axis == 0 ? image.size.width : image.size.height);
    float factor = from.points == C::Points::to_previous ? 1.f : -1.f;
    if (axis == 1 && from.y == C::Y::up) factor = -factor;
    if (from.unit != C::Unit::pixel) factor *= from.unit == C::Unit::ndc ? extent / 2.f : extent;
    if (from.jitter != C::Jitter::left_in) return {factor, 0.f};
    auto const change = jitter_in(image, "quell:jitter_previous") - jitter_in(image, "quell:jitter");
    return {factor, axis == 0 ? change.x : change.y};
}
/// Converts one component of motion vectors to quell's convention once on loading, as Supplied<> does per frame.
inline void convert_motion(std::vector<float>& motion, ToOwnMotion const& rule) {
    for (auto& m : motion) m = m * rule.factor + rule.offset;
}

/// Motion to the next frame has the same unit and direction of y, points to that frame, and has no jitter.
inline MotionConvention next_convention(MotionConvention motion) {
    motion.points = MotionConvention::Points::to_previous;
    motion.jitter = MotionConvention::Jitter::left_out;
    return motion;
}

template <ChannelTag C> void load_channel(C channel, ImageView auto const& view, ExrImage const& image, ChannelNames const& names) {
    auto const sources = sources_of(names, channel);
    for (int c = 0; c < C::components; ++c) {
        auto const& source = sources[static_cast<std::size_t>(c)];
        auto values = component_of(image, source, std::is_same_v<C, Instance>);
        if constexpr (std::is_same_v<C, Depth>) {
            mark_misses(values, image, source, names);
            to_view_axis(values, image, names.depth);
        }
        if constexpr (std::is_same_v<C, Motion>) convert_motion(values, to_own_motion(c, image, names.motion));
        if constexpr (std::is_same_v<C, MotionNext>) convert_motion(values, to_own_motion(c, image, next_convention(names.motion)));
        auto value = values.begin();
        for (int y = 0; y < image.size.height; ++y)
            for (int x = 0; x < image.size.width; ++x) view.set(c, x, y, *value++);
    }
}

/// Format in quell's own files: integers for object numbers, float for exact channels, half for the rest.
template <ChannelTag C> constexpr SampleType type_of(C) {
    if constexpr (std::is_same_v<C, Instance>) return SampleType::uint32;
    return C::full_precision ? SampleType::float32 : SampleType::half;
}

} // namespace detail

/// Shutter time as a fraction of the frame time: from `names`, else from the attribute `quell:shutter`; else empty.
/// @throws Error where the attribute is no number
[[nodiscard]] inline std::optional<float> shutter_of(ExrImage const& image, ChannelNames const& names = {}) {
    if (names.shutter) return names.shutter;
    if (!image.attributes.contains("quell:shutter")) return std::nullopt;
    if (auto const* const stored = image.attribute<float>("quell:shutter")) return *stored;
    if (auto const* const whole = image.attribute<int>("quell:shutter")) return static_cast<float>(*whole);
    throw Error(image.name, "its attribute quell:shutter is no number", "write it as a float, or say --shutter");
}

/// Fills some channels of a frame from an image, and its camera and shutter if the image has them.
/// @throws Error naming the file and the channel: sizes differ, or a plane is missing or of a wrong type
template <class Some, class Set, class Storage>
void load_channels(Some some, Frame<Set, Storage>& frame, ExrImage const& image, ChannelNames const& names = {}) {
    if (!(frame.size == image.size))
        throw Error(image.name, "it is " + to_string(image.size) + " but the frame is " + to_string(frame.size),
                    "make the frame of the image's size");
    for_each_channel(some, [&](auto channel) { detail::load_channel(channel, frame[channel].view(), image, names); });
    if (auto const camera = camera_of(image)) frame.camera = *camera;
    if (auto const shutter = shutter_of(image, names)) frame.shutter = *shutter;
}
/// Fills all channels of a frame, and its camera and shutter if the image has them.
/// @throws Error as load_channels does
template <class Set, class Storage> void load(Frame<Set, Storage>& frame, ExrImage const& image, ChannelNames const& names = {}) {
    load_channels(Set{}, frame, image, names);
}

/// Adds a channel to an image under quell's own names.
/// @param image to add planes to
/// @param channel whose names to use
/// @param view the values
/// @param type format in the file
template <ChannelTag C> void put(ExrImage& image, C channel, ImageView auto const& view, SampleType type = detail::type_of(C{})) {
    auto const names = own_names(channel);
    for (int c = 0; c < C::components; ++c) {
        Plane plane{.name = names[static_cast<std::size_t>(c)], .type = type, .values = {}};
        plane.values.reserve(image.pixels());
        for (int y = 0; y < image.size.height; ++y)
            for (int x = 0; x < image.size.width; ++x) plane.values.push_back(view.get(c, x, y));
        image.planes.push_back(std::move(plane));
    }
}

/// The image of a frame as in quell's own files: all channels, the camera, and the shutter if there are sweeps.
template <class Set, class Storage> [[nodiscard]] ExrImage image_of(Frame<Set, Storage> const& frame) {
    ExrImage image{.size = frame.size};
    for_each_channel(Set{}, [&](auto channel) { put(image, channel, frame[channel].view()); });
    put_camera(image, frame.camera);
    if constexpr (Set::template has<Sweep>) image.attributes["quell:shutter"] = frame.shutter;
    return image;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::io

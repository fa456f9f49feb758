#pragma once

#include <quell/frame/cursor/past_pixel.hpp>
#include <quell/image/planar.hpp>
#include <quell/shader/frame_block.hpp>
#include <quell/shader/recorded.hpp>

#include <unordered_map>

/// @file
/// Images of a recorded kernel: which plane a memory is, loads and stores.

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The size of a pass that is recorded.
struct RecordedExtent {
    RecordedInteger width, ///< pixels
        height;            ///< pixels
};

/// PixelRays of a recorded kernel.
struct RecordedRays {
    vec3<Recorded> eye,  ///< see PixelRays
        forward,         ///< see PixelRays
        right,           ///< see PixelRays
        down;            ///< see PixelRays
    Recorded pixel_size; ///< see PixelRays

    /// See PixelRays.
    [[nodiscard]] vec3<Recorded> direction(vec2<Recorded> const& where) const {
        auto const along = [&](Recorded r, Recorded d, Recorded f) { return fma(where.x, r, fma(where.y, d, f)); };
        return {along(right.x, down.x, forward.x), along(right.y, down.y, forward.y), along(right.z, down.z, forward.z)};
    }
    /// See PixelRays.
    [[nodiscard]] vec3<Recorded> position(vec2<Recorded> const& where, Recorded linear_depth) const {
        auto const d = direction(where);
        return {fma(d.x, linear_depth, eye.x), fma(d.y, linear_depth, eye.y), fma(d.z, linear_depth, eye.z)};
    }
};
/// What is in every lane already.
template <std::same_as<Recorded> Real> vec3<Real> broadcast(vec3<Real> const& v) { return v; }

namespace detail {
/// What a plane's memory is, by its address.
struct KnownPlane {
    std::string channel;
    int component = 0, fraction = 1;
    bool is_half = false; ///< see GraphPlane
};
/// How a history that is recorded keeps what Planar<Float16> keeps as halves: so, or as floats, as RecordOptions say.
struct SquaredHalfIfAsked : SquaredFloat16 {
    using Squares = SquaredHalfIfAsked;
};
struct HalfIfAsked : Float16 {
    using Squares = SquaredHalfIfAsked;
};

/// The pass that this thread records.
struct PassRecording {
    std::unordered_map<void const*, KnownPlane> const& known; ///< images that hosts and passes have so far
    GraphBuilder builder{};
    std::vector<void const*> memory{}; ///< of each plane that it touches
    std::vector<KnownPlane> planes{};
    RecordedRays rays{}, rays_then{};
    bool half_precision; ///< see RecordOptions

    PassRecording(std::unordered_map<void const*, KnownPlane> const& images, bool in_halves) : known(images), half_precision(in_halves) {}

    std::uint32_t plane(void const* address) {
        for (std::size_t i = 0; i < memory.size(); ++i)
            if (memory[i] == address) return static_cast<std::uint32_t>(i);
        auto const found = known.find(address);
        if (found == known.end())
            raise_error<Failure>("recorded pass", "it reads an image that no pass and no host has filled",
                                 "keep what a policy reads in channels: `reads`, `remembers`, `keeps`");
        memory.push_back(address), planes.push_back(found->second);
        return static_cast<std::uint32_t>(memory.size() - 1);
    }
};
inline thread_local PassRecording* pass_recording = nullptr;

inline RecordedExtent recorded_size(int fraction) {
    auto const of = static_cast<std::uint32_t>(fraction);
    return {recorded_leaf<RecordedInteger>(Operation::width, of), recorded_leaf<RecordedInteger>(Operation::height, of)};
}
inline RecordedInteger within(RecordedInteger at, RecordedInteger size) { return clamped(at, 0, size - 1); }
/// Where a pixel lies in a plane. Outside the image, that of the nearest one.
inline RecordedInteger place_of(RecordedInteger x, RecordedInteger y, int fraction) {
    auto const size = recorded_size(fraction);
    auto const inside = [](RecordedInteger at, Operation itself, RecordedInteger length) {
        return node_at(at.node).operation == itself ? at : within(at, length);
    };
    return inside(y, Operation::this_row, size.height) * size.width + inside(x, Operation::this_column, size.width);
}
/// Whether a format rounds to half.
template <class Format> bool is_half() {
    if (std::is_base_of_v<HalfIfAsked, Format> || std::is_base_of_v<SquaredHalfIfAsked, Format>) return pass_recording->half_precision;
    return !std::is_same_v<typename Format::Element, float>;
}
template <class Format> bool keeps_roots() { return std::is_base_of_v<SquaredFloat16, Format> && is_half<Format>(); }

template <class Format, int N, class Memory>
Recorded load_plane(PlanarView<Format, N, Memory> const& view, int c, RecordedInteger x, RecordedInteger y) {
    auto const plane = pass_recording->plane(view.planes[c]);
    auto const place = place_of(x, y, pass_recording->planes[plane].fraction);
    Recorded loaded;
    loaded.node = graph_builder->add({Operation::load, {place.node}, plane});
    return keeps_roots<Format>() ? loaded * loaded : loaded;
}
template <class Format, int N, class Memory>
void store_plane(PlanarView<Format, N, Memory> const& view, int c, RecordedInteger x, RecordedInteger y, Recorded value) {
    auto const plane = pass_recording->plane(view.planes[c]);
    if (keeps_roots<Format>()) value = sqrt(max(value, Recorded(0.f)));
    if (is_half<Format>()) value = recorded<Recorded>(Operation::round_to_half, value);
    graph_builder->add({Operation::store, {value.node, place_of(x, y, pass_recording->planes[plane].fraction).node}, plane});
}

// What kernels and jobs call.
template <std::same_as<Recorded> Real, class View> auto load_pixels(View const& view, RecordedInteger x, RecordedInteger y) {
    return make_value<View::components, Real>([&](auto c) { return load_plane(view, c, x, y); });
}
template <std::same_as<Recorded> Real, class View, class V>
void store_pixels(View const& view, RecordedInteger x, RecordedInteger y, V const& value, int) {
    [&]<int... c>(std::integer_sequence<int, c...>) { (store_plane(view, c, x, y, component<c>(value)), ...); }
    (std::make_integer_sequence<int, View::components>{});
}
template <std::same_as<Recorded> Real, int rows, class View, class V>
void store_rows(View const& view, RecordedInteger x, RecordedInteger y, V const& value, int) {
    store_pixels<Real>(view, x, y, value, 1);
}

/// The pixel at a whole-numbered column and row; outside an image of `size` the nearest one.
inline PixelCoordinates<Recorded> nearest_inside(RecordedExtent size, vec2<Recorded> const& at) {
    return {clamp(at.x, Recorded(0.f), to_real(size.width - 1)), clamp(at.y, Recorded(0.f), to_real(size.height - 1))};
}
/// As fetch(): the pixel at a place plus (dx, dy), outside the image the nearest one.
template <class View> auto fetch_recorded(View const& view, RecordedExtent size, PixelCoordinates<Recorded> const& place, int dx, int dy) {
    auto const near_by = [](Recorded at, int offset, RecordedInteger length) {
        return truncate(clamp(at + static_cast<float>(offset), Recorded(0.f), to_real(length - 1)));
    };
    return load_pixels<Recorded>(view, near_by(place.column, dx, size.width), near_by(place.row, dy, size.height));
}
} // namespace detail

/// See nearest_place().
template <class Px, std::same_as<Recorded> Real> PixelCoordinates<Real> nearest_place(Px const& px, vec2<Real> const& where) {
    return detail::nearest_inside(px.size(), vec2<Real>{floor(where.x), floor(where.y)});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

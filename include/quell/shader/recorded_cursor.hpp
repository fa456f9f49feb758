#pragma once

#include <quell/frame/cursor/pixel.hpp>
#include <quell/shader/recorded_images.hpp>

/// @file
/// The cursors of a recorded kernel. See Pixel and PastPixel.

namespace quell::inline QUELL_INSTRUCTION_SET {

/// @cond
namespace detail {
template <MotionConvention convention> vec2<Recorded> in_pixels(VectorConversion<convention> const&, vec2<Recorded> const& m) {
    if constexpr (convention == MotionConvention{})
        return m;
    else {
        // As VectorConversion does it: factors that powers of two and signs cannot make inexact.
        constexpr auto factor = to_pixels(convention, Extent{1, 1});
        auto const whole = recorded_size(1);
        bool const in_image = convention.unit != MotionConvention::Unit::pixel;
        Recorded const across = in_image ? factor.x * to_real(whole.width) : Recorded(factor.x);
        Recorded const down = in_image ? factor.y * to_real(whole.height) : Recorded(factor.y);
        auto const change = [](int axis) {
            if constexpr (convention.jitter == MotionConvention::Jitter::left_in)
                return uniform(FrameBlock::jitter_then_word + axis) - uniform(FrameBlock::jitter_word + axis);
            else
                return Recorded(0.f);
        };
        return {fma(m.x, across, change(0)), fma(m.y, down, change(1))};
    }
}
} // namespace detail

template <class S> struct PastPixel<Recorded, S> {
    S const& scope;
    PixelCoordinates<Recorded> const& place;
    int dx, dy;

    [[nodiscard]] RecordedMask inside() const {
        auto const column = place.column + static_cast<float>(dx), row = place.row + static_cast<float>(dy);
        auto const size = detail::recorded_size(S::fraction);
        return both(column >= Recorded(0.f), column < to_real(size.width), row >= Recorded(0.f), row < to_real(size.height));
    }
    [[nodiscard]] vec2<Recorded> sample_position() const {
        auto const along = [](Recorded at, int offset, int axis) {
            return at + (static_cast<float>(offset) + 0.5f + detail::uniform(FrameBlock::jitter_then_word + axis));
        };
        return {along(place.column, dx, 0), along(place.row, dy, 1)};
    }
    template <ChannelTag C> auto operator[](C c) const {
        constexpr bool remembered = S::remembered_channels::template has<C>, kept = S::kept_channels::template has<C>;
        static_assert(remembered || kept,
                      "a policy looks at the previous frame's channel that it does not list: add it to `remembers` or `keeps`");
        if constexpr (remembered)
            return detail::Remembered<C>::unpack(fetch(scope.remembered.view(typename detail::Remembered<C>::Stored{})));
        else if constexpr (kept)
            return fetch(scope.kept_then.view(c));
    }
    [[nodiscard]] auto signal() const { return fetch(scope.signal_then); }

private:
    auto fetch(auto const& view) const { return detail::fetch_recorded(view, detail::recorded_size(S::fraction), place, dx, dy); }
};

template <class S> struct Pixel<Recorded, S, 1> {
    using Real = Recorded;
    using Scope = S;
    using Signal = Value<S::components, Recorded>;
    static constexpr int pack_width = 1;

    S const& scope;
    RecordedInteger x, y;
    RecordedMask row_inside = RecordedMask(true);

    template <ChannelTag C> auto operator[](C c) const {
        return read(c, [&](auto const& view) { return detail::load_pixels<Real>(view, x, y); });
    }
    template <int c, ChannelTag C> Real channel_component(C channel) const {
        if constexpr (S::made_channels::template has<C>)
            return detail::load_plane(scope.made.view(channel), c, x, y);
        else
            return detail::load_plane(scope.frame.view(channel), c, x, y);
    }
    template <ChannelTag C> auto finer(C c, int i, int j) const { return at_repeated(c, under(S::fraction / C::fraction, i, j)); }
    Signal finer_signal(int i, int j) const {
        return without_mark(detail::fetch_recorded(scope.signal, detail::recorded_size(1), nearest<1>(under(S::fraction, i, j)), 0, 0));
    }
    template <ChannelTag C> auto coarser(C c, int dx = 0, int dy = 0) const {
        auto const where = over<C>();
        return at_repeated(c, {floor(where.x) + static_cast<float>(dx), floor(where.y) + static_cast<float>(dy)});
    }
    template <ChannelTag C> auto coarser_interpolated(C c) const {
        auto const where = over<C>();
        auto const column = floor(where.x - 0.5f), row = floor(where.y - 0.5f);
        auto const u = where.x - 0.5f - column, v = where.y - 0.5f - row;
        auto const tap = [&](float i, float j) { return at_repeated(c, {column + i, row + j}); };
        return mix(mix(tap(0.f, 0.f), tap(1.f, 0.f), u), mix(tap(0.f, 1.f), tap(1.f, 1.f), u), v);
    }
    Signal signal() const { return without_mark(stored_signal()); }
    template <int c> Real signal_component() const {
        if constexpr (S::marks_missing)
            return component<c>(signal());
        else
            return detail::load_plane(scope.signal, c, x, y);
    }
    auto missing() const {
        if constexpr (S::fraction == 1)
            return S::mark::template of<S::marks_missing>(stored_signal());
        else
            return RecordedMask(false);
    }
    Signal stored_signal() const { return detail::load_pixels<Real>(scope.signal, x, y); }
    static constexpr bool knows_samples = S::frame_channels::template has<SampleCount>;
    Real samples() const {
        if constexpr (knows_samples) {
            auto const count = (*this)[sample_count];
            return select(is_finite(count), clamp(count, Real(1e-3f), Real(1e6f)), Real(1.f));
        } else
            return Real(1.f);
    }
    Real variance_of_sample() const {
        if constexpr (knows_samples) {
            auto const known = (*this)[sample_variance];
            return masked(both(is_finite(known), known < Real(1e32f)), max(known, Real(0.f)));
        } else
            return Real(0.f);
    }
    Pixel at(int dx, int dy) const {
        Pixel there = *this;
        if (dx != 0) there.x = x + dx;
        if (dy != 0) {
            auto const row = y + dy, height = size().height;
            there.row_inside = both(row_inside, dy < 0 ? row >= 0 : row < height);
            there.y = detail::within(row, height);
        }
        return there;
    }
    Pixel at(RecordedInteger dx, RecordedInteger dy) const {
        auto const row = y + dy, height = size().height;
        return {scope, x + dx, detail::within(row, height), both(row_inside, row >= 0, row < height)};
    }
    RecordedMask inside() const {
        bool const here = detail::node_at(x.node).operation == Operation::this_column;
        return here ? row_inside : both(row_inside, x >= 0, x < size().width);
    }
    [[nodiscard]] bool any_row_inside() const { return any(row_inside); }
    Real columns() const { return to_real(x); }
    Real row_of_lanes() const { return to_real(y); }
    vec2<Real> position() const { return {columns() + 0.5f, row_of_lanes() + 0.5f}; }
    RecordedExtent size() const { return detail::recorded_size(S::fraction); }
    RecordedExtent frame_size() const { return detail::recorded_size(1); }
    vec2<Real> jitter_now() const { return {detail::uniform(FrameBlock::jitter_word), detail::uniform(FrameBlock::jitter_word + 1)}; }
    vec2<Real> jitter_then() const {
        return {detail::uniform(FrameBlock::jitter_then_word), detail::uniform(FrameBlock::jitter_then_word + 1)};
    }
    Real shutter_now() const { return detail::uniform(FrameBlock::shutter_word); }
    Real shutter_then() const { return detail::uniform(FrameBlock::shutter_then_word); }
    [[nodiscard]] bool has_past() const { return scope.has_past; }
    PastPixel<Real, S> past(PixelCoordinates<Real> const& place, int dx = 0, int dy = 0) const { return {scope, place, dx, dy}; }
    void past(PixelCoordinates<Real>&&, int = 0, int = 0) const = delete;
    template <ChannelTag C> auto elsewhere(PixelCoordinates<Real> const& place, C c) const {
        return read(c, [&](auto const& view) { return detail::fetch_recorded(view, size(), place, 0, 0); });
    }
    auto signal_elsewhere(PixelCoordinates<Real> const& place, int dx = 0, int dy = 0) const {
        auto const v = detail::fetch_recorded(scope.signal, size(), place, dx, dy);
        return std::pair{without_mark(v), S::mark::template of<S::marks_missing>(v)};
    }
    RecordedRays const& rays() const { return detail::pass_recording->rays; }
    RecordedRays const& rays_then() const { return detail::pass_recording->rays_then; }
    std::pair<Real, Real> random_normals() const {
        auto const [first, second] = random_bits(0);
        return {detail::normal_from_bits<Real>(first), detail::normal_from_bits<Real>(second)};
    }
    std::pair<Real, Real> random_uniforms(int which = 0) const {
        auto const [first, second] = random_bits(which << 26);
        return {detail::uniform_from_bits<Real>(first), detail::uniform_from_bits<Real>(second)};
    }
    vec3<Real> project_to_past(vec3<Real> const& p) const { return project(FrameBlock::clip_then_word, p); }
    vec3<Real> project(vec3<Real> const& p) const { return project(FrameBlock::clip_word, p); }

private:
    static Signal without_mark(Signal const& v) { return S::mark::template value<S::marks_missing>(v); }
    /// As normal_pair() and uniform_pair() have them.
    auto random_bits(std::int32_t flipped) const {
        auto const frame = detail::uniform_integer(FrameBlock::index_word) ^ RecordedInteger(flipped);
        auto const seed = detail::scrambled(truncate(row_of_lanes()) + wrapping_product(frame, 0x51ed270b));
        auto const first = detail::scrambled(truncate(columns()) ^ seed);
        return std::pair{first, detail::scrambled(first + RecordedInteger(1))};
    }
    vec2<Real> under(int ratio, int i, int j) const {
        auto const times = static_cast<float>(ratio);
        return {columns() * times + static_cast<float>(i), row_of_lanes() * times + static_cast<float>(j)};
    }
    template <class C> vec2<Real> over() const {
        constexpr int ratio = C::fraction / S::fraction;
        auto const p = position();
        return {p.x * (1.f / ratio), p.y * (1.f / ratio)};
    }
    template <int fraction> static PixelCoordinates<Real> nearest(vec2<Real> const& where) {
        return detail::nearest_inside(detail::recorded_size(fraction), where);
    }
    template <ChannelTag C> auto at_repeated(C c, vec2<Real> const& where) const {
        return read(c, [&](auto const& view) {
            return detail::fetch_recorded(view, detail::recorded_size(C::fraction), nearest<C::fraction>(where), 0, 0);
        });
    }
    template <ChannelTag C> auto read(C c, auto&& load_from) const {
        constexpr bool made = S::made_channels::template has<C>, given = S::frame_channels::template has<C>;
        static_assert(made || given, "a policy looks at a channel that it does not list: add the channel to its `reads`");
        if constexpr (made)
            return load_from(scope.made.view(c));
        else if constexpr (std::is_same_v<C, Motion>)
            return detail::in_pixels(scope.vectors, load_from(scope.frame.view(c)));
        else if constexpr (given)
            return load_from(scope.frame.view(c));
    }
    vec3<Real> project(int matrix, vec3<Real> const& p) const {
        auto const m = [&](int column, int row) { return detail::uniform(matrix + 4 * column + row); };
        auto const row = [&](int r) { return p.x * m(0, r) + p.y * m(1, r) + p.z * m(2, r) + m(3, r); };
        auto const w = row(3), inverse = 1.f / w;
        auto const whole = size();
        return {(row(0) * inverse + 1.f) * (0.5f * to_real(whole.width)) - jitter_now().x,
                (1.f - row(1) * inverse) * (0.5f * to_real(whole.height)) - jitter_now().y, w};
    }
};
/// @endcond

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/core/random.hpp>
#include <quell/frame/cursor/pack_rows.hpp>
#include <quell/frame/cursor/past_pixel.hpp>
#include <quell/frame/kept_channels.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The cursor that policies use: one pixel of the current frame, or neighbouring pixels of a row where Real is a pack.
/// @tparam R float or a pack
/// @tparam S the Scope of the pass
/// @tparam rows 1; in passes of `two_rows` also 2: the second half of a pack is then the pixels below the first half
template <class R, class S, int rows = 1> struct Pixel {
    using Real = R;                         ///< float or a pack
    using Scope = S;                        ///< of the pass
    using Signal = Value<S::components, R>; ///< a value of the signal

    S const& scope;         ///< what the pass can read
    int x,                  ///< column of the first lane
        y;                  ///< row
    bool row_inside = true; ///< false where at() left the image vertically; y is then the border's row
    /// @cond
    QUELL_NO_UNIQUE_ADDRESS detail::SecondRow<rows> second = detail::SecondRow<rows>(y + 1);
    static constexpr int pack_width = width_of<R> / rows; // columns of a pack
    /// @endcond

    /// The value of a channel of this frame: supplied by the host or made by an earlier pass.
    template <ChannelTag C> QUELL_KERNEL auto operator[](C c) const {
        require_same_size<C>();
        return read(c, [&](auto const& view) QUELL_INLINED { return load(view); });
    }
    /// One component of a channel, for channels of many components.
    template <int c, ChannelTag C> QUELL_KERNEL Real channel_component(C channel) const {
        require_same_size<C>();
        if constexpr (S::made_channels::template has<C>)
            return load_one<c>(scope.made.view(channel));
        else
            return load_one<c>(scope.frame.view(channel));
    }
    /// A channel of a finer resolution at one of the fine pixels that this pixel covers. (i, j) counts columns and rows from 0 to the ratio
    /// of the resolutions - 1; beyond that it reaches fine pixels of neighbours. Outside the image the border repeats.
    template <ChannelTag C> QUELL_KERNEL auto finer(C c, int i, int j) const {
        constexpr int ratio = S::fraction / C::fraction;
        static_assert(ratio > 1 && ratio * C::fraction == S::fraction,
                      "px.finer(channel, i, j): the pass's fraction must be a multiple of the channel's");
        return at_repeated(c, under(ratio, i, j));
    }
    /// The signal at fine pixel (i, j), as finer(). Finite.
    QUELL_KERNEL Signal finer_signal(int i, int j) const {
        static_assert(S::fraction > 1, "px.finer_signal(i, j): the pass is of the frame's size: use px.signal()");
        return without_mark(detail::fetch_repeated(scope.signal, under(S::fraction, i, j)));
    }
    /// A channel of a coarser resolution at the coarse pixel that contains this pixel, plus (dx, dy) coarse pixels. Outside the image the
    /// border repeats.
    template <ChannelTag C> QUELL_KERNEL auto coarser(C c, int dx = 0, int dy = 0) const {
        auto const where = over<C>();
        return at_repeated(c, {floor(where.x) + static_cast<float>(dx), floor(where.y) + static_cast<float>(dy)});
    }
    /// A coarser channel, interpolated bilinearly at this pixel's centre.
    template <ChannelTag C> QUELL_KERNEL auto coarser_interpolated(C c) const {
        auto const where = over<C>();
        auto const column = floor(where.x - 0.5f), row = floor(where.y - 0.5f);
        auto const u = where.x - 0.5f - column, v = where.y - 0.5f - row;
        auto const tap = [&](float i, float j) QUELL_INLINED { return at_repeated(c, {column + i, row + j}); };
        return mix(mix(tap(0.f, 0.f), tap(1.f, 0.f), u), mix(tap(0.f, 1.f), tap(1.f, 1.f), u), v);
    }
    /// The signal being denoised. Finite; components may be negative. A missing sample holds the mean of its usable neighbours.
    QUELL_KERNEL Signal signal() const {
        static_assert(S::fraction == 1, "a pass of a fraction of the frame's size looks at the signal: use px.finer_signal(i, j)");
        return without_mark(stored_signal());
    }
    /// One component of the signal.
    template <int c> QUELL_KERNEL Real signal_component() const {
        require_frame_size();
        if constexpr (S::marks_missing)
            return component<c>(signal());
        else
            return load_one<c>(scope.signal);
    }
    /// True where the host's sample is unusable (not finite, beyond 1e16, of negative luminance). It must have weight 0. Always false after
    /// Temporal, or, without a Temporal, after the first stage that makes a new signal; and in a pass of a fraction of the frame's size.
    QUELL_KERNEL auto missing() const {
        if constexpr (S::fraction == 1)
            return S::mark::template of<S::marks_missing>(stored_signal());
        else
            return Real(0.f) != Real(0.f);
    }
    /// @cond
    QUELL_KERNEL Signal stored_signal() const { return load(scope.signal); } // with marks
    /// @endcond
    /// Whether the host supplies sample counts: KnownSamples{} is a part of the pipeline.
    static constexpr bool knows_samples = S::frame_channels::template has<SampleCount>;
    /// The number of samples that the signal's value is the mean of, in [1e-3, 1e6]. 1 where the host supplies none.
    QUELL_KERNEL Real samples() const {
        if constexpr (knows_samples) {
            auto const count = (*this)[sample_count];
            return select(is_finite(count), clamp(count, Real(1e-3f), Real(1e6f)), Real(1.f));
        } else
            return Real(1.f);
    }
    /// The variance of the luminance of one sample, >= 0. 0: unknown.
    QUELL_KERNEL Real variance_of_sample() const {
        if constexpr (knows_samples) {
            auto const known = (*this)[sample_variance];
            return masked(both(is_finite(known), known < Real(1e32f)), max(known, Real(0.f)));
        } else
            return Real(0.f);
    }
    /// The pixel at an offset. Outside the image, rows repeat the border and columns hold finite values without meaning: test `inside()`,
    /// or use for_each_tap.
    QUELL_KERNEL Pixel at(int dx, int dy) const {
        int const row = y + dy, last = scope.size.height - 1;
        return {scope, column(x + dx), detail::clamp_to(row, last), row_inside && row >= 0 && row <= last, second.at(dy, last)};
    }
    /// True where this pixel lies inside the image.
    QUELL_KERNEL auto inside() const {
        auto const column = columns();
        auto const whole = static_cast<float>(scope.size.width);
        auto const width = detail::by_rows<Real, rows>(row_inside ? whole : 0.f, second.inside ? whole : 0.f);
        return both(column >= Real(0.f), column < width);
    }
    /// Whether any lane's row lies inside the image.
    QUELL_KERNEL bool any_row_inside() const { return row_inside || second.inside; }
    /// Column of each lane.
    QUELL_KERNEL Real columns() const {
        return Real(static_cast<float>(x)) + lanes<Real>() - detail::by_rows<Real, rows>(0.f, static_cast<float>(pack_width));
    }
    /// Row of each lane.
    QUELL_KERNEL Real row_of_lanes() const { return detail::by_rows<Real, rows>(static_cast<float>(y), static_cast<float>(second.y)); }
    /// Pixel coordinates of the centre: (column + 0.5, row + 0.5). The point in the world is px[quell::position], or rays().position().
    QUELL_KERNEL vec2<Real> position() const { return {columns() + 0.5f, row_of_lanes() + 0.5f}; }
    /// The size of the pass, in pixels.
    QUELL_KERNEL Extent size() const { return scope.size; }
    /// The size of the frame, in pixels.
    QUELL_KERNEL Extent frame_size() const { return scope.frame_size; }
    /// Offset of this frame's samples from the pixels' centres, in pixels, y down.
    QUELL_KERNEL glm::vec2 jitter_now() const { return scope.jitter; }
    /// The same in the previous frame.
    QUELL_KERNEL glm::vec2 jitter_then() const { return scope.jitter_then; }
    /// Shutter time of this frame, as a part of the time between frames.
    QUELL_KERNEL float shutter_now() const { return scope.shutter; }
    /// The same in the previous frame.
    QUELL_KERNEL float shutter_then() const { return scope.shutter_then; }
    /// Whether there is a previous frame.
    QUELL_KERNEL bool has_past() const { return scope.has_past; }
    /// The pixel of the previous frame at a place plus (dx, dy). Outside the image it holds finite values without meaning. It keeps a
    /// reference to `place`.
    QUELL_KERNEL PastPixel<Real, S> past(PixelCoordinates<Real> const& place, int dx = 0, int dy = 0) const {
        require_frame_size();
        return {scope, place, dx, dy};
    }
    /// Deleted: the place must outlive the past pixel, so give it a name.
    void past(PixelCoordinates<Real>&&, int = 0, int = 0) const = delete;
    /// A channel of this frame at any place. Outside the image it holds finite values without meaning.
    template <ChannelTag C> QUELL_KERNEL auto elsewhere(PixelCoordinates<Real> const& place, C c) const {
        require_same_size<C>();
        return read(c, [&](auto const& view) QUELL_INLINED { return detail::fetch<Real>(view, scope.size, place, 0, 0); });
    }
    /// The signal at any place plus (dx, dy), and whether the host's sample is missing there.
    QUELL_KERNEL auto signal_elsewhere(PixelCoordinates<Real> const& place, int dx = 0, int dy = 0) const {
        require_frame_size();
        auto const v = detail::fetch<Real>(scope.signal, scope.size, place, dx, dy);
        return std::pair{without_mark(v), S::mark::template of<S::marks_missing>(v)};
    }
    /// rays().position(where, z): in world space. The sample is at position() plus jitter_now(). The policy must declare `needs_camera`.
    QUELL_KERNEL PixelRays const& rays() const { return require_camera(), scope.rays; }
    /// The same for the previous frame.
    QUELL_KERNEL PixelRays const& rays_then() const { return require_camera(), scope.rays_then; }
    /// Two approximately normal random numbers, mean 0 and standard deviation 1. They depend on the pixel and the frame's number only.
    QUELL_KERNEL std::pair<Real, Real> random_normals() const { return normal_pair(columns(), row_of_lanes(), scope.frame_index); }
    /// Two uniform random numbers in [0, 1), likewise.
    /// @param which selects one of 16 pairs, 0 to 15
    QUELL_KERNEL std::pair<Real, Real> random_uniforms(int which = 0) const {
        return uniform_pair(columns(), row_of_lanes(), scope.frame_index ^ (which << 26));
    }
    /// Projects a world-space point to the previous frame: pixel coordinates (x, y) minus this frame's jitter, and linear depth (z; <= 0 is
    /// behind the camera). The sample that saw the point was off the pixel's centre by the jitter; history belongs to pixels' centres. The
    /// policy must declare `needs_camera`.
    QUELL_KERNEL vec3<Real> project_to_past(vec3<Real> const& p) const { return project(scope.clip_from_world_then, p); }
    /// Projects a world-space point to this frame, likewise.
    QUELL_KERNEL vec3<Real> project(vec3<Real> const& p) const { return project(scope.clip_from_world, p); }

private:
    QUELL_KERNEL static Signal without_mark(Signal const& v) { return S::mark::template value<S::marks_missing>(v); }
    template <class C> QUELL_KERNEL static void require_same_size() {
        static_assert(C::fraction == S::fraction,
                      "a policy looks at a channel of another size than the pass: read a finer one by px.finer(channel, i, j), a coarser "
                      "one by px.coarser(channel)");
    }
    /// Column and row of fine pixel (i, j) in an image of `ratio` times the resolution.
    QUELL_KERNEL vec2<Real> under(int ratio, int i, int j) const {
        auto const times = static_cast<float>(ratio);
        return {columns() * times + static_cast<float>(i), row_of_lanes() * times + static_cast<float>(j)};
    }
    /// This pixel's centre in pixel coordinates of a coarser channel.
    template <class C> QUELL_KERNEL vec2<Real> over() const {
        constexpr int ratio = C::fraction / S::fraction;
        static_assert(ratio > 1 && ratio * S::fraction == C::fraction,
                      "px.coarser(channel): the channel's fraction must be a multiple of the pass's");
        auto const p = position();
        return {p.x * (1.f / ratio), p.y * (1.f / ratio)};
    }
    /// A channel of any resolution, at a whole-numbered column and row of it. Outside the image the border repeats.
    template <ChannelTag C> QUELL_KERNEL auto at_repeated(C c, vec2<Real> const& where) const {
        return read(c, [&](auto const& view) QUELL_INLINED { return detail::fetch_repeated(view, where); });
    }
    /// What `load_from` makes of a channel's view, with motion in quell's convention.
    template <ChannelTag C> QUELL_KERNEL auto read(C c, auto&& load_from) const {
        constexpr bool made = S::made_channels::template has<C>, given = S::frame_channels::template has<C>;
        static_assert(made || given, "a policy looks at a channel that it does not list: add the channel to its `reads`");
        if constexpr (made)
            return load_from(scope.made.view(c));
        else if constexpr (std::is_same_v<C, Motion>)
            return scope.vectors(load_from(scope.frame.view(c)));
        else if constexpr (given)
            return load_from(scope.frame.view(c));
    }
    QUELL_KERNEL static void require_frame_size() {
        static_assert(S::fraction == 1,
                      "a pass of a fraction of the frame's size looks at the past, the camera or parts of the signal, which are of "
                      "the frame's size: do that in a pass without `fraction`");
    }
    QUELL_KERNEL static void require_camera() {
        require_frame_size();
        static_assert(S::has_camera, "a policy uses the camera without saying so: add `static constexpr bool needs_camera = true` to it");
    }
    QUELL_KERNEL vec3<Real> project(glm::mat4 const& m, vec3<Real> const& p) const {
        require_camera();
        auto row = [&](int r) { return p.x * m[0][r] + p.y * m[1][r] + p.z * m[2][r] + m[3][r]; };
        auto const w = row(3), inverse = 1.f / w;
        return {(row(0) * inverse + 1.f) * (0.5f * static_cast<float>(scope.size.width)) - scope.jitter.x,
                (1.f - row(1) * inverse) * (0.5f * static_cast<float>(scope.size.height)) - scope.jitter.y, w};
    }
    /// All images of a pass have its size. Setting it here lets the compiler compute one address for all of them.
    QUELL_KERNEL auto load(auto view) const {
        view.size = scope.size;
        return detail::load_rows<R, rows>(view, x, y, second);
    }
    template <int c> QUELL_KERNEL Real load_one(auto view) const {
        static_assert(rows == 1, "a pass of `two_rows` looks at a component by itself: take it from px[channel]");
        view.size = scope.size;
        return detail::load_one<R, c>(view, x, y);
    }
    /// Limits a column to where a pack may start. Beyond that no lane is inside, so the values do not matter.
    QUELL_KERNEL int column(int i) const {
        int const low = -pack_width, high = scope.size.width;
        return i < low ? low : i > high ? high : i;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

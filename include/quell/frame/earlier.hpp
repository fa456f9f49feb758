#pragma once

#include <quell/core/channel.hpp>

#include <array>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// "colour, 2 frames earlier"
template <ChannelTag C, int frames> struct EarlierName {
    static constexpr std::string_view of = C::name, tail = frames == 1 ? ", 1 frame earlier" : ", 0 frames earlier";
    static constexpr int digits = frames < 10 ? 0 : 1; ///< more than one
    static constexpr auto text = [] {
        std::array<char, of.size() + tail.size() + digits> all{};
        std::size_t n = 0;
        for (char const c : of) all[n++] = c;
        for (char const c : tail) {
            if (c == '0' && frames >= 10) all[n++] = '0' + frames / 10;
            all[n++] = c == '0' ? '0' + frames % 10 : c;
        }
        return all;
    }();
};
} // namespace detail

/// What a kept channel held some frames earlier. A policy that lists it among `reads_kept` looks at frames farther back than the last:
/// px.past(place)[Earlier<C, 1>{}] is what C was in the frame before the last. History keeps the images themselves; none is copied.
///
/// Where the history is shorter, it is what C was in its first frame: a policy that follows surfaces from frame to frame lets the first one
/// say that they were nowhere before (PixelCoordinates outside the image).
/// @tparam C      a channel that a stage keeps
/// @tparam frames how much farther back than the last frame, 1 to 15
template <ChannelTag C, int frames> struct Earlier : C {
    static_assert(frames >= 1 && frames <= 15, "Earlier<channel, frames>: from 1 to 15 frames before the last");
    static constexpr std::string_view name{detail::EarlierName<C, frames>::text.data(),
                                           detail::EarlierName<C, frames>::text.size()}; ///< for plans
    /// @cond
    using kept = C;
    using later = std::conditional_t<frames == 1, C, Earlier<C, frames - (frames > 1)>>; // what it was a frame ago
    /// @endcond
};

namespace detail {
template <class C> inline constexpr int frames_earlier = 0;
template <class C, int frames> inline constexpr int frames_earlier<Earlier<C, frames>> = frames;

/// The channel of this frame that a channel of the past is.
template <class C> struct KeptAs { using type = C; };
template <class C, int frames> struct KeptAs<Earlier<C, frames>> { using type = C; };
template <class... Cs> auto kept_as(Channels<Cs...>) -> union_of<Channels<typename KeptAs<Cs>::type>...>;

/// An Earlier and all that becomes it in the frames to come, the latest first.
template <class C> struct Carried { using type = Channels<>; };
template <class C, int frames> struct Carried<Earlier<C, frames>> {
    using type = union_of<typename Carried<typename Earlier<C, frames>::later>::type, Channels<Earlier<C, frames>>>;
};
template <class... Cs> auto carried(Channels<Cs...>) -> union_of<typename Carried<Cs>::type...>;
template <class... Cs> constexpr int most_frames_earlier(Channels<Cs...>) {
    int most = 0;
    ((most = frames_earlier<Cs> > most ? frames_earlier<Cs> : most), ...);
    return most;
}
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include "sequence.hpp"

#include <quell/presets/named.hpp>

namespace quell::bench {

/// Whether a pipeline makes motion blur, so that the shutter is open.
template <class P> inline constexpr bool blurs = blur_input<P> != BlurInput::none;

namespace detail {
template <class P, bool open> using ReadsIf = std::conditional_t<blurs<P> == open, typename P::reads, Channels<>>;
template <bool open, class... Presets>
constexpr union_of<ReadsIf<decltype(Presets::usual()), open>...> all_reads(std::tuple<Presets...> const&) {
    return {};
}
} // namespace detail

/// A frame with all that presets read, of a shutter that is open or not.
template <bool open> using TracedInput = Frame<decltype(detail::all_reads<open>(named_presets))>;

/// A few frames of a built-in scene, `room` or `mixed`, to be run round and round. Made once; only the last size asked for is kept.
template <bool open> std::vector<TracedInput<open>> const& traced_sequence(Extent size);

} // namespace quell::bench

#pragma once

#include <quell/frame/cursor/pixel.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// The signal that a policy is made for, if it names one; else Radiance.
template <class P> struct SignalFor {
    static_assert(check_hooks<P>());
    using type = Radiance;
};
template <class P>
    requires ChannelTag<typename P::Signal>
struct SignalFor<P> {
    using type = typename P::Signal;
};
/// The Scope by which concepts test a policy: it has what the policy declares.
template <class P, class S = typename SignalFor<P>::type>
using ProbeScope =
    Scope<Views<Planar<>, reads_of<P>>, Views<Planar<>, Channels<>>, ViewOf<Planar<>, S>, ViewOf<Planar<>, S>,
          Views<Planar<>, decltype(keeps_of<P>{} | reads_kept_of<P>{})>, RememberedViewsOf<Planar<>, remembers_of<P>>,
          PassTraits{.marks_missing = true, .has_camera = needs_camera_of<P>, .reads_past_signal = true, .fraction = fraction_of<P>}>;
template <class P> using Probe = Pixel<float, ProbeScope<P>>;
template <class P> using PastProbe = PastPixel<float, ProbeScope<P>>;
} // namespace detail

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/frame/cursor/scope.hpp>
#include <quell/pipeline/pipeline.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// What the passes of a pipeline see: views of exactly the channels that each declares.
/// @tparam Set, FrameStorage the frame's channels and their storage
/// @tparam Storage           of the history
template <class P, class Set, class FrameStorage, class Storage> struct PassScopes {
    using SignalView = ViewOf<Storage, typename P::Signal>;
    using Vectors = VectorConversion<P::motion_convention>;

    /// @tparam raw whether the pass sees marks of missing samples
    template <class Pass, bool raw>
    using Of = Scope<Views<FrameStorage, common_to<decltype(reads_of<Pass>{} | typename P::known_samples{}), Set>>,
                     Views<Storage, common_to<reads_of<Pass>, typename P::made>>, SignalView, SignalView,
                     Views<Storage, decltype(keeps_of<Pass>{} | reads_kept_of<Pass>{})>, RememberedViewsOf<Storage, remembers_of<Pass>>,
                     PassTraits{.marks_missing = raw, .has_camera = needs_camera_of<Pass>, .fraction = fraction_of<Pass>}, Vectors>;
    /// For the end of the last pass: what demodulation reads, and what the history remembers.
    using Finish = Scope<Views<FrameStorage, decltype(reads_of<typename P::Form>{} | typename P::remembers{})>, Views<Storage, Channels<>>,
                         SignalView, SignalView, Views<Storage, Channels<>>, RememberedViewsOf<Storage, Channels<>>, PassTraits{}, Vectors>;
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

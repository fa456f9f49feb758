#pragma once

#include <quell/diagnose/hypotheses/motion/motion_by_blocks.hpp>
#include <quell/diagnose/inspect.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// The part of diagnose() that costs little enough for every run, for programs that read frames from files: motion that is 0 although the
/// picture moves, and motion of another sign, unit, direction of y, or of half or twice the length. It needs no camera and no history, but
/// motion and at least one of depth, normal and albedo. It looks at 24 parts of the picture, and finds them again in the next frames.
///
///     CheapDiagnosis check; // one for each sequence
///     for (auto const& finding : check(frame)) log(to_string(finding)); // for each of the first frames, in their order
///
/// Slow motion takes some frames to show: five will do for most cameras, ten for most of the others.
class CheapDiagnosis {
    detail::BlockNotes notes{};
    std::optional<long long> number_then{};
    Extent size_then{};

public:
    /// What it finds in this frame and those before it; mostly nothing. A mistake is found in every frame that shows it.
    /// @param frame          the next one, as it goes into run()
    /// @param converted_from for hosts that convert motion vectors before they write them: the convention from which, so that the finding
    /// names the mistake in its terms
    template <class Set, class Storage>
    [[nodiscard]] std::vector<Finding> operator()(Frame<Set, Storage> const& frame, MotionConvention converted_from = {}) {
        detail::Observation seen{.size = frame.size, .number = frame.number, .convention = converted_from, .camera = frame.camera};
        auto const look_up = [&](auto channel) -> detail::Lookup {
            if constexpr (Set::template has<decltype(channel)>) return detail::lookup(frame[channel].view());
            return {};
        };
        seen.depth = look_up(depth), seen.normal = look_up(normal), seen.albedo = look_up(albedo), seen.motion = look_up(motion);
        return look_at(seen);
    }

    /// @cond
    [[nodiscard]] std::vector<Finding> look_at(detail::Observation const& seen) {
        bool const follows = size_then == seen.size && (!seen.number || !number_then || *seen.number == *number_then + 1);
        size_then = seen.size, number_then = seen.number;
        std::vector<Finding> findings;
        if (seen.depth || seen.normal || seen.albedo) detail::find_motion_by_blocks(seen, notes, follows, findings);
        return findings;
    }
    /// @endcond
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

#pragma once

#include <quell/blur/path_search.hpp>
#include <quell/blur/two_motions/directional_mean.hpp>
#include <quell/blur/two_motions/pair_history.hpp>
#include <quell/pipeline/composite.hpp>

/// Presets for motion blur from one sample per pixel at a random time of the open shutter. They read the velocity of each sample (sweep)
/// and its time. How long the shutter is open is frame.shutter.
namespace quell::inline QUELL_INSTRUCTION_SET::presets {

/// Motion blur from one sample per pixel at a random time (after Oberberger et al. 2022). Samples are gathered along the two motions that
/// meet around a pixel, and each is tested by its own trajectory. Each layer is averaged along its motion, over the gaps between samples.
/// Foreground and background layer are accumulated separately.
/// @tparam Trajectories     trajectories: RotatingTrajectories, arcs measured from the velocities around; BentTrajectories, arcs that the
/// host supplies; or StraightTrajectories, which cost less
/// @tparam S         the signal's channel type
/// @param signal     the channel to denoise
/// @param search     how the history is found
/// @param gather     how samples are gathered
template <class Trajectories = RotatingTrajectories, ChannelTag S>
constexpr auto blur(S signal, PathSearch search = {}, PairGather<S, Trajectories> gather = {}) {
    return Pipeline{signal, Spatial{PairGuide<Trajectories>{}}, Spatial{gather}, Spatial{DirectionalMean{gather}},
                    Temporal{search, PairBlend<S>{}, PairFetch<S>{search.along(foreground_sweep)}}};
}

/// Motion blur for shadows and reflections that do not move like their surfaces: each signal has velocities of its own (as MB section 6
/// proposes). The picture is direct * visibility + glossy + albedo * indirect, each blurred along straight lines.
/// @param search how the history is found
template <class = void> constexpr auto blur_split(PathSearch search = {}) {
    return Composite{blur<StraightTrajectoriesAlong<SweepOf<Visibility>>>(visibility, search),
                     blur<StraightTrajectoriesAlong<SweepOf<Glossy>>>(quell::glossy, search), blur<StraightTrajectories>(direct, search),
                     blur<StraightTrajectories>(indirect, search), blur<StraightTrajectories>(albedo, search)};
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::presets

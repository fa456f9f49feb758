#pragma once

#include <quell/blur/path_search.hpp>
#include <quell/blur/two_motions/pair_history.hpp>
#include <quell/pipeline/composite.hpp>

/// Presets for motion blur from one sample per pixel at a random time. They want the way that what is seen goes while the shutter is open
/// (sweep), and when it was seen (time).
namespace quell::presets {

/// Motion blur from one sample per pixel at a random time (after Oberberger et al. 2022): samples are gathered along the two motions that
/// meet around a pixel, tested by their own paths one by one, and what is in front and what is behind are each accumulated over frames.
/// @tparam Paths TurningPaths: what turns is blurred along arcs, which are measured; BentPaths: arcs that the host supplies; or
/// StraightPaths, which cost less
/// @param search how the past is found. How long the shutter is open each frame says: frame.shutter
template <class Paths = TurningPaths, class Footprint = FixedFootprint, ChannelTag S>
constexpr auto blur(S signal, PathSearch search = {}, PairGather<S, Paths, Footprint> gather = {}) {
    return Pipeline{signal, Spatial{PairGuide<Paths>{}}, Spatial{gather},
                    Temporal{search, PairBlend<S>{}, PairFetch<S>{search.along(front_sweep)}}};
}

/// blur where shadows and reflections don't move like the surfaces that show them: each along sweeps of its own (the way out that MB
/// section 6 names). direct * visibility + glossy + albedo * indirect, all of them blurred, along straight lines.
template <class = void> constexpr auto blur_split(PathSearch search = {}) {
    return Composite{blur<StraightPathsAlong<SweepOf<Visibility>>>(visibility, search),
                     blur<StraightPathsAlong<SweepOf<Glossy>>>(quell::glossy, search), blur<StraightPaths>(direct, search),
                     blur<StraightPaths>(indirect, search), blur<StraightPaths>(albedo, search)};
}

} // namespace quell::presets

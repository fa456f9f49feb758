#pragma once

#include "options.hpp"

#include <quell/frame/frame.hpp>
#include <quell/metrics/picture.hpp>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace quell::bench {

/// All that any contender reads. `radiance` is the noisy picture.
using FitFrame =
    Frame<Channels<Radiance, Albedo, Normal, Depth, Position, Roughness, Motion, Direct, Visibility, Light, LightPrevious, Blocker,
                   BlockerPrevious, ReceiverPrevious, Glossy, GlossyHit, GlossyHitPrevious, Indirect, IndirectDirection, Sweep, Time>>;

/// Makes this the noisy picture of a frame.
void put_picture(metrics::Picture const& picture, FitFrame& frame);

/// A converged frame, as displayed.
struct Converged {
    long long frame = 0;
    metrics::Picture displayed;
};

/// Frames to fit a composition to, in order, as often as is wanted.
class FitSequence {
public:
    virtual ~FitSequence() = default;

    std::string name; ///< as the header calls it
    Extent size;
    std::vector<long long> numbers;
    std::set<std::string> channels; ///< those that its frames have, by name
    bool has_camera = true;
    std::vector<Converged> converged; ///< of the scored frames, ascending

    /// @throws Error naming the file and what is wrong with it
    virtual void load(long long number, FitFrame& frame) = 0;
};

/// A scene, rendered, with its references.
/// @throws Error for a scene that there isn't
[[nodiscard]] std::unique_ptr<FitSequence> scene_sequence(FitOptions const& options);
/// Frames from files.
/// @throws Error where there are none, none has a reference, or they are too few for a history to fill
[[nodiscard]] std::unique_ptr<FitSequence> file_sequence(FitOptions const& options);

} // namespace quell::bench

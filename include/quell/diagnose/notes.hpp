#pragma once

#include <quell/core/instruction_set.hpp>

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Counts of a comparison of two motion conventions: pixels where only the first, or only the second, leads to the surface seen in the
/// pixel; and pixels where they lead to different places.
struct Comparison {
    long long first = 0, second = 0, apart = 0;
};

/// State of diagnose between calls. It lives in the history, from the first call on.
struct DiagnosisNotes {
    std::vector<float> input;              ///< the signal of the last call's frame, at the sampled pixels
    long long resets = 0;                  ///< resets of the history up to the last call
    int resets_in_a_row = 0;               ///< consecutive runs before this call that began without a past
    int idle_in_a_row = 0;                 ///< consecutive runs whose output was their input
    int calls_without_surface = 0;         ///< calls with no finite depth, before the first with one
    bool had_surface = false;              ///< whether any call had a surface
    std::optional<float> constant_depth{}; ///< depth of the last call's frame if it was constant
    glm::vec2 motion_offset{};             ///< common offset of static pixels in pixels, if it may be jitter
    int jittered_in_a_row = 0;             ///< consecutive frames whose motion had an offset like jitter
    std::vector<Comparison> comparisons{}; ///< each convention against each, over all frames
    int disagreed_in_a_row = 0;            ///< consecutive frames whose cameras find the past where motion does not
    int swept_wrongly_in_a_row = 0;        ///< consecutive frames whose sweeps contradict the cameras
    glm::vec2 shift{};                     ///< movement of the projection's centre, in pixels
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

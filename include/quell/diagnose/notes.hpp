#pragma once

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace quell::detail {

/// How often two conventions of motion led to different places, and only one of them to what is seen: at the edges of what moves.
struct Duel {
    long long first = 0, second = 0, apart = 0;
};

/// What diagnose remembers from one call to the next. It lives in the history, and only once diagnose has been called.
struct DiagnosisNotes {
    std::vector<float> input;              ///< the signal of the last call's frame, at the places that are looked at
    long long resets = 0;                  ///< of the history, at the last call
    int resets_in_a_row = 0;               ///< of the runs before this call
    int idle_in_a_row = 0;                 ///< runs whose output was what went in
    int calls_without_surface = 0;         ///< of depth, from the first on
    bool had_surface = false;              ///< in any call
    std::optional<float> constant_depth{}; ///< of the last call's frame, where all its depths are one
    glm::vec2 motion_offset{};             ///< what most still pixels had in common, in pixels, where that may be jitter
    int jittered_in_a_row = 0;             ///< frames whose motion had an offset as jitter makes them
    std::vector<Duel> duels{};             ///< of each convention with each, in all frames so far
    int disagreed_in_a_row = 0;            ///< frames whose cameras find the past where motion doesn't
    int swept_wrongly_in_a_row = 0;        ///< frames whose sweeps are not what the cameras say
    glm::vec2 shift{};                     ///< how the projection's centre moved, in pixels
};

} // namespace quell::detail

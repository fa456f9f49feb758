#pragma once

#include <quell/diagnose/observation.hpp>

#include <algorithm>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline std::string why_afresh(Observation const& seen, SignalSeen const& signal) {
    if (!(seen.size == signal.size_then)) return "its size went from " + to_string(signal.size_then) + " to " + to_string(seen.size);
    if (seen.number && signal.number_then && *seen.number != *signal.number_then + 1)
        return "frame.number went from " + std::to_string(*signal.number_then) + " to " + std::to_string(*seen.number);
    return "numbers and sizes follow each other";
}

/// Three consecutive runs without a past: cuts are rarer.
inline void find_resets(Observation const& seen, std::vector<Finding>& findings) {
    auto const with_past = std::ranges::find_if(seen.of_signals, &SignalSeen::has_past);
    if (with_past == seen.of_signals.end()) return;
    auto const& signal = *with_past;
    auto& notes = *signal.notes;
    bool const afresh = signal.frames <= 1 && signal.resets == notes.resets + 1;
    notes.resets_in_a_row = afresh ? notes.resets_in_a_row + 1 : 0;
    notes.resets = signal.resets;
    if (notes.resets_in_a_row < 3) return;
    findings.push_back(
        {Mistake::resets_every_frame,
         "the last " + std::to_string(notes.resets_in_a_row) + " runs each began without a past; " + why_afresh(seen, signal),
         "count frame.number up by 1 for every run() of this history or leave it unset, keep one size, and call forget() at "
         "cuts only"});
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

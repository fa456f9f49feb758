#pragma once

#include <quell/core/instruction_set.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// A frame of a history that holds several, or keeps something beside one. Where an error ends the frame, as for want of memory, the
/// history forgets: parts that have run would be a frame ahead of the others.
template <class History> class Unfinished {
    History* history;

public:
    explicit Unfinished(History& of) : history(&of) {}
    ~Unfinished() {
        if (history) history->forget();
    }
    Unfinished(Unfinished const&) = delete;
    Unfinished& operator=(Unfinished const&) = delete;

    /// Of the whole frame.
    void finish() { history = nullptr; }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

#pragma once

#include <quell/core/instruction_set.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// What is kept of the last frames, the nearest first, and place for what will be kept of the running one: that of the oldest.
/// @tparam Kept of each frame; empty where it is made by default
/// @tparam most how many frames are kept
template <class Kept, std::size_t most> class KeptFrames {
    std::array<Kept, most + 1> frames{};
    std::size_t known = 0;
    bool complete = false; ///< whether the last frame has ended without an error
    std::optional<long long> number{};

public:
    /// Begins a frame. Nothing is known where the last one ended by an error, or where this one does not follow it.
    /// @param frame_number none: it follows
    void start(std::optional<long long> frame_number) {
        bool const follows = !frame_number || !number || *frame_number == *number + 1;
        if (!std::exchange(complete, false) || !follows) known = 0;
        number = frame_number;
    }
    /// What is known of the frames before the running one.
    [[nodiscard]] std::span<Kept const> before() const { return std::span(frames).first(known); }
    /// The running frame's place, with what is left there of the oldest.
    [[nodiscard]] Kept& place() { return frames.back(); }
    /// Ends the running frame, of which its place holds what the next ones may know.
    void finish() {
        std::rotate(frames.begin(), frames.end() - 1, frames.end());
        known = std::min(known + 1, most);
        complete = true;
    }
    /// The next frame knows none.
    void forget() { known = 0; }
    /// The bytes of all that is held.
    [[nodiscard]] std::size_t bytes() const {
        std::size_t sum = 0;
        for (auto const& each : frames)
            if (each) sum += each->bytes();
        return sum;
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

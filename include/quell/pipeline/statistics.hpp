#pragma once

#include <quell/frame/repair.hpp>

#include <algorithm>
#include <array>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Pixels of a frame with guides that no scene has, which are repaired (docs/channels.md, impossible guides). A pixel without a surface
/// needs no normal.
struct RepairedGuides {
    long long pixels = 0; ///< with one or more
    /// @cond
    std::array<long long, detail::CheckedGuides::size> by_guide{}; // in the order of CheckedGuides
    /// @endcond

    /// Those of one guide: of(albedo), of(normal), of(depth) or of(motion).
    template <ChannelTag C> [[nodiscard]] constexpr long long of(C) const {
        static_assert(detail::CheckedGuides::has<C>, "repaired_guides.of(channel): no value of this channel is repaired");
        return by_guide[static_cast<std::size_t>(detail::number_of_guide<C>())];
    }
    /// Calls visit(channel, what is impossible of it in words, pixels) for each guide.
    void for_each(auto const& visit) const {
        for_each_channel(detail::CheckedGuides{}, [&]<class C>(C c) { visit(c, detail::Repair<C>::impossible, of(c)); });
    }
    /// Adds those of another frame.
    RepairedGuides& operator+=(RepairedGuides const& other) {
        pixels += other.pixels;
        for (std::size_t i = 0; i < by_guide.size(); ++i) by_guide[i] += other.by_guide[i];
        return *this;
    }
    /// Takes each count of another run with the same frame that is larger.
    void raise_to(RepairedGuides const& other) {
        pixels = std::max(pixels, other.pixels);
        for (std::size_t i = 0; i < by_guide.size(); ++i) by_guide[i] = std::max(by_guide[i], other.by_guide[i]);
    }
};

/// Counts of the runs with one history.
struct Statistics {
    long long frames = 0;           ///< since the last reset
    long long missing_samples = 0;  ///< in the last frame: not finite, a component beyond 1e16, or negative luminance
    RepairedGuides repaired_guides; ///< in the last frame
    /// Light that SuppressFireflies took away in the last frame: sum of luminance, in the units of the host's samples. The same for any
    /// number of threads.
    double suppressed = 0;
    long long resets = 0; ///< how often history was dropped: first frame, new size, gap in the frame numbers, forget()
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

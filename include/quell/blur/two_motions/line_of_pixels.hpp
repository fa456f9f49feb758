#pragma once

#include <quell/core/for_each_turn.hpp>
#include <quell/core/recording.hpp>
#include <quell/core/value.hpp>

#include <type_traits>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The pixels along a line through a pixel, to both sides: all of them, or a subset within the budget. Beside a slanted line both nearest
/// pixels are visited.
/// @tparam Lane float; or the Real of a kernel that is recorded
template <class Lane = float> struct LineOfPixels {
    static constexpr int max_steps = 128; ///< steps, for any budget
    using Mask = decltype(Lane(0.f) < Lane(0.f));
    Mask steep, slanted;
    Lane slope, bent, whole, reach, step;
    Lane steps; ///< a whole number

    /// @param speed velocity, in pixels per open shutter
    /// @param bend distance from the chord to the middle of the arc, in pixels
    /// @param part how far the line reaches, as a fraction of the sweep: a sample farther away passes this pixel while the shutter is open
    /// with a probability of at most 1 - part. One or two pixels are always within reach.
    /// @param budget pixels to visit at most, besides the pixel itself: a whole number
    constexpr LineOfPixels(vec2<Lane> const& speed, vec2<Lane> const& bend, float part, std::type_identity_t<Lane> budget)
        : steep(abs(speed.y) > abs(speed.x)), slanted(false), slope(0.f), bent(0.f), whole(0.f), reach(0.f), step(0.f), steps(0.f) {
        auto const major = select(steep, speed.y, speed.x), minor = select(steep, speed.x, speed.y);
        slope = minor / select(abs(major) > Lane(1e-6f), major, Lane(1.f));
        bent = fma(-slope, select(steep, bend.y, bend.x), select(steep, bend.x, bend.y));
        slanted = either(abs(slope) > Lane(0.02f), abs(bent) > Lane(0.1f));
        whole = floor(abs(major)) + 1.f;
        reach = min(whole, floor(abs(major) * part) + 2.f);
        auto const pixels = fma(reach, Lane(2.f), Lane(1.f)), affordable = select(slanted, floor(budget * 0.5f), budget);
        steps = min(affordable, min(pixels, Lane(static_cast<float>(max_steps))));
        step = 2.f * reach / max(steps - 1.f, Lane(1.f));
    }
    /// The pixel nearest to a point of the line, `along` pixels away by rows or columns. Lines and their mirror images have the same ones.
    QUELL_KERNEL auto nearest(Lane along) const {
        auto const rounded = [](Lane a) QUELL_INLINED { return select(a < Lane(0.f), -floor(0.5f - a), floor(0.5f + a)); };
        auto const part = along / whole;
        return offset(rounded(along), rounded(fma(part * part * bent, Lane(-4.f), rounded(along) * slope)));
    }
    /// Calls visit(dx, dy) for each, the pixel itself first. Recorded: visit(dx, dy, whether that is a pixel to visit).
    /// @param state all that visit() changes
    template <class Visit, class... State> QUELL_KERNEL void for_each(Visit&& visit, State&... state) const {
        for_each_with(Mask(true), visit, state...);
    }
    /// Without the pixel itself.
    template <class Visit, class... State> QUELL_KERNEL void for_each_other(Visit&& visit, State&... state) const {
        for_each_with(Mask(false), visit, state...);
    }
    /// With the pixel itself or without it.
    template <class Visit, class... State> QUELL_KERNEL void for_each_with(Mask itself, Visit&& visit, State&... state) const {
        if constexpr (on_device || records<Lane>)
            for_each_in_turn(itself, visit, state...);
        else {
            // All places first, so that the loads of several visits overlap.
            glm::ivec2 places[2 * max_steps + 1];
            int n = 0;
            if (itself) places[n++] = {0, 0};
            for (int i = 0; i < static_cast<int>(steps); ++i) {
                auto const at = place(static_cast<float>(i));
                int const a = static_cast<int>(at.along), first = static_cast<int>(at.first);
                for (int k = 0; k <= (slanted ? 1 : 0); ++k)
                    if (int const b = first + k; a != 0 || b != 0) places[n++] = steep ? glm::ivec2(b, a) : glm::ivec2(a, b);
            }
            for (int i = 0; i < n; ++i) visit(places[i].x, places[i].y);
        }
    }

private:
    /// The same without an array. Other threads run while one waits for its loads.
    template <class Visit, class... State> QUELL_KERNEL void for_each_in_turn(Mask itself, Visit&& visit, State&... state) const {
        auto const beside = select(slanted, Lane(2.f), Lane(1.f)), before = masked(itself, Lane(1.f));
        auto const visit_one = [&](Lane turn) QUELL_INLINED {
            auto const n = turn - before, i = floor(n * select(slanted, Lane(0.5f), Lane(1.f)));
            auto const at = place(i);
            auto const is_itself = n < Lane(0.f);
            auto const a = select(is_itself, Lane(0.f), at.along), b = select(is_itself, Lane(0.f), at.first + (n - i * beside));
            auto const again = both(invert(is_itself), a == Lane(0.f), b == Lane(0.f));
            auto const where = offset(a, b);
            if constexpr (records<Lane>)
                visit(where.x, where.y, invert(again));
            else if (!again)
                visit(where.x, where.y);
        };
        for_each_turn(fma(steps, beside, before), visit_one, state...);
    }
    struct Place {
        Lane along, first; ///< whole numbers
    };
    /// The i-th step along the line, and the first pixel beside it.
    QUELL_KERNEL Place place(Lane i) const {
        // fma fixes the rounding, which decides which pixel is visited.
        auto const along = floor(fma(i, step, -reach) + 0.5f), part = along / whole;
        auto const aside = fma(part * part * bent, Lane(-4.f), along * slope);
        return {along, floor(select(slanted, aside, aside + 0.5f))};
    }
    struct Offset {
        Index<Lane> x, y;
    };
    QUELL_KERNEL Offset offset(Lane along, Lane aside) const {
        return {in_pixels(select(steep, aside, along)), in_pixels(select(steep, along, aside))};
    }
    QUELL_KERNEL static Index<Lane> in_pixels(Lane a) {
        if constexpr (records<Lane>)
            return truncate(a);
        else
            return static_cast<int>(a);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

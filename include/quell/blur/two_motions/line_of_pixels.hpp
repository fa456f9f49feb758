#pragma once

#include <quell/core/real.hpp>
#include <quell/core/value.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// The pixels along a line through a pixel, to both sides: all of them, or a subset within the budget. Beside a slanted line both nearest
/// pixels are visited.
struct LineOfPixels {
    static constexpr int max_steps = 128; ///< steps, for any budget
    bool steep, slanted;
    float slope, bent, whole, reach, step;
    int steps;

    /// @param speed velocity, in pixels per open shutter
    /// @param bend distance from the chord to the middle of the arc, in pixels
    /// @param part how far the line reaches, as a fraction of the sweep: a sample farther away passes this pixel while the shutter is open
    /// with a probability of at most 1 - part. One or two pixels are always within reach.
    /// @param budget pixels to visit at most, besides the pixel itself
    constexpr LineOfPixels(glm::vec2 const& speed, glm::vec2 const& bend, float part, int budget)
        : steep(abs(speed.y) > abs(speed.x)), slanted(false), slope(0), bent(0), whole(0), reach(0), step(0), steps(0) {
        float const major = steep ? speed.y : speed.x, minor = steep ? speed.x : speed.y;
        slope = minor / (abs(major) > 1e-6f ? major : 1.f);
        bent = fma(-slope, steep ? bend.y : bend.x, steep ? bend.x : bend.y);
        slanted = abs(slope) > 0.02f || abs(bent) > 0.1f;
        whole = floor(abs(major)) + 1.f;
        reach = min(whole, floor(abs(major) * part) + 2.f);
        float const pixels = fma(reach, 2.f, 1.f), affordable = static_cast<float>(slanted ? budget / 2 : budget);
        steps = static_cast<int>(min(affordable, min(pixels, static_cast<float>(max_steps))));
        step = 2.f * reach / max(static_cast<float>(steps - 1), 1.f);
    }
    /// Number of pixels.
    constexpr int size() const { return slanted ? 2 * steps : steps; }
    /// The pixel nearest to a point of the line, `along` pixels away by rows or columns. Lines and their mirror images have the same ones.
    QUELL_KERNEL glm::ivec2 nearest(float along) const {
        auto const rounded = [](float a) { return a < 0.f ? -floor(0.5f - a) : floor(0.5f + a); };
        float const part = along / whole;
        int const a = static_cast<int>(rounded(along)),
                  b = static_cast<int>(rounded(fma(part * part * bent, -4.f, rounded(along) * slope)));
        return steep ? glm::ivec2(b, a) : glm::ivec2(a, b);
    }
    /// Calls visit(dx, dy) for each, the pixel itself first.
    template <class Visit> QUELL_KERNEL void for_each(Visit&& visit) const { for_each(visit, true); }
    /// Without the pixel itself.
    template <class Visit> QUELL_KERNEL void for_each_other(Visit&& visit) const { for_each(visit, false); }

private:
    template <class Visit> QUELL_KERNEL void for_each(Visit&& visit, bool itself) const {
        if constexpr (on_device) return for_each_in_turn(visit, itself);
        // All places first, so that the loads of several visits overlap.
        glm::ivec2 places[2 * max_steps + 1];
        int n = 0;
        if (itself) places[n++] = {0, 0};
        for (int i = 0; i < steps; ++i) {
            auto const [a, first] = place(i);
            for (int k = 0; k <= (slanted ? 1 : 0); ++k)
                if (int const b = first + k; a != 0 || b != 0) places[n++] = steep ? glm::ivec2(b, a) : glm::ivec2(a, b);
        }
        for (int i = 0; i < n; ++i) visit(places[i].x, places[i].y);
    }
    /// The same without an array. Other threads run while one waits for its loads.
    template <class Visit> QUELL_KERNEL void for_each_in_turn(Visit&& visit, bool itself) const {
        int const beside = slanted ? 2 : 1;
        for (int n = itself ? -1 : 0; n < steps * beside; ++n) {
            int a = 0, b = 0;
            if (n >= 0) {
                auto const at = place(n / beside);
                a = at.along, b = at.first + n % beside;
                if (a == 0 && b == 0) continue;
            }
            visit(steep ? b : a, steep ? a : b);
        }
    }
    struct Place {
        int along, first;
    };
    /// The i-th step along the line, and the first pixel beside it.
    QUELL_KERNEL Place place(int i) const {
        // fma fixes the rounding, which decides which pixel is visited.
        float const along = floor(fma(static_cast<float>(i), step, -reach) + 0.5f), part = along / whole;
        float const aside = fma(part * part * bent, -4.f, along * slope);
        return {static_cast<int>(along), static_cast<int>(floor(slanted ? aside : aside + 0.5f))};
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

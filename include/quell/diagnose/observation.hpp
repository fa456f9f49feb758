#pragma once

#include <quell/core/value.hpp>
#include <quell/diagnose/finding.hpp>
#include <quell/diagnose/notes.hpp>
#include <quell/frame/camera.hpp>
#include <quell/frame/motion_convention.hpp>

#include <glm/vec3.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace quell::detail {

/// Component c of an image at (x, y), whatever its storage; empty where the pipeline reads no such channel. Hypotheses are judged on this,
/// so that they are compiled once and not for every pipeline.
using Lookup = std::function<float(int c, int x, int y)>;

inline glm::vec2 vec2_at(Lookup const& image, int x, int y) { return {image(0, x, y), image(1, x, y)}; }
inline glm::vec3 vec3_at(Lookup const& image, int x, int y) { return {image(0, x, y), image(1, x, y), image(2, x, y)}; }

/// One signal that is denoised, and what its history knows.
struct SignalSeen {
    std::string name;
    int components = 1;
    bool has_past = false;   ///< whether the pipeline has a history at all
    bool has_stages = false; ///< whether it does anything
    bool blurs = false;      ///< along sweeps: then what stands still comes out as it went in
    Lookup input{};
    Lookup output_then{}; ///< of the last run; empty where there was none, or where the host keeps it
    long long frames = 0, resets = 0;
    std::optional<long long> number_then{};
    Extent size_then{};
    DiagnosisNotes* notes = nullptr;
};

/// A channel that must be finite where there is a surface.
struct GuideSeen {
    std::string name;
    int components;
    Lookup image;
    double allowed; ///< the share of surface pixels that may be without
};

/// All that is looked at.
struct Observation {
    Extent size;
    std::optional<long long> number;
    Lookup depth{}, normal{}, albedo{};
    Lookup motion{};               ///< as the pipeline understands it
    Lookup sweep{};                ///< of the surface while the shutter is open
    float shutter = 0.f;           ///< how long that is
    MotionConvention convention{}; ///< the one that the host's vectors are taken for
    Lookup depth_then{};           ///< of the last frame, where the history remembers it
    bool has_then = false;         ///< whether camera_then is that of a last frame
    Camera camera{}, camera_then{};
    std::vector<SignalSeen> of_signals{};
    std::vector<GuideSeen> guides{};

    [[nodiscard]] DiagnosisNotes& notes() const { return *of_signals.front().notes; }
    /// Whether there is a surface: misses may hold anything.
    [[nodiscard]] bool hit(int x, int y) const { return !depth || is_finite(depth(0, x, y)); }
};

/// Calls f(x, y) for at most about 16,000 places, evenly spread.
void for_each_place(Extent size, auto&& f) {
    int step = 1;
    while (size.pixels() / (step * step) > 16384) ++step;
    for (int y = step / 2; y < size.height; y += step)
        for (int x = step / 2; x < size.width; x += step) f(x, y);
}
/// Those where there is a surface.
void for_each_hit(Observation const& seen, auto&& f) {
    for_each_place(seen.size, [&](int x, int y) {
        if (seen.hit(x, y)) f(x, y);
    });
}

} // namespace quell::detail

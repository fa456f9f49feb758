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

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Component c of an image at (x, y), for any storage; empty where the pipeline does not read the channel. Hypotheses use it, so that they
/// are compiled once and not per pipeline.
using Lookup = std::function<float(int c, int x, int y)>;

inline glm::vec2 vec2_at(Lookup const& image, int x, int y) { return {image(0, x, y), image(1, x, y)}; }
inline glm::vec3 vec3_at(Lookup const& image, int x, int y) { return {image(0, x, y), image(1, x, y), image(2, x, y)}; }

/// One signal, and the state of its history.
struct SignalSeen {
    std::string name;
    int components = 1;
    bool has_past = false;     ///< whether the pipeline has a history
    bool has_stages = false;   ///< whether the pipeline has stages
    bool demodulated = false;  ///< whether the pipeline divides it by albedo
    bool times_albedo = false; ///< whether the composite multiplies it by albedo
    bool blurs = false;        ///< whether it blurs along sweeps: its static pixels come out as they went in
    Lookup input{};
    Lookup output_then{}; ///< of the last run; empty without one, or if the host owns it (run_into)
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
    double allowed; ///< largest share of surface pixels that may be not finite
};

/// Everything that the hypotheses look at.
struct Observation {
    Extent size;
    std::optional<long long> number;
    Lookup depth{}, normal{}, albedo{};
    Lookup factor{};               ///< that the host multiplies the output by: the albedo of signals that it has divided by it; or empty
    Lookup motion{};               ///< in quell's convention, by the pipeline's Supplied
    Lookup sweep{};                ///< of the surface, in pixels
    float shutter = 0.f;           ///< fraction of the frame time
    MotionConvention convention{}; ///< convention that the host's vectors are taken for
    Lookup depth_then{};           ///< of the last frame, if the history remembers it
    bool has_then = false;         ///< whether there is a last frame; else camera_then is a default
    Camera camera{}, camera_then{};
    std::vector<SignalSeen> of_signals{};
    std::vector<GuideSeen> guides{};
    std::vector<GuideSeen> positions{};  ///< world-space positions that every surface has
    std::vector<GuideSeen> hit_points{}; ///< world-space positions that are not finite where a ray hit nothing

    [[nodiscard]] DiagnosisNotes& notes() const { return *of_signals.front().notes; }
    /// Whether the pixel shows a surface; a miss may hold anything.
    [[nodiscard]] bool hit(int x, int y) const { return !depth || is_finite(depth(0, x, y)); }
};

/// Calls f(x, y) for at most 16,384 evenly spread pixels.
void for_each_place(Extent size, auto&& f) {
    int step = 1;
    while (size.pixels() / (step * step) > 16384) ++step;
    for (int y = step / 2; y < size.height; y += step)
        for (int x = step / 2; x < size.width; x += step) f(x, y);
}
/// The same for pixels with a surface.
void for_each_hit(Observation const& seen, auto&& f) {
    for_each_place(seen.size, [&](int x, int y) {
        if (seen.hit(x, y)) f(x, y);
    });
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

#pragma once

#include <quell/frame/camera.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Counts of a comparison of two motion conventions: pixels where only the first, or only the second, leads to the surface seen in the
/// pixel; and pixels where they lead to different places.
struct Comparison {
    long long first = 0, second = 0, apart = 0;
};

/// Sums of a signal on both sides of edges in albedo, by how strong the edge is and in groups that tell how sure the sums are.
struct EdgeSums {
    static constexpr int groups = 8, strengths = 4;
    struct Sum {
        double bright = 0., dark = 0., logarithms = 0.;
        long long edges = 0;
    };
    std::array<std::array<Sum, strengths>, groups> sums{};
    long long edges = 0;
};

/// A pixel with its neighbours to the right and below.
struct Patch {
    std::array<glm::vec3, 3> signal{}, albedo{};
};

/// What the guides say of a pixel.
struct Texel {
    float depth = 1.f;
    glm::vec3 normal{}, albedo{};
};
/// Some pixels around a place of an earlier frame.
struct GuideBlock {
    static constexpr int third = 3, side = 3 * third; ///< texels of a third, and of the whole
    static constexpr std::size_t count = side * side;
    glm::ivec2 at{}; ///< the middle
    std::array<Texel, count> texels{};
    using Ways = std::array<glm::vec2, 9>; ///< one for each third of a third
    /// How far it went since, and in the last frame, by each reading of motion, in pixels. NaN where that is unknown.
    std::vector<Ways> ways{}, steps{};
};
/// What the blocks of all frames said of motion.
struct BlockNotes {
    std::vector<GuideBlock> blocks{};
    glm::vec2 jitter{};                    ///< of their frame's camera
    int age = 0;                           ///< how many frames ago that was
    std::vector<Comparison> comparisons{}; ///< each reading of motion against each, over all frames that contradicted it
};

/// State of diagnose between calls. It lives in the history, from the first call on.
struct DiagnosisNotes {
    std::vector<float> input;              ///< the signal of the last call's frame, at the sampled pixels
    long long resets = 0;                  ///< resets of the history up to the last call
    int resets_in_a_row = 0;               ///< consecutive runs before this call that began without a past
    int idle_in_a_row = 0;                 ///< consecutive runs whose output was their input
    int calls_without_surface = 0;         ///< calls with no finite depth, before the first with one
    bool had_surface = false;              ///< whether any call had a surface
    float farthest = 0.f;                  ///< largest finite depth of the last call's frame
    std::optional<float> constant_depth{}; ///< depth of the last call's frame if it was constant
    glm::vec2 motion_offset{};             ///< common offset of static pixels in pixels, if it may be jitter
    int jittered_in_a_row = 0;             ///< consecutive frames whose motion had an offset like jitter
    glm::vec2 constant_offset{};           ///< the last frame's common offset in pixels
    int offset_in_a_row = 0;               ///< consecutive frames in which it was the same
    std::vector<Comparison> comparisons{}; ///< each convention against each, over all frames
    long long absent = 0;                  ///< how many such pixels in these frames
    std::array<long long, 3> absences{};   ///< pixels whose motion, half and twice that, lead to what is farther away, over all frames
    long long moving = 0;                  ///< of so many pixels that move
    int behind_in_a_row = 0;               ///< consecutive frames whose motion is that of the frame before
    int absent_in_a_row = 0;               ///< consecutive frames with static surfaces that the last frame did not have
    int disagreed_in_a_row = 0;            ///< consecutive frames whose cameras find the past where motion does not
    int swept_wrongly_in_a_row = 0;        ///< consecutive frames whose sweeps contradict the cameras
    int misfits_in_a_row = 0;              ///< consecutive frames that fit better with a mistake of the geometry
    std::optional<Camera> camera_before{}; ///< of the frame before the last
    std::array<EdgeSums, 5> edges{};       ///< of each Pairing of the signal with albedo, over all frames
    std::vector<Patch> patches{};          ///< of the last call's frame, at the places that were looked at
    float brightest = 0.f;                 ///< largest value of the signal at those places in all frames
    int other_power_in_a_row = 0;          ///< consecutive frames in which the signal did not follow albedo as it should
    std::vector<int> noise{};              ///< which pixels stood out in the last call's frame
    int repeats_in_a_row = 0;              ///< consecutive frames whose noise is the last one's
    BlockNotes blocks{};                   ///< of some frames ago
    BlockNotes last{};                     ///< of the last frame
    std::optional<float> strangeness{};    ///< of the last frame to the one before it
    bool said_what_is_not_checked = false;
    glm::vec2 shift{}; ///< movement of the projection's centre, in pixels
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

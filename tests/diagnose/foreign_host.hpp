#pragma once

#include "host_mistakes.hpp"

// A renderer that was not made for quell: a small path tracer of one sample per pixel, with area lights, checks and moving things.
namespace quell::tests {

/// What the guides are of.
enum class GuidesOf {
    centre,    ///< C: all are of the pixel's centre
    materials, ///< S: albedo and normal are of the sample that the path took, depth and motion of the centre
    sample,    ///< J: all are of the sample
};
enum class Path { dolly, orbit, pan, still, jittered };
enum class Set { studio, plaza, terrace };

inline constexpr char const* name_of(GuidesOf guides) {
    return guides == GuidesOf::centre ? "C" : guides == GuidesOf::materials ? "S" : "J";
}

struct ForeignShot {
    Set set = Set::studio;
    Path path = Path::dolly;
    GuidesOf guides = GuidesOf::centre;
    Extent size{240, 135};
    bool one_seed = false; ///< the same random numbers in every frame

    [[nodiscard]] Camera camera_at(int number) const;
};

/// Renders frame `number`.
Places render(GoodFrame& frame, ForeignShot const& shot, int number);

} // namespace quell::tests

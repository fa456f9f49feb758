#pragma once

#include <cstdint>
#include <string>

namespace quell_library {

/// What is done and kept before a preset runs whose guides are made steady first: a sentence before its plan. It is here, apart from
/// quell's headers, as it is the same for all instruction sets.
/// @param steady_guides as quell_settings has it, not 0
[[nodiscard]] inline std::string plan_of_steady(std::int32_t steady_guides) {
    constexpr int copied = 2 + 1 + 3; // of a frame: motion, depth and albedo
    // Of each guide a mean and its number of frames, of this frame and the last one, and what comes out.
    constexpr auto kept = [](int components) { return 2 * (components + 1) + components; };
    bool const has_depth = (steady_guides & 1) != 0, has_albedo = (steady_guides & 2) != 0;
    int const floats = copied + (has_depth ? kept(1) : 0) + (has_albedo ? kept(3) : 0);
    return std::string("Before it, ") +
           (!has_albedo  ? "depth is"
            : !has_depth ? "albedo is"
                         : "depth and albedo are") +
           " accumulated along the motion, over 8 frames at most, which takes " + std::to_string(floats * static_cast<int>(sizeof(float))) +
           " bytes a pixel of the frames.\n\n";
}

} // namespace quell_library

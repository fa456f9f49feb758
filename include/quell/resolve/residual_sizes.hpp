#pragma once

#include <quell/core/error.hpp>
#include <quell/image/extent.hpp>

#include <glm/vec3.hpp>

#include <string>
#include <utility>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// @param what function the images were given to
/// @throws Error where they differ in size
inline void check_residual_sizes(std::string const& what, std::vector<glm::vec3> const& samples, Extent normal, Extent depth,
                                 std::vector<glm::vec3> const& picture) {
    if (!(normal == depth))
        raise_error(what + ": the normals", to_string(normal) + " beside depths of " + to_string(depth), "give both the picture's size");
    auto const pixels = static_cast<std::size_t>(depth.pixels());
    for (auto const& [image, count] : {std::pair{": the samples", samples.size()}, std::pair{": the picture", picture.size()}})
        if (count != pixels)
            raise_error(what + image, std::to_string(count) + " pixels beside depths of " + to_string(depth),
                        "give one value for each pixel, row by row");
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

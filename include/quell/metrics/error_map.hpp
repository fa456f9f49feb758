#pragma once

#include <quell/metrics/flip.hpp>

#include <array>

namespace quell::inline QUELL_INSTRUCTION_SET::metrics {

/// Colour of an error in [0, 1], from dark to bright: the magma map (Smith and van der Walt 2015, CC0) that FLIP's authors use, linear
/// between nine of its colours; no component differs by more than 0.04. Displayed, in [0, 1].
[[nodiscard]] inline glm::vec3 magma(float error) {
    static constexpr std::array<std::uint32_t, 9> colours{0x000004, 0x221150, 0x51127c, 0x822681, 0xb63679,
                                                          0xe65164, 0xfb8861, 0xfec287, 0xfcfdbf};
    auto const rgb = [](std::uint32_t c) { return glm::vec3((c >> 16) & 255u, (c >> 8) & 255u, c & 255u) / 255.f; };
    auto const at = error * static_cast<float>(colours.size() - 1);
    auto const below = std::min(static_cast<std::size_t>(at), colours.size() - 2);
    auto const t = at - static_cast<float>(below);
    return rgb(colours[below]) * (1.f - t) + rgb(colours[below + 1]) * t;
}

/// A displayed picture of the errors.
/// @throws Error where `flip` has another number of errors than pixels, or one outside [0, 1]
[[nodiscard]] inline Picture error_map(Flip const& flip) {
    detail::check_size("FLIP error", flip.size, flip.error.size());
    Picture result{flip.size, {}};
    for (auto const error : flip.error) {
        if (!detail::in_unit_range(error)) raise_error("FLIP error", "one value is " + std::to_string(error), "give values in [0, 1]");
        result.pixels.push_back(magma(error));
    }
    return result;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET::metrics

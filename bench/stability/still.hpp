#pragma once

#include "scored_sequence.hpp"

namespace quell::stability {

/// A frame of a room in which nothing moves and all signals are even: `radiance` is `light` everywhere, and so is the picture that is put
/// together from direct light without shadows, glossy reflection and indirect light.
[[nodiscard]] io::ExrImage even_frame(float light, Making const& making);

/// A picture of one grey.
[[nodiscard]] metrics::Picture even_picture(float light, Extent size);

/// The planes of the signals, each of which carries this part of the picture.
struct SignalPlane {
    std::string name;
    float part;
};
[[nodiscard]] std::vector<SignalPlane> const& signal_planes();

} // namespace quell::stability

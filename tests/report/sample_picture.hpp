#pragma once

#include <array>
#include <vector>

namespace quell::examples::sample {

using Color = std::array<double, 3>; ///< red, green and blue from 0 to 1, as shown

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Color> pixels = {};
};

/// A ball over a chequered floor, lit from a side that turns with the frame.
Picture draw_scene(int width, int height, int frame);

/// The same with noise of this strength, different in every frame.
Picture add_noise(Picture picture, double strength, int frame);

/// A stand-in for an error map: the difference of the pictures in the colours of the given stops, 0xrrggbb each.
Picture draw_difference(Picture const& a, Picture const& b, std::vector<unsigned> const& stops);

double mean_difference(Picture const& a, Picture const& b);

/// The picture as a PNG file.
std::vector<unsigned char> encode_png(Picture const& picture);

} // namespace quell::examples::sample

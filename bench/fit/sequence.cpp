#include "sequence.hpp"

void quell::bench::put_picture(metrics::Picture const& picture, FitFrame& frame) {
    auto value = picture.pixels.begin();
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) frame[radiance].set(x, y, *value++);
}

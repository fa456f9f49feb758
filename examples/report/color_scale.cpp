#include "report/report.hpp"

namespace quell::examples {

ColorScale flip_color_scale() {
    // Ten evenly spaced samples of magma: a gradient between them differs from the full map by less than the eye can tell.
    return {
        "FLIP error", 0, 1, {"#000004", "#180f3d", "#440f76", "#721f81", "#9e2f7f", "#cd4071", "#f1605d", "#fd9668", "#feca8d", "#fcfdbf"}};
}

} // namespace quell::examples

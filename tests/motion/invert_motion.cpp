#include "../frames.hpp"

#include <quell/motion/invert_motion.hpp>

using namespace quell;

TEST_CASE("motion of the next frame turned round leads there and back, and nowhere where it is hidden") {
    constexpr Extent size{64, 48};
    Planar<>::Image<2> next_motion(size), to(size);
    Planar<>::Image<1> depth(size);
    // A near square of 10x10 moves by (3, -2) before a wall that stands still; the next frame has it at (20, 15).
    auto const in_square = [](int x, int y) { return x >= 20 && x < 30 && y >= 15 && y < 25; };
    tests::fill(next_motion, [&](int x, int y) { return in_square(x, y) ? glm::vec2(-3, 2) : glm::vec2(0); });
    tests::fill(depth, [&](int x, int y) { return in_square(x, y) ? 2.f : 8.f; });
    invert_motion(to.view(), next_motion.view(), depth.view());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float const dx = to.view().get(0, x, y), dy = to.view().get(1, x, y);
            bool const square_now = in_square(x + 3, y - 2), hidden = in_square(x, y) && !square_now;
            if (hidden)
                CHECK(!is_finite(dx));
            else {
                CHECK(dx == doctest::Approx(square_now ? 3.f : 0.f));
                CHECK(dy == doctest::Approx(square_now ? -2.f : 0.f));
            }
        }
}

#include <gauntlet/worlds.hpp>

namespace quell::gauntlet {

World court() {
    World world;
    world.things = {
        {.shape = Shape::floor, .material = {{0.62, 0.58, 0.5}, {0.3, 0.29, 0.27}, 0.7}},
        {.shape = Shape::box,
         .at = {-1.6, 0.5, -1.6},
         .half = {0.5, 0.5, 0.4},
         .material = {{0.75, 0.25, 0.2}, {0.35, 0.12, 0.1}, 0.27},
         .angle = 0.5},
        {.shape = Shape::box,
         .at = {1.9, 1., -2.2},
         .half = {0.3, 1., 0.3},
         .material = {{0.25, 0.6, 0.3}, {0.65, 0.7, 0.5}, 0.22},
         .angle = -0.3},
        {.shape = Shape::ball,
         .at = {-0.5, 0.45, -0.5},
         .half = Vec3(0.45),
         .material = {{0.85, 0.8, 0.3}, {0.3, 0.3, 0.7}, 0.3},
         .speed = {0.06, 0., 0.01}},
        {.shape = Shape::box, .at = {0.5, 1.3, -3.}, .half = {1., 0.65, 0.06}, .material = {{0.8, 0.75, 0.7}, {0.12, 0.2, 0.35}, 0.31}},
        {.shape = Shape::box, .at = {-3.6, 0.9, -5.}, .half = {1.8, 0.9, 0.2}, .material = {{0.6, 0.5, 0.4}, {0.45, 0.36, 0.3}, 0.5}},
    };
    return world;
}

World plain_court() {
    auto world = court();
    world.sky.detail = 0;
    return world;
}

World drops() {
    auto world = plain_court();
    for (int i = 0; i < 14; ++i) {
        double const u = fraction_of(static_cast<std::uint64_t>(i)), v = fraction_of(static_cast<std::uint64_t>(i + 50));
        world.things.push_back({.shape = Shape::ball,
                                .at = {-3. + 6. * u, 1.7 + 1.3 * v, -2.5 - 1.5 * fraction_of(static_cast<std::uint64_t>(i + 90))},
                                .half = Vec3(0.1 + 0.08 * v),
                                .material = {{0.7, 0.72, 0.75}, {0.5, 0.55, 0.65}, 0.2},
                                .speed = {0.05 * (u - 0.5), 0.05, 0.02},
                                .is_apart = true});
    }
    return world;
}

} // namespace quell::gauntlet

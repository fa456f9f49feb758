#include "../views.hpp"

#include <baselines/presets.hpp>

#include <algorithm>
#include <array>

using namespace quell;
using tests::View;

namespace {
constexpr Extent size{96, 48};
constexpr auto denoise = presets::shadow(visibility);
constexpr auto paper = presets::shadow_paper(visibility);
View const view({0, 6, 5}, {0, 0, 0}, size);
constexpr double light_side = 1.2, light_height = 4, blocker_height = 2;

glm::dvec3 receiver(int x, int y) { return tests::ground(view, x, y); }
/// Hangs half way between a square light and the ground, from one x to another.
struct Bar {
    double from, to;
    /// What part of the light is seen from a point of the ground: the bar's edges as seen against the light.
    [[nodiscard]] double seen(glm::dvec3 at) const {
        double const half = 0.5 * light_side;
        double const left = std::clamp(2 * from - at.x, -half, half), right = std::clamp(2 * to - at.x, -half, half);
        return 1 - (right - left) / light_side;
    }
};

/// Means over 200 frames and all pixels that belong: of what came out, of what went in, and of the map of probabilities.
template <class P> std::array<double, 3> means(P const& pipeline, Bar bar, auto&& belongs) {
    Frame frame{size, pipeline};
    History history{size, pipeline};
    std::mt19937 random(21);
    std::uniform_real_distribution<double> part(-0.5 * light_side, 0.5 * light_side);
    tests::fill_ground(frame, view);
    double sum = 0, in = 0, wanted = 0;
    long long count = 0;
    for (int i = -20; i < 200; ++i) {
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                auto const s = receiver(x, y);
                glm::dvec3 const sample(part(random), light_height, part(random));
                auto const on_way = tests::meet(sample, s - sample, {0, blocker_height, 0}, {0, 1, 0});
                bool const blocked = on_way.x > bar.from && on_way.x < bar.to;
                glm::vec3 const b(blocked ? on_way : glm::dvec3(std::bit_cast<float>(0x7f800000u)));
                frame[visibility].set(x, y, blocked ? 0.f : 1.f);
                frame[light].set(x, y, glm::vec3(sample)), frame[light_previous].set(x, y, glm::vec3(sample));
                frame[blocker].set(x, y, b), frame[blocker_previous].set(x, y, b);
            }
        auto const out = run(pipeline, frame, history);
        if (i < 0) continue;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (belongs(x, y)) sum += out.get(0, x, y), in += frame[visibility].get(x, y), wanted += bar.seen(receiver(x, y)), ++count;
    }
    auto const n = static_cast<double>(count);
    return {sum / n, in / n, wanted / n};
}
} // namespace

TEST_CASE("a static soft shadow keeps its mean: nothing brightens or darkens") {
    auto const everywhere = [](int, int) { return true; };
    // Half of the picture in shadow; a bar that leaves a core; bars that never hide all of the light.
    for (Bar const bar : {Bar{-50, 0}, Bar{-0.6, 1.2}, Bar{-0.2, 0.2}, Bar{0.5, 0.6}})
        for (auto const& [out, in, map] : {means(denoise, bar, everywhere), means(paper, bar, everywhere)}) {
            CHECK(in == doctest::Approx(map).epsilon(0.003));
            CHECK(out == doctest::Approx(map).epsilon(0.005));
        }
}

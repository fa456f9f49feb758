#include "world.hpp"

#include <quell/presets/blur.hpp>

#include <algorithm>

using namespace quell;
using namespace quell::tests;

namespace {
constexpr Extent size{128, 128};

struct ShowBend {
    using reads = Channels<SampleTrajectory<RotatingTrajectories>>;
    template <class Px> QUELL_KERNEL auto filter(Px const& px) const {
        auto const path = px[SampleTrajectory<RotatingTrajectories>{}];
        auto const sagitta = component<5>(path);
        return vec3<typename Px::Real>{sagitta * component<1>(path), -(sagitta * component<0>(path)), typename Px::Real(0.f)};
    }
};
struct Measured {
    glm::vec2 bend;
    Seen seen;
};
/// What is measured of all that moves, in one frame.
std::vector<Measured> measured(auto&& seen_at) {
    std::vector<Measured> moving;
    std::vector<Seen> all;
    auto const keep = [&](int x, int y, int frame, float t) { return all.emplace_back(seen_at(x, y, frame, t)); };
    auto const out = World{.size = size, .frames = 1}.last(Pipeline{radiance, Spatial{RotationGuide{}}, Spatial{ShowBend{}}}, keep);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (glm::length(all[i].sweep) > 1) moving.push_back({{out[3 * i], out[3 * i + 1]}, all[i]});
    return moving;
}
float longest_bend(auto&& seen_at) {
    float most = 0;
    for (auto const& each : measured(seen_at)) most = std::max(most, glm::length(each.bend));
    return most;
}
} // namespace

TEST_CASE("of what turns, the bend is measured that a host would supply") {
    double off = 0, long_ones = 0, bends = 0;
    auto const all = measured(TurningSector::seen);
    for (auto const& each : all) {
        float const distance = glm::distance(each.bend, each.seen.bend);
        off += distance, bends += glm::length(each.seen.bend), long_ones += distance > 0.25f * glm::length(each.seen.bend);
    }
    auto const n = static_cast<double>(all.size());
    CHECK(n > 800);
    CHECK(bends / n > 4);
    CHECK(off / bends < 0.12);
    CHECK(long_ones / n < 0.05);
}

TEST_CASE("a camera that rolls bends all paths by its own turn") {
    constexpr float turn = 0.1f;
    for (auto const &each : measured([](int x, int y, int, float t) {
             auto const placed = [&](float when) { return tests::turned(centre_of(x, y), {40, 150}, turn * (when - t)); };
             return Seen{0.5f, placed(1) - placed(0), 4.f, placed(0.5f) - (placed(0) + placed(1)) * 0.5f};
         }))
        REQUIRE(glm::distance(each.bend, each.seen.bend) < 0.06f); // 0.05 are taken for straight
}

TEST_CASE("what moves in straight lines is not bent, however fast its parts are") {
    auto const still = [](auto&& sweep_of) {
        return longest_bend([&](int x, int y, int, float) { return Seen{0.5f, sweep_of(centre_of(x, y))}; });
    };
    CHECK(still([](glm::vec2) { return glm::vec2(9, -7); }) == 0.f);
    // The floor and a slanted wall, past which a camera goes sideways.
    CHECK(still([](glm::vec2 p) { return glm::vec2(2 + 0.2f * p.y, 0); }) == 0.f);
    CHECK(still([](glm::vec2 p) { return glm::vec2(2 + 0.2f * p.x, 0); }) == 0.f);
    // Two things behind each other, of which one moves in another direction.
    CHECK(longest_bend([](int x, int y, int, float t) {
              return std::sin(0.2f * (static_cast<float>(x + y) - 12.f * t)) > 0 ? Seen{1.f, {12, 0}, 4.f} : Seen{0.f, {0, 9}, 8.f};
          }) == 0.f);
    // A camera that goes forward: paths are radial. Sweeps end where the point is when the shutter closes.
    CHECK(longest_bend([](int x, int y, int, float t) {
              auto const from = centre_of(x, y) - glm::vec2(64, 64);
              return Seen{0.5f, from * (1 / (1 - 0.2f * (1 - t)) - 1 / (1 + 0.2f * t))};
          }) < 0.3f);
    // Sweeps in half precision.
    CHECK(longest_bend([](int x, int y, int, float) {
              float const wrong = 1 + static_cast<float>((x * 7 + y * 3) % 5 - 2) / 2048.f;
              return Seen{0.5f, {20 * wrong, 12}};
          }) < 0.1f);
}

TEST_CASE("what turns is blurred along its arc without a host that says so") {
    World const world{.size = size, .frames = 1};
    auto const error = [&](auto const& pipeline) {
        auto const out = world.last(pipeline, TurningSector::seen);
        double squared = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                double const off = world.at(out, x, y) - TurningSector::blurred(x, y);
                squared += off * off;
            }
        return squared;
    };
    double const turning = error(presets::blur<RotatingTrajectories>(radiance));
    CHECK(turning < 0.4 * error(presets::blur<StraightTrajectories>(radiance)));
    CHECK(turning < 1.2 * error(presets::blur<BentTrajectories>(radiance)));
}

#include "world.hpp"

#include <quell/execute/threads.hpp>

using namespace quell;
using tests::Seen, tests::World;

namespace {
constexpr auto paper = presets::blur_paper(radiance);
constexpr auto collected = Pipeline{radiance, Spatial{SampleCollector<>{}}};
} // namespace

TEST_CASE("samples are collected from along the path only") {
    World const world{.frames = 1};
    auto const out = world.last(collected, [](int, int y, int, float) { return Seen{y == 24 ? 1.f : 0.f, {20, 0}}; });
    double sum = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 24; x < 40; ++x) {
            sum += world.at(out, x, y) / 16;
            if (std::abs(y - 24) > 2) REQUIRE(world.at(out, x, y) == 0.f);
        }
    CHECK(sum == doctest::Approx(1).epsilon(0.15));
}

TEST_CASE("collected samples have less variance, by about as many as there are") {
    World const world{.frames = 1};
    std::mt19937 random(3);
    auto const noisy = [&](int, int, int, float) { return Seen{std::uniform_real_distribution<float>(0, 1)(random), {30, 0}}; };
    auto const out = world.last(collected, noisy);
    double mean = 0, squared = 0;
    for (float const a : out) mean += a / static_cast<double>(out.size()), squared += a * a / static_cast<double>(out.size());
    CHECK(mean == doctest::Approx(0.5).epsilon(0.05));
    // 19 samples, some outside the image or the open shutter, some the same for neighbours.
    CHECK(squared - mean * mean < 1 / 12. / 6);
}

TEST_CASE("what moves little is collected for by nobody") {
    World const world{.frames = 1};
    std::mt19937 random(3);
    std::vector<float> in;
    auto const slow = [&](int x, int, int, float) {
        in.insert(in.end(), 3, std::uniform_real_distribution<float>(0, 1)(random));
        return Seen{in.back(), x % 2 ? glm::vec2(2.9f, 0) : glm::vec2(0)};
    };
    CHECK(world.last(collected, slow) == in);
}

TEST_CASE("the paper's steps keep a constant, and to the last bit what stands still far from what moves") {
    World const world;
    for (float const a : world.last(paper, [](int x, int y, int, float) {
             return Seen{0.7f, (x / 9 + y / 7) % 2 ? glm::vec2(9, 4) : glm::vec2(0)};
         }))
        REQUIRE(a == doctest::Approx(0.7).epsilon(1e-4));
    std::mt19937 random(2);
    std::vector<float> in;
    auto const out = world.last(paper, [&](int x, int y, int, float) {
        if (x == 0 && y == 0) in.clear();
        in.insert(in.end(), 3, std::uniform_real_distribution<float>(0, 5)(random));
        return Seen{in.back(), x > 48 ? glm::vec2(3, 1) : glm::vec2(0)};
    });
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 20; ++x) REQUIRE(world.at(out, x, y) == world.at(in, x, y));
}

TEST_CASE("serial, SIMD and threads compute the same: the paper's steps") {
    auto const turns = [](auto& frame, unsigned) {
        tests::fill(frame[sweep], [](int x, int y) { return (x / 5 + y) % 3 ? glm::vec2(y - 12, 20 - x) * 0.4f : glm::vec2(0); });
    };
    for (Extent const size : {Extent{61, 24}, Extent{3, 7}, Extent{1, 1}}) {
        auto const serial = tests::sequence(paper, size, Serial{}, turns), simd = tests::sequence(paper, size, Simd{}, turns);
        CHECK(tests::all_finite(serial));
        CHECK(tests::difference(serial, simd) < 1e-4);
        CHECK(tests::sequence(paper, size, Threads<>{.count = 3, .tile = {5, 3}}, turns) == simd);
    }
}

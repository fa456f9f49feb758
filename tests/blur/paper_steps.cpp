#include "world.hpp"

#include <baselines/presets.hpp>
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

TEST_CASE("the paper's steps look at nothing outside the image, however long sweeps are") {
    World const world{.size = {40, 9}, .frames = 2};
    for (glm::vec2 const longer : {glm::vec2(1000, 0), glm::vec2(0, -700), glm::vec2(-600, -600)})
        for (float const a : world.last(paper, [&](int, int, int, float) { return Seen{0.3f, longer}; }))
            REQUIRE(a == doctest::Approx(0.3).epsilon(1e-4));
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

TEST_CASE("the paper's steps find what part of the samples move at the image's borders too") {
    // White that slides along each border before black, 12 pixels wide: half of the window's samples there lie outside.
    constexpr Extent size{120, 120};
    for (glm::vec2 const along : {glm::vec2(0, 1), glm::vec2(1, 0)})
        for (bool const far : {false, true}) {
            World const world{size, 2};
            auto const out = world.last(paper, [&](int x, int y, int, float) {
                int const from_border = along.y > 0 ? x : y;
                return (far ? from_border >= 108 : from_border < 12) ? Seen{1.f, along * 9.f} : Seen{0.f};
            });
            double sum = 0;
            for (float const a : out) sum += a / static_cast<double>(out.size());
            CHECK(sum == doctest::Approx(0.1).epsilon(0.05));
        }
}

TEST_CASE("what stood still is gone where all moves now") {
    World const world{.frames = 13};
    auto const out = world.last(paper, [](int, int, int frame, float) { return frame < 4 ? Seen{1.f} : Seen{0.f, {9, 5}}; });
    for (float const a : out) REQUIRE(a < 1e-3f);
}

TEST_CASE("nothing is collected of what stands still") {
    World const world{.frames = 1};
    auto const out = world.last(collected, [](int x, int, int, float) { return x < 30 ? Seen{0.f} : Seen{1.f, {0, 12}}; });
    for (int y = 0; y < 48; ++y)
        for (int x = 30; x < 64; ++x) REQUIRE(world.at(out, x, y) == 1.f);
}

TEST_CASE("the paper's wavelet leaves stripes that move along themselves, and smooths what is noisy along them") {
    World const world{.frames = 1};
    std::mt19937 random(5);
    auto const out = world.last(presets::blur_no_pre_filter(radiance), [&](int, int y, int, float) {
        return Seen{(y / 2 % 2 ? 1.f : 0.f) + std::uniform_real_distribution<float>(0, 1)(random), {16, 0}};
    });
    double dark = 0, bright = 0, squared = 0;
    constexpr int count = 32 * 16;
    for (int y = 8; y < 40; ++y)
        for (int x = 16; x < 48; ++x) {
            bool const is_bright = y / 2 % 2 != 0;
            (is_bright ? bright : dark) += world.at(out, x, y) / count;
            squared += std::pow(world.at(out, x, y) - (is_bright ? 1.5 : 0.5), 2) / (2 * count);
        }
    CHECK(bright - dark == doctest::Approx(1).epsilon(0.03));
    CHECK(squared < 0.1 / 12);
}

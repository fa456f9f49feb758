#include "world.hpp"

#include <baselines/presets.hpp>
#include <quell/execute/threads.hpp>

using namespace quell;

namespace {
constexpr auto denoise = presets::blur(radiance);
using tests::Seen, tests::World;
float const infinite = std::bit_cast<float>(0x7f800000u), not_a_number = std::bit_cast<float>(0x7fc00000u);

template <class P> void same_everywhere(P const& pipeline) {
    auto const any = [](auto& frame, unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> pixels(-12.f, 12.f);
        tests::fill(frame[sweep], [&](int x, int y) { return (x / 5 + y) % 3 == 0 ? glm::vec2(0) : glm::vec2(6 + pixels(random) / 8, 3); });
    };
    for (Extent const size : {Extent{61, 24}, Extent{16, 5}, Extent{3, 7}, Extent{1, 1}}) {
        auto const serial = tests::sequence(pipeline, size, Serial{}, any), simd = tests::sequence(pipeline, size, Simd{}, any);
        CHECK(tests::all_finite(serial));
        CHECK(tests::difference(serial, simd) < 1e-4);
        CHECK(tests::sequence(pipeline, size, Threads<>{.count = 3, .tile = {5, 3}}, any) == simd);
    }
}
} // namespace

TEST_CASE("serial, SIMD and threads compute the same: blur") {
    same_everywhere(denoise);
    same_everywhere(presets::blur_wavelet(radiance));
    same_everywhere(presets::blur_fixed_step(radiance));
    same_everywhere(presets::blur<BentTrajectories>(radiance));
}

TEST_CASE("a constant stays constant, whatever moves") {
    World const world;
    std::mt19937 random(9);
    std::uniform_real_distribution<float> pixels(-20, 20);
    auto const some_move = [&](int x, int y, int, float) {
        return (x + y) % 3 ? Seen{0.7f, {pixels(random), pixels(random)}} : Seen{0.7f};
    };
    auto const all_move = [](int, int, int, float) { return Seen{0.7f, {9, -4}}; };
    for (float const a : world.last(denoise, some_move)) REQUIRE(a == doctest::Approx(0.7).epsilon(1e-4));
    for (float const a : world.last(denoise, all_move)) REQUIRE(a == doctest::Approx(0.7).epsilon(1e-4));
}

TEST_CASE("where nothing moves the picture is the input, to the last bit") {
    World const world;
    std::mt19937 random(2);
    std::vector<float> in;
    auto const noise = [&](int x, int y, int, float) {
        float const a = std::uniform_real_distribution<float>(0, 5)(random);
        if (x == 0 && y == 0) in.clear();
        for (int i = 0; i < 3; ++i) in.push_back(a);
        return Seen{a};
    };
    CHECK(world.last(denoise, noise) == in);
}

TEST_CASE("a lone sample spreads along its path and nowhere else") {
    World const world{.frames = 1};
    float seen_at = 0;
    auto const out = world.last(denoise, [&](int x, int y, int, float t) {
        if (x != 32 || y != 24) return Seen{0.f};
        seen_at = t;
        return Seen{4.f, {16, 0}};
    });
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            float const a = world.at(out, x, y);
            // It passes when the shutter is open, give or take half a pixel that it stands for and one of the directional mean.
            float const pixels = seen_at * 16 + static_cast<float>(x - 32);
            if (std::abs(y - 24) > 2 || pixels < -1.51f || pixels > 17.51f) REQUIRE(a == 0.f);
        }
}

TEST_CASE("lone samples keep their light along rows, and along columns for a few pixels, in the mean to 6 %") {
    // 400 of them, too far apart to meet. Light of 4 stays 4, however far it is spread; its mean is known to 2 %.
    World const world{.size = {960, 960}, .frames = 1};
    for (glm::vec2 const path : {glm::vec2(16, 0), glm::vec2(-9, 0), glm::vec2(4, 0), glm::vec2(0, 4), glm::vec2(0, -4), glm::vec2(2, 1)}) {
        auto const out = world.last(denoise, [&](int x, int y, int, float) {
            return x % 48 == 24 && y % 48 == 24 ? Seen{4.f, path} : Seen{0.f};
        });
        double sum = 0;
        for (float const a : out) sum += static_cast<double>(a) / 3;
        INFO("by ", path.x, ", ", path.y);
        CHECK(sum / 400 == doctest::Approx(4).epsilon(0.06));
    }
}

TEST_CASE("a moving bar covers what it passes for as long as it takes, in the mean of the picture to 1 %, along rows and columns") {
    // A white bar 20 wide slides 24 pixels a frame, 12 of them while the shutter is open, before black.
    World const world{.size = {160, 160}, .frames = 4};
    for (bool const down : {false, true}) {
        auto const out = world.last(denoise, [&](int x, int y, int frame, float t) {
            return tests::in_sliding_bar(down ? y : x, frame, t) ? Seen{1.f, down ? glm::vec2(0, 12) : glm::vec2(12, 0)} : Seen{0.f};
        });
        double sum = 0;
        for (float const a : out) sum += static_cast<double>(a) / 3;
        CHECK(sum / 160 == doctest::Approx(20).epsilon(0.01));
        // The edges are ramps of 12 pixels.
        for (int i = 0; i < 12; ++i) {
            double rise = 0, fall = 0;
            for (int y = 0; y < 160; ++y) {
                rise += static_cast<double>(down ? world.at(out, y, 92 + i) : world.at(out, 92 + i, y)) / 160;
                fall += static_cast<double>(down ? world.at(out, y, 112 + i) : world.at(out, 112 + i, y)) / 160;
            }
            CHECK(std::abs(rise - (i + 0.5) / 12) < 0.025);
            CHECK(std::abs(fall - (11.5 - i) / 12) < 0.025);
        }
    }
}

TEST_CASE("the search finds the past of what slides and of what turns, which plain reprojection misses") {
    World const world{.size = {128, 128}, .frames = 3};
    auto const shown = [&](PathSearch const& search) {
        auto const pipeline = presets::blur(radiance, search);
        return world.last(pipeline, [](int x, int y, int, float) {
            return Seen{0.5f + 0.4f * std::sin(0.3f * static_cast<float>(x + y)),
                        glm::vec2(static_cast<float>(64 - y), static_cast<float>(x - 64)) * 0.15f};
        });
    };
    // What has no history is the input's own estimate, frame after frame: compare with a pipeline that never finds any.
    auto const searched = shown({}), plain = shown({.iterations = 0}), none = shown({.accept = 0.f});
    auto const with_history = [&](std::vector<float> const& all) {
        int n = 0;
        for (int y = 24; y < 104; ++y)
            for (int x = 24; x < 104; ++x) n += world.at(all, x, y) != world.at(none, x, y);
        return n / 6400.;
    };
    CHECK(with_history(searched) > 0.9);
    CHECK(with_history(plain) < 0.7 * with_history(searched));
}

TEST_CASE("of what slides evenly, plain reprojection finds the past: nothing has to be searched for") {
    World const world{.frames = 2};
    auto const out = world.last(presets::blur_one_step(radiance), [](int, int, int frame, float) {
        return Seen{frame == 0 ? 1.f : 0.f, {3, 1}};
    });
    CHECK(world.at(out, 32, 24) > 0.1f);
    CHECK(world.at(out, 2, 24) == 0.f); // it came from outside the image
}

TEST_CASE("the past is found for whatever part of the frame time the shutter is open") {
    // A wave of 16 pixels slides by 6 in a frame.
    auto const error = [](float part, int frames) {
        World const world{.size = {160, 64}, .frames = frames, .shutter = part};
        auto const wave = [](float x) { return 0.5f + 0.5f * std::sin(0.3927f * x); };
        auto const at = [&](int x, int frame, float t) { return wave(static_cast<float>(x) - 6 * (static_cast<float>(frame) + part * t)); };
        auto const out = world.last(denoise, [&](int x, int, int frame, float t) { return Seen{at(x, frame, t), {6 * part, 0}}; });
        double squared = 0;
        for (int x = 40; x < 120; ++x) {
            double blurred = 0;
            for (int k = 0; k < 32; ++k) blurred += at(x, frames - 1, (static_cast<float>(k) + 0.5f) / 32) / 32;
            for (int y = 8; y < 56; ++y) squared += std::pow(world.at(out, x, y) - blurred, 2);
        }
        return squared;
    };
    for (float const part : {0.3f, 0.5f, 1.f}) CHECK(error(part, 9) < 0.4 * error(part, 1));
}

TEST_CASE("a shutter that is never open gives what sweeps no past; one that is no number is refused") {
    auto const seen = [](int x, int, int, float) { return Seen{0.3f, x % 3 ? glm::vec2(9, 2) : glm::vec2(0)}; };
    World const closed{.frames = 3, .shutter = 0};
    for (float const a : closed.last(denoise, seen)) REQUIRE(a == doctest::Approx(0.3).epsilon(1e-4));
    for (float const bad : {not_a_number, infinite, -0.5f}) CHECK_THROWS_AS(World{.shutter = bad}.last(denoise, seen), Error);
}

TEST_CASE("sweeps longer than the image look at nothing outside it, and a constant stays one") {
    World const world{.size = {40, 9}, .frames = 2};
    for (glm::vec2 const longer : {glm::vec2(1000, 0), glm::vec2(-1000, 0), glm::vec2(0, 700), glm::vec2(-600, -600)})
        for (float const a : world.last(denoise, [&](int, int, int, float) { return Seen{0.3f, longer}; }))
            REQUIRE(a == doctest::Approx(0.3).epsilon(1e-4));
}

namespace {
void stays_finite(Extent size, auto const& pipeline, auto... channels) {
    Frame frame{size, pipeline};
    History history{size, pipeline};
    for (float const bad : {not_a_number, infinite, -infinite, 1e30f, -1e30f, 0.f, 2.f}) {
        auto const breaks = [&](auto channel) {
            tests::fill_randomly(frame, 3);
            tests::fill(frame[sweep], [](int x, int) { return x % 3 ? glm::vec2(9, 2) : glm::vec2(0); });
            tests::fill(frame[channel], [&](int x, int) {
                using V = Value<decltype(channel)::components, float>;
                return x % 2 ? V(bad) : V(1.f);
            });
            CHECK(tests::all_finite(tests::copy_of(run(pipeline, frame, history))));
            tests::fill_randomly(frame, 4);
            CHECK(tests::all_finite(tests::copy_of(run(pipeline, frame, history))));
        };
        (breaks(channels), ...);
    }
}
} // namespace

TEST_CASE("bad input: nothing that is not finite comes out or stays in the history") {
    for (Extent const size : {Extent{40, 20}, Extent{1, 1}}) {
        stays_finite(size, presets::blur<BentTrajectories>(radiance), sweep, sweep_bend, quell::time, depth, radiance);
        stays_finite(size, presets::blur<RotatingTrajectories>(radiance), sweep, quell::time, depth, radiance);
    }
}

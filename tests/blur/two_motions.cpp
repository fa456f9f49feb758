#include "world.hpp"

#include <quell/presets/blur.hpp>

#include <set>

using namespace quell;

namespace {
constexpr auto denoise = presets::blur(radiance);
using tests::Seen, tests::TurningSector, tests::World;
constexpr Extent size{160, 48}, tall{160, 240};
} // namespace

TEST_CASE("a line of pixels visits all within a pixel of the line, to both sides, none twice") {
    for (glm::vec2 const v : {glm::vec2(12, 0), glm::vec2(-7, 0), glm::vec2(0, 9), glm::vec2(8, 3), glm::vec2(-3, 10), glm::vec2(5, -5)}) {
        std::set<std::pair<int, int>> visited, others;
        detail::LineOfPixels const line(v, {0, 0}, 1.f, 128);
        line.for_each([&](int x, int y) { CHECK(visited.insert({x, y}).second); });
        line.for_each_other([&](int x, int y) { CHECK(others.insert({x, y}).second); });
        CHECK(others.insert({0, 0}).second);
        CHECK(others == visited);
        float const length = glm::length(v);
        for (int y = -14; y <= 14; ++y)
            for (int x = -14; x <= 14; ++x) {
                glm::vec2 const p(x, y);
                bool const near = std::abs(p.x * v.y - p.y * v.x) / length < 0.7f && std::abs(glm::dot(p, v)) <= length * length;
                if (near) CHECK(visited.contains({x, y}));
                if (visited.contains({x, y})) CHECK(std::abs(p.x * v.y - p.y * v.x) / length <= 1.01f);
            }
    }
    int visits = 0;
    detail::LineOfPixels({300, 40}, {0, 0}, 1.f, 64).for_each_other([&](int, int) { ++visits; });
    CHECK(visits <= 64);
    CHECK(visits >= 60);
}

TEST_CASE("what moves in front of something else that moves covers it for as long as it takes to pass, however near in depth that is") {
    World const world{tall, 4};
    for (float const depth : {4.f, 8.4f, 8.7f, 9.f}) {
        auto const out = world.last(denoise, [&](int x, int, int frame, float t) {
            return tests::in_sliding_bar(x, frame, t) ? Seen{1.f, {12, 0}, depth} : Seen{0.25f, {0, -9}, 9.f};
        });
        double sum = 0;
        for (int y = 0; y < tall.height; ++y)
            for (int x = 0; x < tall.width; ++x) sum += (world.at(out, x, y) - 0.25) / 0.75;
        CHECK(sum / tall.height == doctest::Approx(20).epsilon(0.01));
        for (int const x : {0, 3, 6, 9, 11}) {
            double mean = 0;
            for (int y = 0; y < tall.height; ++y) mean += world.at(out, 92 + x, y) / tall.height;
            CHECK(mean == doctest::Approx(0.25 + 0.75 * (x + 0.5) / 12).epsilon(0.1));
        }
        // Where what is behind is seen for a moment only, few of its samples are near: it counts for that moment all the same.
        double nearly_covered = 0;
        for (int y = 0; y < tall.height; ++y) nearly_covered += world.at(out, 102, y) / tall.height;
        CHECK(nearly_covered == doctest::Approx(0.25 + 0.75 * 10.5 / 12).epsilon(0.012));
    }
}

TEST_CASE("of what changes behind something that moves, a pixel shows what is there while it is not covered") {
    World const world{tall, 1};
    constexpr float period = 60;
    auto const seen = [](int x, int y, int frame, float t) {
        if (tests::in_sliding_bar(x, frame, t)) return Seen{1.f, {12, 0}, 4.f};
        float const along = static_cast<float>(y) - 40 * t;
        return Seen{0.5f + 0.5f * std::sin(along * 6.2832f / period), {0, 40}, 9.f};
    };
    auto const out = world.last(denoise, seen);
    double error = 0;
    // Covered only later, only earlier, and at last.
    for (int const x : {21, 24, 28, 42, 46, 50}) {
        double squared = 0;
        for (int y = 45; y < tall.height - 45; ++y) {
            double blurred = 0;
            for (int k = 0; k < 64; ++k) blurred += seen(x, y, 0, (static_cast<float>(k) + 0.5f) / 64).value / 64.;
            squared += std::pow(world.at(out, x, y) - blurred, 2) / (tall.height - 90);
        }
        error = std::max(error, std::sqrt(squared));
    }
    CHECK(error < 0.065);
}

TEST_CASE("motion of hundreds of pixels is as smooth as that of some, though only a part of its samples is looked at") {
    World const world{{640, 64}, 1};
    auto const deviation_of = [&](auto const& pipeline, float length) {
        auto const out = world.last(pipeline, [&](int x, int y, int, float t) {
            // Stripes of every row their own.
            float const along = static_cast<float>(x) - length * t;
            return Seen{0.5f + 0.5f * std::sin(along * 0.11f + static_cast<float>(y) * 1.7f), {length, 0}, 9.f};
        });
        double squared = 0;
        for (int y = 0; y < world.size.height; ++y)
            for (int x = 200; x < 440; ++x) {
                double blurred = 0;
                for (int k = 0; k < 256; ++k)
                    blurred += std::sin((x - static_cast<double>(length) * (k + 0.5) / 256) * 0.11 + y * 1.7) * 0.5 / 256;
                squared += std::pow(world.at(out, x, y) - 0.5 - blurred, 2) / (240. * world.size.height);
            }
        return std::sqrt(squared);
    };
    constexpr Pipeline without{radiance, Spatial{PairGuide<>{}}, Spatial{PairGather<Radiance>{}},
                               Temporal{PathSearch{}, PairBlend<Radiance>{}, PairFetch<Radiance>{PathSearch{}.along(foreground_sweep)}}};
    constexpr auto with = presets::blur<StraightTrajectories>(radiance);
    CHECK(deviation_of(with, 360) < 0.6 * deviation_of(without, 360));
    CHECK(deviation_of(with, 8) == doctest::Approx(deviation_of(without, 8)));
}

TEST_CASE("an outline that passes a few pixels is nearly as smooth as if the shutter had been watched all the time") {
    World const world{tall, 1};
    auto const out = world.last(denoise, [](int x, int, int, float t) {
        return static_cast<float>(x) + 0.5f < 80 + 6 * t ? Seen{1.f, {6, 0}, 4.f} : Seen{0.f, {0, 0}, 9.f};
    });
    double squared = 0;
    for (int y = 0; y < tall.height; ++y)
        for (int x = 80; x < 86; ++x) squared += std::pow(world.at(out, x, y) - (85.5 - x) / 6, 2);
    // Means of six samples, which is how many pass, at times of their own: sqrt(p (1 - p) / 6), are 0.17 off.
    CHECK(std::sqrt(squared / (6 * tall.height)) < 0.12);
}

TEST_CASE("an outline that passes few pixels is smoother for its past, and where it was") {
    // Before what stands still, and before what moves.
    for (Seen const behind : {Seen{0.f, {0, 0}, 9.f}, Seen{0.f, {-1, 0}, 9.f}}) {
        auto const edge = [](int frame) { return 80 + 6.6f * static_cast<float>(frame); };
        auto const after = [&](int frames) {
            World const world{tall, frames};
            auto const out = world.last(denoise, [&](int x, int, int frame, float t) {
                return static_cast<float>(x) + 0.5f < edge(frame) + 3.3f * t ? Seen{1.f, {3.3f, 0}, 4.f} : behind;
            });
            double error = 0, covered = 0;
            for (int y = 0; y < tall.height; ++y)
                for (int x = 0; x < tall.width; ++x) {
                    auto const open = std::clamp((edge(frames - 1) + 3.3 - x - 0.5) / 3.3, 0.0, 1.0);
                    error += std::pow(world.at(out, x, y) - open, 2);
                    covered += world.at(out, x, y) / tall.height;
                }
            return std::pair(error, covered - edge(frames - 1) - 3.3 / 2);
        };
        auto const alone = after(1).first;
        auto const [with_past, shift] = after(8);
        CHECK(with_past < 0.4 * alone);
        CHECK(std::abs(shift) < 0.05);
    }
}

TEST_CASE("what moves slowly leaves hardly anything of itself on what it uncovers, though that moves nearly as it does") {
    World const world{tall, 24};
    auto const out = world.last(denoise, [](int x, int, int frame, float t) {
        float const frames = static_cast<float>(frame) + 0.5f * t, edge = 120 - 2.16f * frames;
        return static_cast<float>(x) + 0.5f < edge ? Seen{0.f, {-1.08f, 0}, 17.f} : Seen{1.f, {-0.85f, 0}, 22.f};
    });
    // It ends at 70.3 in the last frame, and has passed all of the next 12 pixels within 6 frames.
    double trail = 0;
    for (int y = 0; y < tall.height; ++y)
        for (int x = 71; x < 83; ++x) trail += (1.0 - world.at(out, x, y)) / (12 * tall.height);
    CHECK(trail < 0.05);
}

TEST_CASE("an outline that moves by less than a pixel has a past too, though what is behind moves nearly as it does") {
    auto const edge = [](int frame) { return 80 + 1.9f * static_cast<float>(frame); };
    auto const error_after = [&](int frames) {
        World const world{tall, frames};
        auto const out = world.last(denoise, [&](int x, int, int frame, float t) {
            return static_cast<float>(x) + 0.5f < edge(frame) + 0.95f * t ? Seen{1.f, {0.95f, 0}, 16.f} : Seen{0.f, {0.75f, 0}, 25.f};
        });
        double error = 0;
        for (int y = 0; y < tall.height; ++y)
            for (int x = 0; x < tall.width; ++x) {
                auto const open = std::clamp((edge(frames - 1) + 0.95 - x - 0.5) / 0.95, 0.0, 1.0);
                error += std::pow(world.at(out, x, y) - open, 2);
            }
        return error;
    };
    // As many frames before as lead to the same place between pixels.
    CHECK(error_after(21) < 0.35 * error_after(1));
}

TEST_CASE("a picture of short sweeps gets no worse, though what moves goes far and around a bend until the next frame") {
    for (float const shutter : {0.02f, 0.05f, 0.1f}) {
        CAPTURE(shutter);
        World const world{.size = {128, 128}, .frames = 6, .shutter = shutter};
        // An ellipse that turns around the middle.
        constexpr float a_frame = 0.7f;
        constexpr glm::vec2 middle(64, 64);
        auto const covers = [&](glm::vec2 p, int frame, float t) {
            auto const at = tests::turned(p, middle, -a_frame * (static_cast<float>(frame) + shutter * t)) - middle;
            return glm::length(glm::vec2(at.x / 55, at.y / 25)) < 1;
        };
        double noisy = 0, denoised = 0;
        std::vector<float> wanted;
        auto const out = world.last(denoise, [&](int x, int y, int frame, float t) {
            auto const p = tests::centre_of(x, y);
            auto const sweep = tests::turned(p, middle, a_frame * shutter * (1 - t)) - tests::turned(p, middle, -a_frame * shutter * t);
            auto const seen = covers(p, frame, t) ? Seen{1.f, sweep, 4.f} : Seen{0.1f, {0, 0}, 9.f};
            if (frame == world.frames - 1) {
                float mean = 0;
                for (int k = 0; k < 64; ++k) mean += (covers(p, frame, (static_cast<float>(k) + 0.5f) / 64) ? 1.f : 0.1f) / 64;
                wanted.push_back(mean);
                noisy += std::pow(seen.value - mean, 2);
            }
            return seen;
        });
        for (int y = 0; y < world.size.height; ++y)
            for (int x = 0; x < world.size.width; ++x)
                denoised += std::pow(world.at(out, x, y) - wanted[static_cast<std::size_t>(y * world.size.width + x)], 2);
        double spilled = 0; // on what it never covers
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (wanted[i] < 0.1001f) spilled += std::abs(out[3 * i] - wanted[i]);
        CHECK(denoised <= noisy);
        // Half a pixel's sweep.
        if (shutter == 0.02f) CHECK(spilled < 0.1);
    }
}

TEST_CASE("what moves slowly keeps its detail") {
    constexpr int frames = 24;
    World const world{tall, frames};
    auto const wave = [](float x) { return 0.5f + 0.5f * std::sin(1.6f * x); }; // a period of 4 pixels
    auto const out = world.last(denoise, [&](int x, int, int frame, float t) {
        return Seen{wave(static_cast<float>(x) - 1.4f * static_cast<float>(frame) - 0.7f * t), {0.7f, 0}, 9.f};
    });
    double kept = 0, whole = 0;
    for (int y = 0; y < tall.height; ++y)
        for (int x = 20; x < 140; ++x) {
            double blurred = 0;
            for (int k = 0; k < 16; ++k)
                blurred += (wave(static_cast<float>(x) - 1.4f * (frames - 1) - 0.7f * (static_cast<float>(k) + 0.5f) / 16) - 0.5) / 16;
            kept += (world.at(out, x, y) - 0.5) * blurred;
            whole += blurred * blurred;
        }
    CHECK(kept / whole > 0.78);
    CHECK(kept / whole < 1.05);
}

TEST_CASE("what swept another way, or by another length, a frame ago is another thing's past") {
    auto const kept_of = [](glm::vec2 before) {
        World const world{.size = size, .frames = 2};
        auto const out = world.last(denoise, [&](int, int, int frame, float) {
            return frame == 0 ? Seen{1.f, before} : Seen{0.f, {2, 0}};
        });
        return world.at(out, 80, 24);
    };
    CHECK(kept_of({2, 0}) > 0.1f);
    CHECK(kept_of({2.1f, 0}) > 0.1f);
    CHECK(kept_of({2.6f, 0}) == 0.f);
    CHECK(kept_of({1.5f, 0}) == 0.f);
    CHECK(kept_of({1.9f, 0.6f}) > 0.1f);
    CHECK(kept_of({1.4f, 1.4f}) == 0.f);
    CHECK(kept_of({-2, 0}) == 0.f);
}

TEST_CASE("what stands still in front keeps its value, whatever moves behind it") {
    World const world{size, 3};
    auto const out = world.last(denoise, [](int x, int y, int frame, float t) {
        if (x >= 60 && x < 90) return Seen{0.6f, {0, 0}, 2.f};
        return Seen{std::sin(0.4f * (static_cast<float>(x) - 24.f * static_cast<float>(frame) - 12.f * t) + static_cast<float>(y)) * 0.5f +
                        0.5f,
                    {12, 0},
                    8.f};
    });
    for (int y = 0; y < size.height; ++y)
        for (int x = 60; x < 90; ++x) REQUIRE(world.at(out, x, y) == doctest::Approx(0.6).epsilon(1e-5));
}

TEST_CASE("what is behind is remembered while it is covered") {
    // A wall with a pattern, seen for two frames; then something as large as the image comes before its middle.
    auto const wall = [](int x, int y) { return (x / 3 + y / 3) % 2 ? 0.8f : 0.1f; };
    World const world{size, 3};
    auto const out = world.last(denoise, [&](int x, int y, int frame, float t) {
        bool const covered = frame == 2 && x > 40 && x < 120 && t < 0.5f;
        return covered ? Seen{2.f, {0, 30}, 3.f} : Seen{wall(x, y), {0, 0}, 8.f};
    });
    double error = 0;
    int n = 0;
    for (int y = 20; y < 28; ++y)
        for (int x = 50; x < 110; ++x) {
            // Between all of it and none, the pattern shows through: by how much depends on the coverage, its sign does not.
            double const other = world.at(out, x + 3, y), own = world.at(out, x, y);
            error += (wall(x, y) > wall(x + 3, y)) == (own > other) ? 0 : 1;
            ++n;
        }
    CHECK(error / n < 0.1);
}

TEST_CASE("a pack may meet as many tiles of pixels that share their lines as it has pixels") {
    for (int const tile : {1, 3, 8}) {
        auto const pipeline = presets::blur(radiance, {}, {.count = 64, .tile_width = tile});
        auto const fast = [](auto& frame, unsigned seed) {
            std::mt19937 random(seed);
            std::uniform_real_distribution<float> faster(0.f, 20.f);
            tests::fill(frame[sweep], [&](int, int) { return glm::vec2(80 + faster(random), 0); });
        };
        Extent const size{160, 6};
        auto const serial = tests::sequence(pipeline, size, Serial{}, fast), simd = tests::sequence(pipeline, size, Simd{}, fast);
        CHECK(tests::difference(serial, simd) < 1e-4);
    }
}

TEST_CASE("what turns covers what is behind for as long as it takes to pass, all along its arc") {
    World const world{.size = {128, 128}, .frames = 1};
    auto const out = world.last(presets::blur<BentTrajectories>(radiance), TurningSector::seen);
    double found = 0, wanted = 0;
    for (int y = 0; y < world.size.height; ++y)
        for (int x = 0; x < world.size.width; ++x) {
            found += world.at(out, x, y) - 0.2f;
            wanted += TurningSector::blurred(x, y) - 0.2f;
        }
    CHECK(found == doctest::Approx(wanted).epsilon(0.03));
}

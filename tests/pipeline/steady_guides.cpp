#include "../frames.hpp"

#include <quell/pipeline/steady_guides.hpp>

using namespace quell;

namespace {
constexpr Extent size{37, 19};
constexpr auto general = presets::general(radiance, Demodulate{});
float const infinity = std::numeric_limits<float>::infinity();

/// A pane before a wall, both still: each sample meets one of the two. Above it the sky.
template <class F> void fill_half_seen(F& frame, std::mt19937& random) {
    tests::fill_still(frame);
    std::bernoulli_distribution meets(0.5);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            bool const pane = meets(random);
            frame[depth].set(x, y, y < 4 ? infinity : pane ? 2.f : 8.f);
            frame[albedo].set(x, y, glm::vec3(pane ? 0.9f : 0.3f));
            frame[radiance].set(x, y, y < 4 ? glm::vec3(1) : glm::vec3(pane ? 0.9f : 0.3f));
        }
}
} // namespace

TEST_CASE("guides become the mean over time along the motion, of at most so many frames; the sky stays") {
    Frame frame{size, general};
    SteadyGuides<Channels<Depth, Albedo>> steady{size};
    CHECK(steady.cap == 8);
    std::mt19937 random(1);
    double worst = 0, sum = 0;
    for (int i = 0; i < 24; ++i) {
        fill_half_seen(frame, random);
        steady.apply(frame);
    }
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float const z = frame[depth].get(x, y);
            if (y < 4) {
                REQUIRE(z == infinity);
                continue;
            }
            worst = std::max(worst, std::abs(z - 5.) / 3), sum += (z - 5.) * (z - 5.) / 9;
            REQUIRE(frame[albedo].get(x, y).x >= 0.3f - 1e-5f);
            REQUIRE(frame[albedo].get(x, y).x <= 0.9f + 1e-5f);
        }
    // Two values 3 on both sides of their mean: an exponential mean of 8 frames leaves 1 / 15 of the variance.
    CHECK(sum / (size.width * (size.height - 4)) == doctest::Approx(1. / 15).epsilon(0.2));
    CHECK(worst < 1);
    CHECK(steady.bytes() > 0);
    steady.forget();
    fill_half_seen(frame, random);
    auto const own = frame[depth].get(9, 9);
    steady.apply(frame);
    CHECK(frame[depth].get(9, 9) == own);
}

TEST_CASE("what does not change stays as it is, to rounding, and follows its motion") {
    Frame frame{size, general};
    SteadyGuides<Channels<Depth>> steady{size};
    for (int i = 0; i < 6; ++i) {
        tests::fill_still(frame);
        tests::fill(frame[depth], [&](int x, int) { return 4.f + 0.5f * static_cast<float>((x + i) % 2); });
        tests::fill(frame[motion], [](int, int) { return glm::vec2(1, 0); }); // it moves to the left
        steady.apply(frame);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x + 1 < size.width; ++x)
                REQUIRE(frame[depth].get(x, y) == doctest::Approx(4.f + 0.5f * static_cast<float>((x + i) % 2)));
    }
}

TEST_CASE("where depth jumps from frame to frame, a history is kept that noisy guides lose") {
    std::mt19937 random(2);
    auto const error = [&](bool is_steady) {
        Frame frame{size, general};
        History history{size, general};
        SteadyGuides<Channels<Depth, Albedo>> steady{size};
        double sum = 0;
        for (int i = 0; i < 32; ++i) {
            fill_half_seen(frame, random);
            if (is_steady) steady.apply(frame);
            auto const out = run(general, frame, history);
            if (i >= 24)
                for (int y = 6; y < size.height; ++y)
                    for (int x = 0; x < size.width; ++x) sum += (out.get(0, x, y) - 0.6) * (out.get(0, x, y) - 0.6);
        }
        return sum;
    };
    auto const steady = error(true), noisy = error(false);
    CHECK(steady < 0.25 * noisy);
}

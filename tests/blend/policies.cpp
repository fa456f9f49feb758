#include "../frames.hpp"

#include <numeric>

using namespace quell;

namespace {
constexpr Extent size{19, 5};
float const not_a_number = std::bit_cast<float>(0x7fc00000u);

/// Runs a still pipeline over frames of one value each and returns the last output's first pixel.
template <class B> float after(B const& blending, std::vector<float> const& samples) {
    auto const pipeline = Pipeline{visibility, Temporal{StillMotion{}, blending}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    float last = 0;
    for (float const a : samples) {
        tests::fill(frame[visibility], [&](int, int) { return a; });
        last = run(pipeline, frame, history).get(0, 7, 3);
    }
    return last;
}
} // namespace

TEST_CASE("the running mean is the exact mean up to its cap, then an exponential of 1 / cap") {
    CHECK(after(RunningMean{.cap = 8}, {1, 2, 3, 4, 5, 6}) == doctest::Approx(3.5));
    CHECK(after(RunningMean{.cap = 2}, {1, 3, 4}) == doctest::Approx(3));
    CHECK(after(RunningMean{.cap = 1}, {1, 3, 4}) == doctest::Approx(4));
}

TEST_CASE("the exponential weighs the newest frame by alpha") {
    CHECK(after(Exponential{.alpha = 0.25f}, {4, 8}) == doctest::Approx(5));
    CHECK(after(Exponential{.alpha = 1.f}, {4, 8}) == 8.f);
}

TEST_CASE("a missing sample changes nothing, and the next one counts as if it had not been") {
    CHECK(after(RunningMean{}, {1, not_a_number, 3}) == doctest::Approx(2));
    CHECK(after(RunningMean{}, {1, -5, 3}) == doctest::Approx(2));
    CHECK(after(RunningMean{}, {not_a_number, 3}) == doctest::Approx(3));
    CHECK(after(RunningMean{}, {not_a_number, not_a_number}) == 0.f);
    CHECK(after(Exponential{.alpha = 0.5f}, {2, std::bit_cast<float>(0x7f800000u), 4}) == doctest::Approx(3));
    CHECK(after(Clamped{RunningMean{}}, {1, not_a_number, 1}) == doctest::Approx(1));
}

TEST_CASE("a constant stays constant under every blend") {
    for (float const a : {0.f, 1e-3f, 1.f, 1000.f}) {
        std::vector<float> const samples(40, a);
        CHECK(after(Exponential{}, samples) == doctest::Approx(a).epsilon(1e-6));
        CHECK(after(RunningMean{}, samples) == doctest::Approx(a).epsilon(1e-6));
        CHECK(after(Adaptive{}, samples) == doctest::Approx(a).epsilon(1e-6));
        CHECK(after(Clamped{RunningMean{}}, samples) == doctest::Approx(a).epsilon(1e-6));
        CHECK(after(Clamped{RunningMean{}, MinMax{}, YCoCg{}}, samples) == doctest::Approx(a).epsilon(1e-6));
        CHECK(after(WithMoments{RunningMean{}}, samples) == doctest::Approx(a).epsilon(1e-6));
    }
}

TEST_CASE("a clamp brings a stale past into what the neighbourhood shows now") {
    CHECK(after(Clamped{Exponential{.alpha = 0.1f}}, {9, 9, 9, 1}) == doctest::Approx(1));
    CHECK(after(Clamped{Exponential{.alpha = 0.1f}, MinMax{}}, {9, 9, 9, 1}) == doctest::Approx(1));
}

namespace {
/// Clamps the past to the number of pixels that it was given, or to the sum of their offsets.
struct Counts {
    bool offsets = false;
    template <class V> struct Gatherer {
        using Real = real_of<V>;
        V low = zero<V>(), high = low, far = low;
        QUELL_KERNEL explicit Gatherer(V const&) {}
        QUELL_KERNEL void add(V const&, Real weight, int dx, int dy) {
            high = high + weight;
            far = far + weight * static_cast<float>(dx + 3 * dy);
        }
        QUELL_KERNEL void finish(Counts range) {
            if (range.offsets) high = far;
            low = high;
        }
    };
};
// As docs/write_your_own.md shows them.
struct RoundedBox { // the mean of two boxes: of the 3x3, and of the plus in it
    template <class V> struct Gatherer {
        using Real = real_of<V>;
        MinMax::Gatherer<V> square, plus;
        V low, high;
        QUELL_KERNEL explicit Gatherer(V const& centre) : square(centre), plus(centre), low(centre), high(centre) {}
        QUELL_KERNEL void add(V const& v, Real weight, int dx, int dy) {
            square.add(v, weight, dx, dy);
            if (dx == 0 || dy == 0) plus.add(v, weight, dx, dy);
        }
        QUELL_KERNEL void finish(RoundedBox) {
            low = mix(square.low, plus.low, Real(0.5f)), high = mix(square.high, plus.high, Real(0.5f));
        }
    };
};
struct TowardsMean { // the past keeps its hue: it goes straight to the mean, until it is in the box
    float sigmas = 1.f;

    template <class V> struct Gatherer {
        using Real = real_of<V>;
        MeanDeviation::Gatherer<V> box;
        QUELL_KERNEL explicit Gatherer(V const& centre) : box(centre) {}
        QUELL_KERNEL void add(V const& v, Real weight, int dx, int dy) { box.add(v, weight, dx, dy); }
        QUELL_KERNEL void finish(TowardsMean range) { box.finish({.sigmas = range.sigmas}); }
        QUELL_KERNEL V clip(V const& past) const {
            auto const mean = mix(box.low, box.high, Real(0.5f));
            auto const out =
                map([](auto a, auto m, auto high) { return quell::abs(a - m) / quell::max(high - m, Real(1e-6f)); }, past, mean, box.high);
            auto const farthest = fold([](auto sofar, auto a) { return quell::max(sofar, a); }, Real(1.f), out);
            return mix(mean, past, 1.f / farthest);
        }
    };
};

/// What a clamp makes, at a pixel, of a past that is `past(x, y)` where the samples are `now(x, y)`.
template <class Range> glm::vec3 clamped(Range const& range, auto&& past, auto&& now, int x, int y) {
    auto const pipeline = Pipeline{radiance, Temporal{StillMotion{}, Clamped{Exponential{.alpha = 0.f}, range}}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    tests::fill(frame[radiance], past);
    run(pipeline, frame, history);
    tests::fill(frame[radiance], now);
    return run(pipeline, frame, history).get(x, y);
}
} // namespace

TEST_CASE("a gatherer is given each pixel of the neighbourhood once, with its offset") {
    auto const past = [](int, int) { return glm::vec3(9); };
    auto const now = [](int x, int y) { return glm::vec3(x == 12 && y == 2 ? not_a_number : 1.f); };
    auto const given = [&](int x, int y, bool offsets) { return clamped(Counts{offsets}, past, now, x, y).x; };
    CHECK(given(7, 2, false) == 9);
    CHECK(given(7, 0, false) == 6);
    CHECK(given(18, 4, false) == 4);
    CHECK(given(11, 2, false) == 8);
    CHECK(given(7, 2, true) == 0);
    CHECK(given(7, 0, true) == 9); // 3 pixels below
    CHECK(given(0, 0, true) == 8); // 1, 3 and 4
}

TEST_CASE("a firefly of the past does not stay, whatever the shape of the range") {
    auto const firefly = [](int x, int y) { return x == 7 && y == 2 ? glm::vec3(1000, 10, 10) : glm::vec3(2); };
    auto const now = [](int x, int y) { return glm::vec3(x == 8 && y == 3 ? 5.f : (x + y) % 2 ? 1.f : 3.f); };
    auto const shown = [&](auto const& range) { return clamped(range, firefly, now, 7, 2); };
    CHECK(shown(MinMax{}) == glm::vec3(5));
    // The corner that is brighter is in the 3x3 and not in the plus: (5 + 3) / 2.
    CHECK(shown(RoundedBox{}) == glm::vec3(4));
    // Of 4 ones, 4 threes and a five: mean 7 / 3, variance 16 / 9.
    auto const mean = 7.f / 3, deviation = 4.f / 3;
    auto const clipped = shown(TowardsMean{.sigmas = 1.5f});
    CHECK(clipped.x == doctest::Approx(mean + 1.5f * deviation).epsilon(1e-5));
    // The way to the mean is straight: the other components go the same part of it.
    float const part = 1.5f * deviation / (1000 - mean);
    CHECK(clipped.y == doctest::Approx(mean + (10 - mean) * part).epsilon(1e-5));
    CHECK(shown(MeanDeviation{.sigmas = 1.5f}).y == doctest::Approx(mean + 1.5f * deviation).epsilon(1e-5));
}

TEST_CASE("a clamp by deviations reaches to the mean and that many of them, up and down") {
    auto const pipeline = Pipeline{visibility, Temporal{StillMotion{}, Clamped{Exponential{.alpha = 0.5f}, MeanDeviation{.sigmas = 0.5f}}}};
    Frame frame{size, pipeline};
    for (float const past : {9.f, 0.f}) {
        History history{size, pipeline};
        tests::fill(frame[visibility], [&](int, int) { return past; });
        run(pipeline, frame, history);
        tests::fill(frame[visibility], [](int x, int y) { return (x + y) % 2 ? 3.f : 1.f; });
        auto const out = run(pipeline, frame, history);
        // Around a 1 there are four 3s and five 1s: a mean of 17 / 9, and a variance of 80 / 81.
        double const mean = 17. / 9, reach = 0.5 * std::sqrt(80. / 81);
        CHECK(out.get(0, 6, 2) == doctest::Approx(0.5 + 0.5 * (past > 1.f ? mean + reach : mean - reach)));
    }
}

TEST_CASE("the adaptive mean forgets what a clamp had to move") {
    // Checkerboard noise keeps the clamp's box open around the new level; a capped mean would take a cap's time to get there.
    auto const settle = [](auto blending) {
        auto const pipeline = Pipeline{visibility, Temporal{StillMotion{}, blending}};
        Frame frame{size, pipeline};
        History history{size, pipeline};
        double last = 0;
        for (int i = 0; i < 44; ++i) {
            float const level = i < 40 ? 8.f : 1.f;
            tests::fill(frame[visibility], [&](int x, int y) { return level * ((x + y + i) % 2 ? 0.5f : 1.5f); });
            auto const out = tests::copy_of(run(pipeline, frame, history));
            last = std::accumulate(out.begin(), out.end(), 0.0) / static_cast<double>(out.size());
        }
        return std::abs(last - 1);
    };
    CHECK(settle(Clamped{Adaptive{.cap = 32}}) < 0.5f * settle(Clamped{RunningMean{.cap = 32}}));
}

namespace {
/// Lets a pipeline's output be what a policy keeps: the variance over time.
struct ShowVariance {
    using reads = Channels<LuminanceVariance>;
    QUELL_KERNEL auto filter(auto px) const { return px.signal() * 0.f + px[luminance_variance]; }
};
} // namespace

TEST_CASE("the variance over time survives a mean of 1000 with a deviation of 0.1") {
    auto const pipeline = Pipeline{visibility, Temporal{StillMotion{}, WithMoments{RunningMean{.cap = 4096}}}};
    // Same numbers in double, the textbook way that floats can't afford.
    std::mt19937 random(5);
    std::normal_distribution<float> noise(1000.f, 0.1f);
    Frame frame{size, pipeline};
    History history{size, pipeline};
    double sum = 0, squares = 0;
    float mean_of_out = 0;
    for (int i = 0; i < 2000; ++i) {
        float const a = noise(random);
        sum += a, squares += static_cast<double>(a) * a;
        tests::fill(frame[visibility], [&](int, int) { return a; });
        mean_of_out = run(pipeline, frame, history).get(0, 3, 3);
    }
    CHECK(mean_of_out == doctest::Approx(sum / 2000).epsilon(1e-6));
    auto const guided = Pipeline{visibility, Temporal{StillMotion{}, WithMoments{RunningMean{.cap = 4096}}}, Spatial{ShowVariance{}}};
    Frame again{size, guided};
    History its_history{size, guided};
    random.seed(5);
    noise.reset();
    float variance_shown = 0;
    for (int i = 0; i < 2000; ++i) {
        float const a = noise(random);
        tests::fill(again[visibility], [&](int, int) { return a; });
        variance_shown = run(guided, again, its_history).get(0, 3, 3);
    }
    CHECK(variance_shown == doctest::Approx(squares / 2000 - (sum / 2000) * (sum / 2000)).epsilon(0.02));
}

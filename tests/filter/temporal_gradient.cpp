#include "../frames.hpp"

#include <baselines/temporal_gradient.hpp>

using namespace quell;

namespace {
constexpr Extent size{37, 22};
using Gradient = GradientOf<Radiance>;
constexpr auto antilag =
    Pipeline{radiance, Spatial{TemporalGradient<Radiance>{}}, Temporal{StillMotion{}, Antilag{RunningMean{.cap = 16.f}}}};
constexpr auto exponential =
    Pipeline{radiance, Spatial{TemporalGradient<Radiance>{}}, Temporal{StillMotion{}, Antilag{Exponential{.alpha = 0.2f}}}};
constexpr auto plain = Pipeline{radiance, Temporal{StillMotion{}, RunningMean{.cap = 16.f}}};
float const not_a_number = std::bit_cast<float>(0x7fc00000u);

/// Four frames of noise and a fifth of another brightness, whose gradient is `gradient` in one pixel of each 3x3.
template <class P> std::vector<float> last_of_five(P const& pipeline, glm::vec2 gradient, float brightness = 1.f) {
    Frame frame{size, antilag, plain};
    History history{size, pipeline};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> noise(0.5f, 1.5f);
    std::vector<float> out;
    for (int i = 0; i < 5; ++i) {
        tests::fill_still(frame);
        tests::fill(frame[radiance], [&](int, int) { return glm::vec3(noise(random) * (i == 4 ? brightness : 1.f)); });
        if (i == 4) tests::fill(frame[Gradient{}], [&](int x, int y) { return x % 3 == 1 && y % 3 == 1 ? gradient : glm::vec2(0); });
        out = tests::copy_of(run(pipeline, frame, history));
        if (i == 4 && gradient.x != 0) {
            // Kept for comparison: what came in last.
            auto const in = tests::copy_of(frame[radiance].view());
            out.insert(out.end(), in.begin(), in.end());
        }
    }
    return out;
}
struct ShowGradient {
    using reads = Channels<FilteredGradient>;
    QUELL_KERNEL auto filter(auto px) const {
        auto const g = px[filtered_gradient];
        return vec3<typename decltype(px)::Real>{quell::abs(g.x), g.y, quell::abs(g.x) / max(g.y, typename decltype(px)::Real(1e-6f))};
    }
};
} // namespace

TEST_CASE("no gradient leaves everything as it would be without") {
    CHECK(tests::difference(last_of_five(plain, {}), last_of_five(antilag, {})) < 1e-6);
}

TEST_CASE("a gradient as large as the light itself drops the history at once; of half of it, alpha is (1 - 0.5) alpha_0 + 0.5") {
    auto const dropped = last_of_five(antilag, {-4, 4}, 0.1f);
    auto const half = dropped.size() / 2;
    for (std::size_t i = 0; i < half; ++i) REQUIRE(dropped[i] == doctest::Approx(dropped[half + i]).epsilon(1e-5));
    // The fifth frame weighs 0.2 by itself.
    auto const check = [&](auto const& pipeline) {
        auto const shortened = last_of_five(pipeline, {2, 4}), unchanged = last_of_five(pipeline, {});
        for (std::size_t i = 0; i < half; ++i) {
            float const now = shortened[half + i], past = (unchanged[i] - 0.2f * now) / 0.8f;
            REQUIRE(shortened[i] == doctest::Approx(past * 0.4f + now * 0.6f).epsilon(1e-4));
        }
    };
    check(antilag);
    check(exponential);
}

TEST_CASE("the single samples of the 3x3 strata become a gradient everywhere, and stop at edges of depth") {
    constexpr auto show = Pipeline{radiance, Spatial{TemporalGradient<Radiance>{}}, Spatial{ShowGradient{}}};
    Frame frame{size, show};
    History history{size, show};
    tests::fill_still(frame);
    tests::fill(frame[depth], [](int x, int) { return x < 18 ? 3.f : 30.f; });
    tests::fill(frame[Gradient{}], [](int x, int y) { return x < 18 && x % 3 == 1 && y % 3 == 0 ? glm::vec2(-3, 6) : glm::vec2(0); });
    auto const out = run(show, frame, history);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (x < 18) {
                REQUIRE(out.get(2, x, y) == doctest::Approx(0.5).epsilon(1e-4));
                REQUIRE(out.get(0, x, y) > 0.05f);
            } else
                REQUIRE(out.get(0, x, y) < 1e-3f);
        }
}

TEST_CASE("gradients that are not finite count for nothing") {
    auto const clean = last_of_five(antilag, {});
    auto const broken = last_of_five(antilag, {not_a_number, 1}), infinite = last_of_five(antilag, {1, std::bit_cast<float>(0x7f800000u)});
    for (std::size_t i = 0; i < clean.size(); ++i) {
        REQUIRE(broken[i] == doctest::Approx(clean[i]).epsilon(1e-5));
        REQUIRE(infinite[i] == doctest::Approx(clean[i]).epsilon(1e-5));
    }
}

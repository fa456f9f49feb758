#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{96, 64};
constexpr auto plain = Pipeline{radiance, Temporal{StillMotion{}, WithVariance{RunningMean{.cap = 24.f}}}};
constexpr auto aware =
    Pipeline{radiance, Spatial{BiasEstimate<StillMotion>{}}, Temporal{StillMotion{}, WithVariance{ForgetBiased{RunningMean{.cap = 24.f}}}}};

/// Sixteen frames of noise with heavy tails and mean 1, then others of which `light` makes something.
template <class P> std::vector<float> after(P const& pipeline, int more, auto&& light) {
    Frame frame{size, aware};
    History history{size, pipeline};
    std::mt19937 random(5);
    std::exponential_distribution<float> noise(1.f);
    std::vector<float> out;
    for (int i = 0; i < 16 + more; ++i) {
        tests::fill_still(frame);
        tests::fill(frame[radiance], [&](int x, int y) { return glm::vec3(i < 16 ? noise(random) : light(noise(random), x, y, i)); });
        out = tests::copy_of(run(pipeline, frame, history));
    }
    return out;
}
/// Mean and mean square distance from it of the pixels in some columns.
std::pair<double, double> moments(std::vector<float> const& picture, int from = 0, int to = size.width) {
    double sum = 0, squares = 0, count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = from; x < to; ++x) {
            double const a = picture[static_cast<std::size_t>(3 * (y * size.width + x))];
            sum += a, squares += a * a, count += 1;
        }
    return {sum / count, squares / count - sum * sum / (count * count)};
}
} // namespace

TEST_CASE("light that changes is followed in the same frame, brighter or darker") {
    for (float const factor : {2.f, 0.5f}) {
        auto const changed = [&](float noise, int, int, int) { return factor * noise; };
        CHECK(std::abs(moments(after(plain, 1, changed)).first - 1) < 0.1);
        CHECK(moments(after(aware, 1, changed)).first == doctest::Approx(factor).epsilon(0.08));
    }
}

TEST_CASE("light that changes in a half of the picture leaves the other's history alone") {
    auto const left = [](float noise, int x, int, int) { return x < 32 ? 3 * noise : noise; };
    auto const with = after(aware, 1, left), without = after(plain, 1, left);
    CHECK(moments(with, 0, 30).first > 2.8);
    CHECK(moments(with, 60, size.width).second < 5 * moments(without, 60, size.width).second);
}

TEST_CASE("noise alone, with heavy tails, leaves a history of several frames and takes no light") {
    auto const same = [](float noise, int, int, int) { return noise; };
    auto const with = moments(after(aware, 16, same)), without = moments(after(plain, 16, same));
    CHECK(with.first == doctest::Approx(1).epsilon(0.01));
    CHECK(with.second < 5 * without.second);
}

TEST_CASE("a firefly is forgotten in the next frame, rare bright samples that come back are not") {
    auto const once = [](float noise, int x, int y, int i) { return i == 16 && x == 40 && y == 30 ? 10000.f : noise; };
    auto const at = [](std::vector<float> const& picture, int x, int y) {
        return picture[static_cast<std::size_t>(3 * (y * size.width + x))];
    };
    CHECK(at(after(aware, 1, once), 40, 30) > 100);
    CHECK(at(after(aware, 2, once), 40, 30) < 20);

    constexpr auto patient =
        Pipeline{radiance, Spatial{BiasEstimate<StillMotion>{}},
                 Temporal{StillMotion{}, WithVariance{ForgetBiased<RunningMean>{.inner = {.cap = 24.f}, .firefly_share = 1.f}}}};
    std::mt19937 random(7);
    auto const rare = [&](float, int, int, int) { return random() % 100 == 0 ? 100.f : 0.f; };
    auto const all = moments(after(patient, 24, rare)).first;
    random.seed(7);
    CHECK(moments(after(aware, 24, rare)).first == doctest::Approx(all).epsilon(0.005));
}

TEST_CASE("a step that moves lags less than half of what it does without the estimate") {
    auto const step = [](float noise, int x, int, int i) { return (x < 20 + 2 * (i - 16) ? 4.f : 1.f) * (0.9f + 0.1f * noise); };
    auto const error = [&](std::vector<float> const& out, int i) {
        double sum = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                double const off = out[static_cast<std::size_t>(3 * (y * size.width + x))] - step(1, x, y, i);
                sum += off * off;
            }
        return sum;
    };
    CHECK(error(after(aware, 12, step), 27) < 0.5 * error(after(plain, 12, step), 27));
}

TEST_CASE("the samples that a host says weigh: of one frame of 16 and one of 1, the mean leans to the first") {
    constexpr auto denoise = Pipeline{radiance, KnownSamples{}, Temporal{StillMotion{}, WithVariance{RunningMean{}}}};
    Frame frame{size, denoise};
    History history{size, denoise};
    std::vector<float> out;
    for (int i = 0; i < 2; ++i) {
        tests::fill_still(frame);
        tests::fill(frame[radiance], [&](int, int) { return glm::vec3(i == 0 ? 1.f : 18.f); });
        tests::fill(frame[sample_count], [&](int, int) { return i == 0 ? 16.f : 1.f; });
        tests::fill(frame[sample_variance], [&](int, int) { return i == 0 ? 2.f : 0.f; });
        out = tests::copy_of(run(denoise, frame, history));
    }
    CHECK(out[0] == doctest::Approx(2));
    CHECK(history[history_length].get(0, 3, 3) == doctest::Approx(17));
    // Within the first 16, and between the two: (16 * 2 + 16 * 1 / 17 * 17^2) / 17.
    CHECK(history[luminance_variance].get(0, 3, 3) == doctest::Approx((16. * 2 + 16. / 17 * 17 * 17) / 17).epsilon(1e-4));
}

TEST_CASE("counts and variances that are no numbers, not positive or beyond all measure do no harm") {
    constexpr auto denoise = presets::general(radiance, KnownSamples{});
    Frame frame{size, denoise};
    History history{size, denoise};
    float const bad[] = {std::bit_cast<float>(0x7fc00000u), std::bit_cast<float>(0x7f800000u), -1.f, 0.f, 1e38f, 1e-40f};
    for (unsigned i = 0; i < 6; ++i) {
        tests::fill_randomly(frame, i);
        tests::fill(frame[sample_count], [&](int x, int) { return bad[static_cast<unsigned>(x) % 6]; });
        tests::fill(frame[sample_variance], [&](int, int y) { return bad[static_cast<unsigned>(y) % 6]; });
        CHECK(tests::all_finite(tests::copy_of(run(denoise, frame, history))));
    }
}

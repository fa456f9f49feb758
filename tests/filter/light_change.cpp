#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{64, 48};
constexpr auto plain = Pipeline{radiance, Temporal{StillMotion{}, RunningMean{.cap = 24.f}}};
constexpr auto forgetful =
    Pipeline{radiance, Spatial{ChangeDetector<StillMotion>{}}, Temporal{StillMotion{}, ForgetChanged{RunningMean{.cap = 24.f}}}};
float const not_a_number = std::bit_cast<float>(0x7fc00000u);

/// Twenty frames of noise with heavy tails and mean 1, then others whose noise `light` makes something of.
template <class P> std::vector<float> after(P const& pipeline, int more, auto&& light) {
    Frame frame{size, forgetful};
    History history{size, pipeline};
    std::mt19937 random(5);
    std::exponential_distribution<float> noise(1.f);
    std::vector<float> out;
    for (int i = 0; i < 20 + more; ++i) {
        tests::fill_still(frame);
        tests::fill(frame[radiance], [&](int x, int y) { return glm::vec3(i < 20 ? noise(random) : light(noise(random), x, y)); });
        out = tests::copy_of(run(pipeline, frame, history));
    }
    return out;
}
/// Mean and mean square distance from 1 of the pixels in some columns.
std::pair<double, double> moments(std::vector<float> const& picture, int from = 0, int to = size.width) {
    double sum = 0, squares = 0, count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = from; x < to; ++x) {
            double const a = picture[static_cast<std::size_t>(3 * (y * size.width + x))];
            sum += a, squares += (a - 1) * (a - 1), count += 1;
        }
    return {sum / count, squares / count};
}
/// The part of the pixels from a column on that differ.
double changed(std::vector<float> const& a, std::vector<float> const& b, int from = 0) {
    double count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = from; x < size.width; ++x) {
            auto const i = static_cast<std::size_t>(3 * (y * size.width + x));
            count += std::abs(a[i] - b[i]) > 1e-5f * (1 + std::abs(a[i]));
        }
    return count / ((size.width - from) * size.height);
}
} // namespace

TEST_CASE("light that grows under strong noise is followed at once, and history starts afresh") {
    auto const twice = [](float noise, int, int) { return 2 * noise; };
    CHECK(moments(after(plain, 1, twice)).first < 1.1);
    CHECK(moments(after(forgetful, 1, twice)).first == doctest::Approx(2).epsilon(0.05));
    // Noise falls again as it does from the start: the second frame weighs half.
    CHECK(moments(after(forgetful, 8, twice)).second < 1.5);
    auto const half = [](float noise, int, int) { return 0.5f * noise; };
    CHECK(moments(after(forgetful, 1, half)).first == doctest::Approx(0.5).epsilon(0.1));
}

TEST_CASE("noise alone shortens hardly any history") {
    auto const same = [](float noise, int, int) { return noise; };
    auto const with = moments(after(forgetful, 20, same)), without = moments(after(plain, 20, same));
    CHECK(with.first == doctest::Approx(1).epsilon(0.02));
    CHECK(with.second < 1.02 * without.second);
}

TEST_CASE("light that changes in a part of the picture leaves the rest as it is") {
    auto const left = [](float noise, int x, int) { return x < 24 ? 3 * noise : noise; };
    auto const with = after(forgetful, 1, left), without = after(plain, 1, left);
    CHECK(moments(with, 0, 24).first > 2.7);
    CHECK(changed(with, without, 24 + 12) < 0.01);
}

TEST_CASE("one firefly is no change of the light, and missing samples are none") {
    auto const firefly = [](float noise, int x, int y) { return x == 20 && y == 20 ? 1e6f : noise; };
    auto const missing = [](float noise, int x, int y) { return (x + y) % 3 == 0 ? not_a_number : noise; };
    CHECK(changed(after(plain, 1, firefly), after(forgetful, 1, firefly)) < 0.01);
    CHECK(changed(after(plain, 1, missing), after(forgetful, 1, missing)) < 0.01);
}

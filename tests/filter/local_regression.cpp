#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{80, 56};
constexpr auto denoise = Pipeline{radiance, Temporal{StillMotion{}, WithVariance{RunningMean{}}}, Spatial{LocalRegression<>{}}};

/// What is left of some frames' light with noise added to it.
template <class P, class Executor = Simd>
std::vector<float> denoised(P const& pipeline, auto&& truth, float noise, auto&& guide, Executor const& executor = {}) {
    Frame frame{size, pipeline};
    History history{size, pipeline};
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(-noise, noise);
    std::vector<float> out;
    for (int i = 0; i < 4; ++i) {
        tests::fill_still(frame);
        tests::fill(frame[normal], guide);
        tests::fill(frame[radiance], [&](int x, int y) { return glm::vec3(truth(x, y) + uniform(random)); });
        out = tests::copy_of(run(pipeline, frame, history, executor));
    }
    return out;
}
double error(std::vector<float> const& out, auto&& truth, int border = 0) {
    double sum = 0, count = 0;
    for (int y = border; y < size.height - border; ++y)
        for (int x = border; x < size.width - border; ++x, ++count) {
            double const off = out[static_cast<std::size_t>(3 * (y * size.width + x))] - truth(x, y);
            sum += off * off;
        }
    return std::sqrt(sum / count);
}
glm::vec3 facing(int, int) { return {0, 0, 1}; }
/// A cylinder whose axis is vertical.
glm::vec3 cylinder(int x, int) {
    float const a = (static_cast<float>(x) + 0.5f) / static_cast<float>(size.width) * 2.f - 1.f;
    return {a, 0, std::sqrt(1 - a * a)};
}
} // namespace

TEST_CASE("least squares find the constant of what is affine in place and vector, whatever the weights are") {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> uniform(-1.f, 1.f);
    auto const next = [&] { return uniform(random); };
    glm::vec3 const constant{0.7f, -2.f, 5.f}, across{1.f, 0.3f, -2.f}, down{-0.4f, 2.f, 1.f};
    glm::vec3 const by_vector[] = {{3.f, 1.f, 0.2f}, {-1.f, 0.5f, 4.f}, {0.3f, -2.f, 1.f}};
    detail::LeastSquares<glm::vec3> fit;
    for (int row = 0; row < 6; ++row) {
        detail::LeastSquares<glm::vec3>::OfRow sums;
        float const y = next();
        for (int i = 0; i < 6; ++i) {
            float const x = next(), w = 0.5f * next() + 0.6f;
            glm::vec3 const v{next(), next(), next()};
            sums.add_regressors(x, v, w);
            sums.add_value(x, v, constant + across * x + down * y + by_vector[0] * v.x + by_vector[1] * v.y + by_vector[2] * v.z, w);
        }
        fit.add(sums, y);
    }
    float const ridge[] = {0.f, 0.f, 0.f, 0.f, 0.f};
    auto const found = fit.constant(ridge);
    for (int c = 0; c < 3; ++c) CHECK(found[c] == doctest::Approx(constant[c]).epsilon(1e-4));
}

TEST_CASE("a regression leaves even light as it is, to rounding") {
    auto const even = [](int, int) { return 0.7f; };
    for (float const a : denoised(denoise, even, 0.f, cylinder)) CHECK(a == doctest::Approx(0.7f).epsilon(1e-5));
}

TEST_CASE("a pilot of one level will do, or of none") {
    constexpr auto one =
        Pipeline{radiance, Temporal{StillMotion{}, WithVariance{RunningMean{}}}, Spatial{LocalRegression<>{.pilot = {.levels = 1}}}};
    constexpr auto none =
        Pipeline{radiance, Temporal{StillMotion{}, WithVariance{RunningMean{}}}, Spatial{LocalRegression<>{.pilot = {.levels = 0}}}};
    auto const even = [](int, int) { return 0.7f; };
    CHECK(error(denoised(one, even, 0.3f, facing), even) < 0.05);
    CHECK(error(denoised(none, even, 0.3f, facing), even) < 0.05);
}

TEST_CASE("light that is linear on the screen, or in the normal, is fitted") {
    auto const ramp = [](int x, int y) { return 1.f + 0.01f * static_cast<float>(x) + 0.005f * static_cast<float>(y); };
    CHECK(error(denoised(denoise, ramp, 0.f, facing), ramp, 16) < 1e-3);
    auto const shaded = [](int x, int y) { return 0.2f + cylinder(x, y).z + 0.3f * cylinder(x, y).x; };
    CHECK(error(denoised(denoise, shaded, 0.f, cylinder), shaded, 16) < 2e-3);
}

TEST_CASE("on curved surfaces a regression is nearer to the truth than the filter that it follows") {
    // Bumps 20 pixels wide, lit from one side.
    auto const bump = [](int x, int y) {
        auto const slope = [](int at) { return (static_cast<float>(at % 20) + 0.5f) / 15.f - 2.f / 3.f; };
        return glm::normalize(glm::vec3(slope(x), slope(y), 1.f));
    };
    auto const shaded = [&](int x, int y) { return 0.2f + glm::dot(bump(x, y), glm::vec3(0.6f, 0.2f, 0.7f)); };
    constexpr auto pilot = Pipeline{radiance, Temporal{StillMotion{}, WithVariance{RunningMean{}}}, Spatial{ConservingAtrous<>{}}};
    auto const by_pilot = error(denoised(pilot, shaded, 0.3f, bump), shaded), by_fit = error(denoised(denoise, shaded, 0.3f, bump), shaded);
    MESSAGE("RMSE of the pilot " << by_pilot << ", of the fit " << by_fit);
    CHECK(by_fit < 0.8 * by_pilot);
}

TEST_CASE("the edge of a shadow that no guide shows stays sharp in a regression") {
    auto const truth = [](int x, int) { return x < size.width / 2 ? 1.f : 3.f; };
    CHECK(error(denoised(denoise, truth, 0.3f, facing), truth) < 0.04);
}

TEST_CASE("twice the light is twice the result of a regression") {
    auto const light = [](int x, int y) { return 0.5f + 0.25f * static_cast<float>((x * 7 + y * 3) % 5); };
    auto const once = denoised(denoise, light, 0.f, facing), twice = denoised(
                                                                 denoise, [&](int x, int y) { return 2.f * light(x, y); }, 0.f, facing);
    for (std::size_t i = 0; i < once.size(); ++i) CHECK(twice[i] == doctest::Approx(2.f * once[i]).epsilon(1e-4));
}

TEST_CASE("a regression in packs is a regression pixel by pixel") {
    auto const truth = [](int x, int y) { return x + y < size.width / 2 ? 1.f : 2.f; };
    auto const packs = denoised(denoise, truth, 0.3f, cylinder), pixels = denoised(denoise, truth, 0.3f, cylinder, Serial{});
    for (std::size_t i = 0; i < packs.size(); ++i) CHECK(packs[i] == doctest::Approx(pixels[i]).epsilon(1e-4));
}

#include "../frames.hpp"

using namespace quell;

namespace {
constexpr Extent size{96, 64};

/// The mean of the last frames' pictures, of samples that are 1 / p with probability p and else 0, over that of the samples.
template <class P> double light_kept(P const& pipeline, double p) {
    Frame frame{size, pipeline};
    History history{size, pipeline};
    std::mt19937 random(3);
    auto const lit = static_cast<std::size_t>(p * static_cast<double>(size.pixels()));
    std::vector<float> samples(static_cast<std::size_t>(size.pixels()));
    // As many in each frame, so that their number adds no noise.
    std::fill_n(samples.begin(), lit, static_cast<float>(samples.size()) / static_cast<float>(lit));
    double sum = 0;
    for (int i = 0; i < 40; ++i) {
        std::shuffle(samples.begin(), samples.end(), random);
        tests::fill_still(frame);
        tests::fill(frame[radiance], [&](int x, int y) { return glm::vec3(samples[static_cast<std::size_t>(y * size.width + x)]); });
        auto const out = tests::copy_of(run(pipeline, frame, history));
        if (i >= 20)
            for (float const a : out) sum += a;
    }
    return sum / (20. * 3. * static_cast<double>(size.pixels()));
}

double luminance_error(std::vector<float> const& out, auto&& wanted) {
    double sum = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            double const off = out[static_cast<std::size_t>(3 * (y * size.width + x))] - wanted(x, y);
            sum += off * off;
        }
    return std::sqrt(sum / static_cast<double>(size.pixels()));
}
} // namespace

TEST_CASE("no light is lost of skewed noise, which other guided filters darken") {
    constexpr auto general = presets::general(radiance);
    constexpr auto svgf = presets::svgf(radiance);
    for (double const p : {0.5, 0.2, 0.05}) CHECK(light_kept(general, p) == doctest::Approx(1).epsilon(0.005));
    CHECK(light_kept(general, 0.01) == doctest::Approx(1).epsilon(0.02));
    CHECK(light_kept(presets::final_frame(radiance), 0.05) == doctest::Approx(1).epsilon(0.005));
    CHECK(light_kept(svgf, 0.05) < 0.9);
}

TEST_CASE("pixels exchange light: of one frame, what one loses others gain") {
    constexpr auto denoise =
        Pipeline{radiance, Temporal{StillMotion{}, WithVariance{RunningMean{}}}, Spatial{ConservingAtrous<>{.levels = 3}}};
    Frame frame{size, denoise};
    History history{size, denoise};
    tests::fill_still(frame);
    std::mt19937 random(4);
    std::exponential_distribution<float> light(1.f);
    // Dark at the borders: what a border pixel gives is weighed by fewer neighbours.
    double before = 0, after = 0;
    tests::fill(frame[radiance], [&](int x, int y) {
        bool const inside = x >= 14 && y >= 14 && x < size.width - 14 && y < size.height - 14;
        float const a = inside ? light(random) : 0.f;
        before += a;
        return glm::vec3(a);
    });
    auto const out = tests::copy_of(run(denoise, frame, history));
    for (std::size_t i = 0; i < out.size(); i += 3) after += out[i];
    CHECK(after == doctest::Approx(before).epsilon(1e-4));
}

TEST_CASE("noise falls, and the edge of a shadow that no guide shows stays sharp") {
    constexpr auto denoise = presets::general(radiance);
    auto const truth = [](int x, int) { return x < size.width / 2 ? 1.f : 3.f; };
    Frame frame{size, denoise};
    History history{size, denoise};
    std::mt19937 random(5);
    std::uniform_real_distribution<float> noise(-0.3f, 0.3f);
    std::vector<float> in, out;
    for (int i = 0; i < 2; ++i) { // while there is hardly a history
        tests::fill_still(frame);
        tests::fill(frame[radiance], [&](int x, int y) { return glm::vec3(truth(x, y) + noise(random)); });
        in = tests::copy_of(frame[radiance].view());
        out = tests::copy_of(run(denoise, frame, history));
    }
    CHECK(luminance_error(out, truth) < 0.35 * luminance_error(in, truth));
    for (int y = 0; y < size.height; ++y) {
        auto const at = [&](int x) { return out[static_cast<std::size_t>(3 * (y * size.width + x))]; };
        CHECK(at(size.width / 2) - at(size.width / 2 - 1) > 1.4f);
    }
}

TEST_CASE("detail that no guide shows is left nearly as it is where there is hardly any noise") {
    constexpr auto denoise = presets::general(radiance);
    auto const truth = [](int x, int y) {
        return 1.f + 0.5f * std::sin(0.9f * static_cast<float>(x)) * std::cos(0.7f * static_cast<float>(y));
    };
    Frame frame{size, denoise};
    History history{size, denoise};
    std::mt19937 random(6);
    std::uniform_real_distribution<float> noise(-1e-3f, 1e-3f);
    std::vector<float> in, out;
    for (int i = 0; i < 8; ++i) {
        tests::fill_still(frame);
        tests::fill(frame[radiance], [&](int x, int y) { return glm::vec3(truth(x, y) + noise(random)); });
        out = tests::copy_of(run(denoise, frame, history));
    }
    CHECK(luminance_error(out, truth) < 0.06);
}

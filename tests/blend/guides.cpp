#include "../frames.hpp"

#include <random>

using namespace quell;
using namespace quell::tests;

namespace {

constexpr Extent size{48, 32};
constexpr auto denoise = presets::accumulated(radiance, Demodulate{});
float const not_a_number = std::bit_cast<float>(0x7fc00000u);

static_assert(contained_in<Channels<MeanAlbedo, MeanNormal>, decltype(denoise)::keeps>);
static_assert(!decltype(presets::general(radiance, Demodulate{}))::keeps::has<MeanAlbedo>, "who wants no guides keeps none");

/// A wall of albedo .5 in light of 1, to which each test adds.
struct Wall {
    Frame<decltype(denoise)::reads> frame{size, denoise};
    History<std::remove_const_t<decltype(denoise)>> history{size, denoise};

    Wall() {
        fill_still(frame);
        fill(frame[albedo], [](int, int) { return glm::vec3(0.5f); });
        fill(frame[radiance], [](int, int) { return glm::vec3(0.5f); });
    }
    /// The light, without the albedo.
    std::vector<float> run_frame() {
        std::vector<float> light;
        auto const out = run(denoise, frame, history);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) light.push_back(out.get(0, x, y) / frame[albedo].get(x, y).x);
        return light;
    }
    [[nodiscard]] float mean_albedo_at(int x, int y) const { return history[mean_albedo].get(0, x, y); }
    [[nodiscard]] glm::vec3 mean_normal_at(int x, int y) const {
        auto const view = history[mean_normal];
        return {view.get(0, x, y), view.get(1, x, y), view.get(2, x, y)};
    }
};

/// Fills the radiance with noise about .5 and returns its light.
std::vector<float> shine(Wall& wall, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> any(0.f, 1.f);
    std::vector<float> light;
    fill(wall.frame[radiance], [&](int, int) {
        light.push_back(2.f * any(random));
        return glm::vec3(0.5f * light.back());
    });
    return light;
}

double spread(std::vector<float> const& values) {
    double sum = 0, squares = 0;
    for (float const a : values) sum += static_cast<double>(a), squares += static_cast<double>(a) * static_cast<double>(a);
    auto const n = static_cast<double>(values.size());
    return squares / n - sum * sum / (n * n);
}

} // namespace

TEST_CASE("accumulated light of a still scene loses none and gains no noise") {
    Wall wall;
    double first = 0, light_in = 0;
    for (int i = 1; i <= 16; ++i) {
        for (float const light : shine(wall, static_cast<unsigned>(i))) light_in += static_cast<double>(light);
        auto const light = wall.run_frame();
        auto const now = spread(light);
        if (i == 1) first = now;
        CAPTURE(i);
        CHECK(now * i / first > 0.85); // it cannot be less than that of the mean
        CHECK(now <= first * 1.05);    // by chance some windows look as if the light had changed
        if (i == 16) CHECK(now < first * 0.75);
        double light_out = 0;
        for (float const each : light) light_out += static_cast<double>(each);
        CHECK(light_out == doctest::Approx(light_in / i).epsilon(0.02));
    }
    CHECK(first == doctest::Approx(1. / 3.).epsilon(0.1)); // uniform in [0, 2]
}

TEST_CASE("light with guides is that without them: the mean of the samples of a still scene, with a variance of one over their number") {
    auto const run_with = [](auto blend) {
        Pipeline const pipeline{radiance, Temporal{SurfaceMotion{}, blend}};
        Frame frame{size, pipeline};
        History history{size, pipeline};
        fill_still(frame);
        std::mt19937 random(3);
        std::vector<float> sum(static_cast<std::size_t>(size.pixels()), 0.f), mean;
        double first = 0;
        for (int i = 1; i <= 12; ++i) {
            auto pixel = sum.begin();
            fill(frame[radiance], [&](int, int) {
                float const a = std::uniform_real_distribution<float>(0.f, 2.f)(random);
                *pixel++ += a;
                return glm::vec3(a);
            });
            mean.clear();
            auto const out = run(pipeline, frame, history);
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) mean.push_back(out.get(0, x, y));
            for (std::size_t p = 0; p < sum.size(); ++p)
                if (std::abs(mean[p] - sum[p] / static_cast<float>(i)) > 1e-5f) FAIL_CHECK("not the mean: ", p);
            if (i == 1) first = spread(mean);
            CHECK(spread(mean) * i / first == doctest::Approx(1).epsilon(0.1));
        }
        return mean;
    };
    CHECK(run_with(WithGuides{RunningMean{}}) == run_with(RunningMean{}));
}

TEST_CASE("accumulated guides are the means of the frames' guides") {
    Wall wall;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(0.2f, 0.8f);
    float sum = 0;
    glm::vec3 normals(0.f);
    for (int i = 1; i <= 6; ++i) {
        float const a = any(random), tilt = 0.1f * static_cast<float>(i % 3 - 1);
        auto const n = glm::vec3(tilt, 0, std::sqrt(1.f - tilt * tilt));
        fill(wall.frame[albedo], [&](int, int) { return glm::vec3(a); });
        fill(wall.frame[radiance], [&](int, int) { return glm::vec3(a); });
        fill(wall.frame[normal], [&](int, int) { return n; });
        wall.run_frame();
        sum += a, normals += n;
        auto const mean = normals / static_cast<float>(i), kept = wall.mean_normal_at(20, 10);
        CHECK(wall.mean_albedo_at(20, 10) == doctest::Approx(sum / static_cast<float>(i)).epsilon(1e-4));
        for (int c = 0; c < 3; ++c) CHECK(kept[c] == doctest::Approx(mean[c]).epsilon(1e-4));
    }
}

TEST_CASE("what is constant stays constant: light and guides") {
    Wall wall;
    for (int i = 0; i < 40; ++i) {
        for (float const light : wall.run_frame()) REQUIRE(light == doctest::Approx(1).epsilon(1e-6));
        REQUIRE(wall.mean_albedo_at(7, 3) == 0.5f);
        REQUIRE(wall.mean_normal_at(7, 3) == glm::vec3(0, 0, 1));
    }
}

TEST_CASE("accumulated guides follow the motion") {
    Wall wall;
    auto const stripe = [](int x, int frame) { return 0.2f + 0.1f * static_cast<float>(((x - 2 * frame) % 7 + 7) % 7); };
    for (int i = 0; i < 10; ++i) {
        fill(wall.frame[albedo], [&](int x, int) { return glm::vec3(stripe(x, i)); });
        fill(wall.frame[radiance], [&](int x, int) { return glm::vec3(stripe(x, i)); });
        fill(wall.frame[motion], [](int, int) { return glm::vec2(-2, 0); });
        wall.run_frame();
        for (int x = 0; x < size.width; ++x) CHECK(wall.mean_albedo_at(x, 9) == doctest::Approx(stripe(x, i)).epsilon(1e-5));
    }
}

TEST_CASE("a pixel has guides where its sample is missing") {
    Wall wall;
    wall.frame[radiance].set(5, 5, glm::vec3(not_a_number));
    wall.run_frame();
    CHECK(wall.mean_albedo_at(5, 5) == 0.5f);
    CHECK(wall.mean_normal_at(5, 5) == glm::vec3(0, 0, 1));
    // The next one goes on with the history of its neighbours, as the light does.
    fill(wall.frame[albedo], [](int, int) { return glm::vec3(0.25f); });
    fill(wall.frame[radiance], [](int, int) { return glm::vec3(0.25f); });
    wall.run_frame();
    CHECK(wall.mean_albedo_at(5, 5) == doctest::Approx(0.375));
    CHECK(wall.mean_albedo_at(20, 20) == doctest::Approx(0.375));
    // A missing sample leaves the history as it is.
    wall.frame[radiance].set(20, 20, glm::vec3(not_a_number));
    wall.run_frame();
    CHECK(wall.mean_albedo_at(20, 20) == doctest::Approx(0.375));
}

TEST_CASE("where nothing is seen a normal may be anything, and none is accumulated") {
    float const infinity = std::numeric_limits<float>::infinity();
    for (auto const& any_normal : {glm::vec3(not_a_number), glm::vec3(infinity), glm::vec3(3e38f), glm::vec3(0.5f, 0, 0)}) {
        CAPTURE(any_normal.x);
        Wall wall;
        fill(wall.frame[depth], [&](int x, int) { return x < 10 ? infinity : 5.f; });
        fill(wall.frame[normal], [&](int x, int) { return x < 10 ? any_normal : glm::vec3(0, 0, 1); });
        for (int i = 0; i < 3; ++i) wall.run_frame();
        CHECK(wall.mean_normal_at(5, 5) == glm::vec3(0));
        CHECK(wall.mean_normal_at(9, 5) == glm::vec3(0));
        CHECK(wall.mean_normal_at(10, 5).z == doctest::Approx(1.0));
    }
}

TEST_CASE("guides are the mean of no more frames than their cap") {
    Pipeline const pipeline{radiance, Temporal{SurfaceMotion{}, WithGuides{RunningMean{.cap = 24.f}, 2.f}}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    fill_still(frame);
    for (float const a : {0.f, 0.f, 0.f, 0.f, 1.f}) {
        fill(frame[albedo], [&](int, int) { return glm::vec3(a); });
        run(pipeline, frame, history);
    }
    CHECK(history[mean_albedo].get(0, 3, 3) == doctest::Approx(0.5));
}

#include <quell/execute/threads.hpp>
#include <quell/frame/channels.hpp>
#include <quell/resolve/repeated_residual.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace quell;

constexpr Extent size{64, 48};
constexpr std::size_t pixels = 64 * 48;
using Colours = std::vector<glm::vec3>;
using Motions = ImageOf<Planar<>, Motion>;

Motions motion_of(float x, float y) {
    Motions motion(size);
    for (int j = 0; j < size.height; ++j)
        for (int i = 0; i < size.width; ++i) motion.view().set(0, i, j, x), motion.view().set(1, i, j, y);
    return motion;
}
/// Stripes that move right by `shift`, finer than a filter keeps.
Colours stripes(int shift, float height = .5f) {
    Colours picture(pixels);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            picture[static_cast<std::size_t>(y * size.width + x)] = glm::vec3((x - shift + 64) % 4 < 2 ? 1.f + height : 1.f - height);
    return picture;
}
Colours with_noise(Colours picture, float deviation, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> noise(0.f, deviation);
    for (auto& pixel : picture) pixel += glm::vec3(noise(random));
    return picture;
}
double product_of(glm::vec3 const& a, glm::vec3 const& b) { return static_cast<double>(dot(vec3<float>(a), vec3<float>(b))); }
double error_of(Colours const& picture, Colours const& truth) {
    double sum = 0.;
    for (std::size_t i = 0; i < pixels; ++i) sum += product_of(picture[i] - truth[i], picture[i] - truth[i]);
    return std::sqrt(sum / (3. * static_cast<double>(pixels)));
}

/// What is made of a picture by its samples and by those of frames around, whose pictures are flat; null: there is no such frame.
Colours made_with(RepeatedResidual const& rule, Colours const& samples, Colours const* before, Colours const* after, Motions const& motion,
                  Motions const& next) {
    Colours const flat(pixels, glm::vec3(1.f));
    std::vector<LackingAround> around;
    if (before != nullptr) around.push_back(lacking_moved(Simd{}, lacking_of_samples(rule, Simd{}, size, *before, flat), motion.view()));
    if (after != nullptr) around.push_back(lacking_moved(Simd{}, lacking_of_samples(rule, Simd{}, size, *after, flat), next.view()));
    auto picture = flat;
    give_back_repeated(rule, Simd{}, size, lacking_of_samples(rule, Simd{}, size, samples, flat), around, picture);
    return picture;
}

TEST_CASE("what two frames both lack comes back, and noise does not") {
    RepeatedResidual const rule{.samples = 64.f};
    Colours const flat(pixels, glm::vec3(1.f));
    auto const motion = motion_of(-1.f, 0.f);
    auto const both = [&](Colours const& before, Colours const& now, Motions const& vectors) {
        return made_with(rule, now, &before, nullptr, vectors, vectors);
    };
    // Where there is no noise, no noise is the same.
    RepeatedResidual const of_any{.samples = 64.f,
                                  .witness = {.alike = 2.f, .same = 3.f, .stays = 9.f, .scattered = -9.f, .in_shapes = -8.f}};
    SUBCASE("without noise it is all there") {
        auto const before = stripes(0);
        CHECK(error_of(made_with(of_any, stripes(1), &before, nullptr, motion, motion), stripes(1)) < .05);
    }
    SUBCASE("with noise as strong, more is gained than of one of both frames, whose best share of a half leaves .35") {
        auto const picture = both(with_noise(stripes(0), .5f, 1), with_noise(stripes(1), .5f, 2), motion);
        CHECK(error_of(picture, stripes(1)) < .34);
    }
    SUBCASE("noise alone changes nearly nothing") {
        auto const picture = both(with_noise(flat, .5f, 1), with_noise(flat, .5f, 2), motion);
        CHECK(error_of(picture, flat) < .05);
    }
    SUBCASE("what is not where its surface came from was no mistake of the filter") {
        auto const picture = both(stripes(0), stripes(2), motion_of(0.f, 0.f));
        CHECK(picture == flat);
    }
    SUBCASE("texture finer than pixels between pixels: its loss on the way is made up for") {
        std::mt19937 random(3);
        std::normal_distribution<float> half(1.f, .7f); // each pixel shows two
        Colours texture(2 * pixels + 1), earlier(pixels), later(pixels);
        for (auto& each : texture) each = glm::vec3(half(random));
        for (std::size_t i = 0; i < pixels; ++i)
            earlier[i] = .5f * (texture[2 * i] + texture[2 * i + 1]), later[i] = .5f * (texture[2 * i + 1] + texture[2 * i + 2]);
        auto const picture = both(with_noise(earlier, .3f, 1), with_noise(later, .3f, 2), motion_of(.5f, 0.f));
        CHECK(error_of(flat, later) > .45);
        CHECK(error_of(picture, later) < .33);
    }
    SUBCASE("of single samples the finest part may be of points alone") {
        auto const before = stripes(0);
        auto const picture = made_with({.witness = {.alike = 2.f, .same = 3.f}}, stripes(1), &before, nullptr, motion, motion);
        CHECK(error_of(picture, stripes(1)) > .15);
        CHECK(error_of(picture, stripes(1)) < .5);
    }
    SUBCASE("without motion vectors nothing is known") {
        float const unknown = std::numeric_limits<float>::quiet_NaN();
        CHECK(both(stripes(0), stripes(1), motion_of(unknown, unknown)) == flat);
    }
    SUBCASE("missing samples are no residual") {
        auto missing = stripes(1);
        for (auto& pixel : missing) pixel.y = std::numeric_limits<float>::quiet_NaN();
        CHECK(both(stripes(0), missing, motion) == flat);
    }
}

TEST_CASE("noise that stays on the screen is no witness") {
    Colours const flat(pixels, glm::vec3(1.f));
    auto const motion = motion_of(.5f, 0.f); // along which much of it is the same
    auto const noisy = with_noise(flat, .5f, 1);
    auto const error = [&](RepeatedResidual const& rule, Colours const& before) {
        return error_of(made_with(rule, noisy, &before, nullptr, motion, motion), flat);
    };
    CHECK(error({.samples = 16.f, .witness = {.same = 3.f, .stays = 9.f}}, noisy) > .2);
    CHECK(error({.samples = 16.f, .witness = {.same = 3.f}}, noisy) < .06);
    CHECK(error({.samples = 16.f}, with_noise(flat, .5f, 2)) < .05);
}

TEST_CASE("noise that goes along with a surface is no detail, as it has nothing in common with its neighbours") {
    Colours const flat(pixels, glm::vec3(1.f));
    auto const motion = motion_of(-1.f, 0.f);
    auto const grain = with_noise(flat, .3f, 1);
    auto moved = grain;
    for (std::size_t i = 1; i < pixels; ++i) moved[i] = grain[i - 1];
    auto const before = with_noise(grain, .3f, 2), now = with_noise(moved, .3f, 3);
    auto const error = [&](NewWitness const& witness) {
        RepeatedResidual const rule{.samples = 64.f, .witness = witness};
        return error_of(made_with(rule, now, &before, nullptr, motion, motion), flat);
    };
    CHECK(error({.scattered = -9.f, .in_shapes = -8.f}) > .15);
    CHECK(error({}) < .05);
}

TEST_CASE("the frame after says as much as the one before, and both say more") {
    RepeatedResidual const rule{.samples = 64.f};
    Colours const flat(pixels, glm::vec3(1.f));
    auto const motion = motion_of(-1.f, 0.f), next = motion_of(1.f, 0.f);
    constexpr float height = .15f;
    auto const stripes_of = [](int shift, unsigned seed) { return with_noise(stripes(shift, height), .3f, seed); };
    auto const now = stripes_of(1, 2), before = stripes_of(0, 1), after = stripes_of(2, 3);
    auto const error = [&](Colours const* one, Colours const* other) {
        return error_of(made_with(rule, now, one, other, motion, next), stripes(1, height));
    };
    CHECK(made_with(rule, now, nullptr, nullptr, motion, next) == flat);
    CHECK(error(nullptr, &after) == doctest::Approx(error(&before, nullptr)).epsilon(.05));
    CHECK(error(&before, &after) < .97 * error(&before, nullptr));
    SUBCASE("where one is not known, the other alone") {
        float const unknown = std::numeric_limits<float>::quiet_NaN();
        CHECK(made_with(rule, now, &before, &after, motion, motion_of(unknown, unknown)) ==
              made_with(rule, now, &before, nullptr, motion, next));
    }
    SUBCASE("their mean has less noise, which is no sign that this frame has less") {
        // With s the square of the mistake and n that of noise, this frame's best share is s / (s + n); x now and y mean add s (x + y)
        // of the mistake and x x n + y y n / 2 of noise.
        auto const made = made_with(rule, now, &before, &after, motion, next), truth = stripes(1, height);
        double along_now = 0., square = 0.;
        for (std::size_t i = 0; i < pixels; ++i) {
            auto const noise = now[i] - truth[i];
            along_now += product_of(made[i] - flat[i], noise), square += product_of(noise, noise);
        }
        CHECK(along_now / square < .2); // x: a seventh; by the square of the mean, as if this frame had as little noise, .3
    }
}

TEST_CASE("given back light is as bright as the samples, and finite, whatever these are") {
    RepeatedResidual const rule;
    auto const motion = motion_of(0.f, 0.f);
    Colours picture(pixels, glm::vec3(1.f)), samples = picture;
    samples[100] = glm::vec3(1e30f), samples[200] = glm::vec3(std::numeric_limits<float>::infinity());
    picture[300] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    auto const lacking = lacking_of_samples(rule, Simd{}, size, samples, picture);
    give_back_repeated(rule, Simd{}, size, lacking, {lacking_moved(Simd{}, lacking, motion.view())}, picture);
    for (std::size_t i = 0; i < pixels; ++i) {
        if (i == 300) continue;
        CHECK(std::isfinite(picture[i].x));
        CHECK(picture[i].x <= 1.f + rule.most * 3.f);
    }
}

TEST_CASE("images of other sizes are refused by name") {
    Colours picture(pixels, glm::vec3(1.f)), few(3);
    auto const motion = motion_of(0.f, 0.f);
    CHECK_THROWS_AS(static_cast<void>(lacking_of_samples({}, Simd{}, size, few, picture)), Error);
    CHECK_THROWS_AS(static_cast<void>(lacking_moved(Simd{}, few, motion.view())), Error);
    CHECK_THROWS_AS(give_back_repeated({}, Simd{}, size, few, {}, picture), Error);
    CHECK_THROWS_AS(give_back_repeated({}, Simd{}, size, picture, {{few, few}}, picture), Error);
    CHECK_THROWS_AS(give_back_repeated({}, Simd{}, size, picture, {{picture, picture}, {picture, picture}, {picture, picture}}, picture),
                    Error);
    CHECK_THROWS_AS(give_back_repeated({.radius = {8, 10, 17}}, Simd{}, size, picture, {{picture, picture}}, picture), Error);
    CHECK_THROWS_AS(give_back_repeated({.witness = {.radius = 17}}, Simd{}, size, picture, {{picture, picture}}, picture), Error);
    CHECK_THROWS_AS(give_back_repeated({.witness = {.same = .6f}}, Simd{}, size, picture, {{picture, picture}}, picture), Error);
    CHECK_THROWS_AS(give_back_repeated({.witness = {.common = 0.f}}, Simd{}, size, picture, {{picture, picture}}, picture), Error);
    CHECK_THROWS_AS(give_back_repeated({.witness = {.in_shapes = .1f}}, Simd{}, size, picture, {{picture, picture}}, picture), Error);
    CHECK_THROWS_AS(give_back_repeated({.witness = {.stays = 0.f}}, Simd{}, size, picture, {{picture, picture}}, picture), Error);
    CHECK_THROWS_AS(give_back_repeated({.deviation = {.7f, 6.f}}, Simd{}, size, picture, {{picture, picture}}, picture), Error);
    CHECK_THROWS_AS(give_back_repeated({.deviation = {0.f, 2.f}}, Simd{}, size, picture, {{picture, picture}}, picture), Error);
}

TEST_CASE("threads give the same bits, and packs what single pixels give") {
    RepeatedResidual const rule{.samples = 16.f};
    Colours const flat(pixels, glm::vec3(1.f));
    auto const motion = motion_of(-.4f, .3f);
    auto const made_by = [&](Executor auto const& executor) {
        auto picture = flat;
        auto const lacking = [&](Colours const& samples) { return lacking_of_samples(rule, executor, size, samples, flat); };
        auto const before = lacking(with_noise(stripes(0), .5f, 1)), now = lacking(with_noise(stripes(1), .5f, 2));
        give_back_repeated(rule, executor, size, now, {lacking_moved(executor, before, motion.view())}, picture);
        return picture;
    };
    auto const one = made_by(Threads<>{.count = 1}), single = made_by(Serial{});
    CHECK(one == made_by(Threads<>{.count = 3}));
    CHECK(one == made_by(Simd{}));
    CHECK(error_of(one, flat) > .1);
    CHECK(error_of(one, single) < 1e-5);
}

TEST_CASE("of few samples, caution is as if there were more of it") {
    auto const motion = motion_of(-1.f, 0.f);
    auto const before = with_noise(stripes(0), .4f, 1), now = with_noise(stripes(1), .4f, 2);
    auto const made = [&](float samples, std::array<float, 3> const& caution) { // of the finest band nothing
        return made_with({.samples = samples, .caution = caution}, now, &before, nullptr, motion, motion);
    };
    CHECK(error_of(made(4.f, {1e6f, .2f, .4f}), made(1e9f, {1e6f, .3f, .6f})) < 1e-6);
    CHECK(error_of(made(4.f, {1e6f, .2f, .4f}), made(1e9f, {1e6f, .2f, .4f})) > 1e-4);
}

} // namespace

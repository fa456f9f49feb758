#include "flat_surface.hpp"

using namespace quell;
using namespace quell::tests;

namespace {
// Where there is no noise, no noise is the same.
constexpr NewWitness of_any{.alike = 2.f, .same = 3.f, .stays = 9.f, .scattered = -9.f, .in_shapes = -8.f};
constexpr glm::vec2 to_the_left{-1.f, 0.f}, to_the_right{1.f, 0.f}, nowhere{0.f, 0.f}, unknown{none, none};

double error_of(Pixels const& picture, Pixels const& truth = flat) { return root_mean_square(picture, truth); }

/// Frames in a row whose pictures are flat.
template <bool has_next> struct Frames : FlatSurface<Pipeline<Denoised, Spatial<RepeatedResidual<Radiance, has_next, true>>>> {
    using Rule = RepeatedResidual<Radiance, has_next, true>;

    explicit Frames(Rule const& rule, glm::vec2 motion = to_the_left) : Frames::FlatSurface(Pipeline{denoised, Spatial{rule}}) {
        this->frame.number = 0, move(quell::motion, motion);
    }
    void move(auto channel, glm::vec2 vector) {
        fill(this->frame[channel], [&](int, int) { return vector; });
    }
    Pixels next(Pixels const& samples) { return ++*this->frame.number, this->run(samples); }
    Pixels both(Pixels const& before, Pixels const& now) { return next(before), next(now); }
    /// Which part of frames around is left out, in the mean over all pixels; and how far noise is that of single pixels.
    std::pair<double, float> refused() {
        auto const told = copy_of(this->history[repeated_refusal]);
        double sum = 0.;
        for (std::size_t i = 0; i < told.size(); i += 2) sum += static_cast<double>(told[i]);
        return {sum / flat_size.pixels(), told[1]};
    }
};
using TwoFrames = Frames<false>;
Pixels made(TwoFrames::Rule const& rule, Pixels const& before, Pixels const& now, glm::vec2 motion = to_the_left) {
    return TwoFrames(rule, motion).both(before, now);
}
Pixels lacks(Pixels const& samples) { return FlatSurface(Pipeline{denoised, Spatial{LackingOfSamples<>{}}}).run(samples); }
} // namespace

TEST_CASE("repeated residual: what two frames both lack comes back, and noise does not") {
    constexpr TwoFrames::Rule rule{.samples = 64.f};
    CHECK(error_of(made({.samples = 64.f, .witness = of_any}, stripes(0), stripes(1)), stripes(1)) < .05);
    // Of one of both frames the best share is a half, which leaves .35.
    CHECK(error_of(made(rule, with_noise(stripes(0), .5f, 1), with_noise(stripes(1), .5f, 2)), stripes(1)) < .34);
    CHECK(error_of(made(rule, with_noise(flat, .5f, 1), with_noise(flat, .5f, 2))) < .05);
    // What is not where its surface came from, or where that is not known, was no mistake of the filter; nor are missing samples.
    CHECK(made(rule, stripes(0), stripes(2), nowhere) == flat);
    CHECK(made(rule, stripes(0), stripes(1), unknown) == flat);
    CHECK(made(rule, stripes(0), Pixels(flat.size(), none)) == flat);
    // Of single samples the finest part may be of points alone.
    double const error = error_of(made({.witness = {.alike = 2.f, .same = 3.f}}, stripes(0), stripes(1)), stripes(1));
    CHECK((error > .15 && error < .5));
    // Of few samples caution is as if there were more of it; of the finest band here nothing.
    auto const by = [](float samples, float middle, float wide) {
        return made({.samples = samples, .caution = {1e6f, middle, wide}}, with_noise(stripes(0), .4f, 1), with_noise(stripes(1), .4f, 2));
    };
    CHECK(error_of(by(4.f, .2f, .4f), by(1e9f, .3f, .6f)) < 1e-6);
    CHECK(error_of(by(4.f, .2f, .4f), by(1e9f, .2f, .4f)) > 1e-4);
}

TEST_CASE("repeated residual: what texture finer than pixels loses on its way between pixels is made up for") {
    std::mt19937 random(3);
    std::normal_distribution<float> half(1.f, .7f); // each pixel shows two
    Pixels texture(2 * static_cast<std::size_t>(flat_size.pixels()) + 1);
    for (auto& each : texture) each = half(random);
    auto const from = [&](int first) {
        return grey([&](int x, int y) {
            auto const* const two = &texture[static_cast<std::size_t>(first + 2 * (y * flat_size.width + x))];
            return .5f * (two[0] + two[1]);
        });
    };
    CHECK(error_of(from(1)) > .45);
    CHECK(error_of(made({.samples = 64.f}, with_noise(from(0), .3f, 1), with_noise(from(1), .3f, 2), {.5f, 0.f}), from(1)) < .33);
}

TEST_CASE("repeated residual: noise that is the same, stays, goes along or is shared is no witness, and the history says so") {
    auto const noisy = with_noise(flat, .5f, 1);
    auto const check = [&](NewWitness const& witness, glm::vec2 motion, Pixels const& before, bool changes, bool is_refused) {
        TwoFrames frames({.samples = 16.f, .witness = witness}, motion);
        CHECK((error_of(frames.both(before, noisy)) > .1) == changes);
        auto const [part, trust] = frames.refused();
        CHECK((is_refused ? part > .9 : part < .05));
        CHECK(trust == 1.f);
    };
    check({}, nowhere, noisy, false, true); // the same frame
    check(of_any, nowhere, noisy, true, false);
    // Along that motion much of it is the same.
    check({.same = 3.f}, {.5f, 0.f}, noisy, false, true);
    check({.same = 3.f, .stays = 9.f}, {.5f, 0.f}, noisy, true, false);
    check({}, {.5f, 0.f}, with_noise(flat, .5f, 2), false, false);

    auto const grain = with_noise(flat, .3f, 1);
    auto moved = grain;
    std::copy(grain.begin(), grain.end() - 3, moved.begin() + 3);
    auto const error = [&](NewWitness const& witness) {
        return error_of(made({.samples = 64.f, .witness = witness}, with_noise(grain, .3f, 2), with_noise(moved, .3f, 3)));
    };
    CHECK(error({.scattered = -9.f, .in_shapes = -8.f}) > .15);
    CHECK(error({}) < .05);

    TwoFrames frames({.samples = 64.f});
    CHECK(frames.both(shared(with_noise(stripes(0), .9f, 1)), shared(with_noise(stripes(1), .9f, 2))) == flat);
    CHECK(frames.refused().second == 0.f);
}

TEST_CASE("repeated residual: the frame after says as much as the one before, and both say more") {
    auto const truth = stripes(1, .15f), before = with_noise(stripes(0, .15f), .3f, 1), now = with_noise(truth, .3f, 2),
               after = with_noise(stripes(2, .15f), .3f, 3);
    auto const made_with = [&](bool has_before, bool has_after, glm::vec2 motion_to_next = to_the_right) {
        Frames<true> frames({.samples = 64.f});
        frames.move(motion_next, motion_to_next);
        if (has_before) frames.next(before);
        put(frames.frame[lacking_next], has_after ? lacks(after) : Pixels(flat.size(), none));
        return frames.next(now);
    };
    auto const both = made_with(true, true);
    double const alone = error_of(made_with(true, false), truth);
    CHECK(made_with(false, false) == flat);
    CHECK(error_of(made_with(false, true), truth) == doctest::Approx(alone).epsilon(.05));
    CHECK(error_of(both, truth) < .97 * alone);
    CHECK(made_with(true, true, unknown) == made_with(true, false));
    // The mean of frames around has less noise, which is no sign that this frame has less. With s the square of the mistake and n that of
    // noise, this frame's best share is s / (s + n); x now and y mean add s (x + y) of the mistake and x x n + y y n / 2 of noise.
    double along_now = 0., square = 0.;
    for (std::size_t i = 0; i < now.size(); ++i) {
        auto const noise = static_cast<double>(now[i] - truth[i]);
        along_now += static_cast<double>(both[i] - 1.f) * noise, square += noise * noise;
    }
    CHECK(along_now / square < .2); // x: a seventh; by the square of the mean, as if this frame had as little noise, .3
}

TEST_CASE("repeated residual: frames that do not follow, and those that are forgotten, are no frame before") {
    auto const before = with_noise(stripes(0), .3f, 1), now = with_noise(stripes(1), .3f, 2);
    TwoFrames frames({.samples = 64.f});
    auto const follows = frames.both(before, now);
    CHECK(follows != flat);
    *frames.frame.number += 3;
    CHECK(frames.next(now) == flat);
    CHECK(frames.both(before, now) == follows);
    frames.history.forget();
    CHECK(frames.next(now) == flat);
    CHECK(copy_of(frames.history[lacking]) == lacks(now));
    CHECK(lacks(scaled(flat, 1.5f)) == scaled(flat, .5f));
}

TEST_CASE("repeated residual: given back light is as bright as the samples, and finite, whatever these are") {
    TwoFrames frames({.witness = of_any}, nowhere);
    auto samples = flat;
    for (std::size_t c = 0; c < 3; ++c) samples[300 + c] = 1e15f, samples[600 + c] = endless;
    frames.frame[denoised].set(12, 3, glm::vec3(none));
    auto const picture = frames.both(samples, samples);
    CHECK((all_finite(picture) && *std::ranges::max_element(picture) <= 61.f));
}

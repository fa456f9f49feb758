#include "../frames.hpp"
#include "../jitter.hpp"
#include "../threads.hpp"

#include <quell/presets/resolve.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <numbers>

using namespace quell;
using tests::copy_of;
using tests::jitter_of;

namespace {

constexpr auto resolve = presets::resolve(presets::none(radiance));

/// A picture that moves over the image: discs with hard edges, at any place of an image that is 1 wide.
struct Discs {
    glm::vec2 speed{0.f}; ///< image widths per frame

    [[nodiscard]] float at(glm::vec2 place, int number) const {
        auto const moved = place - speed * static_cast<float>(number);
        auto const from_centre = glm::fract(moved * 4.f) - .5f;
        return glm::dot(from_centre, from_centre) < .1f ? 1.f : .1f;
    }
    /// The mean over a pixel.
    [[nodiscard]] float mean(int x, int y, Extent size, int number) const {
        constexpr int steps = 8;
        float sum = 0.f;
        for (int j = 0; j < steps; ++j)
            for (int i = 0; i < steps; ++i) {
                glm::vec2 const within{(static_cast<float>(i) + .5f) / steps, (static_cast<float>(j) + .5f) / steps};
                sum += at((glm::vec2(x, y) + within) / static_cast<float>(size.width), number);
            }
        return sum / (steps * steps);
    }
};

template <class F> void fill(F& frame, Discs const& discs, int number, glm::vec2 jitter) {
    auto const width = static_cast<float>(frame.size.width);
    tests::fill_still(frame);
    tests::fill(frame[radiance], [&](int x, int y) { return glm::vec3(discs.at((glm::vec2(x, y) + .5f + jitter) / width, number)); });
    tests::fill(frame[motion], [&](int, int) { return -discs.speed * width; });
    frame.camera.jitter = jitter;
}

template <class View> double error(View const& view, Discs const& discs, int number, int border) {
    double sum = 0;
    int count = 0;
    for (int y = border; y < view.size.height - border; ++y)
        for (int x = border; x < view.size.width - border; ++x, ++count) {
            double const off = static_cast<double>(view.get(0, x, y)) - static_cast<double>(discs.mean(x, y, view.size, number));
            sum += off * off;
        }
    return std::sqrt(sum / count);
}

/// Errors of the first frame, which is a spline's, and of the last.
struct Errors {
    double first, last;
};
template <class R>
Errors errors_of(R const& resolved, Extent size, Extent output, Discs const& discs, bool jittered = true, int frames = 16) {
    Frame frame{size, resolved};
    History history{output, resolved};
    Errors errors{};
    for (int i = 0; i < frames; ++i) {
        fill(frame, discs, i, jittered ? jitter_of(i) : glm::vec2{0.f});
        double const its = error(run(resolved, frame, history), discs, i, output.width / 8);
        (i == 0 ? errors.first : errors.last) = its;
    }
    return errors;
}

template <class R> std::vector<float> random_sequence(R const& resolved, Extent size, Extent output, auto const& executor) {
    Frame frame{size, resolved};
    History history{output, resolved};
    std::vector<float> all;
    for (int i = 0; i < 3; ++i) {
        tests::fill_randomly(frame, static_cast<unsigned>(i));
        frame.camera.jitter = jitter_of(i);
        all = copy_of(run(resolved, frame, history, executor));
    }
    return all;
}

} // namespace

TEST_CASE("resolve: a constant picture stays constant, whatever moves, at any size and ratio") {
    std::array<std::array<Extent, 2>, 7> const sizes{{{{{1, 1}, {1, 1}}},
                                                      {{{1, 1}, {3, 2}}},
                                                      {{{2, 3}, {5, 7}}},
                                                      {{{17, 9}, {34, 18}}},
                                                      {{{33, 7}, {49, 11}}},
                                                      {{{20, 1}, {61, 3}}},
                                                      {{{19, 13}, {7, 5}}}}};
    for (auto const& sizes_of_both : sizes) {
        Extent const size = sizes_of_both[0], output = sizes_of_both[1];
        CAPTURE(to_string(size) + " to " + to_string(output));
        Frame frame{size, resolve};
        History history{output, resolve};
        for (int i = 0; i < 9; ++i) {
            tests::fill_randomly(frame, static_cast<unsigned>(i));
            tests::fill(frame[radiance], [](int, int) { return glm::vec3(.25f, 3.f, .5f); });
            frame.camera.jitter = jitter_of(i);
            auto const view = run(resolve, frame, history);
            CHECK(view.size == output);
            double worst = 0;
            for (int y = 0; y < output.height; ++y)
                for (int x = 0; x < output.width; ++x)
                    for (int c = 0; c < 3; ++c) {
                        double const expected = c == 0 ? .25 : c == 1 ? 3. : .5;
                        worst = std::max(worst, std::abs(static_cast<double>(view.get(c, x, y)) / expected - 1.));
                    }
            CHECK(worst < 1e-5);
        }
    }
}

TEST_CASE("resolve: jittered samples of a still picture make its edges smooth, at its own size and at larger ones") {
    for (Extent const output : {Extent{64, 64}, Extent{96, 96}, Extent{128, 128}, Extent{192, 192}, Extent{101, 101}}) {
        CAPTURE(to_string(output));
        auto const errors = errors_of(resolve, {64, 64}, output, {});
        CHECK(errors.last < .75 * errors.first);
    }
}

TEST_CASE("resolve: a picture that moves stays sharp") {
    // Without jitter too: motion brings other places.
    for (bool const jittered : {true, false}) {
        CAPTURE(jittered);
        auto const errors = errors_of(resolve, {64, 64}, {128, 128}, {.speed = {.0071f, .0043f}}, jittered);
        CHECK(errors.last < .8 * errors.first);
    }
}

TEST_CASE("resolve: motion with jitter left in gives the picture of motion without, whatever size the frames have") {
    constexpr auto with_jitter =
        presets::resolve(presets::none(radiance, Supplied<MotionConvention{.jitter = MotionConvention::Jitter::left_in}>{}));
    Extent const output{64, 64};
    History left_in{output, with_jitter};
    History left_out{output, resolve};
    auto const pixels = [](Extent size) { return glm::vec2(size.width, size.height); };
    glm::vec2 then{0.f}; // in parts of the image
    for (int i = 0; i < 8; ++i) {
        Extent const size = i % 3 == 2 ? Extent{48, 24} : Extent{32, 32};
        Frame frame{size, resolve}, jittered{size, with_jitter};
        fill(frame, {}, i, jitter_of(i)), fill(jittered, {}, i, jitter_of(i));
        auto const now = jitter_of(i) / pixels(size);
        tests::fill(jittered[motion], [&](int, int) { return (now - then) * pixels(size); });
        then = now;
        CHECK(tests::difference(copy_of(run(with_jitter, jittered, left_in)), copy_of(run(resolve, frame, left_out))) < 1e-4);
    }
}

TEST_CASE("resolve: forget() and a gap in the numbers begin anew") {
    Discs const discs;
    Frame frame{{32, 32}, resolve};
    auto const picture = [&](auto&& before_last) {
        History history{{64, 64}, resolve};
        for (int i = 0; i < 5; ++i) {
            fill(frame, discs, i, jitter_of(i));
            frame.number = i;
            if (i == 4) before_last(history);
            auto const view = run(resolve, frame, history);
            if (i == 4) return copy_of(view);
        }
        return std::vector<float>{};
    };
    fill(frame, discs, 4, jitter_of(4));
    History fresh{{64, 64}, resolve};
    auto const alone = copy_of(run(resolve, frame, fresh));
    CHECK(picture([](auto& history) { history.forget(); }) == alone);
    CHECK(picture([&](auto&) { frame.number = 9; }) == alone);
    CHECK(picture([](auto&) {}) != alone);
}

TEST_CASE("resolve: bits do not depend on threads") {
    constexpr Extent size{37, 19};
    for (Extent const output : {Extent{74, 38}, Extent{37, 19}, Extent{56, 30}}) {
        CAPTURE(to_string(output));
        auto const alone = random_sequence(resolve, size, output, Simd{});
#if defined(QUELL_TEST_THREADS)
        CHECK(random_sequence(resolve, size, output, Threads<>{3}) == alone);
#endif
        CHECK(tests::all_finite(alone));
    }
}

TEST_CASE("resolve: no motion, depth or colour makes a picture that is not finite") {
    constexpr float none = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    Frame frame{{33, 9}, resolve};
    History history{{66, 18}, resolve};
    for (int i = 0; i < 4; ++i) {
        tests::fill_randomly(frame, static_cast<unsigned>(i));
        for (int y = 0; y < 9; ++y) {
            frame[motion].set(y, y, {none, 0.f}), frame[motion].set(y + 3, y, {0.f, infinite}),
                frame[motion].set(y + 7, y, {3e38f, -3e38f});
            frame[depth].set(y + 12, y, none), frame[depth].set(y + 14, y, infinite);
            frame[radiance].set(y + 16, y, glm::vec3(none));
        }
        CHECK(tests::all_finite(copy_of(run(resolve, frame, history))));
    }
}

TEST_CASE("resolve: sharpening raises contrast, adds no seams, and leaves a constant picture alone") {
    Sharpen const sharpen{.amount = 1.f};
    float const same[]{2.f, 2.f, 2.f, 2.f};
    CHECK(sharpen(2.f, same) == 2.f);
    float const around[]{1.f, 3.f, 2.f, 2.5f};
    CHECK(sharpen(2.5f, around) == doctest::Approx(2.875f));
    float const below[]{1.f, 1.f, 1.f, 1.f};
    CHECK(sharpen(2.f, below) == 2.f); // limited to what the five hold
    auto const sharp = presets::resolve(presets::none(radiance), Resolve{GaussianKernel{}, MeanDeviation{}, YCoCg{}, Sharpen{}});
    CHECK(errors_of(sharp, {64, 64}, {128, 128}, {}).last < .75 * errors_of(sharp, {64, 64}, {128, 128}, {}).first);
}

TEST_CASE("resolve: run_into writes to the host's memory; wrong sizes and jitter are named") {
    Frame frame{{16, 8}, resolve};
    fill(frame, {}, 0, jitter_of(0));
    History history{{32, 16}, resolve}, other{{32, 16}, resolve};
    ImageOf<Planar<>, Radiance> target(Extent{32, 16}), wrong(Extent{16, 8});
    run_into(target.view(), resolve, frame, history);
    CHECK(copy_of(target.view()) == copy_of(run(resolve, frame, other)));
    CHECK(tests::message([&] { run_into(wrong.view(), resolve, frame, history); }).find("16x8 for a history of 32x16") !=
          std::string::npos);
    frame.camera.jitter = {0.f, std::numeric_limits<float>::quiet_NaN()};
    CHECK(tests::message([&] { run(resolve, frame, history); }).find("frame.camera.jitter") != std::string::npos);
    frame.camera.jitter = {9.f, 0.f};
    CHECK(tests::message([&] { run(resolve, frame, history); }).find("frame.camera.jitter") != std::string::npos);
}

TEST_CASE("resolve: memory is complete when all frames are kept, and follows the sizes of input and output") {
    Frame frame{{32, 32}, resolve};
    History history{{64, 64}, resolve};
    for (int i = 0; i < 8; ++i) fill(frame, {}, i, jitter_of(i)), run(resolve, frame, history);
    auto const complete = history.bytes();
    fill(frame, {}, 8, jitter_of(8)), run(resolve, frame, history);
    CHECK(history.bytes() == complete);
    // Seven frames of colour, motion and depth at a quarter of the output's pixels, ranges around them, the pipeline's output, and this
    // one.
    CHECK(history.bytes_per_pixel() < 102.);
}

TEST_CASE("resolve: an output pixel is the mean of samples by how near they come to it along the motion of the nearest surface") {
    // Ranges are so wide that nothing is clamped.
    auto const wide = presets::resolve(presets::none(radiance), Resolve{GaussianKernel{}, MeanDeviation{.sigmas = 1e4f}});
    struct Seen {
        Extent size;
        glm::dvec2 jitter;
        std::vector<glm::dvec3> colours;
        std::vector<double> depths;
        std::vector<glm::dvec2> motions;
        [[nodiscard]] std::size_t at(int x, int y) const {
            return static_cast<std::size_t>(std::clamp(y, 0, size.height - 1) * size.width + std::clamp(x, 0, size.width - 1));
        }
        [[nodiscard]] std::size_t nearest_around(int x, int y) const {
            auto found = at(x, y);
            for (int i = 0; i < 9; ++i)
                if (depths[at(x + i % 3 - 1, y + i / 3 - 1)] < depths[found]) found = at(x + i % 3 - 1, y + i / 3 - 1);
            return found;
        }
    };
    Extent const output{40, 26};
    History history{output, wide};
    std::vector<Seen> frames; // the newest first
    std::mt19937 random(8);
    std::uniform_real_distribution<float> number(-1.f, 1.f);
    std::vector<float> made;
    for (int k = 0; k < 5; ++k) {
        Frame frame{k % 2 == 0 ? Extent{20, 13} : Extent{27, 11}, wide};
        frame.camera.jitter = {.4f * number(random), .4f * number(random)};
        auto& seen = *frames.insert(frames.begin(), Seen{frame.size, frame.camera.jitter, {}, {}, {}});
        for (int y = 0; y < frame.size.height; ++y)
            for (int x = 0; x < frame.size.width; ++x) {
                bool const in_front = (x + k) % 10 < 4 && y > 2;
                glm::vec3 const light(2.f + number(random), 3.f + number(random), 4.f + number(random));
                float const its_depth = (in_front ? 1.5f : 4.f) + .01f * number(random);
                glm::vec2 const vector = in_front ? glm::vec2(1.1f, -.7f) : glm::vec2(-.4f, .3f);
                frame[radiance].set(x, y, light), frame[depth].set(x, y, its_depth), frame[motion].set(x, y, vector);
                seen.colours.emplace_back(light), seen.depths.push_back(static_cast<double>(its_depth)), seen.motions.emplace_back(vector);
            }
        made = copy_of(run(wide, frame, history));
    }
    auto const ratio = [&](Seen const& frame) {
        return glm::dvec2(output.width, output.height) / glm::dvec2(frame.size.width, frame.size.height);
    };
    auto const& now = frames[0];
    double worst = 0.;
    for (int y = 0; y < output.height; ++y)
        for (int x = 0; x < output.width; ++x) {
            glm::dvec2 place(x + .5, y + .5);
            auto const where_in = [&](Seen const& frame) { return place / ratio(frame) - frame.jitter; };
            auto const weight = [&](Seen const& frame) {
                auto const off = (glm::fract(where_in(frame)) - .5) * ratio(frame);
                return std::exp(-.5 * glm::dot(off, off) / (.45 * .45));
            };
            auto const sample = [&](Seen const& frame) {
                auto const where = glm::floor(where_in(frame));
                return glm::ivec2(std::clamp(static_cast<int>(where.x), 0, frame.size.width - 1),
                                  std::clamp(static_cast<int>(where.y), 0, frame.size.height - 1));
            };
            // Catmull-Rom, within the values of its taps.
            glm::dvec3 spline(0.), low(1e9), high(-1e9);
            auto const corner = glm::floor(where_in(now) - .5), t = where_in(now) - .5 - corner;
            auto const spline_weights = [](double u) {
                return std::array{(-u + 2. * u * u - u * u * u) / 2., (2. - 5. * u * u + 3. * u * u * u) / 2.,
                                  (u + 4. * u * u - 3. * u * u * u) / 2., (-u * u + u * u * u) / 2.};
            };
            for (std::size_t i = 0; i < 16; ++i) {
                auto const tap = now.colours[now.at(static_cast<int>(corner.x + static_cast<double>(i % 4)) - 1,
                                                    static_cast<int>(corner.y + static_cast<double>(i / 4)) - 1)];
                spline += spline_weights(t.x)[i % 4] * spline_weights(t.y)[i / 4] * tap, low = glm::min(low, tap),
                                                                                         high = glm::max(high, tap);
            }
            spline = glm::clamp(spline, low, high);
            auto const here = sample(now);
            double nearest = 1e9, farthest = 0., total = weight(now), best = total;
            for (int i = 0; i < 9; ++i) {
                double const its = now.depths[now.at(here.x + i % 3 - 1, here.y + i / 3 - 1)];
                nearest = std::min(nearest, its), farthest = std::max(farthest, its);
            }
            auto sum = total * spline;
            auto vector = now.motions[now.nearest_around(here.x, here.y)];
            for (std::size_t k = 1; k < frames.size(); ++k) {
                place += vector * ratio(frames[k - 1]);
                if (place.x < 0. || place.y < 0. || place.x > output.width || place.y > output.height) break;
                auto const there = sample(frames[k]);
                double const its = frames[k].depths[frames[k].at(there.x, there.y)];
                if (its >= nearest * .97 && its <= farthest * 1.03) {
                    sum += weight(frames[k]) * frames[k].colours[frames[k].at(there.x, there.y)];
                    total += weight(frames[k]), best = std::max(best, weight(frames[k]));
                }
                vector = frames[k].motions[frames[k].nearest_around(there.x, there.y)];
            }
            auto const wanted = glm::mix(spline, sum / total, best);
            for (int c = 0; c < 3; ++c)
                worst = std::max(worst,
                                 std::abs(static_cast<double>(made[static_cast<std::size_t>(3 * (y * output.width + x) + c)]) - wanted[c]));
        }
    CHECK(worst < 2e-3);
}

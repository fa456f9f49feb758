#include "../failing.hpp"
#include "../frames.hpp"
#include "../threads.hpp"

#include <quell/presets/anti_aliased.hpp>

#include <limits>

using namespace quell;
using tests::copy_of;

namespace {

constexpr auto pipeline = presets::none(radiance, Demodulate{});
constexpr auto denoise = presets::anti_aliased(pipeline);
constexpr Extent size{48, 24};

/// A thing before a wall, with a slanted edge. The light is 1 everywhere.
struct Edge {
    glm::vec2 speed{0.f};   ///< of the thing, in pixels per frame
    float wall_depth = 4.f; ///< that of the thing is 2

    [[nodiscard]] bool is_thing(glm::vec2 place, int number) const {
        auto const there = place - speed * static_cast<float>(number);
        return there.x + .31f * there.y < 22.f;
    }
    static float albedo_of(bool is_thing) { return is_thing ? .25f : .75f; }
    /// The mean albedo over a pixel.
    [[nodiscard]] float mean(int x, int y, int number) const {
        constexpr int steps = 8;
        float sum = 0.f;
        for (int j = 0; j < steps; ++j)
            for (int i = 0; i < steps; ++i) {
                glm::vec2 const within{(static_cast<float>(i) + .5f) / steps, (static_cast<float>(j) + .5f) / steps};
                sum += albedo_of(is_thing(glm::vec2(x, y) + within, number));
            }
        return sum / (steps * steps);
    }
};

glm::vec2 jitter_of(int number) {
    constexpr glm::vec2 places[] = {{0.f, -.17f}, {-.25f, .17f}, {.25f, -.39f}, {-.375f, -.06f}, {.125f, .28f}};
    return places[number % 5];
}

template <class F> void fill(F& frame, Edge const& edge, int number, glm::vec2 jitter) {
    auto const is_thing = [&](int x, int y) { return edge.is_thing(glm::vec2(x, y) + .5f + jitter, number); };
    tests::fill_still(frame);
    tests::fill(frame[albedo], [&](int x, int y) { return glm::vec3(Edge::albedo_of(is_thing(x, y))); });
    tests::fill(frame[radiance], [&](int x, int y) { return glm::vec3(Edge::albedo_of(is_thing(x, y))); });
    tests::fill(frame[depth], [&](int x, int y) { return is_thing(x, y) ? 2.f : edge.wall_depth; });
    tests::fill(frame[motion], [&](int x, int y) { return is_thing(x, y) ? -edge.speed : glm::vec2(0.f); });
    frame.camera.jitter = jitter;
}

/// The error of the last of some frames, and of the picture that came in.
struct Errors {
    double input = 0., output = 0.;
};
template <class R> Errors errors_of(R const& remodulated, Edge const& edge, bool jittered, int frames = 9) {
    Frame frame{size, remodulated};
    History history{size, remodulated};
    Errors errors;
    for (int i = 0; i < frames; ++i) {
        fill(frame, edge, i, jittered ? jitter_of(i) : glm::vec2(0.f));
        auto const view = run(remodulated, frame, history);
        errors = {};
        for (int y = 2; y < size.height - 2; ++y)
            for (int x = 2; x < size.width - 2; ++x) {
                auto const off = [&](float value) {
                    double const by = static_cast<double>(value) - static_cast<double>(edge.mean(x, y, i));
                    return by * by;
                };
                errors.input += off(frame[radiance].view().get(0, x, y)), errors.output += off(view.get(0, x, y));
            }
    }
    return {std::sqrt(errors.input), std::sqrt(errors.output)};
}

} // namespace

TEST_CASE("anti-aliased: an edge becomes the mean of jittered samples, nearer by those of the frame before") {
    for (float const wall_depth : {4.f, 2.f}) { // between two surfaces, and within one
        Edge const edge{.wall_depth = wall_depth};
        auto const alone = errors_of(denoise, edge, true, 1), with_past = errors_of(denoise, edge, true);
        CHECK(alone.output < .7 * alone.input);
        CHECK(with_past.output / with_past.input < .9 * alone.output / alone.input);
    }
}

TEST_CASE("anti-aliased: where a surface has one colour, the picture stays as it is to the bit") {
    Frame frame{size, denoise};
    History history{size, denoise};
    History plain{size, pipeline};
    for (unsigned i = 0; i < 3; ++i) {
        tests::fill_randomly(frame, i);
        tests::fill(frame[albedo], [](int x, int) { return x < 24 ? glm::vec3(.5f, .25f, 1.f) : glm::vec3(0.f); });
        tests::fill(frame[depth], [](int, int y) { return 2.f + .01f * static_cast<float>(y); });
        auto const made = copy_of(run(denoise, frame, history)), given = copy_of(run(pipeline, frame, plain));
        std::size_t differing = 0;
        for (std::size_t p = 0; p < made.size(); ++p) {
            auto const x = static_cast<int>(p / 3) % size.width;
            differing += std::abs(x - 24) > 2 && made[p] != given[p] ? 1u : 0u;
        }
        CHECK(differing == 0);
    }
}

TEST_CASE("anti-aliased: what is kept lies in the pipeline's memory, and does not grow") {
    Frame frame{size, denoise};
    History history{size, denoise};
    History plain{size, pipeline};
    auto const bytes_after = [&](int frames) {
        for (int i = 0; i < frames; ++i) fill(frame, {}, i, jitter_of(i)), run(denoise, frame, history), run(pipeline, frame, plain);
        return history.bytes();
    };
    auto const complete = bytes_after(3);
    CHECK(bytes_after(4) == complete);
    history.forget();
    CHECK(bytes_after(4) == complete);
    // Two frames of six planes, and the picture that it is given. What it makes takes three that the pipeline needs no more.
    CHECK(complete - plain.bytes() <= 15 * ImageOf<Planar<>, Depth>(size).bytes());
    history.release_scratch();
    CHECK(history.bytes() < complete);
    CHECK(bytes_after(2) == complete);
}

TEST_CASE("anti-aliased: behind a composite too, whose size may change") {
    constexpr auto both = presets::anti_aliased(Composite{presets::none(direct), presets::none(glossy)});
    Frame small{Extent{9, 5}, both}, frame{size, both};
    History history{size, both}, fresh{size, both};
    auto const last_of = [&](auto& of) {
        std::vector<float> made;
        for (unsigned i = 0; i < 3; ++i) tests::fill_randomly(frame, i), made = copy_of(run(both, frame, of));
        return made;
    };
    tests::fill_randomly(small, 7), run(both, small, history);
    auto const made = last_of(history);
    CHECK(tests::all_finite(made));
    CHECK(made == last_of(fresh));
    CHECK(history.bytes() == fresh.bytes());
}

TEST_CASE("anti-aliased: an edge that moves needs no jitter") {
    auto const moved = errors_of(denoise, {.speed = {.37f, .21f}}, false);
    CHECK(moved.output < .6 * moved.input);
}

TEST_CASE("anti-aliased: what one surface shows stays as it is, and a constant picture constant whatever moves") {
    for (Extent const small : {Extent{1, 1}, Extent{2, 3}, Extent{17, 9}, Extent{33, 5}}) {
        CAPTURE(to_string(small));
        Frame frame{small, denoise};
        History history{small, denoise};
        for (unsigned i = 0; i < 6; ++i) {
            tests::fill_randomly(frame, i);
            tests::fill(frame[albedo], [](int, int) { return glm::vec3(.5f, .25f, 1.f); });
            tests::fill(frame[radiance], [](int, int) { return glm::vec3(.25f, 3.f, .5f); });
            frame.camera.jitter = jitter_of(static_cast<int>(i));
            auto const made = copy_of(run(denoise, frame, history));
            double worst = 0;
            for (std::size_t p = 0; p < made.size(); ++p)
                worst = std::max(worst, std::abs(static_cast<double>(made[p]) / (p % 3 == 0 ? .25 : p % 3 == 1 ? 3. : .5) - 1.));
            CHECK(worst < 1e-5);
        }
    }
}

TEST_CASE("anti-aliased: motion with jitter left in gives the picture of motion without") {
    constexpr auto left_out = presets::anti_aliased(pipeline);
    constexpr auto left_in = presets::anti_aliased(
        presets::none(radiance, Demodulate{}, Supplied<MotionConvention{.jitter = MotionConvention::Jitter::left_in}>{}));
    Frame frame{size, left_out}, jittered{size, left_in};
    History history{size, left_out};
    History of_jittered{size, left_in};
    Edge const edge{.speed = {.7f, .2f}};
    glm::vec2 then{0.f};
    for (int i = 0; i < 5; ++i) {
        glm::vec2 const now = jitter_of(i);
        fill(frame, edge, i, now), fill(jittered, edge, i, now);
        tests::fill(jittered[motion], [&](int x, int y) { return glm::vec2(frame[motion].get(x, y)) + now - then; });
        then = now;
        CHECK(tests::difference(copy_of(run(left_in, jittered, of_jittered)), copy_of(run(left_out, frame, history))) < 1e-4);
    }
}

TEST_CASE("anti-aliased: what comes into sight takes the current frame") {
    // A thing goes away at once, and what it hid has another colour.
    Frame frame{size, denoise};
    History history{size, denoise}, fresh{size, denoise};
    auto const show = [&](bool is_there) {
        tests::fill_still(frame);
        auto const hides = [&](int x) { return is_there && x >= 12 && x < 30; };
        tests::fill(frame[albedo],
                    [&](int x, int y) { return glm::vec3(hides(x) ? .9f : .1f + .02f * static_cast<float>((x * 7 + y * 3) % 5)); });
        tests::fill(frame[radiance], [&](int x, int) { return glm::vec3(hides(x) ? 2.f : .5f); });
        tests::fill(frame[depth], [&](int x, int) { return hides(x) ? 2.f : 4.f; });
    };
    for (int i = 0; i < 5; ++i) show(true), static_cast<void>(run(denoise, frame, history));
    show(false);
    auto const after = copy_of(run(denoise, frame, history)), alone = copy_of(run(denoise, frame, fresh));
    double worst = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 14; x < 28; ++x) {
            auto const at = static_cast<std::size_t>((y * size.width + x) * 3);
            worst = std::max(worst, std::abs(static_cast<double>(after[at]) - static_cast<double>(alone[at])));
        }
    CHECK(worst < 1e-6);
}

TEST_CASE("anti-aliased: at a cut, after a gap and at another size nothing is left of the frames before") {
    auto const last_of = [](auto&& between, bool has_past) {
        Frame frame{size, denoise};
        History history{size, denoise};
        for (int i = 0; i < 4 && has_past; ++i)
            fill(frame, {.speed = {.3f, 0.f}}, i, jitter_of(i)), frame.number = i, run(denoise, frame, history);
        between(history, frame);
        fill(frame, {}, 0, jitter_of(1));
        return copy_of(run(denoise, frame, history));
    };
    auto const alone = last_of([](auto&, auto& frame) { frame.number = 4; }, false);
    CHECK(last_of([](auto&, auto& frame) { frame.number = 4; }, true) != alone);
    CHECK(last_of([](auto& history, auto& frame) { history.forget(), frame.number = 4; }, true) == alone);
    CHECK(last_of([](auto&, auto& frame) { frame.number = 7; }, true) == alone);
    CHECK(last_of(
              [](auto& history, auto& frame) {
                  Frame other{Extent{9, 5}, denoise};
                  other.number = 4, frame.number = 5;
                  tests::fill_still(other), run(denoise, other, history);
              },
              true) == alone);
}

TEST_CASE("anti-aliased: wrong jitter is named, and leaves the history as it is") {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    Frame frame{size, denoise};
    History history{size, denoise}, other{size, denoise};
    for (int i = 0; i < 3; ++i) {
        fill(frame, {}, i, jitter_of(i));
        if (i == 2)
            for (glm::vec2 const wrong : {glm::vec2(0.f, nan), glm::vec2(9.f, 0.f), glm::vec2(0.f, -8.5f)}) {
                frame.camera.jitter = wrong;
                CHECK(tests::message([&] { run(denoise, frame, history); }).find("frame.camera.jitter") != std::string::npos);
            }
        frame.camera.jitter = jitter_of(i);
        CHECK(copy_of(run(denoise, frame, history)) == copy_of(run(denoise, frame, other)));
    }
}

TEST_CASE("anti-aliased: where memory runs out at another size, the next frame starts afresh") {
    constexpr Extent small{17, 9};
    // Allocations fail one after another, until all of a frame's succeed.
    for (int fails_at = 0; fails_at < 64; ++fails_at) {
        CAPTURE(fails_at);
        History history{size, denoise, tests::Failing{}}, fresh{size, denoise, tests::Failing{}};
        Frame frame{size, denoise}, smaller{small, denoise};
        fill(frame, {}, 0, jitter_of(0)), fill(smaller, {}, 1, jitter_of(1));
        run(denoise, frame, history, Serial{});
        tests::Failing::left = fails_at;
        bool ran_out = false;
        try {
            run(denoise, smaller, history, Serial{});
        } catch (std::bad_alloc const&) {
            ran_out = true;
        }
        tests::Failing::left = -1;
        fill(frame, {}, 2, jitter_of(2));
        CHECK(copy_of(run(denoise, frame, history, Serial{})) == copy_of(run(denoise, frame, fresh, Serial{})));
        if (!ran_out) {
            CHECK(fails_at > 3);
            return;
        }
    }
    FAIL("memory never sufficed");
}

TEST_CASE("anti-aliased: bits do not depend on threads, nor on where the picture goes") {
    auto const random_sequence = [](auto const& executor, auto const& runs) {
        Frame frame{size, denoise};
        History history{size, denoise};
        std::vector<float> all;
        for (unsigned i = 0; i < 6; ++i) {
            tests::fill_randomly(frame, i);
            frame.camera.jitter = jitter_of(static_cast<int>(i));
            all = runs(frame, history, executor);
        }
        return all;
    };
    auto const plainly = [](auto& frame, auto& history, auto const& executor) { return copy_of(run(denoise, frame, history, executor)); };
    auto const alone = random_sequence(Simd{}, plainly);
    CHECK(tests::all_finite(alone));
    CHECK(tests::difference(random_sequence(Serial{}, plainly), alone) < 2e-3);
#if defined(QUELL_TEST_THREADS)
    CHECK(random_sequence(Threads<>{3}, plainly) == alone);
#endif
    CHECK(random_sequence(Simd{}, [](auto& frame, auto& history, auto const& executor) {
              ImageOf<Planar<>, Radiance> target(size);
              run_into(target.view(), denoise, frame, history, executor);
              return copy_of(target.view());
          }) == alone);
}

TEST_CASE("anti-aliased: no guide makes a picture that is not finite, in any storage") {
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    auto const check = [](auto const& storage) {
        Frame frame{size, denoise};
        History history{size, denoise, storage};
        for (unsigned i = 0; i < 6; ++i) {
            tests::fill_randomly(frame, i);
            tests::fill(frame[depth], [&](int x, int y) { return (x + y) % 5 == 0 ? inf : (x * y) % 11 == 3 ? nan : 4.f; });
            tests::fill(frame[motion], [&](int x, int y) { return (x * 3 + y) % 7 == 0 ? glm::vec2(nan, inf) : glm::vec2(x, y); });
            tests::fill(frame[albedo], [&](int x, int y) { return (x + 2 * y) % 9 == 0 ? glm::vec3(nan, -1.f, inf) : glm::vec3(.5f); });
            CHECK(tests::all_finite(copy_of(run(denoise, frame, history))));
        }
        CHECK(history.bytes_per_pixel() > 0.);
    };
    check(Planar<>{}), check(Planar<Float16>{}), check(Interleaved<>{});
}

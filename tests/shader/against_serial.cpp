#include <quell/blur/two_motions/stratified_mean.hpp>

/// Sums of strata are rounded otherwise than sums of samples: here Serial takes them too.
template <> inline constexpr bool quell::detail::keeps_sums<float> = true;

#include "own_policies.hpp"

#include "../images.hpp"
#include "two_sizes.hpp"

#include <quell/link/light_given_back.hpp>
#include <quell/link/resolve/resolve.hpp>
#include <quell/presets/anti_aliased.hpp>
#include <quell/presets/blur.hpp>
#include <quell/presets/by_evidence.hpp>
#include <quell/shader/interpreter.hpp>
#include <quell/shader/record.hpp>
#include <quell/shader/write_plan.hpp>

#include <doctest/doctest.h>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <random>

namespace {

using namespace quell;

Camera camera_of(unsigned frame, Extent size) {
    auto const number = static_cast<float>(frame);
    auto const aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
    return {glm::lookAt(glm::vec3(0.1f * number, 1, 8), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)),
            glm::perspective(0.9f, aspect, 0.1f, 100.f), glm::vec2(0.3f * number - 0.2f, 0.1f * number)};
}
/// Strips that turn, in front of what is still or moves otherwise.
glm::vec2 sweep_at(int x, int y) {
    auto const along = static_cast<float>(x), down = static_cast<float>(y);
    if ((x / 13 + y / 9) % 3 == 0) return {9.f + 0.3f * down, 4.f - 0.3f * along};
    return x % 60 < 30 ? glm::vec2(-3.f, 1.f) : glm::vec2(0.f);
}
/// Some samples are not finite, some parts of the image are sky.
template <class F> void fill(F& frame, unsigned number) {
    tests::fill_randomly(frame, number + 7);
    std::mt19937 random(number + 99);
    auto const spoil = [&](auto& image, auto const& value) {
        for (int y = 0; y < frame.size.height; ++y)
            for (int x = 0; x < frame.size.width; ++x)
                if (random() % 40 == 0 && x + y > 0) image.set(x, y, value); // some sample is usable: see docs/shaders.md
    };
    if constexpr (F::template has<Radiance>) spoil(frame[radiance], glm::vec3(std::numeric_limits<float>::quiet_NaN(), 1.f, 1.f));
    if constexpr (F::template has<Visibility>) spoil(frame[visibility], std::numeric_limits<float>::infinity());
    if constexpr (F::template has<Depth>) spoil(frame[depth], std::numeric_limits<float>::infinity());
    if constexpr (F::template has<Sweep>)
        tests::fill(frame[sweep], [&](int x, int y) { return sweep_at(x + 3 * static_cast<int>(number), y); });
    frame.camera = camera_of(number, frame.size);
}
/// How many values of a frame differ in a bit between a recorded plan and Serial.
template <class P, class F, class H>
int differing_in_frame(P const& pipeline, ShaderPlan const& plan, F const& frame, H& history, PlanInterpreter& interpreter,
                       unsigned number) {
    auto const size = frame.size;
    int slot = 0, count = 0;
    for_each_channel(typename F::channels{}, [&]<class C>(C c) {
        auto const& image = frame[c];
        for (int k = 0; k < C::components; ++k) {
            auto const plane = interpreter.plane(ShaderBuffer::inputs, slot++);
            for (int y = 0; y < image.size().height; ++y)
                for (int x = 0; x < image.size().width; ++x)
                    plane[static_cast<std::size_t>(y * image.size().width + x)] = image.get(k, x, y);
        }
    });
    auto const clean = run(pipeline, frame, history, Serial{});
    interpreter.run({.size = size,
                     .frame_index = static_cast<std::int32_t>(number),
                     .camera = frame.camera,
                     .camera_then = number > 0 ? camera_of(number - 1, size) : frame.camera,
                     .shutter = frame.shutter,
                     .shutter_then = frame.shutter,
                     .needs_camera = plan.needs_camera});
    for (int c = 0; c < clean.components; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                float const recorded = interpreter.plane(ShaderBuffer::output, c)[static_cast<std::size_t>(y * size.width + x)];
                count += std::bit_cast<std::uint32_t>(recorded) != std::bit_cast<std::uint32_t>(clean.get(c, x, y));
            }
    return count;
}
/// The same of three frames.
template <class P, class Storage> int differing(P const& pipeline, ShaderPlan const& plan, Extent size, Storage const& storage) {
    Frame frame{size, pipeline};
    History history{size, pipeline, storage};
    PlanInterpreter interpreter(plan, size);
    int count = 0;
    for (unsigned number = 0; number < 5; ++number) {
        fill(frame, number);
        count += differing_in_frame(pipeline, plan, frame, history, interpreter, number);
    }
    return count;
}
template <class P, class Storage = Planar<>>
void check_sizes(P const& pipeline, RecordOptions const& options = {}, Storage const& storage = {}) {
    auto const plan = record(pipeline, "recorded", options);
    for (Extent const size : {Extent{1, 1}, Extent{2, 1}, Extent{3, 7}, Extent{16, 5}, Extent{41, 23}}) {
        CAPTURE(to_string(size));
        CHECK(differing(pipeline, plan, size, storage) == 0);
    }
}
constexpr RecordOptions in_halves{.half_precision = true};

/// Impossible guides, and a hole of nine by nine pixels.
template <class F> void break_frame(F& frame, unsigned number) {
    fill(frame, number);
    auto const [width, height] = frame.size;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (x < 9 && y < 9) frame[radiance].set(x, y, glm::vec3(nan));
            if ((x + 3 * y) % 17 == 0) frame[albedo].set(x, y, glm::vec3(x % 2 == 0 ? infinity : 3.f, 0.5f, 0.5f));
            if ((x + 5 * y) % 19 == 0) frame[normal].set(x, y, glm::vec3(1, x % 3 == 0 ? nan : 2.f, 0));
            if ((x + 7 * y) % 23 == 0) frame[depth].set(x, y, x % 2 == 0 ? -1.f : nan);
            if ((2 * x + y) % 29 == 0) frame[motion].set(x, y, glm::vec2(nan, 0));
        }
}
/// The host's sum of a count over all squares.
double total(ShaderPlan const& plan, PlanInterpreter& interpreter, Extent size, std::string_view what) {
    auto const count = std::ranges::find(plan.counts, what, &ShaderCount::what);
    REQUIRE(count != plan.counts.end());
    return plan.total(*count, size, interpreter.plane(ShaderBuffer::output, count->slot));
}

} // namespace

TEST_CASE("a recorded preset has the bits of Serial: general") { check_sizes(presets::general(radiance, Demodulate{})); }
TEST_CASE("a pass of general binds at most 8 buffers of the 4 slots that 128 MiB have at 3840x2160") {
    auto const plan = record(presets::general(radiance, Demodulate{}), "general", {.most_slots = 4});
    for (auto const& pass : plan.passes) {
        CAPTURE(pass.graph.name);
        CHECK(detail::buffers_of(plan, pass).size() <= 8);
    }
    for (auto const& buffer : plan.bound_buffers()) CHECK(buffer.slot_count <= 4);
}
TEST_CASE("a recorded preset has the bits of Serial: shadow, which looks at the camera") { check_sizes(presets::shadow()); }
TEST_CASE("a recorded preset has the bits of Serial: blur, whose loops are as long as a pixel wants") {
    check_sizes(presets::blur(radiance));
}
TEST_CASE("recorded passes of half the size have the bits of Serial") { check_sizes(tests::two_sizes); }
TEST_CASE("a host's own policies, which call functions with quell:: before them, are recorded with the bits of Serial") {
    check_sizes(tests::own_policies);
}
TEST_CASE("a recorded chain, whose link has a history too, has the bits of Serial") {
    check_sizes(Chain{tests::own_policies, Pipeline{denoised, tests::accumulate, Spatial{tests::EveryFunction{}}}});
}
TEST_CASE("a recorded link that gives light back has the bits of Serial") { check_sizes(light_given_back(radiance, 4.f)); }
TEST_CASE("a recorded policy that looks at several frames of the past has the bits of Serial") { check_sizes(tests::look_back); }
TEST_CASE("a recorded resolve has the bits of Serial") {
    check_sizes(Pipeline{denoised, Spatial{Resolve<GaussianKernel, MeanDeviation, YCoCg, NoSharpening, 2>{}}});
}
TEST_CASE("recorded anti-aliased colours have the bits of Serial") {
    check_sizes(presets::anti_aliased(presets::none(radiance, Demodulate{})));
}
TEST_CASE("a recorded choice between history and the frame alone has the bits of Serial") {
    check_sizes(presets::by_evidence(Pipeline{radiance, tests::accumulate, Spatial{Atrous<>{.levels = 1}}}));
}
TEST_CASE("recorded in half precision it has the bits of Serial with a history in half: general") {
    check_sizes(presets::general(radiance, Demodulate{}), in_halves, Planar<Float16>{});
}
TEST_CASE("the same: svgf, whose variances are kept as roots") { check_sizes(presets::svgf(radiance), in_halves, Planar<Float16>{}); }
TEST_CASE("the same: passes of half the size") { check_sizes(tests::two_sizes, in_halves, Planar<Float16>{}); }
TEST_CASE("what only a frame without a past looks at is still there") { check_sizes(tests::early_at_first); }

TEST_CASE("recorded passes that repair guides, fill holes and count do what run() does") {
    constexpr Pipeline pipeline{
        radiance, Demodulate{}, SuppressFireflies{}, tests::accumulate, Spatial{tests::MakeSmaller{}}, Spatial{tests::UseSmaller{}}};
    auto const plan = record(pipeline, "checked", {.repair_guides = true, .fill_holes = 3, .counts = true});
    for (Extent const size : {Extent{12, 11}, Extent{70, 9}, Extent{9, 70}}) {
        CAPTURE(to_string(size));
        Frame frame{size, pipeline};
        History history{size, pipeline};
        PlanInterpreter interpreter(plan, size);
        for (unsigned number = 0; number < 3; ++number) {
            break_frame(frame, number);
            CHECK(differing_in_frame(pipeline, plan, frame, history, interpreter, number) == 0);
            auto const& statistics = history.statistics();
            CHECK(total(plan, interpreter, size, "missing samples") == static_cast<double>(statistics.missing_samples));
            CHECK(total(plan, interpreter, size, "impossible guides") == static_cast<double>(statistics.repaired_guides.pixels));
            for_each_channel(Channels<Albedo, Normal, Depth, Motion>{}, [&]<class C>(C c) {
                CHECK(total(plan, interpreter, size, "impossible " + std::string(C::name)) ==
                      static_cast<double>(statistics.repaired_guides.of(c)));
            });
            CHECK(total(plan, interpreter, size, "suppressed light") == doctest::Approx(statistics.suppressed).epsilon(1e-5));
            CHECK(statistics.suppressed > 0.);
        }
    }
}

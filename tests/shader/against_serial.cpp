#include <quell/blur/two_motions/stratified_mean.hpp>

/// Sums of strata are rounded otherwise than sums of samples: here Serial takes them too.
template <> inline constexpr bool quell::detail::keeps_sums<float> = true;

#include "../images.hpp"
#include "two_sizes.hpp"

#include <quell/presets/blur.hpp>
#include <quell/shader/interpreter.hpp>
#include <quell/shader/record.hpp>

#include <doctest/doctest.h>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

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
/// How many values of three frames differ in a bit between a recorded plan and Serial.
template <class P> int differing(P const& pipeline, ShaderPlan const& plan, Extent size) {
    Frame frame{size, pipeline};
    History history{size, pipeline};
    PlanInterpreter interpreter(plan, size);
    int count = 0;
    for (unsigned number = 0; number < 3; ++number) {
        fill(frame, number);
        int slot = 0;
        for_each_channel(typename decltype(frame)::channels{}, [&]<class C>(C c) {
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
    }
    return count;
}
template <class P> void check_sizes(P const& pipeline) {
    auto const plan = record(pipeline);
    for (Extent const size : {Extent{1, 1}, Extent{2, 1}, Extent{3, 7}, Extent{16, 5}, Extent{41, 23}}) {
        CAPTURE(to_string(size));
        CHECK(differing(pipeline, plan, size) == 0);
    }
}

} // namespace

TEST_CASE("a recorded preset has the bits of Serial: general") { check_sizes(presets::general(radiance, Demodulate{})); }
TEST_CASE("a recorded preset has the bits of Serial: shadow, which looks at the camera") { check_sizes(presets::shadow()); }
TEST_CASE("a recorded preset has the bits of Serial: blur, whose loops are as long as a pixel wants") {
    check_sizes(presets::blur(radiance));
}
TEST_CASE("recorded passes of half the size have the bits of Serial") { check_sizes(tests::two_sizes); }
TEST_CASE("what only a frame without a past looks at is still there") { check_sizes(tests::early_at_first); }

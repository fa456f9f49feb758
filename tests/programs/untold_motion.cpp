#include "passes.hpp"

#include <denoise/untold_motion.hpp>

#include <quell/core/random.hpp>
#include <quell/io/frame_image.hpp>

#include <cmath>
#include <numbers>

using namespace quell;
using namespace quell::tests;
using examples::found_motion;
using examples::Pyramid;
using examples::SmoothMotion;
using examples::UntoldMotion;

// Motion that vectors leave out, of pictures whose motion is known exactly: each is one picture of waves, looked up where a pixel was.
namespace {

constexpr Extent size{120, 80};
constexpr int horizon = 40; ///< rows above which there is a background
constexpr float far = std::numeric_limits<float>::infinity();

/// Luminance of a picture at a place, in pixels.
float waves(glm::vec2 at) {
    float sum = 0;
    for (int k = 1; k <= 6; ++k) {
        auto const turn = static_cast<float>(k) * 2.4f, length = 5.f + 3.f * static_cast<float>(k);
        sum += std::sin((std::cos(turn) * at.x + std::sin(turn) * at.y) * 2.f * std::numbers::pi_v<float> / length + turn);
    }
    return 2.f + .3f * sum;
}
/// A pan to the right, with some zoom, turn and perspective.
SmoothMotion a_motion() { return {size, {{{-3.2, 1.5, -.6, .8, .4, 0.}, {.9, .6, 1.5, 0., .8, .4}}}}; }
SmoothMotion no_motion() { return {size, {}}; }
float noise(int x, int y, int number) { return 2.f * uniform_pair(static_cast<float>(x), static_cast<float>(y), number).first - 1.f; }

/// The picture of waves after some motion: it shows where each pixel was.
/// @param strength of noise, which differs by number
std::vector<float> picture_after(SmoothMotion const& motion, float strength = 0.f, int number = 0) {
    std::vector<float> light;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) light.push_back(waves(glm::vec2(x, y) + motion.at(x, y)) + strength * noise(x, y, number));
    return light;
}
Pyramid pyramid_of(std::vector<float> light) {
    return {size, std::move(light), std::vector<char>(static_cast<std::size_t>(size.pixels()), 1)};
}
std::vector<glm::vec2> told(SmoothMotion const& motion) {
    std::vector<glm::vec2> vectors;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) vectors.push_back(motion.at(x, y));
    return vectors;
}
float farthest_off(SmoothMotion const& found, SmoothMotion const& wanted) {
    float most = 0;
    for (int y = 4; y < size.height - 4; y += 8)
        for (int x = 4; x < size.width - 4; x += 8) most = std::max(most, glm::distance(found.at(x, y), wanted.at(x, y)));
    return most;
}

/// A frame of quell's own names: a background above, a floor with waves of colour below. Its vectors are 0.
/// @param unit of light
io::ExrImage frame_after(SmoothMotion const& sky, SmoothMotion const& floor, float unit = 1.f) {
    auto image = noisy_image(size, 1);
    auto const of_sky = picture_after(sky), of_floor = picture_after(floor);
    for (auto& plane : image.planes)
        for (std::size_t i = 0; i < plane.values.size(); ++i) {
            bool const is_sky = static_cast<int>(i) / size.width < horizon;
            auto& value = plane.values[i];
            if (plane.name == "depth.Z") value = is_sky ? far : 4.f;
            if (plane.name == "R" || plane.name == "G" || plane.name == "B") value = (is_sky ? of_sky[i] : 1.f) * unit;
            if (plane.name.starts_with("albedo")) value = is_sky ? 1.f : .25f * of_floor[i];
            if (plane.name.starts_with("motion")) value = 0.f;
        }
    for (auto const* const name : {"motion_next.X", "motion_next.Y"})
        image.planes.push_back({.name = name, .type = io::SampleType::float32, .values = std::vector<float>(image.pixels(), 0.f)});
    return image;
}
glm::vec2 vector_in(io::ExrImage const& image, int x, int y, std::string const& name = "motion") {
    auto const i = static_cast<std::size_t>(y * size.width + x);
    return {image[name + ".X"].values[i], image[name + ".Y"].values[i]};
}

} // namespace

TEST_CASE("the way back of a motion leads to where it came from") {
    auto const motion = a_motion();
    for (auto const place : {glm::vec2(3.f, 5.f), glm::vec2(60.f, 40.f), glm::vec2(110.f, 70.f)}) {
        auto const there = place + motion.back_from(place.x, place.y);
        CHECK(glm::distance(there + motion.at(there.x, there.y), place) < 1e-3f);
    }
}

TEST_CASE("the motion between two pictures is found, with noise and without, and whatever of it is told") {
    for (float const strength : {0.f, .5f}) {
        auto const before = pyramid_of(picture_after(no_motion(), strength, 1)), now = pyramid_of(picture_after(a_motion(), strength, 2));
        auto const found = found_motion(now, before, told(no_motion()));
        REQUIRE(found);
        CHECK(farthest_off(*found, a_motion()) < (strength > 0.f ? .3f : .1f));
        auto half = a_motion();
        for (auto& axis : half.factors)
            for (auto& factor : axis) factor *= .5;
        auto const rest = found_motion(now, before, told(half));
        REQUIRE(rest);
        CHECK(farthest_off(*rest, half) < (strength > 0.f ? .3f : .1f));
        CHECK(!found_motion(now, before, told(a_motion()))); // all is told
    }
}

TEST_CASE("no motion is found in noise, in an even picture, between two pictures, or of a part alone") {
    auto const plain = picture_after(no_motion());
    std::vector<float> const even(plain.size(), 1.f);
    auto only_noise = even, other_noise = even, others = plain, parts = plain;
    auto const moved = picture_after(a_motion());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const i = static_cast<std::size_t>(y * size.width + x);
            only_noise[i] += .5f * noise(x, y, 3), other_noise[i] += .5f * noise(x, y, 4);
            others[i] = waves(glm::vec2(3 * x + 500, 2 * y - 700));
            if (x < size.width / 3) parts[i] = moved[i]; // a thing moves before what stands still
        }
    auto const still = told(no_motion());
    CHECK(!found_motion(pyramid_of(only_noise), pyramid_of(other_noise), still));
    CHECK(!found_motion(pyramid_of(even), pyramid_of(even), still));
    CHECK(!found_motion(pyramid_of(others), pyramid_of(plain), still));
    CHECK(!found_motion(pyramid_of(parts), pyramid_of(plain), still));
    CHECK(!found_motion(pyramid_of(moved), pyramid_of(std::vector<float>(plain.size(), std::numeric_limits<float>::quiet_NaN())), still));
}

TEST_CASE("vectors of the background and of all surfaces become those that the pictures show, each by itself, in any unit of light") {
    auto names = io::own_sequence();
    SmoothMotion const none = no_motion();
    auto floor = none;
    floor.factors[0] = {0., 4., 0., 0., 0., 0.}, floor.factors[1] = {1.5, 0., 4., 0., 0., 0.};
    std::vector<io::ExrImage> told_of;
    for (float const unit : {1.f, 0x1p-20f}) {
        UntoldMotion untold;
        auto first = frame_after(none, none, unit), second = frame_after(a_motion(), floor, unit);
        examples::GuideImages of_first, of_second;
        untold.tell(first, names, 1, true, of_first), untold.tell(second, names, 2, true, of_second);
        CHECK(untold.tell_next(first, names, 1, of_first));
        for (int const x : {20, 60, 100}) {
            CHECK(glm::distance(vector_in(second, x, 20), a_motion().at(x, 20)) < .3f);
            CHECK(glm::distance(vector_in(first, x, 20, "motion_next"), a_motion().back_from(x, 20)) < .3f);
            CHECK(glm::distance(vector_in(second, x, 60), floor.at(x, 60)) < .3f);
            CHECK(glm::distance(vector_in(first, x, 60, "motion_next"), floor.back_from(x, 60)) < .3f);
        }
        CHECK(vector_in(first, 60, 20) == glm::vec2(0.f)); // the frame before it is not known
        told_of.push_back(second);
    }
    CHECK(told_of[0]["motion.X"].values == told_of[1]["motion.X"].values);
}

TEST_CASE("vectors stay as they are where nothing is missing, after a gap, and of a background behind a transparent film") {
    auto const names = io::own_sequence();
    auto const stays = [&](SmoothMotion const& sky, long long number, bool is_opaque) {
        UntoldMotion untold;
        auto first = frame_after(no_motion(), no_motion()), second = frame_after(sky, no_motion());
        examples::GuideImages of_first, of_second;
        untold.tell(first, names, 1, is_opaque, of_first), untold.tell(second, names, number, is_opaque, of_second);
        return vector_in(second, 60, 20) == glm::vec2(0.f) && vector_in(second, 60, 60) == glm::vec2(0.f) &&
               !untold.tell_next(first, names, 1, of_first);
    };
    CHECK(stays(no_motion(), 2, true));
    CHECK(stays(a_motion(), 3, true));
    CHECK(stays(a_motion(), 2, false));
    CHECK(!stays(a_motion(), 2, true));
}

TEST_CASE("vectors are written as the file has them: of another unit, direction of y and end") {
    auto names = io::own_sequence();
    auto& guides = names.of_signals[0].channels;
    guides.motion = {.points = MotionConvention::Points::from_previous, .unit = MotionConvention::Unit::uv, .y = MotionConvention::Y::up};
    UntoldMotion untold;
    auto first = frame_after(no_motion(), no_motion()), second = frame_after(a_motion(), no_motion());
    examples::GuideImages of_first, of_second;
    untold.tell(first, names, 1, true, of_first), untold.tell(second, names, 2, true, of_second);
    Frame<Channels<Motion>> frame(size);
    io::load_channels(Channels<Motion>{}, frame, second, guides);
    auto const view = frame[motion].view();
    CHECK(glm::distance(glm::vec2(view.get(0, 60, 20), view.get(1, 60, 20)), a_motion().at(60, 20)) < .3f);
    CHECK(glm::distance(vector_in(second, 60, 20) * glm::vec2(-static_cast<float>(size.width), static_cast<float>(size.height)),
                        a_motion().at(60, 20)) < .3f);
}

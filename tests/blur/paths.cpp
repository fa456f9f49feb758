#include "../frames.hpp"

#include <baselines/presets.hpp>

using namespace quell;

namespace {
constexpr Extent size{64, 48};
float const infinite = std::bit_cast<float>(0x7f800000u), not_a_number = std::bit_cast<float>(0x7fc00000u);

/// Shows what a guide has found: its axis and the variance of angles, or the variance of lengths and the part that moves.
struct ShowGuide {
    using reads = Channels<GuideAxis, GuideSpread>;
    bool lengths = false;
    template <class Px> QUELL_KERNEL auto filter(Px const& px) const {
        auto const axis = px[guide_axis];
        auto const spread = px[guide_spread];
        using Real = typename Px::Real;
        return lengths ? vec3<Real>{spread.x, spread.z, spread.y} : vec3<Real>{axis.x, axis.y, spread.y};
    }
};
glm::vec3 guide_in_the_middle(auto&& sweep_at, bool lengths = false) {
    auto const pipeline = Pipeline{radiance, Spatial{MotionGuide{}}, Spatial{ShowGuide{lengths}}};
    Frame frame{size, pipeline};
    History history{size, pipeline};
    tests::fill_still(frame);
    tests::fill(frame[sweep], sweep_at);
    auto const out = run(pipeline, frame, history);
    return {out.get(0, 32, 24), out.get(1, 32, 24), out.get(2, 32, 24)};
}
glm::vec2 towards(double degrees, double length) {
    double const a = degrees * 3.14159265358979 / 180;
    return {static_cast<float>(length * std::cos(a)), static_cast<float>(length * std::sin(a))};
}
} // namespace

TEST_CASE("a path passes a point where plain geometry says") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0, 1), pixels(-40, 40);
    for (int i = 0; i < 1000; ++i) {
        glm::dvec2 const v(pixels(random), pixels(random)), offset(pixels(random), pixels(random));
        double const t = part(random), length = glm::length(v);
        if (length < 1) continue;
        auto const passing = Trajectory<float>::of(glm::vec2(v), static_cast<float>(t)).passing(glm::vec2(offset));
        // The line's distance from the point by the cross product, and how far along it the foot lies.
        double const distance = std::abs(v.x * offset.y - v.y * offset.x) / length, when = t + glm::dot(v, offset) / length / length;
        CHECK(passing.distance == doctest::Approx(distance).epsilon(1e-3).scale(1));
        CHECK(passing.when == doctest::Approx(when).epsilon(1e-4).scale(1));
    }
}

TEST_CASE("a path that bends passes points of its own arc, at their times") {
    // A point turns by 70 degrees within the shutter, at a distance of 60 pixels from the centre.
    auto const place = [](double t) { return 60. * glm::dvec2(std::cos(1.2 * t), std::sin(1.2 * t)); };
    auto const sweep = place(1) - place(0), bend = place(0.5) - (place(0) + place(1)) * 0.5;
    for (double const seen : {0., 0.3, 0.8})
        for (double const t : {0.05, 0.4, 0.95}) {
            auto const straight = Trajectory<float>::of(glm::vec2(sweep), static_cast<float>(seen));
            auto const path = BentTrajectory<float>::of(straight, glm::vec2(bend));
            auto const passing = path.passing(glm::vec2(place(t) - place(seen)));
            // A parabola is no circle: 0.6 pixels off on such an arc, where a straight path would be 10.
            CHECK(passing.distance < 0.65f);
            CHECK(std::abs(passing.when - t) < 0.02);
            // Without a bend it is the straight path.
            auto const flat = BentTrajectory<float>::of(straight, {not_a_number, 3.f}).passing({3.f, 4.f});
            CHECK(flat.distance == doctest::Approx(straight.passing({3.f, 4.f}).distance).epsilon(1e-4));
        }
}

TEST_CASE("bad sweeps and times have a meaning") {
    for (float const bad : {not_a_number, infinite, -infinite}) {
        CHECK(!Trajectory<float>::of({bad, 3.f}, 0.5f).moves());
        CHECK(!Trajectory<float>::of({3.f, bad}, 0.5f).moves());
        CHECK(Trajectory<float>::of({3.f, 3.f}, bad).time == 0.5f);
    }
    CHECK(!Trajectory<float>::of({0.f, 0.f}, 0.5f).moves());
    CHECK(Trajectory<float>::of({9.f, 0.f}, 2.f).time == 1.f);
    CHECK(Trajectory<float>::of({9.f, 0.f}, -1.f).time == 0.f);
    CHECK(Trajectory<float>::of({1e30f, 0.f}, 0.f).length() <= 1.5f * Trajectory<float>::longest);
}

TEST_CASE("angles around 0 and opposite directions count as what they are") {
    auto const around_zero = guide_in_the_middle([](int x, int) { return towards(x % 2 ? 359 : 1, 10); });
    CHECK(around_zero.x == doctest::Approx(10).epsilon(0.01));
    CHECK(std::abs(around_zero.y) < 0.2);
    CHECK(around_zero.z < 0.01);
    auto const opposite = guide_in_the_middle([](int x, int y) { return towards((x + y) % 2 ? 30 : 210, 8); });
    CHECK(std::abs(opposite.x) == doctest::Approx(8 * std::cos(30 * 3.14159265 / 180)).epsilon(0.01));
    CHECK(opposite.y / opposite.x == doctest::Approx(std::tan(30 * 3.14159265 / 180)).epsilon(0.01));
    CHECK(opposite.z < 0.01);
    // Half of the directions at right angles to the others: no axis is better than another.
    CHECK(guide_in_the_middle([](int x, int) { return towards(x % 2 ? 0 : 90, 8); }).z > 0.9);
    // Vertical motion, which doubled angles have at their seam.
    auto const vertical = guide_in_the_middle([](int, int) { return glm::vec2(0, -6); });
    CHECK(std::abs(vertical.x) < 1e-2);
    CHECK(std::abs(vertical.y) == doctest::Approx(6).epsilon(1e-3));
}

TEST_CASE("lengths have the variance that they have, and what stands still does not count") {
    auto const two = guide_in_the_middle([](int x, int) { return glm::vec2(x % 2 ? 4 : 8, 0); }, true);
    CHECK(two.x == doctest::Approx(4).epsilon(0.01)); // 7 of 15 columns have one length, 8 the other
    CHECK(two.y == doctest::Approx(1));
    auto const half = guide_in_the_middle([](int x, int) { return x < 32 ? glm::vec2(5, 0) : glm::vec2(0); }, true);
    CHECK(half.x < 1e-3);
    CHECK(half.y == doctest::Approx(7.0 / 15).epsilon(1e-3));
    CHECK(guide_in_the_middle([](int, int) { return glm::vec2(0); }, true) == glm::vec3(0));
}

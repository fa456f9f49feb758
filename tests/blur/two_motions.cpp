#include "../frames.hpp"

#include <set>

using namespace quell;

namespace {
constexpr auto denoise = presets::blur(radiance);
constexpr Extent size{160, 48};

/// What is seen somewhere at a time: a grey value, its sweep and its depth.
struct Seen {
    float value;
    glm::vec2 sweep;
    float depth;
};
/// The last of some frames in which every pixel has a random time.
std::vector<float> last_of(int frames, auto&& seen_at) {
    Frame frame{size, denoise};
    History history{size, denoise};
    tests::fill_still(frame);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> part(0, 1);
    std::vector<float> out;
    for (int i = 0; i < frames; ++i) {
        tests::fill(frame[quell::time], [&](int, int) { return part(random); });
        auto const seen = [&](int x, int y) { return seen_at(x, y, i, frame[quell::time].get(x, y)); };
        tests::fill(frame[radiance], [&](int x, int y) { return glm::vec3(seen(x, y).value); });
        tests::fill(frame[sweep], [&](int x, int y) { return seen(x, y).sweep; });
        tests::fill(frame[depth], [&](int x, int y) { return seen(x, y).depth; });
        out = tests::copy_of(run(denoise, frame, history));
    }
    return out;
}
float at(std::vector<float> const& all, int x, int y) { return all[static_cast<std::size_t>(y * size.width + x) * 3]; }

/// A bar that is 20 pixels wide and slides by 12 while the shutter is open, at a depth of 4.
bool in_bar(int x, int frame, float t) {
    float const left = 20.f + 24.f * static_cast<float>(frame) + 12.f * t, centre = static_cast<float>(x) + 0.5f;
    return centre >= left && centre < left + 20;
}
} // namespace

TEST_CASE("a line of pixels visits all within a pixel of the line, to both sides, none twice") {
    for (glm::vec2 const v : {glm::vec2(12, 0), glm::vec2(-7, 0), glm::vec2(0, 9), glm::vec2(8, 3), glm::vec2(-3, 10), glm::vec2(5, -5)}) {
        std::set<std::pair<int, int>> visited;
        detail::LineOfPixels(v, {0, 0}, 128).for_each([&](int x, int y) { CHECK(visited.insert({x, y}).second); });
        float const length = glm::length(v);
        CHECK(!visited.contains({0, 0}));
        for (int y = -14; y <= 14; ++y)
            for (int x = -14; x <= 14; ++x) {
                glm::vec2 const p(x, y);
                bool const near = std::abs(p.x * v.y - p.y * v.x) / length < 0.7f && std::abs(glm::dot(p, v)) <= length * length;
                if (near && (x != 0 || y != 0)) CHECK(visited.contains({x, y}));
                if (visited.contains({x, y})) CHECK(std::abs(p.x * v.y - p.y * v.x) / length <= 1.01f);
            }
    }
    int visits = 0;
    detail::LineOfPixels({300, 40}, {0, 0}, 64).for_each([&](int, int) { ++visits; });
    CHECK(visits <= 64);
    CHECK(visits >= 60);
}

TEST_CASE("what moves in front of something else that moves covers it for as long as it takes to pass") {
    auto const out = last_of(4, [](int x, int, int frame, float t) {
        return in_bar(x, frame, t) ? Seen{1.f, {12, 0}, 4.f} : Seen{0.25f, {0, -9}, 9.f};
    });
    double sum = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) sum += (at(out, x, y) - 0.25) / 0.75;
    CHECK(sum / size.height == doctest::Approx(20).epsilon(0.01));
    for (int const x : {0, 3, 6, 9, 11}) {
        double mean = 0;
        for (int y = 0; y < size.height; ++y) mean += at(out, 92 + x, y) / size.height;
        CHECK(mean == doctest::Approx(0.25 + 0.75 * (x + 0.5) / 12).epsilon(0.1));
    }
}

TEST_CASE("what stands still in front keeps its value, whatever moves behind it") {
    auto const out = last_of(3, [](int x, int y, int frame, float t) {
        if (x >= 60 && x < 90) return Seen{0.6f, {0, 0}, 2.f};
        return Seen{std::sin(0.4f * (static_cast<float>(x) - 24.f * static_cast<float>(frame) - 12.f * t) + static_cast<float>(y)) * 0.5f +
                        0.5f,
                    {12, 0},
                    8.f};
    });
    for (int y = 0; y < size.height; ++y)
        for (int x = 60; x < 90; ++x) REQUIRE(at(out, x, y) == doctest::Approx(0.6).epsilon(1e-5));
}

TEST_CASE("what is behind is remembered while it is covered") {
    // A wall with a pattern, seen for two frames; then something as large as the image comes before its middle.
    auto const wall = [](int x, int y) { return (x / 3 + y / 3) % 2 ? 0.8f : 0.1f; };
    auto const out = last_of(3, [&](int x, int y, int frame, float t) {
        bool const covered = frame == 2 && x > 40 && x < 120 && t < 0.5f;
        return covered ? Seen{2.f, {0, 30}, 3.f} : Seen{wall(x, y), {0, 0}, 8.f};
    });
    double error = 0;
    int n = 0;
    for (int y = 20; y < 28; ++y)
        for (int x = 50; x < 110; ++x) {
            // Between all of it and none, the pattern shows through: by how much depends on the coverage, its sign does not.
            double const other = at(out, x + 3, y), own = at(out, x, y);
            error += (wall(x, y) > wall(x + 3, y)) == (own > other) ? 0 : 1;
            ++n;
        }
    CHECK(error / n < 0.1);
}

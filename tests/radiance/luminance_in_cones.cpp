#include "../frames.hpp"

#include <baselines/colour_cones.hpp>

using namespace quell;

// Cones of luminance beside a colour, against cones of colour.
namespace {
constexpr Extent size{24, 12};
constexpr auto of_luminance = Pipeline{indirect, Temporal{StillMotion{}, WithCones{RunningMean{}}, ConeFetch{}}, Spatial{ConeGather{}}};
constexpr auto of_colour = Pipeline{indirect, Cones{}, Temporal{StillMotion{}, RunningMean{}, ConeFetch{}}};

/// What a pixel shows in the last frame of a plane that is turned then.
/// @param at_end   the last frame is so many times as bright
/// @param contrast of two adjacent pixels; the gathered 3x3 is as bright as without it
template <class P>
glm::vec3 after_turn(P const& denoise, glm::vec3 before, glm::vec3 after, auto&& light, float at_end = 1, float contrast = 0) {
    Frame frame{size, denoise};
    History history{size, denoise};
    std::mt19937 random(5);
    std::uniform_real_distribution<float> any(-1, 1);
    glm::vec3 seen{};
    constexpr int frames = 14;
    for (int i = 0; i < frames; ++i) {
        tests::fill_still(frame);
        auto const n = i < frames - 1 ? before : after;
        glm::vec3 const spread(any(random), any(random), any(random)), from = glm::normalize(n + 0.9f * glm::normalize(spread));
        tests::fill(frame[normal], [&](int, int) { return n; });
        tests::fill(frame[indirect_direction], [&](int, int) { return from; });
        float const brightness = i < frames - 1 ? 1.f : at_end;
        tests::fill(frame[indirect],
                    [&](int x, int y) { return brightness * (1 + ((x + y) % 2 == 0 ? contrast : -contrast)) * light(from); });
        auto const out = run(denoise, frame, history);
        seen = {out.get(0, 9, 6), out.get(1, 9, 6), out.get(2, 9, 6)};
    }
    return seen;
}
constexpr glm::vec3 up(0, 0, 1);
// Results stay between what is looked at; here that is wide.
constexpr float at_end = 10, contrast = 0.9f;
glm::vec3 const turns[] = {up, glm::normalize(glm::vec3(0.3f, 0, 1)), glm::normalize(glm::vec3(0, -1, 1)), {1, 0, 0}};
} // namespace

TEST_CASE("light of one colour comes out as from cones of colour, also where the surface is turned") {
    glm::vec3 const tint(1, 0.5f, 3);
    auto const light = [&](glm::vec3 from) { return tint * (0.1f + std::max(from.x, 0.f) + from.z * from.z); };
    for (auto const& turn : turns) {
        CAPTURE(turn.x);
        auto const wanted = after_turn(of_colour, up, turn, light, at_end),
                   seen = after_turn(of_luminance, up, turn, light, at_end, contrast);
        for (int c = 0; c < 3; ++c) CHECK(seen[c] == doctest::Approx(wanted[c]).epsilon(0.002));
    }
}

TEST_CASE("light of several colours is as bright as from cones of colour") {
    auto const light = [](glm::vec3 from) { return from.x > 0 ? glm::vec3(2, 0.2f, 0.1f) : glm::vec3(0.1f, 0.3f, 1); };
    for (auto const& turn : turns) {
        CAPTURE(turn.x);
        auto const wanted = after_turn(of_colour, up, turn, light, at_end),
                   seen = after_turn(of_luminance, up, turn, light, at_end, contrast);
        CHECK(luminance(seen) == doctest::Approx(luminance(wanted)).epsilon(0.002));
    }
}

TEST_CASE("constant light stays constant, to whatever the surface is turned, and no light stays none") {
    for (auto const& turn : turns)
        for (glm::vec3 const colour : {glm::vec3(0.5f, 2, 7), glm::vec3(0)}) {
            auto const seen = after_turn(of_luminance, up, turn, [&](glm::vec3) { return colour; });
            for (int c = 0; c < 3; ++c) CHECK(seen[c] == doctest::Approx(colour[c]).epsilon(1e-5));
        }
}

TEST_CASE("light may have any unit, though cones are stored in half") {
    static_assert(sizeof(ViewOf<Planar<>, ConeLuminance>::Element) == 2);
    auto const light = [](glm::vec3 from) { return glm::vec3(0.1f + std::max(from.x, 0.f) + from.z * from.z); };
    for (auto const& turn : turns)
        for (float const unit : {1e-7f, 1e9f}) {
            CAPTURE(unit);
            auto const wanted = after_turn(of_luminance, up, turn, light);
            auto const seen = after_turn(of_luminance, up, turn, [&](glm::vec3 from) { return unit * light(from); });
            CHECK(seen.x / unit == doctest::Approx(wanted.x).epsilon(1e-3));
        }
}

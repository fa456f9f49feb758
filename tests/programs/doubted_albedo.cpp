#include "passes.hpp"

#include <denoise/doubted_albedo.hpp>

#include <nlohmann/json.hpp>

#include <quell/io/frame_image.hpp>

using namespace quell;
using namespace quell::tests;
using examples::AlbedoEvidence;
using examples::DoubtedAlbedo;
using examples::SurfaceGuides;
using examples::SurfaceLinks;

// Albedos that are not the colour of what the light fell on.
namespace {

constexpr Extent size{64, 48};

/// What a renderer writes for the albedo of a ball of metal.
enum class Metal {
    colour,    ///< its colour
    highlight, ///< a highlight, up to 96, noisy: microfacets of a roughness of 0.1 that face the camera
    cut        ///< the same, cut to 1
};
struct Shot {
    Metal metal = Metal::colour;
    float samples = 4.f;
    float unit = 1.f; ///< of light
};

constexpr glm::vec3 gold{.9f, .7f, .5f};

/// A ball of rough metal before a painted wall, under smooth light: exactly, but for noise whose variance is 2/samples of the light's
/// square.
class Ball {
    static constexpr float radius = 17.f;
    Shot shot;
    std::mt19937 random;

    [[nodiscard]] static glm::vec2 place(int x, int y) {
        return (glm::vec2(x, y) - .5f * glm::vec2(size.width - 1, size.height - 1)) / radius;
    }
    [[nodiscard]] static float facing(int x, int y) { return std::sqrt(std::max(1.f - glm::dot(place(x, y), place(x, y)), 0.f)); }
    [[nodiscard]] glm::vec3 metal(int x, int y) {
        if (shot.metal == Metal::colour) return gold;
        constexpr float squared = .1f * .1f;
        float const cosine = facing(x, y), off = cosine * cosine * (squared - 1.f) + 1.f;
        std::normal_distribution<float> noise(1.f, .3f);
        auto const value = gold * std::clamp(.5f * squared / (off * off * std::max(cosine, .05f)) * noise(random), 0.f, 96.f);
        return shot.metal == Metal::cut ? glm::min(value, glm::vec3(1.f)) : value;
    }

public:
    Ball(Shot const& of, int number) : shot(of), random(static_cast<unsigned>(number)) {}

    [[nodiscard]] static bool is_metal(int x, int y) { return glm::dot(place(x, y), place(x, y)) < 1.f; }
    [[nodiscard]] static glm::vec3 paint(int x, int y) {
        return (x / 6 + y / 6) % 2 == 0 ? glm::vec3(.8f, .7f, .6f) : glm::vec3(.3f, .3f, .2f);
    }
    [[nodiscard]] glm::vec3 picture(int x, int y) const {
        auto const at = place(x, y);
        return shot.unit * (is_metal(x, y) ? gold * (.8f + .5f * at.x * facing(x, y)) : paint(x, y) * (1.f + .2f * at.y));
    }
    io::ExrImage image() {
        Frame<Channels<Radiance, Albedo, Normal, Depth, Motion, MotionNext>> frame(size);
        std::gamma_distribution<float> light(.5f * shot.samples, 2.f / shot.samples);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                auto const at = place(x, y);
                frame[radiance].set(x, y, picture(x, y) * light(random));
                frame[albedo].set(x, y, is_metal(x, y) ? metal(x, y) : paint(x, y));
                frame[normal].set(x, y, is_metal(x, y) ? glm::vec3(at.x, -at.y, facing(x, y)) : glm::vec3(0.f, 0.f, 1.f));
                frame[depth].set(x, y, is_metal(x, y) ? 8.f - facing(x, y) : 12.f);
                frame[motion].set(x, y, glm::vec2(0.f)), frame[motion_next].set(x, y, glm::vec2(0.f));
            }
        return io::image_of(frame);
    }
    /// How far a picture is off, on the metal or beside it.
    [[nodiscard]] double error(Colours const& of, bool on_metal) const {
        double sum = 0, count = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                if (is_metal(x, y) != on_metal) continue;
                auto const off = of[static_cast<std::size_t>(y * size.width + x)] - picture(x, y);
                sum += static_cast<double>(glm::dot(off, off)), count += 3.;
            }
        return std::sqrt(sum / count);
    }
};

Colours colours_by(io::ExrImage const& image, std::vector<io::Source> const& sources) {
    return pixels_of(examples::picture_of(image, sources, 1.f));
}
std::optional<io::SequenceNames> names_by(auto&& doubted, io::ExrImage& image, io::SequenceNames const& names, bool by_albedo,
                                          long long number) {
    examples::GuideImages guides;
    return doubted.names_for(image, names, by_albedo, number, guides);
}
std::vector<io::Source> albedo_in(io::SequenceNames const& names) { return io::sources_of(names.of_signals[0].channels, albedo); }
std::size_t at(int x, int y) { return static_cast<std::size_t>(y * size.width + x); }

} // namespace

TEST_CASE("links of surfaces sum up a window on one surface, each pixel once") {
    constexpr Extent wide{40, 33};
    SurfaceGuides guides;
    for (int y = 0; y < wide.height; ++y)
        for (int x = 0; x < wide.width; ++x) guides.depth.push_back(x < 25 ? 1.f : 2.f);
    SurfaceLinks const surfaces(wide, guides);
    std::vector<int> values;
    for (int i = 0; i < wide.pixels(); ++i) values.push_back(1 + i % 7);
    auto const sums = surfaces.window_sums(values);
    int sum = 0;
    for (int y = 16 - 13; y <= 16 + 13; ++y)
        for (int x = 0; x < 25; ++x) sum += values[static_cast<std::size_t>(y * wide.width + x)];
    CHECK(sums[static_cast<std::size_t>(16 * wide.width + 12)] == sum);
    SurfaceLinks const one({27, 27}, {});
    CHECK(one.window_sums(std::vector<int>(27 * 27, 1))[13 * 27 + 13] == 27 * 27);
}

TEST_CASE("a plane is one surface however steep it is seen, and a step in it makes two") {
    constexpr Extent wide{40, 33};
    for (float const step : {0.f, .1f}) {
        SurfaceGuides guides;
        for (int y = 0; y < wide.height; ++y)
            for (int x = 0; x < wide.width; ++x)
                guides.depth.push_back(1.f / (.02f + .004f * static_cast<float>(y) + (x < 20 ? 0.f : step)));
        guides.find_slopes(wide);
        SurfaceLinks const surfaces(wide, guides);
        auto const sums = surfaces.window_sums(std::vector<int>(guides.depth.size(), 1));
        CHECK(sums[static_cast<std::size_t>(16 * wide.width + 18)] == (step > 0.f ? 15 * 27 : 27 * 27));
    }
}

TEST_CASE("a colour of paint is believed, whatever the noise") {
    for (float const samples : {1.f, 4.f, 64.f}) {
        DoubtedAlbedo doubted;
        for (int number = 1; number <= 6; ++number) {
            auto image = Ball({.samples = samples}, number).image();
            auto const planes = image.planes.size();
            CHECK_FALSE(names_by(doubted, image, io::own_sequence(), true, number));
            CHECK(image.planes.size() == planes);
        }
        CHECK(doubted.remarks().empty());
    }
}

TEST_CASE("a highlight in the place of a metal's colour becomes a constant, and nothing else does") {
    for (auto const metal : {Metal::highlight, Metal::cut})
        for (float const unit : {1.f, std::ldexp(1.f, -12)}) {
            DoubtedAlbedo doubted;
            auto image = Ball({metal, 4.f, unit}, 1).image();
            auto const names = names_by(doubted, image, io::own_sequence(), true, 1);
            REQUIRE(names);
            auto const given = pass(image, "albedo"), used = colours_by(image, albedo_in(*names));
            int same = 0, all = 0;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) {
                    if (!Ball::is_metal(x, y)) {
                        CHECK(used[at(x, y)] == given[at(x, y)]);
                        continue;
                    }
                    ++all;
                    if (used[at(x, y)] == used[at(size.width / 2, size.height / 2)]) ++same;
                }
            CHECK(same > .95 * all);
            CHECK(doubted.remarks().size() == 1);
        }
}

TEST_CASE("an albedo of noise that light knows nothing of is divided by nowhere, and the light's own noise is believed") {
    for (float const samples : {1.f, 16.f})
        for (bool const is_of_light : {false, true}) {
            constexpr float infinity = std::numeric_limits<float>::infinity();
            std::mt19937 random(1);
            std::uniform_real_distribution<float> noise(.4f, 1.6f);
            std::gamma_distribution<float> light(.5f * samples, 2.f / samples);
            Frame<Channels<Radiance, Albedo, Normal, Depth>> frame({96, 54});
            for (int y = 0; y < 54; ++y)
                for (int x = 0; x < 96; ++x) {
                    float const colour = .5f * noise(random);
                    frame[radiance].set(x, y, glm::vec3((is_of_light ? colour : .5f) * light(random)));
                    frame[albedo].set(x, y, glm::vec3(colour));
                    frame[normal].set(x, y, glm::vec3(0.f, 1.f, 0.f));
                    frame[depth].set(x, y, y < 5 ? infinity : 1.f / (.02f + .004f * static_cast<float>(y)));
                }
            auto image = io::image_of(frame);
            auto const names = names_by(DoubtedAlbedo(), image, io::own_sequence(), true, 1);
            CHECK(names.has_value() != is_of_light);
            if (names) CHECK(colours_by(image, albedo_in(*names)) == Colours(96 * 54, glm::vec3(1.f)));
        }
}

TEST_CASE("a factor that says nothing is replaced with its light, which add up to the same picture") {
    auto image = Ball({.metal = Metal::cut}, 1).image();
    auto const picture = pass(image, ""), factor = pass(image, "albedo");
    auto light = picture;
    for (std::size_t i = 0; i < light.size(); ++i)
        for (int c = 0; c < 3; ++c) light[i][c] = factor[i][c] > 0.f ? light[i][c] / factor[i][c] : 0.f;
    add_pass(image, "divided", light, io::SampleType::float32);
    auto names = io::own_sequence();
    names.of_signals[0].factor = three({"albedo"});
    names.of_signals[0].channels.sources["radiance"] = three({"divided"});
    names.of_signals[0].channels.sources["albedo"] = std::vector<io::Source>(3, io::Source{{}, 1.f});
    auto const seen = names_by(DoubtedAlbedo(), image, names, false, 1);
    REQUIRE(seen);
    auto const new_factor = colours_by(image, seen->of_signals[0].factor),
               new_light = colours_by(image, io::sources_of(seen->of_signals[0].channels, radiance));
    CHECK(new_factor != factor);
    for (std::size_t i = 0; i < light.size(); ++i)
        for (int c = 0; c < 3; ++c) CHECK(new_factor[i][c] * new_light[i][c] == doctest::Approx(factor[i][c] * light[i][c]));
}

TEST_CASE("a frame that is read again is read by the same names") {
    DoubtedAlbedo doubted;
    std::array<Colours, 2> seen;
    for (int const number : {1, 2, 3, 4, 2}) {
        auto image = Ball({.metal = Metal::cut}, number).image();
        auto const names = names_by(doubted, image, io::own_sequence(), true, number);
        REQUIRE(names);
        if (number == 2) seen[seen[0].empty() ? 0 : 1] = colours_by(image, albedo_in(*names));
    }
    CHECK(seen[0] == seen[1]);
}

TEST_CASE("metal whose albedo is a highlight is denoised as metal with a colour, and the wall behind it too") {
    Folder const folder;
    auto const errors = [&](Metal metal, std::string const& more) {
        constexpr int last = 5;
        for (int number = 1; number <= last; ++number)
            io::write_exr(folder / numbered("frame.", number), Ball({.metal = metal}, number).image());
        auto const ran = denoise(input(folder) + output(folder) + "--quiet --json --layers picture " + more);
        REQUIRE(ran.code == 0);
        CHECK(contains(nlohmann::json::parse(ran.out)["remarks"].dump(), "albedo says nothing") == (metal != Metal::colour));
        auto const picture = pass(io::read_exr(folder / numbered("out.", last)), "");
        Ball const ball({.metal = metal}, last);
        return std::pair(ball.error(picture, true), ball.error(picture, false));
    };
    for (std::string const more : {"", "--quick"}) {
        auto const right = errors(Metal::colour, more);
        for (auto const metal : {Metal::highlight, Metal::cut}) {
            auto const wrong = errors(metal, more);
            CHECK(wrong.first < 1.2 * right.first);
            CHECK(wrong.second < 1.05 * right.second);
        }
    }
}

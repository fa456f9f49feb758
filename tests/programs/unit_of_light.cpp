#include "passes.hpp"

using namespace quell;
using namespace quell::tests;

// Files of floats whose light is of another unit.
namespace {

constexpr Extent size{64, 48};
constexpr int frames = 5;
auto const exact = io::SampleType::float32;

/// A wall with a painted half, which moves, a dark half, and a sky above. Light is direct, from around (in the last frames only), and what
/// shines by itself; the picture has some that no pass holds. Paints are noisy in some frames, so that the picture is denoised as one.
void write_frame(Folder const& folder, int number, float unit) {
    std::mt19937 random(static_cast<unsigned>(number));
    std::exponential_distribution<float> noise(1.f);
    std::uniform_real_distribution<float> part(0.f, 1.f);
    bool const is_noisy = number == 3;
    auto const paint = colours(size, [&](int x, int y) {
        bool const is_bright = is_noisy ? part(random) < .5f : ((x - number + 64) / 4 + y / 4) % 2 == 0;
        return y < 8 ? glm::vec3(0.f) : is_bright ? glm::vec3(.8f, .6f, .3f) : glm::vec3(.2f, .3f, .6f);
    });
    auto const bright = [](int x) { return x < size.width / 3 ? .004f : 1.f; };
    auto const direct = colours(size, [&](int x, int) { return glm::vec3(bright(x) * noise(random)); });
    auto const around = colours(size, [&](int x, int) { return glm::vec3(number < 2 ? 0.f : .3f * bright(x) * noise(random)); });
    auto const sky = colours(size, [&](int x, int y) { return y < 8 ? glm::vec3(.4f, .5f, 2.f) : glm::vec3(x > 58 ? 3.f : 0.f); });
    auto beside = colours(size, [&](int x, int y) { return glm::vec3(number == 4 && x > 40 && y > 20 ? .1f * noise(random) : 0.f); });
    for (std::size_t i = 0; i < beside.size(); ++i) beside[i] += (direct[i] + around[i]) * paint[i] + sky[i];
    io::ExrImage image{.size = size};
    image.attributes["cycles.ViewLayer.samples"] = std::string("4");
    auto const add_light = [&](std::string const& name, Colours light) {
        for (auto& pixel : light) pixel *= unit;
        add_pass(image, name, light, exact);
    };
    add_light("direct", direct), add_light("around", around), add_light("sky", sky), add_light("beauty", beside);
    add_pass(image, "paint", paint, exact);
    add_guides(
        image, [](int, int y) { return y < 8 ? std::numeric_limits<float>::infinity() : 5.f + .01f * static_cast<float>(y); },
        glm::vec2(-1.f, 0.f));
    io::write_exr(folder / numbered("frame.", number), image);
}

/// All pictures that a line of options gives, one after the other.
Colours pictures(Folder const& folder, std::string const& options) {
    auto const map = (folder / "map.json").string();
    auto const ran = denoise(input(folder) + output(folder) + "--quiet --map '" + map + "' " + options);
    INFO(ran.err);
    REQUIRE(ran.code == 0);
    Colours all;
    for (int i = 1; i <= frames; ++i) {
        auto const image = io::read_exr(folder / numbered("out.", i));
        for (std::string const layer : {"beauty", "direct", "around"}) {
            if (image.find(layer + ".R") == nullptr) continue; // --upsample writes the picture alone
            auto const found = pass(image, layer);
            all.insert(all.end(), found.begin(), found.end());
        }
    }
    return all;
}

} // namespace

TEST_CASE("quell-denoise: the unit of light changes no bit") {
    Folder const usual, dim, bright;
    for (auto const& [folder, unit] : {std::pair{&usual, 1.f}, {&dim, 0x1p-12f}, {&bright, 0x1p12f}}) {
        for (int i = 1; i <= frames; ++i) write_frame(*folder, i, unit);
        write_bytes(*folder / "map.json", R"({"signals": [{"name": "direct", "irradiance": "direct", "albedo": "paint"},
            {"name": "around", "irradiance": "around", "albedo": "paint"}], "added": "sky", "picture": "beauty"})");
    }
    for (std::string const options : {"", "--quick", "--preset general", "--preset svgf", "--upsample 2"}) {
        CAPTURE(options);
        auto const wanted = pictures(usual, options);
        for (auto const& [folder, unit] : {std::pair{&dim, 0x1p-12f}, {&bright, 0x1p12f}}) {
            CAPTURE(unit);
            auto const found = pictures(*folder, options);
            REQUIRE(found.size() == wanted.size());
            std::size_t others = 0;
            for (std::size_t i = 0; i < wanted.size(); ++i) others += found[i] == wanted[i] * unit ? 0 : 1;
            CHECK(others == 0);
        }
    }
}

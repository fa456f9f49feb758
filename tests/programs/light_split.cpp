#include "passes.hpp"

#include <denoise/guide_noise.hpp>

using namespace quell;
using namespace quell::tests;
using examples::GuideKind;
using examples::is_better_as_one;
using examples::LightSplit;
using examples::split_light;

// How the light of a frame is divided among the signals that are denoised.
namespace {

constexpr Extent small{24, 16};
float const not_a_number = std::bit_cast<float>(0x7fc00000u);
auto const packed = io::SampleType::half, exact = io::SampleType::float32;

struct Random {
    std::mt19937 numbers;
    explicit Random(unsigned seed) : numbers(seed) {}
    float between(float a, float b) { return std::uniform_real_distribution<float>(a, b)(numbers); }
    glm::vec3 colour(float a, float b) { return {between(a, b), between(a, b), between(a, b)}; }
    float light() { return std::exponential_distribution<float>(1.f)(numbers); }
};

/// Random passes, and a picture that is their sum, before it is rounded, times scale(pixel).
io::ExrImage random_passes(unsigned seed, io::SampleType type, auto const& scale) {
    Random random(seed);
    io::ExrImage image{.size = small};
    Colours sum(image.pixels(), glm::vec3(0.f));
    auto const make = [&](float darkest) { return colours(small, [&](int, int) { return random.colour(darkest, 1.f); }); };
    for (std::string const name : {"diffuse", "glossy"}) {
        auto const light = make(0.f), colour = make(0.1f);
        add_pass(image, name, light, type), add_pass(image, name + "_colour", colour, type);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += light[i] * colour[i];
    }
    for (std::string const name : {"glow", "sky"}) {
        auto const light = make(0.f);
        add_pass(image, name, light, type);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += 0.25f * light[i];
        for (auto& plane : image.planes)
            if (plane.name.starts_with(name + "."))
                for (auto& value : plane.values) value = as_stored(0.25f * value, type);
    }
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] *= scale(i);
    add_pass(image, "beauty", sum, type);
    return image;
}

Colours light_of(io::ExrImage const& image, std::vector<io::Source> const& sources, float otherwise = 0.f) {
    return pixels_of(examples::picture_of(image, sources, otherwise));
}
Colours light_of(io::ExrImage const& image, LightSplit const& split, std::size_t signal) {
    if (!split.active[signal]) return Colours(image.pixels(), glm::vec3(0.f));
    return light_of(image, io::sources_of(split.signals[signal].channels, radiance));
}

/// What the parts of a split add up to.
Colours sum_of(io::ExrImage const& image, LightSplit const& split) {
    auto sum = light_of(image, split.added);
    for (std::size_t s = 0; s < split.signals.size(); ++s) {
        auto const light = light_of(image, split, s), factor = light_of(image, split.signals[s].factor, 1.f);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += light[i] * factor[i];
    }
    return sum;
}
/// The greatest difference, as a part of the larger number.
float worst_part(Colours const& a, Colours const& b) {
    float worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (glm::length_t c = 0; c < 3; ++c) {
            float const larger = std::max(std::abs(a[i][c]), std::abs(b[i][c]));
            if (larger > 0.f) worst = std::max(worst, std::abs(a[i][c] - b[i][c]) / larger);
        }
    return worst;
}
/// Numbers that go through halves several times.
float tolerance(io::SampleType type) { return type == packed ? 1.f / 256.f : 1e-5f; }

} // namespace

TEST_CASE("signals, what is added and the rest add up to the picture, in each pixel, by whatever the passes are off") {
    for (auto const type : {packed, exact})
        for (unsigned seed = 1; seed <= 6; ++seed) {
            Random random(100 + seed);
            auto image = random_passes(seed, type, [&](std::size_t) { return random.colour(0.f, 2.f); });
            for (bool const as_one : {false, true}) {
                auto own = image;
                auto const split = split_light(own, names_of_passes(), {}, as_one);
                REQUIRE(split.signals.size() == 3);
                CHECK(split.active == (as_one ? std::vector{false, false, true} : std::vector{true, true, true}));
                CHECK(worst_part(sum_of(own, split), pass(image, "beauty")) < tolerance(type));
                for (auto const& rest : light_of(own, split, 2)) CHECK(std::min({rest.x, rest.y, rest.z}) >= 0.f);
            }
        }
}

TEST_CASE("no light is lost by a pass that wasn't rendered, and a black picture is black") {
    Random random(7);
    auto const image = random_passes(7, packed, [&](std::size_t i) { return i % 5 == 0 ? glm::vec3(0.f) : random.colour(0.5f, 1.5f); });
    auto const whole = names_of_passes();
    auto without_glossy = whole, without_added = whole, without_both = whole;
    without_glossy.of_signals.pop_back(), without_both.of_signals.erase(without_both.of_signals.begin());
    without_added.added.clear(), without_both.added.clear();
    for (auto const& names : {whole, without_glossy, without_added, without_both}) {
        auto own = image;
        auto const split = split_light(own, names, {}, false);
        auto const sum = sum_of(own, split), picture = pass(image, "beauty");
        CHECK(worst_part(sum, picture) < tolerance(packed));
        for (std::size_t i = 0; i < sum.size(); i += 5) CHECK(sum[i] == glm::vec3(0.f));
    }
}

TEST_CASE("passes that hold more than the picture: what is added is scaled down first, then all signals in proportion") {
    auto image = random_passes(8, exact, [](std::size_t) { return glm::vec3(1.f); });
    auto const names = names_of_passes();
    auto const added = light_of(image, names.added), sum = pass(image, "beauty");
    auto const lower = [&](auto const& by) {
        auto own = image;
        std::erase_if(own.planes, [](auto const& plane) { return plane.name.starts_with("beauty"); });
        auto picture = sum;
        for (std::size_t i = 0; i < picture.size(); ++i) picture[i] -= by(i);
        add_pass(own, "beauty", picture, exact);
        return own;
    };
    auto part = lower([&](std::size_t i) { return 0.5f * added[i]; });
    auto const half_of_added = split_light(part, names, {}, false);
    CHECK(half_of_added.active == std::vector{true, true, false});
    for (std::size_t s = 0; s < 2; ++s) CHECK(worst_part(light_of(part, half_of_added, s), pass(image, names.of_signals[s].name)) < 1e-5f);
    auto halved = added;
    for (auto& value : halved) value *= 0.5f;
    CHECK(worst_part(light_of(part, half_of_added.added), halved) < 1e-4f);

    auto more = lower([&](std::size_t i) { return added[i] + 0.25f * (sum[i] - added[i]); });
    auto const all_of_added = split_light(more, names, {}, false);
    for (auto const& value : light_of(more, all_of_added.added)) CHECK(value == glm::vec3(0.f));
    for (std::size_t s = 0; s < 2; ++s) {
        auto expected = pass(image, names.of_signals[s].name);
        for (auto& value : expected) value *= 0.75f;
        CHECK(worst_part(light_of(more, all_of_added, s), expected) < 1e-4f);
    }
}

TEST_CASE("what rounding to half explains makes no rest, and leaves everything as it is") {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        auto image = random_passes(seed, packed, [](std::size_t) { return glm::vec3(1.f); });
        auto const planes = image.planes.size();
        auto const split = split_light(image, names_of_passes(), {}, false);
        CHECK(split.active == std::vector{true, true, false});
        CHECK(image.planes.size() == planes);
    }
    auto less = random_passes(3, packed, [](std::size_t) { return glm::vec3(1.02f); }); // 2 % is no rounding
    CHECK(split_light(less, names_of_passes(), {}, false).active[2]);
}

TEST_CASE("what is not finite in a pass or in the picture changes the split of its own pixel alone") {
    Random random(9);
    auto const scale = colours(small, [&](int, int) { return random.colour(0.3f, 1.7f); });
    auto const image = random_passes(9, exact, [&](std::size_t i) { return scale[i]; });
    for (auto const* const bad : {"beauty.G", "diffuse.R", "glossy_colour.B", "sky.R"})
        for (bool const as_one : {false, true}) {
            INFO(bad, as_one);
            auto clean = image, broken = image;
            constexpr std::size_t pixel = 77;
            for (auto& plane : broken.planes)
                if (plane.name == bad) plane.values[pixel] = not_a_number;
            auto const a = split_light(clean, names_of_passes(), {}, as_one), b = split_light(broken, names_of_passes(), {}, as_one);
            CHECK(a.active == b.active);
            for (std::size_t s = 0; s < a.signals.size(); ++s) {
                auto x = light_of(clean, a, s), y = light_of(broken, b, s);
                x[pixel] = y[pixel] = glm::vec3(0.f);
                CHECK(x == y);
            }
            auto x = light_of(clean, a.added), y = light_of(broken, b.added);
            x[pixel] = y[pixel] = glm::vec3(0.f);
            CHECK(x == y);
        }
}

// Which frames are filtered as one picture.
namespace {

constexpr Extent wide{96, 64};

/// One light, whose noise is that of few samples, and its colour.
io::ExrImage lit(auto const& colour, auto const& depth, unsigned seed, float noise_of_light = 1.f) {
    Random random(seed);
    io::ExrImage image{.size = wide};
    auto const smooth = [](int x, int y) { return 0.7f + 0.3f * std::sin(0.05f * static_cast<float>(x + 2 * y)); };
    auto const of_colour = colours(wide, colour);
    auto const light =
        colours(wide, [&](int x, int y) { return glm::vec3(smooth(x, y) * (1.f - noise_of_light + noise_of_light * random.light())); });
    auto picture = light;
    for (std::size_t i = 0; i < picture.size(); ++i) picture[i] *= of_colour[i];
    add_pass(image, "diffuse", light, exact), add_pass(image, "diffuse_colour", of_colour, exact),
        add_pass(image, "beauty", picture, exact);
    add_guides(image, depth);
    return image;
}
io::SequenceNames names_of_one_light() {
    auto names = names_of_passes();
    names.of_signals.pop_back(), names.added.clear();
    return names;
}
bool is_as_one(io::ExrImage const& image) { return is_better_as_one(image, names_of_one_light(), {}); }

/// Depth of a plane that is seen at a slant: its inverse is a linear function of the place.
float of_plane(int x, int y) { return 1.f / (0.1f + 1e-3f * static_cast<float>(x) + 5e-4f * static_cast<float>(y)); }
/// The same, as samples all over a blurred pixel have it.
auto scattered(unsigned seed) {
    return [random = Random(seed)](int x, int y) mutable { return of_plane(x, y) * random.between(0.8f, 1.25f); };
}
/// Checks whose edges lie anywhere in pixels.
glm::vec3 checks(int x, int y) {
    auto const cell = [](int i) { return static_cast<int>(std::floor((static_cast<float>(i) + 0.5f) / 3.3f)); };
    return glm::vec3((cell(x) + cell(y)) % 2 == 0 ? 0.8f : 0.2f);
}

} // namespace

TEST_CASE("a picture whose colours are noisy is filtered as one, and by its signals where they are sharp") {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        Random random(seed);
        auto const noisy = [&](int, int) { return glm::vec3(random.between(0.2f, 0.8f)); };
        CHECK(is_as_one(lit(noisy, scattered(seed), seed)));
        CHECK(is_as_one(lit(noisy, scattered(seed), seed, 0.1f)));
        auto unknown = lit(noisy, of_plane, seed);
        std::erase_if(unknown.planes, [](auto const& plane) { return plane.name == "depth.Z"; });
        CHECK(is_as_one(unknown));
        // Texture as fine as noise, on a plane that is seen sharply.
        CHECK_FALSE(is_as_one(lit(noisy, of_plane, seed)));
        auto const edge = [](int x, int y) { return glm::vec3(x + 2 * y < 90 ? 0.1f : 0.9f); };
        auto const plain = [](int, int) { return glm::vec3(0.3f, 0.5f, 0.7f); };
        for (float const noise_of_light : {1.f, 0.3f}) {
            CHECK_FALSE(is_as_one(lit(checks, of_plane, seed, noise_of_light)));
            CHECK_FALSE(is_as_one(lit(edge, of_plane, seed, noise_of_light)));
            CHECK_FALSE(is_as_one(lit(plain, scattered(seed), seed, noise_of_light)));
        }
        // Sharp colours are told by themselves too, under light as noisy as that of few samples.
        CHECK_FALSE(is_as_one(lit(checks, scattered(seed), seed)));
        CHECK_FALSE(is_as_one(lit(edge, scattered(seed), seed)));
    }
}

TEST_CASE("an environment that is noisy behind fog is filtered with the rest, and one that is sharp is not") {
    for (bool const is_noisy : {true, false}) {
        Random random(5);
        auto image = lit([](int, int) { return glm::vec3(0.5f); }, scattered(5), 5);
        auto const sky = colours(wide, [&](int x, int) {
            return glm::vec3(is_noisy ? (random.between(0.f, 1.f) < 0.3f ? 2.f : 0.f) : x < 40 ? 1.f : 0.f);
        });
        auto picture = pass(image, "beauty");
        for (std::size_t i = 0; i < picture.size(); ++i) picture[i] += sky[i];
        std::erase_if(image.planes, [](auto const& plane) { return plane.name.starts_with("beauty"); });
        add_pass(image, "beauty", picture, exact), add_pass(image, "sky", sky, exact);
        auto names = names_of_one_light();
        names.added = three({"sky"});
        CHECK(is_better_as_one(image, names, {}) == is_noisy);
    }
}

TEST_CASE("a picture whose rest is noisier than its colours have detail is filtered as one") {
    for (float const amount : {2.f, 0.02f}) {
        Random random(5);
        auto image = lit(checks, of_plane, 5);
        auto picture = pass(image, "beauty");
        for (auto& pixel : picture) pixel += amount * random.light();
        std::erase_if(image.planes, [](auto const& plane) { return plane.name.starts_with("beauty"); });
        add_pass(image, "beauty", picture, exact);
        CHECK(is_as_one(image) == (amount > 1));
    }
}

TEST_CASE("estimates of guides' errors: the noise of a guide is its variance, and structure has none") {
    Random random(3);
    constexpr float amplitude = 0.3f;
    auto const picture_of = [](auto const& f) { return tests::picture_of(wide, colours(wide, f)); };
    auto const grey = picture_of([](int, int) { return glm::vec3(1.f); });
    auto const white = picture_of([&](int, int) { return glm::vec3(1.f + random.between(-amplitude, amplitude)); });
    auto const noise = guide_errors(white, GuideKind::added, white, grey, {}).noise * 1.1f; // of a display's weight, 1 / (1 + 0.1)
    CHECK(noise > 0.3f * amplitude * amplitude / 3.f);                                      // the least of four directions
    CHECK(noise < amplitude * amplitude / 3.f);
    auto const ramp = picture_of([](int x, int y) { return glm::vec3(0.02f * static_cast<float>(x + y)); });
    CHECK(guide_errors(ramp, GuideKind::added, ramp, grey, {}).noise < 1e-6f);
    auto const edge = picture_of([](int x, int) { return glm::vec3(x < 50 ? 0.f : 1.f); });
    CHECK(guide_errors(edge, GuideKind::added, edge, grey, {}).noise == 0.f);
}

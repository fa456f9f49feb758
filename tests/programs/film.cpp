#include "passes.hpp"

#include <denoise/film_alpha.hpp>
#include <denoise/unlit_film.hpp>

using namespace quell;
using namespace quell::tests;

// Transparent films whose alpha and light do not go together: shadows on catchers, flames, veils.
namespace {

constexpr Extent size{48, 32};
auto const exact = io::SampleType::float32;

/// The ways in which a film is denoised.
std::vector<std::string> const ways{"--preset final-frame", "--preset final-frame --quick", "--preset general", "--preset svgf",
                                    "--preset final-frame --keep-alpha"};
/// Those of them that leave no alpha as it is.
std::vector<std::string> const denoising(ways.begin(), ways.begin() + 3);

void write_map(Folder const& folder) {
    write_bytes(folder / "passes.json",
                R"({"signals": [{"name": "diffuse", "irradiance": "diffuse", "albedo": "diffuse_colour"},
                                {"name": "glossy", "irradiance": "glossy", "albedo": "glossy_colour"}],
                    "added": "glow", "picture": "beauty"})");
    write_bytes(folder / "one.json", R"({"signals": [{"radiance": "beauty", "albedo": 1}], "picture": "beauty"})");
}
void run(Folder const& folder, std::string const& map, std::string const& more) {
    auto const ran = denoise(input(folder) + output(folder) + "--quiet --layers picture --map '" + (folder / map).string() + "' " + more);
    INFO(ran.err);
    REQUIRE(ran.code == 0);
}
io::ExrImage made(Folder const& folder, int number) { return io::read_exr(folder / numbered("out.", number)); }

/// A film, by what its pixels hold, with passes that add up to its picture.
struct Film {
    Colours diffuse, diffuse_colour, glossy, glossy_colour, glow;
    std::vector<float> alpha;

    explicit Film(Extent extent = size)
        : diffuse(static_cast<std::size_t>(extent.pixels()), glm::vec3(0.f)), diffuse_colour(diffuse), glossy(diffuse),
          glossy_colour(diffuse), glow(diffuse), alpha(diffuse.size(), 0.f) {}

    [[nodiscard]] io::ExrImage image() const {
        io::ExrImage made{.size = size};
        auto picture = glow;
        for (std::size_t i = 0; i < picture.size(); ++i) picture[i] += diffuse[i] * diffuse_colour[i] + glossy[i] * glossy_colour[i];
        add_pass(made, "diffuse", diffuse, exact), add_pass(made, "diffuse_colour", diffuse_colour, exact);
        add_pass(made, "glossy", glossy, exact), add_pass(made, "glossy_colour", glossy_colour, exact);
        add_pass(made, "glow", glow, exact), add_pass(made, "beauty", picture, exact);
        made.planes.push_back({.name = "beauty.A", .values = alpha});
        return made;
    }
};
std::size_t at(int x, int y) { return static_cast<std::size_t>(y * size.width + x); }

double off(std::vector<float> const& a, auto const& truth, auto const& counts) {
    double sum = 0;
    int pixels = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (counts(x, y)) sum += std::pow(static_cast<double>(a[at(x, y)] - truth(x, y)), 2), ++pixels;
    return std::sqrt(sum / pixels);
}

} // namespace

// A wall on the left, and flames before an empty film on the right, whose light is no part of alpha.
namespace {

bool is_wall(int x) { return x < 12; }
glm::vec3 flame(int x, int y) {
    float const r = glm::length(glm::vec2(x - 32, y - 16)) / 8.f;
    return glm::vec3(1.f, 0.5f, 0.1f) * std::max(1.f - r * r, 0.f);
}
bool is_far_from_all(int x, int y) { return x > 14 && glm::length(glm::vec2(x - 32, y - 16)) > 10.f; }

void write_flames(Folder const& folder, int number, int samples) {
    std::mt19937 random(static_cast<unsigned>(number));
    std::gamma_distribution<float> light(static_cast<float>(samples), 1.f / static_cast<float>(samples));
    Film film;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const i = at(x, y);
            if (is_wall(x)) film.diffuse[i] = glm::vec3(light(random)), film.diffuse_colour[i] = glm::vec3(0.5f), film.alpha[i] = 1.f;
            film.glow[i] = flame(x, y) * light(random);
        }
    auto image = film.image();
    add_guides(image, [](int x, int) { return is_wall(x) ? 5.f : std::numeric_limits<float>::infinity(); });
    io::write_exr(folder / numbered("frame.", number), image);
}

} // namespace

TEST_CASE("light over alpha 0 stays in a film, and where there is neither there is nothing") {
    constexpr int frames = 3;
    for (int const samples : {1, 16}) {
        Folder const folder;
        write_map(folder);
        for (int i = 1; i <= frames; ++i) write_flames(folder, i, samples);
        auto const truth = colours(size, [](int x, int y) { return flame(x, y) + (is_wall(x) ? glm::vec3(0.5f) : glm::vec3(0.f)); });
        for (auto const& way : ways)
            for (std::string const map : {"passes.json", "one.json"}) {
                INFO(samples, " samples, ", way, ", ", map);
                run(folder, map, way);
                auto const before = io::read_exr(folder / numbered("frame.", frames)), after = made(folder, frames);
                auto const picture = pass(after, "beauty");
                CHECK(root_mean_square(picture, truth) < (map == "one.json" ? .8 : 1.) * root_mean_square(pass(before, "beauty"), truth));
                double light = 0, expected = 0;
                int leaks = 0, invented = 0;
                for (int y = 0; y < size.height; ++y)
                    for (int x = 16; x < size.width; ++x) {
                        auto const& p = picture[at(x, y)];
                        light += static_cast<double>(p.x), expected += static_cast<double>(flame(x, y).x);
                        invented += after["beauty.A"].values[at(x, y)] != 0.f;
                        leaks += is_far_from_all(x, y) && p != glm::vec3(0.f);
                    }
                CHECK(light / expected == doctest::Approx(1.).epsilon(0.25)); // noisy as one sample is
                CHECK(leaks == 0);
                CHECK(invented == 0);
            }
    }
}

// A box that was rendered, which moves to the right before a floor that only catches its shadow. No light of the floor is in the picture.
namespace {

constexpr int box_left = 4, box_width = 8, box_top = 4, box_height = 10;
bool is_box(int x, int y, int number) {
    int const left = box_left + number;
    return x >= left && x < left + box_width && y >= box_top && y < box_top + box_height;
}
/// Below the box.
float shadow(int x, int y, int number) {
    auto const from = glm::vec2(static_cast<float>(x - box_left - number - box_width / 2) / 12.f, static_cast<float>(y - 20) / 6.f);
    return 0.8f * std::max(1.f - glm::dot(from, from), 0.f);
}

void write_catcher(Folder const& folder, int number, int samples) {
    std::mt19937 random(static_cast<unsigned>(number));
    std::gamma_distribution<float> light(static_cast<float>(samples), 1.f / static_cast<float>(samples));
    Film film;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            auto const i = at(x, y);
            film.diffuse_colour[i] = glm::vec3(is_box(x, y, number) ? 0.5f : 1.6f); // of catchers it is doubled
            std::binomial_distribution<int> in_shadow(samples, static_cast<double>(shadow(x, y, number)));
            film.alpha[i] = static_cast<float>(in_shadow(random)) / static_cast<float>(samples);
            if (is_box(x, y, number)) film.diffuse[i] = glm::vec3(light(random)), film.alpha[i] = 1.f;
        }
    auto image = film.image();
    image.planes.push_back(plane("depth.Z", size, [&](int x, int y) { return is_box(x, y, number) ? 5.f : 6.f; }));
    for (auto const& [name, of_box, of_floor] : {std::tuple{"normal.X", 0.f, 0.f},
                                                 {"normal.Y", 0.f, -2.f},
                                                 {"normal.Z", 1.f, 0.f},
                                                 {"motion.X", -1.f, 0.f},
                                                 {"motion.Y", 0.f, 0.f}})
        image.planes.push_back(plane(name, size, [&, b = of_box, f = of_floor](int x, int y) { return is_box(x, y, number) ? b : f; }));
    io::write_exr(folder / numbered("frame.", number), image);
}

} // namespace

TEST_CASE("the shadow on a catcher is denoised as a signal of its own, and no light is spread over it") {
    constexpr int frames = 6, shown = 4;
    for (int const samples : {1, 4, 64}) {
        Folder const folder;
        write_map(folder);
        for (int i = 1; i <= frames; ++i) write_catcher(folder, i, samples);
        for (std::string const way : {"--preset final-frame", "--preset final-frame --quick", "--preset general", "--preset svgf"})
            for (std::string const map : {"passes.json", "one.json"}) {
                INFO(samples, " samples, ", way, ", ", map);
                run(folder, map, way);
                auto const before = io::read_exr(folder / numbered("frame.", shown)), after = made(folder, shown);
                auto const truth = [](int x, int y) { return shadow(x, y, shown); };
                auto const in_shadow = [&](int x, int y) { return truth(x, y) > 0.f && !is_box(x, y, shown); };
                auto const &given = before["beauty.A"].values, &alpha = after["beauty.A"].values;
                CHECK(off(alpha, truth, in_shadow) < (samples > 4 ? .8 : .5) * off(given, truth, in_shadow));
                double sum = 0, expected = 0, leaks = 0;
                int opaque = 0;
                auto const picture = pass(after, "beauty");
                for (int y = 0; y < size.height; ++y)
                    for (int x = 0; x < size.width; ++x) {
                        if (is_box(x, y, shown)) opaque += alpha[at(x, y)] > 0.999f;
                        if (in_shadow(x, y)) sum += static_cast<double>(alpha[at(x, y)]), expected += static_cast<double>(truth(x, y));
                        bool const is_empty = given[at(x, y)] == 0.f && !is_box(x, y, shown);
                        if (is_empty && map == "passes.json") leaks = std::max(leaks, static_cast<double>(picture[at(x, y)].x));
                    }
                CHECK(sum / expected == doctest::Approx(1.).epsilon(0.08));
                CHECK(leaks == 0.);
                if (map == "passes.json") CHECK(opaque == box_width * box_height);
            }
        run(folder, "passes.json", "--preset final-frame --keep-alpha");
        for (int i = 1; i <= frames; ++i)
            CHECK(made(folder, i)["beauty.A"].values == io::read_exr(folder / numbered("frame.", i))["beauty.A"].values);
    }
}

TEST_CASE("where a film goes from its passes to the picture as one, and back, alpha stays what it is") {
    constexpr float veil = 0.3f;
    for (float const beside : {0.f, 0.02f}) { // light that no pass holds
        Folder const folder;
        write_map(folder);
        for (int number = 1; number <= 4; ++number) {
            std::mt19937 random(static_cast<unsigned>(number));
            std::uniform_real_distribution<float> part(0.f, 1.f);
            bool const is_noisy = number == 2 || number == 3;
            Film film;
            for (std::size_t i = 0; i < film.alpha.size(); ++i) {
                film.diffuse[i] = glm::vec3(0.24f + 0.12f * part(random)), film.glossy[i] = 0.1f * film.diffuse[i];
                film.diffuse_colour[i] = glm::vec3(is_noisy ? 0.1f + 0.8f * part(random) : 0.5f), film.glossy_colour[i] = glm::vec3(1.f);
                film.alpha[i] = veil;
            }
            auto image = film.image();
            for (auto& each : image.planes)
                if (each.name.starts_with("beauty.") && each.name != "beauty.A")
                    for (auto& value : each.values) value += beside * part(random);
            add_guides(image, [&](int, int) { return is_noisy ? 5.f + part(random) : 5.f; });
            io::write_exr(folder / numbered("frame.", number), image);
        }
        for (auto const& way : denoising) {
            run(folder, "passes.json", way);
            for (int i = 1; i <= 4; ++i) {
                INFO("frame ", i, ", ", way, ", beside: ", beside);
                auto const image = made(folder, i);
                for (float const a : image["beauty.A"].values) REQUIRE(a == doctest::Approx(veil).epsilon(1e-3 / veil));
            }
        }
    }
}

TEST_CASE("alpha has a signal of its own where no light of the same surface is near") {
    auto const random = [](int x, int y, int k) { return static_cast<unsigned>(x * 7919 + y * 104729 + k * 1299709) % 100u; };
    std::vector<bool> lit;
    io::ExrImage image{.size = size};
    image.planes.push_back(plane("depth.Z", size, [](int x, int) {
        return x < 16 ? 5.f : x < 32 ? 6.f : std::numeric_limits<float>::infinity();
    }));
    for (auto const* const name : {"normal.X", "normal.Y", "normal.Z"})
        image.planes.push_back(plane(name, size, [&](int, int y) {
            auto const axis = y < 16 ? 'Z' : 'X';
            return name[7] != axis ? 0.f : y < 16 ? 1.f : 2.f;
        }));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) lit.push_back(random(x, y, 1) < (x < 16 ? 50u : x < 24 ? 12u : 0u));
    auto const found = examples::unlit_film(lit, image, {});
    auto const surface = [](int x, int y) { return std::pair(x / 16, y / 16); };
    int own = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            int alike = 0, with_light = 0;
            for (int v = y - 2; v <= y + 2; ++v)
                for (int u = x - 2; u <= x + 2; ++u) {
                    if (u < 0 || v < 0 || u >= size.width || v >= size.height || surface(u, v) != surface(x, y)) continue;
                    ++alike, with_light += lit[at(u, v)];
                }
            bool const expected = !lit[at(x, y)] && 4 * with_light < alike;
            CHECK(found[at(x, y)] == expected);
            own += expected;
        }
    CHECK(own > size.pixels() / 3);
    CHECK(own < size.pixels());
}

TEST_CASE("what later frames show counts where their motion comes from") {
    using examples::shows_alpha;
    using examples::shows_light;
    std::deque<examples::SeenFrame> window;
    for (int k = 0; k < 3; ++k) {
        io::ExrImage image{.size = size};
        for (auto const& [name, value] : {std::pair{"motion_next.X", 2.f}, {"motion_next.Y", 0.f}})
            image.planes.push_back(plane(name, size, [v = value](int, int) { return v; }));
        auto& seen = window.emplace_back(examples::SeenFrame{k, std::move(image), false, {}, {}});
        seen.film.assign(static_cast<std::size_t>(size.pixels()), 0);
    }
    window[0].film[at(10, 10)] = shows_light;
    window[1].film[at(22, 5)] = shows_alpha;
    window[2].film[at(34, 20)] = shows_light;
    auto const check = [&](int later) {
        auto const shown = examples::shown_from_now_on(window, later, {});
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                int expected = std::abs(x - 10) <= 1 && std::abs(y - 10) <= 1 ? shows_light : 0;
                if (later > 0 && x == 20 && y == 5) expected |= shows_alpha;
                if (later > 1 && x == 30 && y == 20) expected |= shows_light;
                CHECK(int{shown[at(x, y)]} == expected);
            }
    };
    for (int const later : {0, 1, 2, 5}) check(later);
    window[1].film.clear(); // an opaque film shows something everywhere
    auto const shown = examples::shown_from_now_on(window, 1, {});
    CHECK(std::ranges::count(shown, shows_light | shows_alpha) == size.height * (size.width - 2));
}

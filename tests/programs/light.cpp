#include "passes.hpp"

#include <nlohmann/json.hpp>

#include <numeric>

using namespace quell;
using namespace quell::tests;

// Sequences whose passes don't say all of the picture, or say it with noise; films that are transparent.
namespace {

constexpr Extent size{96, 64};
auto const exact = io::SampleType::float32;
auto const outside = glm::vec2(10'000.f, 0.f);

glm::vec3 checks(int x, int y) { return (x / 4 + y / 4) % 2 == 0 ? glm::vec3(0.8f, 0.6f, 0.3f) : glm::vec3(0.2f, 0.3f, 0.6f); }

/// What a frame of one light and its colour has.
struct Look {
    bool noisy = false; ///< whether colours and depths are of samples all over the pixel
    float beside = 0;   ///< light that no pass holds
    glm::vec2 motion{}; ///< to the frame before
};
glm::vec3 truth_at(int x, int y, Look const& look) {
    return (look.noisy ? glm::vec3(0.5f, 0.45f, 0.45f) : checks(x, y)) + glm::vec3(look.beside);
}
Colours truth(Look const& look) {
    return colours(size, [&](int x, int y) { return truth_at(x, y, look); });
}

void write_frame(Folder const& folder, int number, Look const& look) {
    std::mt19937 random(static_cast<unsigned>(number));
    std::exponential_distribution<float> light(1.f);
    std::uniform_real_distribution<float> part(0.f, 1.f);
    io::ExrImage image{.size = size};
    auto const colour =
        colours(size, [&](int x, int y) { return look.noisy ? (part(random) < 0.5f ? checks(0, 0) : checks(4, 0)) : checks(x, y); });
    auto const of_light = colours(size, [&](int, int) { return glm::vec3(light(random)); });
    auto picture = of_light;
    for (std::size_t i = 0; i < picture.size(); ++i) picture[i] = picture[i] * colour[i] + look.beside * light(random);
    add_pass(image, "diffuse", of_light, exact), add_pass(image, "diffuse_colour", colour, exact),
        add_pass(image, "beauty", picture, exact);
    add_guides(
        image, [&](int, int) { return look.noisy ? 5.f + part(random) : 5.f; }, look.motion);
    io::write_exr(folder / numbered("frame.", number), image);
}
/// A map of the passes, and one of the picture alone.
void write_maps(Folder const& folder) {
    write_bytes(folder / "passes.json",
                R"({"signals": [{"name": "diffuse", "irradiance": "diffuse", "albedo": "diffuse_colour"}], "picture": "beauty"})");
    write_bytes(folder / "one.json", R"({"signals": [{"radiance": "beauty", "albedo": 1}], "picture": "beauty"})");
}
void denoised(Folder const& folder, std::string const& name, std::string const& map, std::string const& more) {
    auto const ran =
        denoise(input(folder) + output(folder, name) + "--quiet --layers picture --map '" + (folder / map).string() + "' " + more);
    INFO(ran.err);
    REQUIRE(ran.code == 0);
}
Colours picture_in(Folder const& folder, std::string const& name, int number) {
    return pass(io::read_exr(folder / numbered(name, number)), "beauty");
}
double error_of(Folder const& folder, std::string const& name, int number, Look const& look) {
    return root_mean_square(picture_in(folder, name, number), truth(look));
}

} // namespace

TEST_CASE("how a frame's light is divided is known from the frame alone") {
    Folder const folder;
    write_maps(folder);
    // Nothing is remembered where motion leads out of the image, so that a frame is the same whatever was before it.
    for (int i = 1; i <= 6; ++i) write_frame(folder, i, {.noisy = i > 4, .beside = i > 2 && i < 5 ? 0.3f : 0.f, .motion = outside});
    std::string const at = "--preset svgf --extra-frames 0 ";
    denoised(folder, "whole.", "passes.json", at);
    for (int i = 1; i <= 6; ++i) {
        INFO("frame ", i);
        denoised(folder, "alone.", "passes.json", at + "--warmup 0 --frames " + std::to_string(i));
        CHECK(bytes_of(folder / numbered("alone.", i)) == bytes_of(folder / numbered("whole.", i)));
    }
    for (auto const* const chunk : {"1/2", "2/2"}) denoised(folder, "chunk.", "passes.json", at + "--warmup 2 --chunk " + chunk);
    for (int i = 1; i <= 6; ++i) CHECK(bytes_of(folder / numbered("chunk.", i)) == bytes_of(folder / numbered("whole.", i)));
}

TEST_CASE("between its file and the output a signal changes its layout at most four times, and motion is decoded once") {
    for (std::string const signal : {"diffuse", "rest"}) { // light that no pass holds is filtered as one picture
        Folder const folder;
        write_maps(folder);
        for (int i = 1; i <= 4; ++i) write_frame(folder, i, {.beside = signal == "rest" ? 0.3f : 0.f});
        for (std::string const preset : {"general", "final-frame"}) {
            auto const ran = denoise(input(folder) + output(folder) + "--quiet --json --map '" + (folder / "passes.json").string() +
                                     "' --preset " + preset);
            INFO(preset, ": ", ran.err);
            REQUIRE(ran.code == 0);
            auto const changes = nlohmann::json::parse(ran.out).at("layout_changes");
            INFO(changes.dump());
            for (auto const& name : {signal, std::string("picture")}) {
                CHECK(changes.at(name).get<double>() > 0.);
                CHECK(changes.at(name).get<double>() <= 4.);
            }
            CHECK(changes.at("motion").get<double>() == 1.);
        }
    }
}

TEST_CASE("light that no pass holds stays in the picture, from its first frame on, whatever chunk it is in") {
    Folder const folder;
    write_maps(folder);
    auto const look = [](int i) { return Look{.beside = i >= 4 ? 0.5f : 0.f}; };
    for (int i = 1; i <= 8; ++i) write_frame(folder, i, look(i));
    denoised(folder, "whole.", "passes.json", "--preset general");
    denoised(folder, "chunk.", "passes.json", "--preset general --chunk 2/2");
    denoised(folder, "first.", "passes.json", "--preset general --first 4 --warmup 3");
    for (int i = 4; i <= 8; ++i) {
        INFO("frame ", i);
        auto const picture = picture_in(folder, "whole.", i);
        if (i >= 5) CHECK(bytes_of(folder / numbered("chunk.", i)) == bytes_of(folder / numbered("whole.", i)));
        CHECK(bytes_of(folder / numbered("first.", i)) == bytes_of(folder / numbered("whole.", i)));
        double sum = 0, expected = 0;
        for (auto const& p : picture) sum += static_cast<double>(p.x + p.y + p.z);
        for (auto const& p : truth(look(i))) expected += static_cast<double>(p.x + p.y + p.z);
        CHECK(sum / expected == doctest::Approx(1.).epsilon(0.03));
        CHECK(error_of(folder, "whole.", i, look(i)) < 0.3 * error_of(folder, "frame.", i, look(i)));
    }
}

TEST_CASE("where colours become noisy or sharp in a sequence, the history goes with the picture") {
    constexpr int frames = 10, change = 6;
    for (bool const becomes_noisy : {true, false}) {
        Folder const folder;
        write_maps(folder);
        auto const look = [&](int i) { return Look{.noisy = (i >= change) == becomes_noisy}; };
        for (int i = 1; i <= frames; ++i) write_frame(folder, i, look(i));
        for (std::string const later : {"0", "2"}) {
            auto const with = "--preset general --extra-frames " + later;
            denoised(folder, "out.", "passes.json", with), denoised(folder, "one.", "one.json", with);
            for (int i = 1; i <= frames; ++i) {
                INFO("frame ", i, " becomes noisy: ", becomes_noisy, " later frames: ", later);
                auto const error = error_of(folder, "out.", i, look(i));
                CHECK(error < error_of(folder, "frame.", i, look(i)));
                CHECK(error <= 1.15 * error_of(folder, "one.", i, look(i)));
            }
        }
    }
}

TEST_CASE("in each frame the layers add up to the picture, together with what the file adds") {
    Folder const folder;
    write_bytes(folder / "map.json", R"({"signals": [{"name": "diffuse", "irradiance": "diffuse", "albedo": "diffuse_colour"}],
                                         "added": "sky", "picture": "beauty"})");
    std::mt19937 random(1);
    std::uniform_real_distribution<float> part(0.f, 1.f);
    for (int i = 1; i <= 4; ++i) { // more than the picture, sharp; less; noisy
        write_frame(folder, i, {.noisy = i == 4, .beside = i == 3 ? 0.1f : 0.f});
        auto image = io::read_exr(folder / numbered("frame.", i));
        add_pass(image, "sky", colours(size, [&](int x, int) { return glm::vec3(i == 4             ? part(random)
                                                                                : i == 1 && x > 40 ? 0.7f
                                                                                                   : 0.f); }),
                 exact);
        io::write_exr(folder / numbered("frame.", i), image);
    }
    auto const ran = denoise(input(folder) + output(folder) + "--quiet --preset svgf --map '" + (folder / "map.json").string() + "'");
    INFO(ran.err);
    REQUIRE(ran.code == 0);
    for (int i = 1; i <= 4; ++i) {
        INFO("frame ", i);
        auto const image = io::read_exr(folder / numbered("out.", i));
        auto const picture = pass(image, "beauty"), diffuse = pass(image, "denoised_diffuse"), rest = pass(image, "denoised_rest"),
                   sky = pass(image, "sky");
        int off = 0;
        for (std::size_t k = 0; k < picture.size(); ++k) {
            // Where the file adds more than the picture takes of it, the rest is negative: floats then round to that of the largest.
            for (int c = 0; c < 3; ++c) {
                float const a = diffuse[k][c], b = rest[k][c], sum = a + b + sky[k][c];
                float const largest = std::max({std::abs(a), std::abs(b), std::abs(sky[k][c])});
                off += std::abs(sum - picture[k][c]) > (i == 1 || i == 4 ? 0x1p-22f * largest : 0.f);
            }
        }
        CHECK(off == 0);
        double const error = error_of(folder, "out.", i, {.noisy = i == 4, .beside = i == 3 ? 0.1f : 0.f});
        CHECK(error < 0.5 * error_of(folder, "frame.", i, {.noisy = i == 4, .beside = i == 3 ? 0.1f : 0.f}));
    }
}

TEST_CASE("--signal rest says where the rest is") {
    Folder const folder;
    write_frame(folder, 1, {});
    write_maps(folder);
    check_refused(denoise(input(folder) + output(folder) + "--signal rest --map '" + (folder / "passes.json").string() + "'"),
                  {"--signal", "frame.0001.exr", "denoised_rest", "--layers signals"});
}

// Films that are transparent.
namespace {

/// How much of a pixel is covered: nothing on the left, all on the right.
float covered(int x) { return std::clamp((static_cast<float>(x) - 32.f) / 32.f, 0.f, 1.f); }

/// One sample a pixel of a textured thing that covers part of it.
void write_film(Folder const& folder, int number) {
    std::mt19937 random(static_cast<unsigned>(number));
    std::uniform_real_distribution<float> part(0.f, 1.f);
    io::ExrImage image{.size = size};
    auto const alpha = colours(size, [&](int x, int) { return glm::vec3(part(random) < covered(x) ? 1.f : 0.f); });
    auto picture = colours(size, checks);
    add_pass(image, "albedo", picture, exact);
    for (std::size_t i = 0; i < picture.size(); ++i) picture[i] *= alpha[i];
    add_pass(image, "", picture, exact);
    image.planes.push_back(plane("A", size, [&](int x, int y) { return alpha[static_cast<std::size_t>(y * size.width + x)].x; }));
    add_guides(image, [](int, int) { return 5.f; });
    io::write_exr(folder / numbered("frame.", number), image);
}
double mean(std::vector<float> const& values) {
    return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}

} // namespace

TEST_CASE("alpha is denoised with the picture: a covered pixel keeps its colour, and nothing leaks into an empty film") {
    constexpr int frames = 5;
    std::string preset;
    float most = 0; // that a colour is off
    SUBCASE("general") { preset = "general", most = 1e-3f; }
    SUBCASE("final-frame") { preset = "final-frame", most = .1f; }
    Folder const folder;
    double given = 0; // what the film has seen so far
    for (int i = 1; i <= frames; ++i) {
        write_film(folder, i);
        given += mean(io::read_exr(folder / numbered("frame.", i))["A"].values) / frames;
    }
    auto const ran = denoise(input(folder) + output(folder) + "--extra-frames 0 --json --preset " + preset);
    INFO(ran.err);
    REQUIRE(ran.code == 0);
    CHECK(nlohmann::json::parse(ran.out)["remarks"].empty());
    for (int i = 1; i <= frames; ++i) {
        INFO("frame ", i);
        auto const image = io::read_exr(folder / numbered("out.", i));
        auto const picture = pass(image, "");
        auto const& alpha = image["A"].values;
        float worst = 0;
        int leaks = 0, covered_pixels = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                auto const k = static_cast<std::size_t>(y * size.width + x);
                if (x < 32) leaks += picture[k] != glm::vec3(0.f) || alpha[k] != 0.f; // the 3x3 around it is empty
                if (alpha[k] < 0.01f) continue;
                ++covered_pixels;
                auto const off = picture[k] / alpha[k] - checks(x, y);
                worst = std::max({worst, std::abs(off.x), std::abs(off.y), std::abs(off.z)});
            }
        CHECK(leaks == 0);
        CHECK(covered_pixels > size.width * size.height / 2);
        CHECK(worst < most);
    }
    auto const last = io::read_exr(folder / numbered("out.", frames))["A"].values;
    CHECK(mean(last) == doctest::Approx(given).epsilon(0.01));
    double squares = 0, before = 0;
    auto const noisy = io::read_exr(folder / numbered("frame.", frames))["A"].values;
    for (std::size_t k = 0; k < last.size(); ++k) {
        auto const right = covered(static_cast<int>(k) % size.width);
        squares += std::pow(static_cast<double>(last[k] - right), 2), before += std::pow(static_cast<double>(noisy[k] - right), 2);
    }
    CHECK(squares < 0.05 * before);
}

TEST_CASE("an opaque film stays opaque, whatever part of the light no pass has") {
    for (float const beside : {0.02f, 0.3f}) { // filtered by its parts, and as one
        Folder const folder;
        write_bytes(folder / "map.json", R"({"signals": [{"name": "diffuse", "irradiance": "diffuse", "albedo": "diffuse_colour"}],
                                             "picture": "beauty"})");
        for (int i = 1; i <= 3; ++i) {
            write_frame(folder, i, {.beside = beside});
            auto image = io::read_exr(folder / numbered("frame.", i));
            image.planes.push_back(plane("beauty.A", size, [](int, int) { return 1.f; }));
            io::write_exr(folder / numbered("frame.", i), image);
        }
        auto const ran =
            denoise(input(folder) + output(folder) + "--quiet --preset general --map '" + (folder / "map.json").string() + "'");
        INFO(ran.err);
        REQUIRE(ran.code == 0);
        auto const out = io::read_exr(folder / numbered("out.", 3));
        for (float const a : out["beauty.A"].values) REQUIRE(a == doctest::Approx(1.f).epsilon(1e-5));
    }
}

TEST_CASE("--keep-alpha leaves alpha as it is, and a preset that can't denoise it says so once") {
    Folder const folder;
    for (int i = 1; i <= 3; ++i) write_film(folder, i);
    auto const remarks = [&](std::string const& more) {
        auto const ran = denoise(input(folder) + output(folder) + "--quiet --json " + more);
        INFO(ran.err);
        REQUIRE(ran.code == 0);
        for (int i = 1; i <= 3; ++i) {
            auto const before = io::read_exr(folder / numbered("frame.", i)), after = io::read_exr(folder / numbered("out.", i));
            CHECK(after["A"].values == before["A"].values);
            CHECK(after["R"].values != before["R"].values);
            auto const picture = pass(after, "");
            for (std::size_t k = 0; k < picture.size(); ++k)
                if (static_cast<int>(k) % size.width < 32) CHECK(picture[k] == glm::vec3(0.f));
        }
        return nlohmann::json::parse(ran.out)["remarks"].get<std::vector<std::string>>();
    };
    CHECK(remarks("--preset general --keep-alpha").empty());
    CHECK(remarks("--preset svgf --keep-alpha").empty());
    auto const said = remarks("--preset svgf");
    REQUIRE(said.size() == 1);
    for (auto const* const part : {"alpha is as in the files", "svgf", "general and final-frame"}) CHECK(contains(said[0], part));
}

// Renders on which pictures were wrong.
namespace {

/// RMSE and FLIP of frame 6.
std::array<double, 2> scores(std::filesystem::path const& from, std::string const& more) {
    auto const at = [&](std::string const& name) { return " '" + (from / name).string() + "' "; };
    auto const ran = denoise("--in" + at("frame_%04d.exr") + "--reference" + at("reference_%04d.exr") +
                             "--quiet --preset final-frame --first 6 --last 6 --warmup 5 --json " + more);
    INFO(ran.err);
    REQUIRE(ran.code == 0);
    auto const mean = nlohmann::json::parse(ran.out)["mean"];
    return {mean["rmse"].get<double>(), mean["flip"].get<double>()};
}

} // namespace

TEST_CASE("fog and depth of field: at most the error of the picture as one signal" * doctest::test_suite("shared data")) {
    for (std::string const name : {"volume", "dof"}) {
        auto const from = shared("data/cases/" + name);
        if (from.empty()) return;
        INFO(name);
        auto const found = scores(from, ""), as_one = scores(from, "--map '" + (from.parent_path() / "comb.json").string() + "'");
        for (std::size_t i = 0; i < 2; ++i) CHECK(found[i] <= 1.005 * as_one[i]);
    }
}

TEST_CASE("several estimates: noisy guides have less error than by one, and fog little more" * doctest::test_suite("shared data")) {
    auto const cases = shared("data/cases");
    if (cases.empty()) return;
    auto const of_field = scores(cases / "dof", ""), of_field_quick = scores(cases / "dof", "--quick");
    auto const fog = scores(cases / "volume", ""), fog_quick = scores(cases / "volume", "--quick");
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(of_field[i] < 0.92 * of_field_quick[i]);
        CHECK(fog[i] < 1.02 * fog_quick[i]);
    }
}

TEST_CASE("noisy guides: a frame is the same whether the one before it is written or not" * doctest::test_suite("shared data")) {
    auto const from = shared("data/cases/dof");
    if (from.empty()) return;
    Folder const folder;
    auto const at = "--in '" + (from / "frame_%04d.exr").string() + "' --preset final-frame --quiet --layers picture ";
    REQUIRE(denoise(at + output(folder, "both.") + "--frames 5,6").code == 0);
    REQUIRE(denoise(at + output(folder, "last.") + "--frames 6").code == 0);
    CHECK(bytes_of(folder / numbered("last.", 6)) == bytes_of(folder / numbered("both.", 6)));
}

TEST_CASE("a glass ball without its passes keeps its light" * doctest::test_suite("shared data")) {
    auto const from = shared("data/cases/glassenter");
    if (from.empty()) return;
    Folder const folder;
    auto const ran = denoise("--in '" + (from / "frame_%04d.exr").string() + "' --quiet --preset final-frame " + output(folder));
    INFO(ran.err);
    REQUIRE(ran.code == 0);
    double before = 0, after = 0;
    for (int i = 5; i <= 8; ++i) {
        INFO("frame ", i);
        auto const image = io::read_exr(from / numbered("frame_", i)), out = io::read_exr(folder / numbered("out.", i));
        auto const layer = [&](io::ExrImage const& of, char const* name) { return pass(of, std::string("ViewLayer.") + name); };
        auto const picture = layer(image, "Combined"), denoised_picture = layer(out, "Combined");
        auto const colour = layer(image, "DiffCol");
        auto const& depth = image["ViewLayer.Depth.Z"].values;
        double given = 0, found = 0;
        int pixels = 0;
        for (std::size_t k = 0; k < picture.size(); ++k) {
            if (luminance(colour[k]) > 0.02f || depth[k] > 1e9f) continue; // glass has no diffuse colour
            given += static_cast<double>(luminance(picture[k])), found += static_cast<double>(luminance(denoised_picture[k]));
            ++pixels;
        }
        CHECK(pixels > 200);
        CHECK(found / given == doctest::Approx(1.).epsilon(0.04));
        before += given, after += found;
    }
    CHECK(after / before == doctest::Approx(1.).epsilon(0.02));
}

TEST_CASE("where nothing is on a transparent film there is nothing" * doctest::test_suite("shared data")) {
    auto const from = shared("data/cases/alphaall");
    if (from.empty()) return;
    Folder const folder;
    auto const ran =
        denoise("--in '" + (from / "frame_%04d.exr").string() + "' --quiet --preset final-frame --extra-frames 0 " + output(folder));
    INFO(ran.err);
    REQUIRE(ran.code == 0);
    std::vector<bool> was_empty; // in all frames so far, in the pixel and around it
    for (int i = 1; i <= 3; ++i) {
        INFO("frame ", i);
        auto const image = io::read_exr(from / numbered("frame_", i)), out = io::read_exr(folder / numbered("out.", i));
        auto const& alpha = image["ViewLayer.Combined.A"].values;
        auto const picture = pass(out, "ViewLayer.Combined");
        auto const width = image.size.width, height = image.size.height;
        was_empty.resize(alpha.size(), true);
        int leaks = 0, empty = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                auto const k = static_cast<std::size_t>(y * width + x);
                for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
                        if (alpha[static_cast<std::size_t>(v * width + u)] != 0.f) was_empty[k] = false;
                if (!was_empty[k]) continue;
                ++empty, leaks += picture[k] != glm::vec3(0.f) || out["ViewLayer.Combined.A"].values[k] != 0.f;
            }
        CHECK(empty > 1000);
        CHECK(leaks == 0);
    }
}

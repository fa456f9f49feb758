#include "passes.hpp"

#include <nlohmann/json.hpp>

// What quell-denoise --why tells of the stages behind a preset.
using namespace quell;
using namespace quell::tests;

namespace {

constexpr Extent size{64, 48};
constexpr int frames = 6;

/// What is wrong with a sequence.
struct Wrong {
    bool film = false;         ///< the left half is a screen whose colours change without motion
    bool held = false;         ///< each frame is there twice
    bool doubled = false;      ///< 2x2 pixels share their samples
    std::string samples = "1"; ///< that the files say
};

/// A textured wall that moves to the right by a pixel a frame, under light of one sample, as Cycles writes it.
io::ExrImage image_of(int number, Wrong const& wrong) {
    int const shown = wrong.held ? number / 2 : number;
    std::mt19937 random(static_cast<unsigned>(shown) + 100U);
    std::exponential_distribution<float> noise(1.f);
    auto const is_screen = [&](int x) { return wrong.film && x < size.width / 2; };
    std::uniform_real_distribution<float> in_pixel(0.f, 1.f);
    auto const colour = colours(size, [&](int x, int y) {
        float const u = in_pixel(random), v = in_pixel(random); // each sample has a place of its own
        auto const at = glm::vec2(x, y) + glm::vec2(u, v);
        auto const now = at * .2f + glm::vec2(2.f, 1.f) * static_cast<float>(number);
        if (is_screen(x)) return glm::vec3(.5f + .4f * std::sin(now.x) * std::sin(now.y));
        auto const cell = glm::ivec2((at + glm::vec2(1000 - shown, 0)) / 8.f);
        return glm::vec3((cell.x + cell.y) % 2 == 0 ? .8f : .3f);
    });
    auto light = colours(size, [&](int, int) { return glm::vec3(noise(random)); });
    auto const others = colours(size, [&](int, int) { return glm::vec3(.2f * noise(random)); });
    auto const width = static_cast<std::size_t>(size.width);
    for (std::size_t i = 0; i < light.size() && wrong.doubled; ++i) light[i] = light[i / width / 2 * 2 * width + i % width / 2 * 2];
    auto picture = colour;
    for (std::size_t i = 0; i < picture.size(); ++i) picture[i] *= light[i] + others[i];
    io::ExrImage image{.size = size};
    auto const exact = io::SampleType::float32;
    add_pass(image, "ViewLayer.Combined", picture, exact), add_pass(image, "ViewLayer.DiffDir", light, exact);
    add_pass(image, "ViewLayer.DiffInd", others, exact), add_pass(image, "ViewLayer.DiffCol", colour, exact);
    float const moved = wrong.held ? 0.f : -1.f;
    for (auto const& [name, value] : {std::pair{"Depth.Z", 5.f},
                                      {"Normal.X", 0.f},
                                      {"Normal.Y", 0.f},
                                      {"Normal.Z", 1.f},
                                      {"Vector.X", moved},
                                      {"Vector.Y", 0.f},
                                      {"Vector.Z", moved},
                                      {"Vector.W", 0.f}})
        image.planes.push_back(plane("ViewLayer." + std::string(name), size, [&, is_vector = name[0] == 'V', v = value](int x, int) {
            return is_vector && is_screen(x) ? 0.f : v;
        }));
    image.attributes["cycles.ViewLayer.samples"] = wrong.samples;
    return image;
}

struct Cells {
    std::string signal, stage, reason;
    double share, refused;
};
/// The rows of a table.
std::vector<Cells> rows_of(std::filesystem::path const& path) {
    std::istringstream text(bytes_of(path));
    std::string line;
    std::getline(text, line);
    CHECK(line == "view,signal,stage,share,refused,reason");
    std::vector<Cells> rows;
    while (std::getline(text, line)) {
        std::istringstream cells(line);
        std::string view, signal, stage, share, refused, reason;
        for (auto* const cell : {&view, &signal, &stage, &share, &refused}) std::getline(cells, *cell, ',');
        std::getline(cells, reason);
        rows.push_back({signal, stage, reason, std::stod(share), std::stod(refused)});
    }
    return rows;
}
/// The row of a stage that refused most.
Cells worst(std::vector<Cells> const& rows, std::string const& stage) {
    Cells most{.signal = "", .stage = stage, .reason = "", .share = 0, .refused = -1};
    for (auto const& row : rows)
        if (row.stage == stage && row.refused > most.refused) most = row;
    return most;
}

struct Told {
    std::vector<Cells> rows; ///< of the frame before the last
    std::string err;
};
Told told(Wrong const& wrong) {
    Folder const folder;
    for (int i = 0; i < frames; ++i) io::write_exr(folder / numbered("frame.", i), image_of(i, wrong));
    auto const ran = denoise(input(folder) + output(folder) + "--why");
    INFO(ran.err);
    REQUIRE(ran.code == 0);
    return {rows_of(folder / "out.0004.why.csv"), ran.err};
}

auto const said_of_colours = "frames around show other colours than this one";

} // namespace

TEST_CASE("--why writes a table and a picture of the stages beside the output, and changes nothing else") {
    Folder const folder;
    for (int i = 0; i < frames; ++i) io::write_exr(folder / numbered("frame.", i), image_of(i, {}));
    REQUIRE(denoise(input(folder) + output(folder, "plain.")).code == 0);
    auto const ran = denoise(input(folder) + output(folder) + "--why --json");
    REQUIRE(ran.code == 0);
    for (int i = 0; i < frames; ++i) {
        CHECK(bytes_of(folder / numbered("plain.", i)) == bytes_of(folder / numbered("out.", i)));
        auto const beside = "out.000" + std::to_string(i) + ".why";
        CHECK(std::filesystem::exists(folder / (beside + ".png")));
        auto const rows = rows_of(folder / (beside + ".csv"));
        for (std::string const stage : {"samples", "evidence", "light", "colours", "guide noise", "repeated light"}) {
            INFO(stage);
            CHECK(std::ranges::count(rows, stage, &Cells::stage) > 0);
        }
        for (auto const& row : rows) {
            CHECK((row.share >= 0. && row.share <= 1.));
            CHECK((row.refused >= 0. && row.refused <= 1.));
        }
    }
    // No frame is known before the first.
    CHECK(worst(rows_of(folder / "out.0000.why.csv"), "evidence").share == 1.);
    CHECK(worst(rows_of(folder / "out.0005.why.csv"), "evidence").share < 1.);
    CHECK(worst(rows_of(folder / "out.0004.why.csv"), "light").share > 0.);
    auto const why = nlohmann::json::parse(ran.out)["why"];
    CHECK(why.size() >= 6);
    CHECK(contains(why.dump(), "light, picture: "));
}

TEST_CASE("--why names a screen whose colours change without motion, and nothing in its twin") {
    auto const broken = told({.film = true}), right = told({});
    auto const row = worst(broken.rows, "colours");
    CHECK(row.signal == "picture"); // the only signal
    CHECK(row.refused > .8 * .5);
    CHECK(row.refused < .7);
    CHECK(row.reason == said_of_colours);
    CHECK(contains(broken.err, said_of_colours));
    CHECK(worst(right.rows, "colours").refused < .05);
    CHECK_FALSE(contains(right.err, "--why"));
}

TEST_CASE("--why names noise that is no new witness") {
    auto const doubled = told({.doubled = true});
    for (std::string const stage : {"evidence", "light", "repeated light"}) {
        INFO(stage);
        CHECK(worst(doubled.rows, stage).refused > .8);
        CHECK(worst(doubled.rows, stage).reason == "neighbouring pixels share their noise");
    }
    CHECK(contains(doubled.err, "neighbouring pixels share their noise"));
    auto const held = told({.held = true});
    CHECK(worst(held.rows, "repeated light").refused > .4);
    CHECK(worst(held.rows, "repeated light").reason == "a frame around has the same noise");
    CHECK(contains(held.err, "a frame around has the same noise"));
    auto const limited = told({.samples = "4096"});
    CHECK(worst(limited.rows, "samples").refused > .99);
    CHECK(contains(worst(limited.rows, "samples").reason, "the file says 4096 samples a pixel, its noise is that of "));
    CHECK(contains(limited.err, "the file says 4096 samples a pixel"));
}

TEST_CASE("--why says what a preset leaves out, and wants an output") {
    Folder const folder;
    for (int i = 0; i < 2; ++i) io::write_exr(folder / numbered("frame.", i), image_of(i, {}));
    REQUIRE(denoise(input(folder) + output(folder) + "--why --quick").code == 0);
    auto const row = worst(rows_of(folder / "out.0001.why.csv"), "light");
    CHECK(row.refused == 0.);
    CHECK(contains(row.reason, "--quick"));
    check_refused(denoise(input(folder) + "--why --reference x.%04d.exr"), {"--why", "--out is missing"});
}

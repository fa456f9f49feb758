#include "programs.hpp"

#include "../shared_data.hpp"

#include <quell/metrics/rmse.hpp>

#include <bit>
#include <set>

using namespace quell;
using namespace quell::tests;

// quell-denoise on one signal of the files: --signal, and references of single effects.
namespace {

/// What quell-trace writes for some effects, the last frame converged too.
struct Traced {
    Folder folder;
    std::string last;

    explicit Traced(std::string const& scene, std::string const& effects, int frames = 6, bool converged = true)
        : last(std::to_string(frames - 1)) {
        auto const run = [&](std::string const& some) {
            auto const ran =
                trace("--scene " + scene + " --size 64x36 --quiet --effects " + effects + " --out '" + folder.path.string() + "' " + some);
            INFO(ran.err);
            CHECK(ran.code == 0);
        };
        run("--frames " + std::to_string(frames));
        if (converged) run("--frames 1 --reference 256 --first " + last);
    }
    [[nodiscard]] Ran denoise(std::string const& arguments) const { return tests::denoise(input(folder) + arguments); }
    [[nodiscard]] std::string reference() const {
        return " --reference '" + (folder / "reference.%04d.exr").string() + "' --first " + last + " --last " + last + " ";
    }
    /// RMSE of the last frame, which those before it are read for.
    [[nodiscard]] double rmse(std::string const& arguments) const {
        auto const ran = denoise("--quiet --extra-frames 0 " + arguments + reference());
        INFO(arguments, ": ", ran.err);
        CHECK(ran.code == 0);
        auto const lines = ran.lines();
        REQUIRE(lines.size() > 2);
        return score_in(lines[lines.size() - 2], "rmse");
    }
};

/// Names of planes that differ between two files; of a plane that one lacks too.
std::set<std::string> changed(std::filesystem::path const& before, std::filesystem::path const& after) {
    auto const a = io::read_exr(before), b = io::read_exr(after);
    std::set<std::string> names;
    auto const same = [](float x, float y) { return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y); }; // NaN too
    for (auto const& plane : b.planes)
        if (!a.find(plane.name) || !std::ranges::equal(a[plane.name].values, plane.values, same)) names.insert(plane.name);
    for (auto const& plane : a.planes)
        if (!b.find(plane.name)) names.insert(plane.name);
    return names;
}
using Names = std::set<std::string>;

/// Adds a layer of what `value` says of each component of the picture: value(letter, pixel).
void add_layer(io::ExrImage& image, std::string const& name, auto&& value) {
    for (std::string const letter : {"R", "G", "B"}) {
        auto plane = image[letter];
        plane.name = name + "." + letter;
        for (std::size_t k = 0; k < plane.values.size(); ++k) plane.values[k] = value(letter, k);
        image.planes.push_back(plane);
    }
}

void write_map(Folder const& folder, std::string const& text) { write_bytes(folder / "map.json", text); }
std::string map(Folder const& folder) { return "--map '" + (folder / "map.json").string() + "' "; }

} // namespace

TEST_CASE("visibility alone is denoised by any preset of one signal, scored, and written in its place") {
    Traced const shot("room", "shadow");
    auto const noisy = shot.rmse("--signal visibility --preset none");
    for (std::string const preset : {"svgf", "surface-clamp", "general", "final-frame", "shadow", "shadow-paper"}) {
        INFO(preset);
        CHECK(shot.rmse("--signal visibility --preset " + preset) < 0.8 * noisy);
    }
    for (std::string const preset : {"svgf", "shadow"}) {
        CHECK(shot.denoise(output(shot.folder) + "--signal visibility --preset " + preset).code == 0);
        CHECK(changed(shot.folder / "frame.0005.exr", shot.folder / "out.0005.exr") == Names{"visibility.V"});
    }
    // The table is of the signal itself.
    CHECK(shot.denoise(output(shot.folder) + "--signal visibility --preset svgf").code == 0);
    auto const out = io::read_exr(shot.folder / "out.0005.exr"), truth = io::read_exr(shot.folder / "reference.0005.exr");
    metrics::Picture shown{out.size, {}}, expected{out.size, {}};
    for (auto const v : out["visibility.V"].values) shown.pixels.emplace_back(v);
    for (auto const v : truth["visibility.V"].values) expected.pixels.emplace_back(v);
    auto const rmse = metrics::rmse(metrics::displayed(expected), metrics::displayed(shown));
    CHECK(shot.rmse("--signal visibility --preset svgf") == doctest::Approx(rmse).epsilon(0.001)); // halves in the file
}

TEST_CASE("without --signal an effect's preset is scored by its part of the picture") {
    Traced const shadows("fence", "shadow"), reflections("temple", "glossy"), bounced("room", "indirect");
    CHECK(shadows.rmse("--preset shadow") > 0);
    CHECK(shadows.rmse("--preset shadow") < 0.7 * shadows.rmse("--signal visibility --preset none"));
    auto const noisy = reflections.rmse("--signal glossy --preset none");
    for (std::string const preset : {"glossy", "glossy-paper", "mirror-clamp"}) {
        INFO(preset);
        // Its part of the picture is the signal itself.
        CHECK(reflections.rmse("--preset " + preset) == reflections.rmse("--preset " + preset + " --signal glossy"));
        CHECK(reflections.rmse("--preset " + preset) < noisy);
    }
    CHECK(reflections.rmse("--signal glossy --preset svgf") < noisy);
    CHECK(bounced.rmse("--signal indirect --preset dual-cone") < 0.5 * bounced.rmse("--signal indirect --preset none"));
    CHECK(bounced.rmse("--preset dual-cone") < bounced.rmse("--signal indirect --preset none"));
    Traced const all("room", "shadow,glossy,indirect", 3);
    CHECK(all.rmse("--preset trmv") > 0);
}

TEST_CASE("without --preset a signal is denoised by what suits it") {
    Traced const all("room", "composite,shadow,glossy,indirect", 1, false);
    auto const preset = [&](std::string const& signal) { return all.denoise("--diagnose --signal " + signal).err; };
    CHECK(contains(preset("visibility"), "preset shadow, since"));
    CHECK(contains(preset("glossy"), "preset glossy, since"));
    CHECK(contains(preset("indirect"), "preset dual-cone, since"));
    CHECK(contains(preset("direct"), "preset final-frame, since"));
    CHECK(contains(preset("radiance"), "preset final-frame, since"));
    CHECK(contains(all.denoise("--plan --signal visibility").out, "shadow\n"));
}

TEST_CASE("the picture as a signal is what it is without --signal") {
    Folder const folder;
    write_sequence(folder, 0, 3);
    CHECK(denoise(input(folder) + output(folder, "plain.") + "--preset svgf").code == 0);
    CHECK(denoise(input(folder) + output(folder, "signal.") + "--preset svgf --signal radiance").code == 0);
    CHECK(bytes_of(folder / "plain.0003.exr") == bytes_of(folder / "signal.0003.exr"));
}

TEST_CASE("post-processes of motion blur run on any signal, along its own sweeps where the file has them") {
    Traced const shot("flyby", "blur,shadow", 2, false);
    for (std::string const preset : {"gather-blur", "tilemax-blur", "blur"}) {
        INFO(preset);
        CHECK(shot.denoise(output(shot.folder) + "--quiet --signal visibility --preset " + preset).code == 0);
        CHECK(changed(shot.folder / "frame.0001.exr", shot.folder / "out.0001.exr") == Names{"visibility.V"});
        CHECK(shot.denoise(output(shot.folder) + "--quiet --preset " + preset).code == 0);
        CHECK(changed(shot.folder / "frame.0001.exr", shot.folder / "out.0001.exr") == Names{"B", "G", "R"});
    }
}

TEST_CASE("a signal of a map, or a layer, is denoised alone and its factor kept") {
    Folder const folder;
    for (int i = 0; i < 3; ++i) {
        auto image = noisy_image({48, 32}, i);
        add_layer(image, "fog", [&](auto const& letter, auto k) { return image[letter].values[k]; });
        io::write_exr(folder / numbered("frame.", i), image);
    }
    CHECK(denoise(input(folder) + output(folder) + "--preset svgf --signal fog").code == 0);
    CHECK(changed(folder / "frame.0002.exr", folder / "out.0002.exr") == Names{"fog.B", "fog.G", "fog.R"});
    write_map(folder, R"({"signals": [{"name": "base", "radiance": ""}, {"name": "haze", "irradiance": "fog", "albedo": "albedo"}]})");
    CHECK(denoise(input(folder) + output(folder) + map(folder) + "--preset svgf --signal haze").code == 0);
    CHECK(changed(folder / "frame.0002.exr", folder / "out.0002.exr") == Names{"denoised_haze.B", "denoised_haze.G", "denoised_haze.R"});
    CHECK(denoise(input(folder) + output(folder) + map(folder) + "--preset none --signal haze").code == 0);
    auto const out = io::read_exr(folder / "out.0002.exr");
    CHECK(out["denoised_haze.G"].values[77] == doctest::Approx(out["fog.G"].values[77] * out["albedo.G"].values[77]).epsilon(0.001));
}

TEST_CASE("what a signal, a preset or a reference lacks is named") {
    Traced const shot("fence", "shadow", 2);
    auto const refused = [&](std::string const& arguments, std::initializer_list<std::string> parts) {
        check_refused(shot.denoise("--quiet " + output(shot.folder) + arguments), parts);
    };
    refused("--signal smoke", {"--signal", "no signal 'smoke' in", "frame.0000.exr", "direct, visibility"});
    refused("--signal blocker --preset svgf", {"--signal", "no signal 'blocker'"}); // three components that are no colour
    refused("--signal glossy --preset svgf", {"--signal", "no signal 'glossy'"});
    refused("--signal visibility --preset trmv", {"--preset", "'trmv'", "visibility, glossy, indirect", "final-frame"});
    refused("--signal direct --preset shadow", {"--preset", "'shadow'", "one component", "'direct'"});
    refused("--signal visibility --preset glossy", {"frame.0000.exr", "glossy_hit.X"});
    refused("--signal visibility --preset gather-blur", {"frame.0000.exr", "sweep.X"});
    refused("--signal visibility --preset asvgf", {"frame.0000.exr", "visibility_gradient.X"});
    auto image = io::read_exr(shot.folder / "reference.0001.exr");
    std::erase_if(image.planes, [](auto const& plane) { return plane.name == "visibility.V"; });
    io::write_exr(shot.folder / "reference.0001.exr", image);
    refused("--signal visibility --preset svgf" + shot.reference(), {"reference.0001.exr", "visibility.V"});
}

TEST_CASE("a map that takes radiance for irradiance, or irradiance for radiance, is noticed") {
    Folder const folder;
    for (int i = 0; i < 6; ++i) {
        auto image = noisy_image({96, 64}, i);
        add_layer(image, "light",
                  [&](auto const& letter, auto k) { return image[letter].values[k] / image["albedo." + letter].values[k]; });
        io::write_exr(folder / numbered("frame.", i), image);
    }
    auto const said = [&](std::string const& signal, std::string const& preset) {
        write_map(folder, "{\"signals\": [" + signal + "]}");
        auto const ran = denoise(input(folder) + map(folder) + "--diagnose --extra-frames 0 --preset " + preset);
        CHECK(ran.code == 0);
        return ran.err;
    };
    for (std::string const preset : {"svgf", "final-frame"}) {
        CHECK(contains(said(R"({"radiance": "", "albedo": "albedo"})", preset), "found nothing wrong"));
        CHECK(contains(said(R"({"irradiance": "light", "albedo": "albedo"})", preset), "found nothing wrong"));
        CHECK(contains(said(R"({"radiance": "light", "albedo": "albedo"})", preset), R"(write "irradiance" in place of "radiance")"));
        CHECK(contains(said(R"({"irradiance": "", "albedo": "albedo"})", preset), R"(write "radiance" in place of "irradiance")"));
    }
}

TEST_CASE("of good files nothing is said, whichever signal is denoised") {
    Traced const all("room", "composite,shadow,glossy,indirect", 5, false);
    for (std::string const signal : {"visibility", "glossy", "indirect", "direct", "radiance"}) {
        INFO(signal);
        auto const ran = all.denoise("--diagnose --preset svgf --signal " + signal);
        INFO(ran.err);
        CHECK(contains(ran.err, "found nothing wrong"));
    }
}

TEST_CASE("of Cycles' sequences nothing is said, and a signal of theirs is denoised alone" * doctest::test_suite("shared data")) {
    auto const folder = shared("data/sequences/cycles_occlusion");
    if (folder.empty()) return;
    Folder const out;
    auto const in = "--in '" + (folder / "frame_%04d.exr").string() + "' --first 33 --last 40 ";
    auto const ran = denoise(in + "--diagnose --preset svgf");
    INFO(ran.err);
    CHECK(contains(ran.err, "found nothing wrong"));
    CHECK(denoise(in + output(out) + "--preset svgf --signal diffuse").code == 0);
    for (auto const& name : changed(folder / "frame_0040.exr", out / "out.0040.exr")) CHECK(contains(name, "ViewLayer.denoised_diffuse"));
}

#include "programs.hpp"

#include <denoise/map_file.hpp>
#include <denoise/presets.hpp>

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

using namespace quell;
using namespace quell::tests;

namespace {

/// Those that need no more than the image and its guides.
std::vector<std::string> image_presets() {
    Folder const folder;
    write_sequence(folder, 0, 0);
    io::ExrFile const file(folder / numbered("frame.", 0));
    std::vector<std::string> names;
    for (auto const& preset : examples::presets())
        if (examples::applies(preset, file, examples::recognised(file))) names.push_back(preset.name);
    REQUIRE(names.size() > 1);
    return names;
}

/// The header of a table of scores, and what else a line of it says of a picture that is as it should be.
std::string const scores_header = [] {
    std::string header = "frame";
    for (auto const& metric : metrics::all_metrics) header += fmt::format(",{}", metric.name);
    return header;
}();
std::string perfect_scores() {
    metrics::Picture const picture{{16, 16}, std::vector(256, glm::vec3(0.5f))};
    std::string scores;
    metrics::errors_of({picture, picture}).for_each([&](auto const&, double value) { scores += fmt::format(",{:.6f}", value); });
    return scores;
}

bool readable(std::filesystem::path const& file) {
    auto const image = io::read_exr(file);
    return image.find("R") && image.find("G") && image.find("B");
}
double noise_of(io::ExrImage const& image) {
    double sum = 0, squares = 0;
    for (auto const value : image["R"].values)
        sum += static_cast<double>(value), squares += static_cast<double>(value) * static_cast<double>(value);
    auto const n = static_cast<double>(image.pixels());
    return std::sqrt(squares / n - sum / n * sum / n);
}

/// The product of some layers of a picture: a name stands for one channel, or for the red, green and blue of a layer ("" for the
/// picture's).
std::vector<float> product_of(io::ExrImage const& image, std::vector<std::string> const& layers) {
    std::vector<float> product(3 * image.pixels(), 1.f);
    for (auto const& layer : layers)
        for (std::size_t c = 0; c < 3; ++c) {
            std::string const letter(1, "RGB"[c]), name = layer.empty() ? letter : layer + "." + letter;
            auto const& values = image[image.find(name) ? name : layer].values;
            for (std::size_t i = 0; i < values.size(); ++i) product[3 * i + c] *= values[i];
        }
    return product;
}
/// RMSE as far as pictures can be shown, from 0 to 1.
double error_of(std::vector<float> const& a, std::vector<float> const& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += std::pow(static_cast<double>(std::clamp(a[i], 0.f, 1.f) - std::clamp(b[i], 0.f, 1.f)), 2);
    return std::sqrt(squares / static_cast<double>(a.size()));
}
/// What quell-trace writes of some frames, and the last one's reference: those of all frames would take longer than everything else.
void trace_with_last_reference(Folder const& folder, std::string const& scene, int frames, std::string const& effects) {
    auto const what = "--scene " + scene + " --size 96x64 --quiet --effects " + effects + " --out '" + folder.path.string() + "' ";
    CHECK(trace(what + "--frames " + std::to_string(frames)).code == 0);
    CHECK(trace(what + "--frames 1 --first " + std::to_string(frames - 1) + " --reference 512").code == 0);
}
/// What a preset leaves of the error of a frame, or of a share of it, against the tracer's reference. Also checks that it ran.
double left_of_error(Folder const& folder, std::string const& preset, int frame, std::vector<std::string> const& share = {""}) {
    auto const ran = denoise(input(folder) + output(folder, preset + ".") + "--preset " + preset);
    INFO(preset, ran.err);
    CHECK(ran.code == 0);
    auto const out = folder / numbered(preset + ".", frame);
    CHECK(readable(out));
    auto const wanted = product_of(io::read_exr(folder / numbered("reference.", frame)), share);
    auto const before = error_of(product_of(io::read_exr(folder / numbered("frame.", frame)), share), wanted);
    CHECK(before > 0.01); // there is noise to take away
    return error_of(product_of(io::read_exr(out), {""}), wanted) / before;
}

} // namespace

TEST_CASE("a sequence goes in, a clean one comes out") {
    Folder const folder;
    write_sequence(folder, 3, 8);
    auto const ran = denoise(input(folder) + output(folder, "made/for/it.") + "--preset svgf");
    INFO(ran.err);
    CHECK(ran.code == 0);
    CHECK(ran.out.empty());
    CHECK(contains(ran.err, "6 frames of quell; 0 samples were missing"));
    for (int i = 3; i <= 8; ++i) CHECK(readable(folder / numbered("made/for/it.", i)));
    CHECK(noise_of(io::read_exr(folder / "made/for/it.0008.exr")) < 0.5 * noise_of(io::read_exr(folder / "frame.0008.exr")));
    auto const hashes = "--in '" + (folder / "frame.####.exr").string() + "' --out '" + (folder / "hashes.###.exr").string() + "' ";
    CHECK(denoise(hashes + "--preset svgf --first 3 --last 3").code == 0);
    CHECK(bytes_of(folder / "hashes.003.exr") == bytes_of(folder / "made/for/it.0003.exr"));
    CHECK(denoise(input(folder) + output(folder, "made/for/it.") + "--quiet").err.empty());
}

TEST_CASE("every preset for whole images runs, and none leaves the image as it is") {
    Folder const folder;
    write_sequence(folder, 0, 1);
    for (auto const& preset : image_presets()) {
        INFO(preset);
        CHECK(denoise(input(folder) + output(folder, preset + ".") + "--preset " + preset).code == 0);
        CHECK(readable(folder / (preset + ".0001.exr")));
        if (preset != "none")
            CHECK(noise_of(io::read_exr(folder / (preset + ".0001.exr"))) < 0.9 * noise_of(io::read_exr(folder / "frame.0001.exr")));
    }
    CHECK(io::read_exr(folder / "none.0001.exr")["G"].values == io::read_exr(folder / "frame.0001.exr")["G"].values);
}

TEST_CASE("the effects' presets lessen the error of what quell-trace writes for these effects") {
    Folder const folder;
    trace_with_last_reference(folder, "temple", 6, "composite,shadow,glossy,indirect");
    CHECK(left_of_error(folder, "shadow", 5, {"direct", "visibility.V"}) < 0.55);
    CHECK(left_of_error(folder, "glossy", 5, {"glossy"}) < 0.7);
    CHECK(left_of_error(folder, "mirror-clamp", 5, {"glossy"}) < 0.9);
    CHECK(left_of_error(folder, "dual-cone", 5, {"albedo", "indirect"}) < 0.2);
    CHECK(left_of_error(folder, "trmv", 5) < 0.4);
    CHECK(left_of_error(folder, "trmv-paper", 5) < 0.55);
    Folder const parts;
    CHECK(trace("--scene room --size 48x32 --frames 1 --quiet --effects shadow,glossy,indirect --out '" + parts.path.string() + "'").code ==
          0);
    check_refused(denoise(input(parts) + output(parts) + "--quiet --preset asvgf"), {"frame.0000.exr", "R"});
}

TEST_CASE("asvgf runs on what quell-trace writes for it: the same frames, and their gradients") {
    Folder const folder, plain;
    CHECK(trace("--scene room --size 48x32 --frames 3 --quiet --effects composite,gradient --out '" + folder.path.string() + "'").code ==
          0);
    CHECK(trace("--scene room --size 48x32 --frames 3 --quiet --out '" + plain.path.string() + "'").code == 0);
    auto const frame = io::read_exr(folder / "frame.0002.exr");
    CHECK(frame["G"].values == io::read_exr(plain / "frame.0002.exr")["G"].values);
    auto const shaded = [](io::Plane const& larger) { return std::ranges::count_if(larger.values, [](float a) { return a > 0; }); };
    CHECK(shaded(io::read_exr(folder / "frame.0000.exr")["radiance_gradient.Y"]) == 0); // nothing before it
    CHECK(shaded(frame["radiance_gradient.Y"]) > 48 * 32 / 18);                         // of a pixel in nine, those that were seen before
    CHECK(denoise(input(folder) + output(folder) + "--preset asvgf").code == 0);
}

TEST_CASE("the presets of motion blur lessen the error of what quell-trace writes for it") {
    Folder const folder;
    trace_with_last_reference(folder, "spheres", 4, "blur,shadow,glossy,indirect");
    for (std::string const preset : {"blur", "blur-straight", "blur-bent", "blur-one-step", "blur-split"})
        CHECK(left_of_error(folder, preset, 3) < 0.3);
    CHECK(left_of_error(folder, "blur-wavelet", 3) < 0.45);
    CHECK(left_of_error(folder, "blur-fixed-step", 3) < 0.6);
    // What the paper's own steps lose in pictures as small as this is more than the noise.
    for (std::string const preset : {"blur-paper", "blur-no-pre-filter"}) {
        auto const left = left_of_error(folder, preset, 3);
        CHECK(left != 1);
        CHECK(left < 2);
    }
}

TEST_CASE("frames that repeat, noise and all, come out closer to the truth than they went in") {
    Folder const folder;
    CHECK(trace("--scene room --size 48x32 --frames 1 --quiet --reference 512 --out '" + folder.path.string() + "'").code == 0);
    for (int i = 1; i < 4; ++i) std::filesystem::copy_file(folder / "frame.0000.exr", folder / numbered("frame.", i));
    auto const in = product_of(io::read_exr(folder / "frame.0000.exr"), {""});
    auto const wanted = product_of(io::read_exr(folder / "reference.0000.exr"), {""});
    for (std::string const preset : {"svgf", "general", "final-frame"}) {
        CHECK(denoise(input(folder) + output(folder, preset + ".") + "--preset " + preset).code == 0);
        for (int i = 0; i < 4; ++i) {
            INFO(preset, " ", i);
            auto const out = product_of(io::read_exr(folder / numbered(preset + ".", i)), {""});
            CHECK(error_of(out, wanted) < 0.85 * error_of(in, wanted));
        }
    }
}

TEST_CASE("how long the shutter is open is known from the files, or as the command line says") {
    Folder const folder;
    REQUIRE(
        trace("--scene mixed --size 48x32 --first 24 --frames 3 --quiet --effects blur --shutter 0.9 --out '" + folder.path.string() + "'")
            .code == 0);
    auto const last = [&](std::string const& name, std::string const& options) {
        auto const ran = denoise(input(folder) + output(folder, name + ".") + "--preset blur " + options);
        INFO(ran.err);
        REQUIRE(ran.code == 0);
        return io::read_exr(folder / (name + ".0026.exr"))["R"].values;
    };
    auto const own = last("own", "");
    CHECK(last("same", "--shutter 0.9") == own);
    CHECK(last("other", "--shutter 0.4") != own);
    check_refused(denoise(input(folder) + output(folder) + "--preset blur --shutter nan"), {"--shutter", "nan"});
    check_refused(denoise(input(folder) + output(folder) + "--preset blur --shutter -1"), {"--shutter", "-1"});
}

TEST_CASE("with references there is a table") {
    Folder const folder;
    write_sequence(folder, 1, 4);
    for (int const i : {2, 4}) io::write_exr(folder / numbered("ref.", i), noisy_image({48, 32}, i));
    auto const reference = "--reference '" + (folder / "ref.%04d.exr").string() + "' ";
    auto const lines = denoise(input(folder) + "--preset none " + reference).lines();
    auto const perfect = perfect_scores();
    CHECK(lines == std::vector<std::string>{scores_header, "2" + perfect, "4" + perfect, "mean" + perfect});
    CHECK(denoise(input(folder) + "--preset svgf " + reference + output(folder)).lines().size() == 4);
    CHECK(readable(folder / "out.0003.exr"));
    io::write_exr(folder / "ref.0004.exr", noisy_image({32, 32}, 4));
    auto const ran = denoise(input(folder) + "--preset none --quiet " + reference);
    check_refused(ran, {"ref.0004.exr", "32x32", "48x32"});
    CHECK(ran.lines().size() == 2); // the header and the frame before it
}

TEST_CASE("a gap, a broken frame or another size stops a sequence with the frames before it whole") {
    Folder const folder;
    auto const stopped_at_4 = [&](std::initializer_list<std::string> parts) {
        for (int i = 1; i <= 6; ++i) std::filesystem::remove(folder / numbered("out.", i));
        auto const ran = denoise(input(folder) + output(folder) + "--quiet");
        check_refused(ran, parts);
        for (int i = 1; i <= 3; ++i) CHECK(readable(folder / numbered("out.", i)));
        CHECK_FALSE(std::filesystem::exists(folder / "out.0004.exr"));
        CHECK_FALSE(std::filesystem::exists(folder / "out.0005.exr"));
        for (auto const& entry : std::filesystem::directory_iterator(folder.path)) CHECK(entry.path().extension() != ".partial");
    };
    write_sequence(folder, 1, 6);
    auto const whole = bytes_of(folder / "frame.0004.exr");
    std::filesystem::remove(folder / "frame.0004.exr");
    stopped_at_4({"frame.0004.exr", "no such file"});
    write_bytes(folder / "frame.0004.exr", whole.substr(0, whole.size() / 2));
    stopped_at_4({"frame.0004.exr", "truncated"});
    write_bytes(folder / "frame.0004.exr", "no picture");
    stopped_at_4({"frame.0004.exr", "isn't an EXR file"});
    io::write_exr(folder / "frame.0004.exr", noisy_image({32, 48}, 4));
    stopped_at_4({"frame.0004.exr", "32x48", "48x32"});
    auto lacking = noisy_image({48, 32}, 4);
    std::erase_if(lacking.planes, [](auto const& p) { return p.name == "motion.Y"; });
    io::write_exr(folder / "frame.0004.exr", lacking);
    stopped_at_4({"frame.0004.exr", "motion.Y", "motion.X"});
}

TEST_CASE("without --preset quell-denoise takes what suits the files' channels, and says so") {
    Folder const folder;
    write_sequence(folder, 1, 3);
    auto const plain = denoise(input(folder) + output(folder));
    CHECK(contains(plain.err, "preset final-frame, since the files have colour and guides"));
    auto const said = denoise(input(folder) + output(folder, "said.") + "--preset final-frame");
    CHECK_FALSE(contains(said.err, "since"));
    CHECK(bytes_of(folder / "out.0002.exr") == bytes_of(folder / "said.0002.exr"));
    auto const made = [&](std::string const& effects) {
        auto const to = folder / effects;
        CHECK(trace("--scene room --size 48x32 --frames 1 --quiet --effects " + effects + " --out '" + to.string() + "'").code == 0);
        return denoise("--in '" + (to / "frame.%04d.exr").string() + "' --out '" + (to / "out.%04d.exr").string() + "'").err;
    };
    CHECK(contains(made("blur"), "preset blur, since"));
    CHECK(contains(made("shadow,glossy,indirect"), "preset trmv, since"));
    CHECK(contains(made("composite,shadow,glossy,indirect"), "preset trmv, since"));
    // What trmv reads, but no camera, without which it can't follow any of it.
    auto image = io::read_exr(folder / "composite,shadow,glossy,indirect" / "frame.0000.exr");
    std::erase_if(image.attributes, [](auto const& each) { return each.first.starts_with("quell:view"); });
    io::write_exr(folder / "blind.0001.exr", image);
    auto const blind = denoise("--in '" + (folder / "blind.%04d.exr").string() + "' " + output(folder, "blind-out."));
    CHECK(blind.code == 0);
    CHECK(contains(blind.err, "preset final-frame, since"));
}

TEST_CASE("--plan shows the passes of a preset, named or suited to the files, and denoises nothing") {
    auto const svgf = denoise("--plan --preset svgf");
    CHECK(svgf.code == 0);
    CHECK(contains(svgf.out, "| temporal | signal, motion, depth, normal | signal, luminance_mean"));
    CHECK(contains(svgf.out, "bytes a pixel"));
    Folder const folder;
    write_sequence(folder, 1, 2);
    auto const best = denoise("--plan " + input(folder)), quick = denoise("--plan --quick " + input(folder));
    for (char const* const all : {"final-frame", "| mix by evidence |", "| residual feedback |", "| repeated residual |"})
        CHECK(contains(best.out, all));
    CHECK(contains(quick.out, "final-frame"));
    CHECK_FALSE(contains(quick.out, "residual"));
    CHECK(contains(denoise("--plan").err, "neither --preset nor --in is there"));
}

TEST_CASE("--stages names what is done behind a preset, in place of the preset's own") {
    Folder const folder;
    write_sequence(folder, 1, 4);
    auto const made_with = [&](std::string const& more) {
        auto const ran = denoise(input(folder) + output(folder) + "--quiet " + more);
        INFO(ran.err);
        REQUIRE(ran.code == 0);
        return bytes_of(folder / "out.0004.exr");
    };
    auto const whole = made_with(""), quick = made_with("--quick"), evidence = made_with("--stages evidence");
    CHECK(made_with("--stages light,evidence,colours") == whole);
    CHECK(evidence != quick);
    CHECK(made_with("--preset svgf --stages evidence") != made_with("--preset svgf"));
    CHECK(contains(denoise("--plan --preset svgf --stages evidence").out, "| mix by evidence |"));
    auto const to = input(folder) + output(folder);
    check_refused(denoise(to + "--stages light,resolve"), {"--stages", "'resolve'", "evidence, light, colours"});
    check_refused(denoise(to + "--stages light --quick"), {"--stages", "--quick"});
    check_refused(denoise(to + "--stages light --preset none"), {"--stages", "preset none", "general"});
}

TEST_CASE("frames from after are used by general, as many as there are and are asked for") {
    Folder const folder;
    write_sequence(folder, 1, 6);
    auto const with = [&](std::string const& name, std::string const& more) {
        auto const ran = denoise(input(folder) + output(folder, name) + "--quiet " + more);
        INFO(ran.err);
        CHECK(ran.code == 0);
    };
    with("none.", "--extra-frames 0");
    with("two.", "");
    with("same.", "--extra-frames 2 --threads 1");
    with("job.", "--first 1 --last 3");
    CHECK(bytes_of(folder / "none.0004.exr") != bytes_of(folder / "two.0004.exr"));
    CHECK(noise_of(io::read_exr(folder / "two.0001.exr")) < noise_of(io::read_exr(folder / "none.0001.exr")));
    for (int i = 1; i <= 6; ++i) CHECK(bytes_of(folder / numbered("two.", i)) == bytes_of(folder / numbered("same.", i)));
    // Frames beyond --last count as well, so that a shot may be split.
    CHECK(bytes_of(folder / "two.0003.exr") == bytes_of(folder / "job.0003.exr"));
    // The last has none after it, and a history that was made without. Only what the picture before lacks tells of frames after that one.
    with("two_quick.", "--quick"), with("none_quick.", "--quick --extra-frames 0");
    CHECK(bytes_of(folder / "two_quick.0006.exr") == bytes_of(folder / "none_quick.0006.exr"));
    check_refused(denoise(input(folder) + output(folder) + "--preset svgf --extra-frames 1"), {"--extra-frames", "svgf", "final-frame"});
    for (std::string const count : {"-1", "9"})
        check_refused(denoise(input(folder) + output(folder) + "--extra-frames " + count), {"--extra-frames", count, "0 to 8"});
    check_refused(denoise(input(folder) + output(folder) + "--preset general --extra-frames 1 --debug-view clamp"), {"--extra-frames"});
}

TEST_CASE("the picture of the frame after takes part in a frame's, and is no part of what is told of it") {
    Folder const folder;
    write_sequence(folder, 1, 5);
    auto const with = [&](std::string const& name, std::string const& more) {
        auto const ran = denoise(input(folder) + output(folder, name) + "--quiet " + more);
        INFO(ran.err);
        REQUIRE(ran.code == 0);
        return ran.out;
    };
    with("whole.", "--threads 1");
    with("job.", "--threads 2 --first 2 --last 3");
    with("list.", "--frames 1,3,5");
    for (int const i : {2, 3}) CHECK(bytes_of(folder / numbered("job.", i)) == bytes_of(folder / numbered("whole.", i)));
    for (int const i : {1, 3, 5}) CHECK(bytes_of(folder / numbered("list.", i)) == bytes_of(folder / numbered("whole.", i)));
    auto lacking = noisy_image({48, 32}, 4);
    std::ranges::find(lacking.planes, "G", &io::Plane::name)->values[100] = std::numeric_limits<float>::quiet_NaN();
    io::write_exr(folder / "frame.0004.exr", lacking);
    CHECK(nlohmann::json::parse(with("lacking.", "--json --last 3")).at("missing_samples") == 0);
    CHECK(nlohmann::json::parse(with("lacking.", "--json --last 4")).at("missing_samples") == 1);
    // A frame that can't be used is as good as none, until it is its turn.
    write_bytes(folder / "frame.0004.exr", "broken");
    with("broken.", "--last 3");
    check_refused(denoise(input(folder) + output(folder, "no.") + "--quiet --last 4"), {"frame.0004.exr", "isn't an EXR file"});
    CHECK(bytes_of(folder / "no.0003.exr") == bytes_of(folder / "broken.0003.exr"));
    std::filesystem::remove(folder / "frame.0004.exr");
    with("none.", "--last 3");
    CHECK(bytes_of(folder / "none.0003.exr") == bytes_of(folder / "broken.0003.exr"));
    CHECK(bytes_of(folder / "none.0003.exr") != bytes_of(folder / "whole.0003.exr"));
}

TEST_CASE("first and last choose frames") {
    Folder const folder;
    write_sequence(folder, 1, 6);
    CHECK(denoise(input(folder) + output(folder) + "--first 2 --last 4").code == 0);
    for (int i = 1; i <= 6; ++i) CHECK(std::filesystem::exists(folder / numbered("out.", i)) == (i >= 2 && i <= 4));
    check_refused(denoise(input(folder) + output(folder) + "--last 7"), {"frame.0007.exr", "no such file"});
    CHECK(std::filesystem::exists(folder / "out.0006.exr"));
}

TEST_CASE("a shot in two jobs with warm-up is the shot in one") {
    Folder const folder;
    write_sequence(folder, 1, 12);
    auto const at = input(folder) + "--quiet --preset svgf ";
    CHECK(denoise(at + output(folder, "straight.")).code == 0);
    CHECK(denoise(at + output(folder, "split.") + "--last 6").code == 0);
    // From the first frame on: the same history, hence the same bits.
    CHECK(denoise(at + output(folder, "split.") + "--first 7 --warmup 6").code == 0);
    for (int i = 1; i <= 12; ++i) CHECK(bytes_of(folder / numbered("split.", i)) == bytes_of(folder / numbered("straight.", i)));
    // There is nothing before the first frame to warm up with.
    CHECK(denoise(at + output(folder, "more.") + "--first 2 --last 2 --warmup 100").code == 0);
    CHECK(bytes_of(folder / "more.0002.exr") == bytes_of(folder / "straight.0002.exr"));
    CHECK_FALSE(std::filesystem::exists(folder / "more.0001.exr"));
}

TEST_CASE("the number of threads makes no difference") {
    Folder const folder;
    write_sequence(folder, 1, 3, {300, 70});
    CHECK(denoise(input(folder) + output(folder, "one.") + "--threads 1").code == 0);
    CHECK(denoise(input(folder) + output(folder, "three.") + "--threads 3").code == 0);
    CHECK(bytes_of(folder / "one.0003.exr") == bytes_of(folder / "three.0003.exr"));
}

TEST_CASE("samples that are not finite are counted and don't come out") {
    Folder const folder;
    for (int i = 1; i <= 3; ++i) {
        auto image = noisy_image({48, 32}, i);
        image.planes[0].values[100] = std::nanf("");
        image.planes[1].values[700] = std::numeric_limits<float>::infinity();
        for (std::size_t c = 0; c < 3; ++c) image.planes[c].values[900] = -1.f; // of negative luminance
        io::write_exr(folder / numbered("frame.", i), image);
    }
    for (auto const& preset : image_presets()) {
        INFO(preset);
        auto const ran = denoise(input(folder) + output(folder) + "--preset " + preset);
        CHECK(contains(ran.err, "; 9 samples were missing"));
        auto const out = io::read_exr(folder / "out.0003.exr");
        for (auto const* const name : {"R", "G", "B"})
            CHECK(std::ranges::all_of(out[name].values, [](float a) { return std::isfinite(a) && a >= 0.f; }));
    }
}

TEST_CASE("a good sequence is diagnosed without findings, and findings name their first frame once") {
    Folder const folder;
    write_sequence(folder, 1, 4);
    auto const good = denoise(input(folder) + output(folder) + "--diagnose");
    CHECK(good.code == 0);
    CHECK(contains(good.err, "--diagnose found nothing wrong"));
    auto const files = folder.files();
    auto const alone = denoise(input(folder) + "--diagnose");
    CHECK(alone.code == 0);
    CHECK(contains(alone.err, "--diagnose found nothing wrong"));
    CHECK(folder.files() == files);
    for (int i = 3; i <= 4; ++i) {
        auto image = noisy_image({48, 32}, i);
        for (auto& plane : image.planes)
            if (plane.name == "normal.X" || plane.name == "normal.Y") plane.values.assign(plane.values.size(), 0.5f);
        io::write_exr(folder / numbered("frame.", i), image);
    }
    auto const bad = denoise(input(folder) + output(folder) + "--diagnose --quiet");
    INFO(bad.err);
    CHECK(bad.code == 0);
    CHECK(std::ranges::count(bad.err, '\n') == 2);
    CHECK(contains(bad.err, "frame 2: not checked: frame.camera is not set"));
    CHECK(contains(bad.err, "frame 3: normals are packed into [0, 1]: "));
    CHECK(contains(bad.err, "2 n - 1"));
    CHECK(denoise(input(folder) + output(folder) + "--quiet").err.empty());
}

TEST_CASE("a finding about files says what to change in --map") {
    Folder const folder;
    for (int i = 1; i <= 2; ++i) {
        auto image = noisy_image({48, 32}, i);
        for (auto& plane : image.planes)
            if (plane.name == "depth.Z" || plane.name.starts_with("normal."))
                std::fill_n(plane.values.begin(), 48 * 12, plane.name == "depth.Z" ? 1e9f : 0.f);
        io::write_exr(folder / numbered("frame.", i), image);
    }
    auto const ran = denoise(input(folder) + output(folder) + "--diagnose --quiet");
    INFO(ran.err);
    CHECK(contains(ran.err, "frame 1: depth is finite where there is no surface: "));
    CHECK(contains(ran.err, "for files, set \"miss_from\" in --map"));
    write_bytes(folder / "map.json", R"({"miss_from": 1e8})");
    auto const mapped = denoise(input(folder) + output(folder) + "--diagnose --map '" + (folder / "map.json").string() + "'");
    CHECK(contains(mapped.err, "--diagnose found nothing wrong"));
}

TEST_CASE("debug views are written beside the output") {
    Folder const folder;
    write_sequence(folder, 1, 3);
    auto const at = input(folder) + output(folder) + "--quiet ";
    CHECK(denoise(at + "--preset surface-clamp --debug-view history_length,motion_source,rejection,clamp").code == 0);
    auto const lengths = io::read_exr(folder / "out.0003.history_length.exr")["Y"].values;
    CHECK(lengths[16 * 48 + 20] == 3.f);
    CHECK(lengths[16 * 48] < 3.f); // was outside of the picture
    CHECK(io::read_exr(folder / "out.0003.motion_source.exr")["Y"].values[16 * 48 + 20] == 1.f);
    for (auto const* const view : {"history_length", "motion_source", "rejection", "clamp"}) {
        CHECK(std::filesystem::exists(folder / (std::string("out.0001.") + view + ".png")));
        CHECK(std::filesystem::exists(folder / (std::string("out.0001.") + view + ".exr")));
    }
    check_refused(denoise(at + "--debug-view depth"), {"--debug-view", "'depth'", "rejection"});
    check_refused(denoise(at + "--preset atrous --debug-view clamp"), {"--debug-view", "'atrous'", "svgf"});
}

TEST_CASE("a debug view that the preset has not is refused before anything is written") {
    Folder const folder;
    write_sequence(folder, 1, 2);
    for (std::string const preset : {"surface", "svgf"})
        check_refused(denoise(input(folder) + output(folder) + "--preset " + preset + " --debug-view history_length,clamp"),
                      {"--debug-view", "'" + preset + "' has no clamp", "a preset that clamps"});
    check_refused(denoise(input(folder) + output(folder) + "--preset trmv --debug-view rejection"), {"--debug-view", "'trmv'", "shadow"});
    CHECK(folder.files() == 2);
}

TEST_CASE("debug views of frames whose names have no ending keep their numbers") {
    Folder const folder;
    write_sequence(folder, 1, 2);
    CHECK(denoise(input(folder) + "--out '" + (folder / "out.%04d").string() + "' --quiet --preset surface --debug-view history_length")
              .code == 0);
    for (auto const* const name : {"out.0001", "out.0002"}) {
        CHECK(std::filesystem::exists(folder / name));
        CHECK(std::filesystem::exists(folder / (std::string(name) + ".history_length.exr")));
        CHECK(std::filesystem::exists(folder / (std::string(name) + ".history_length.png")));
    }
}

TEST_CASE("asvgf has its gradients by a map") {
    Folder const folder;
    write_sequence(folder, 1, 2);
    write_bytes(folder / "map.json", R"({"channels": {"radiance_gradient": 0}})");
    auto const ran = denoise(input(folder) + output(folder) + "--preset asvgf --map '" + (folder / "map.json").string() + "'");
    INFO(ran.err);
    CHECK(ran.code == 0);
    CHECK(readable(folder / "out.0002.exr"));
}

TEST_CASE("products that are too large for a float are missing, not infinite") {
    Folder const folder;
    auto image = noisy_image({48, 32}, 1);
    for (auto& plane : image.planes) {
        plane.type = io::SampleType::float32;
        if (plane.name == "R" || plane.name == "G" || plane.name == "B") plane.values[100] = 1e15f;
        if (plane.name.starts_with("albedo")) plane.values[100] = 1e30f;
    }
    io::write_exr(folder / "frame.0001.exr", image);
    write_bytes(folder / "map.json", R"({"signals": [{"irradiance": "", "albedo": "albedo"}]})");
    auto const ran = denoise(input(folder) + output(folder) + "--preset none --map '" + (folder / "map.json").string() + "'");
    INFO(ran.err);
    CHECK(ran.code == 0);
    CHECK(contains(ran.err, "quell-denoise: 1 frame of "));
    CHECK(contains(ran.err, "; 1 sample was missing"));
    CHECK(std::abs(io::read_exr(folder / "out.0001.exr")["R"].values[100]) < 100.f);
}

TEST_CASE("another renderer's files by a map are denoised as quell's own") {
    Folder const folder;
    write_sequence(folder, 1, 3);
    for (int i = 1; i <= 3; ++i) {
        auto image = noisy_image({48, 32}, i);
        std::erase_if(image.planes, [](auto const& p) { return p.name.starts_with("normal"); }); // it has none
        for (auto& plane : image.planes) {
            if (plane.name == "motion.X")
                plane.name = "speed.u";
            else if (plane.name == "motion.Y")
                plane.name = "speed.v";
            else if (plane.name == "depth.Z")
                plane.name = "Z";
            else
                plane.name = plane.name.starts_with("albedo.") ? "paint" + plane.name.substr(6) : "beauty." + plane.name;
            if (plane.name.starts_with("speed"))
                for (auto& value : plane.values) value = -value / 48.f;
        }
        io::write_exr(folder / numbered("other.", i), image);
    }
    write_bytes(folder / "map.json", R"({"channels": {"depth": "Z", "normal": [0, 0, 1], "motion": ["speed.u", "speed.v"]},
                                         "motion": {"points": "from_previous", "unit": "uv"},
                                         "signals": [{"radiance": "beauty", "albedo": "paint"}]})");
    CHECK(denoise(input(folder) + output(folder, "own.")).code == 0);
    auto const ran = denoise("--in '" + (folder / "other.%04d.exr").string() + "' " + output(folder, "mapped.") + "--map '" +
                             (folder / "map.json").string() + "'");
    INFO(ran.err);
    CHECK(ran.code == 0);
    CHECK(contains(ran.err, " of " + (folder / "other.%04d.exr").string() + "; 0 samples were missing"));
    auto const own = io::read_exr(folder / "own.0003.exr"), mapped = io::read_exr(folder / "mapped.0003.exr");
    double worst = 0;
    for (std::size_t i = 0; i < own.pixels(); ++i)
        worst = std::max(worst, std::abs(static_cast<double>(own["R"].values[i]) - static_cast<double>(mapped["beauty.R"].values[i])));
    CHECK(worst < 1e-3);
    check_refused(denoise("--in '" + (folder / "other.%04d.exr").string() + "' " + output(folder)),
                  {"other.0001.exr", "channel map", "beauty.R"});
}

TEST_CASE("svgf at least halves the FLIP of the Cycles sequence, and general leaves less still" * doctest::test_suite("shared data")) {
    auto const folder = shared("data/sequences/cycles_occlusion");
    if (folder.empty()) return;
    auto const flip = [&](std::string const& preset) {
        auto const lines = denoise("--in '" + (folder / "frame_%04d.exr").string() + "' --reference '" +
                                   (folder / "reference_%04d.exr").string() + "' --preset " + preset)
                               .lines();
        REQUIRE(lines.size() == 4);
        CHECK(lines[0] == scores_header);
        CHECK(lines[1].starts_with("40,"));
        CHECK(lines[3].starts_with("mean,"));
        return score_in(lines[3], "flip");
    };
    auto const noisy = flip("none"), clean = flip("svgf"), best = flip("general");
    MESSAGE("FLIP of the Cycles sequence: none ", noisy, ", svgf ", clean, ", general ", best);
    CHECK(clean <= 0.5 * noisy);
    CHECK(best <= 0.85 * clean);
}

TEST_CASE("the preset accumulated writes guides beside its light, for a denoiser behind it") {
    Folder const folder;
    REQUIRE(trace("--scene room --size 48x32 --frames 4 --quiet --out '" + folder.path.string() + "'").code == 0);
    auto const layers = std::array<std::string, 2>{"mean_albedo.R", "mean_normal.Z"};
    auto const run = [&](std::string const& name, std::string const& options) {
        auto const ran = denoise(input(folder) + output(folder, name + ".") + options);
        INFO(ran.err);
        REQUIRE(ran.code == 0);
    };
    run("light", "--preset accumulated");
    auto const first = io::read_exr(folder / "light.0000.exr"), last = io::read_exr(folder / "light.0003.exr");
    // Of one frame the means are that frame's guides.
    for (auto const& [mean, own] : {std::pair{"mean_albedo.G", "albedo.G"}, {"mean_normal.X", "normal.X"}, {"mean_normal.Y", "normal.Y"}})
        for (std::size_t i = 0; i < first.pixels(); ++i)
            REQUIRE(first[mean].values[i] == doctest::Approx(first[own].values[i]).epsilon(0.002));
    double change = 0;
    for (std::size_t i = 0; i < last.pixels(); ++i)
        change += static_cast<double>(std::abs(last["mean_normal.X"].values[i] - last["normal.X"].values[i]));
    CHECK(change > 0); // the camera moves

    run("picture", "--preset accumulated --layers picture");
    run("guides", "--preset accumulated --layers guides");
    run("none", "--preset none");
    for (auto const& layer : layers) {
        CHECK(last.find(layer));
        CHECK(io::read_exr(folder / "guides.0003.exr").find(layer));
        CHECK(!io::read_exr(folder / "picture.0003.exr").find(layer));
        CHECK(!io::read_exr(folder / "none.0003.exr").find(layer));
    }
    CHECK(!io::read_exr(folder / "guides.0003.exr").find("R"));
}

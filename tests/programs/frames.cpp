#include "../frames.hpp"
#include "programs.hpp"

#include <denoise/frame_list.hpp>
#include <denoise/presets.hpp>

#include <quell/io/frame_image.hpp>
#include <quell/metrics/flip.hpp>
#include <quell/presets/general.hpp>

#include <nlohmann/json.hpp>

#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace quell;
using namespace quell::tests;
using examples::frames_in;
using examples::part_of;
using examples::Step;
using examples::steps_for;

namespace {

using Numbers = std::vector<long long>;

metrics::Picture shown(std::filesystem::path const& file) {
    auto const image = io::read_exr(file);
    metrics::Picture picture{image.size, {}};
    for (std::size_t i = 0; i < image.pixels(); ++i)
        picture.pixels.emplace_back(image["R"].values[i], image["G"].values[i], image["B"].values[i]);
    return metrics::displayed(picture);
}

/// A program with its arguments, not waited for.
pid_t started(std::string const& program, std::vector<std::string> arguments) {
    std::vector<char*> list;
    arguments.insert(arguments.begin(), program);
    for (auto& argument : arguments) list.push_back(argument.data());
    list.push_back(nullptr);
    auto const child = fork();
    if (child == 0) {
        auto const nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, 1), dup2(nowhere, 2);
        execv(list[0], list.data());
        _exit(127);
    }
    return child;
}
/// The most memory that quell-denoise had for frames 1 to `last`, in MiB.
double resident(Folder const& folder, int last) {
    int status = 0;
    rusage usage{};
    auto const child = started(QUELL_DENOISE, {"--in", (folder / "frame.%04d.exr").string(), "--out", (folder / "out.%04d.exr").string(),
                                               "--quiet", "--threads", "1", "--frames", "1-" + std::to_string(last)});
    REQUIRE(wait4(child, &status, 0, &usage) == child);
    REQUIRE(status == 0);
    return static_cast<double>(usage.ru_maxrss) / 1024.;
}

} // namespace

TEST_CASE("lists of frames") {
    CHECK(frames_in("7") == Numbers{7});
    CHECK(frames_in("1-4,9") == Numbers{1, 2, 3, 4, 9});
    CHECK(frames_in("10-20x5,9,11-12") == Numbers{9, 10, 11, 12, 15, 20});
    CHECK(frames_in("-3--1,0,3-3") == Numbers{-3, -2, -1, 0, 3});
    CHECK(frames_in("4,1-5") == Numbers{1, 2, 3, 4, 5});
    for (std::string const bad : {"", ",", "1,", ",1", "a", "1-", "5-1", "1-5x0", "1-5x", "1 2", "1-5x2x2", "1.5", "99999999999999999999"})
        check_error([&] { static_cast<void>(frames_in(bad)); }, {"--frames", "'" + bad + "'", "1-48,60"});
    check_error([] { static_cast<void>(frames_in("1-2000000")); }, {"--frames", "'1-2000000'", "a million"});
}

TEST_CASE("chunks are parts in a row that have each frame once") {
    Numbers const frames = frames_in("1-10,20");
    for (long long const count : {1, 2, 3, 6, 11, 15}) {
        Numbers all;
        for (long long number = 1; number <= count; ++number) {
            auto const part = part_of(frames, {number, count});
            CHECK(static_cast<long long>(part.size()) >= 11 / count);
            CHECK(static_cast<long long>(part.size()) <= 11 / count + 1);
            all.insert(all.end(), part.begin(), part.end());
        }
        CHECK(all == frames);
    }
    CHECK(part_of(frames_in("1-48"), {2, 6}) == frames_in("9-16"));
    for (std::string const bad : {"7/6", "0/6", "1", "1/", "/6", "a/b", "1/6/2", "-1/6", ""})
        check_error([&] { static_cast<void>(examples::chunk_in(bad)); }, {"--chunk", "'" + bad + "'", "1/6 to 6/6"});
}

TEST_CASE("frames warm up before the first and before gaps, as far as there are any") {
    auto const there = frames_in("1-30");
    auto const numbers = [](std::vector<Step> const& steps) {
        std::string text;
        for (auto const& step : steps) text += (step.begins ? "|" : "") + std::to_string(step.number) + (step.is_written ? "w " : " ");
        return text;
    };
    CHECK(numbers(steps_for({5, 6}, {2, true}, there)) == "|3 4 5w 6w ");
    CHECK(numbers(steps_for({5, 6}, {0, false}, there)) == "|5w 6w ");
    CHECK(numbers(steps_for({2}, {5, true}, there)) == "|1 2w ");
    CHECK(numbers(steps_for({5, 9, 20}, {4, true}, there)) == "|1 2 3 4 5w 6 7 8 9w |16 17 18 19 20w ");
    CHECK(numbers(steps_for({5, 9}, {1, true}, there)) == "|4 5w |8 9w ");
    CHECK(numbers(steps_for({5, 9}, {4, true}, {1, 2, 4, 5, 8, 9})) == "|4 5w |8 9w ");
    CHECK(numbers(steps_for({5}, {4, false}, {1, 2, 4, 5})) == "|1 2 3 4 5w "); // they were asked for, and frame 3 is missed
    CHECK(steps_for({}, {4, true}, there).empty());
}

TEST_CASE("the warm-up of a preset follows from its history") {
    for (auto const* const name : {"none", "atrous", "gather-blur"}) CHECK(examples::preset_of(name).warm_up == 0);
    CHECK(examples::preset_of("final-frame").warm_up == 48); // twice its cap of 24
    CHECK(examples::preset_of("svgf").warm_up == 45);
    CHECK(examples::preset_of("surface-clamp").warm_up == 40);
    CHECK(examples::preset_of("trmv").warm_up == 216); // the longest of its parts
    for (auto const& preset : examples::presets()) CHECK(preset.warm_up <= 288);
}

TEST_CASE("a frame that could not be denoised is read anew") {
    auto const image = [](float light, float shutter) {
        constexpr auto denoise = presets::surface(radiance, Demodulate{});
        Frame frame{{24, 16}, denoise};
        fill_still(frame);
        fill(frame[radiance], [&](int x, int) { return glm::vec3(light + 0.01f * static_cast<float>(x)); });
        auto made = io::image_of(frame);
        made.attributes["quell:shutter"] = shutter;
        return made;
    };
    auto const& preset = examples::preset_of("surface");
    auto const denoiser = examples::denoiser_of(preset, {24, 16}, 1), fresh = examples::denoiser_of(preset, {24, 16}, 1);
    CHECK(contains(message([&] { static_cast<void>(denoiser->denoise(image(5, -1), {}, 0)); }), "shutter"));
    CHECK(denoiser->denoise(image(1, 0.5f), {}, 0).values == fresh->denoise(image(1, 0.5f), {}, 0).values);
}

TEST_CASE("chunks without --warmup make the frames of the whole run, to 0.1 % of FLIP") {
    Folder const folder;
    write_sequence(folder, 1, 90);
    auto const run = [&](std::string const& name, std::string const& more) {
        auto const ran = denoise(input(folder) + output(folder, name) + "--quiet --layers picture " + more);
        INFO(ran.err);
        REQUIRE(ran.code == 0);
    };
    run("whole.", "");
    for (int part = 1; part <= 6; ++part) run("part.", "--chunk " + std::to_string(part) + "/6");
    run("bare.", "--chunk 6/6 --warmup 0");
    double worst = 0, bare = 0;
    for (int i = 1; i <= 90; ++i) {
        auto const whole = shown(folder / numbered("whole.", i));
        worst = std::max(worst, metrics::flip(whole, shown(folder / numbered("part.", i))).mean());
        if (i > 75) bare = std::max(bare, metrics::flip(whole, shown(folder / numbered("bare.", i))).mean());
    }
    CHECK(worst < 0.001);
    CHECK(bare > 0.01); // the test would notice
    CHECK_FALSE(std::filesystem::exists(folder / "bare.0075.exr"));
}

TEST_CASE("a list of frames is written, and each frame is what the whole run makes of it") {
    Folder const folder;
    write_sequence(folder, 1, 12);
    auto const at = input(folder) + "--quiet --preset svgf ";
    REQUIRE(denoise(at + output(folder, "whole.")).code == 0);
    REQUIRE(denoise(at + output(folder, "list.") + "--frames 2-3,11").code == 0);
    CHECK(folder.files() == 12 + 12 + 3);
    for (int const i : {2, 3, 11}) CHECK(bytes_of(folder / numbered("list.", i)) == bytes_of(folder / numbered("whole.", i)));
    REQUIRE(denoise(at + output(folder, "list.") + "--frames 1-12 --chunk 1/40").code == 0); // nothing is in it
    CHECK(folder.files() == 12 + 12 + 3);
}

TEST_CASE("where nobody asked for warm-up, frames that can't be used for it are as good as none") {
    Folder const folder;
    write_sequence(folder, 1, 6);
    write_bytes(folder / "frame.0003.exr", "broken");
    io::write_exr(folder / "frame.0002.exr", noisy_image({32, 32}, 2));
    auto const at = input(folder) + "--quiet --preset svgf --first 5 ";
    REQUIRE(denoise(at + output(folder)).code == 0);
    REQUIRE(denoise(at + output(folder, "one.") + "--warmup 1").code == 0);
    CHECK(bytes_of(folder / "out.0006.exr") == bytes_of(folder / "one.0006.exr"));
    check_refused(denoise(at + output(folder) + "--warmup 3"), {"frame.0003.exr", "isn't an EXR file"});
}

TEST_CASE("--skip-existing leaves out what is there and whole") {
    Folder const folder;
    write_sequence(folder, 1, 6);
    auto const at = input(folder) + output(folder) + "--preset svgf --skip-existing ";
    REQUIRE(denoise(at + "--quiet").code == 0);
    std::vector<std::string> before(1);
    for (int i = 1; i <= 6; ++i) before.push_back(bytes_of(folder / numbered("out.", i)));
    std::filesystem::remove(folder / "out.0003.exr");
    write_bytes(folder / "out.0005.exr", before[5].substr(0, before[5].size() / 2));
    write_bytes(folder / "out.0006.exr", "");
    auto const old = std::filesystem::last_write_time(folder / "out.0004.exr");
    auto const ran = denoise(at);
    CHECK(ran.code == 0);
    CHECK(contains(ran.err, "3 skipped, since their output is there"));
    CHECK(contains(ran.err, "3 frames of quell"));
    CHECK(std::filesystem::last_write_time(folder / "out.0004.exr") == old);
    for (int i = 1; i <= 6; ++i) CHECK(bytes_of(folder / numbered("out.", i)) == before[static_cast<std::size_t>(i)]);
    CHECK(contains(denoise(at).err, "6 skipped"));
}

TEST_CASE("--json prints what was done as one object, where it failed too") {
    Folder const folder;
    write_sequence(folder, 1, 5);
    std::filesystem::copy_file(folder / "frame.0002.exr", folder / "ref.0002.exr");
    auto const at = input(folder) + output(folder) + "--json --quiet ";
    auto const json = [](Ran const& ran) { return nlohmann::json::parse(ran.out); };
    auto const good = json(denoise(at + "--preset svgf --frames 2-3 --reference '" + (folder / "ref.%04d.exr").string() + "'"));
    CHECK(good["preset"] == "svgf");
    CHECK(good["renderer"] == "quell");
    CHECK(good["written"] == Numbers{2, 3});
    CHECK(good["warm_up_frames"] == 1);
    CHECK(good["missing_samples"] == 0);
    CHECK(good["milliseconds"].get<double>() > 0);
    CHECK(good["bytes_per_pixel"].get<double>() > 0);
    CHECK(good["layout_changes"]["picture"].get<double>() > 0);
    CHECK(good["scores"].size() == 1);
    CHECK(good["scores"][0]["frame"] == 2);
    CHECK(good["mean"]["flip"] == good["scores"][0]["flip"]);
    CHECK_FALSE(good.contains("error"));
    auto const rest = json(denoise(at + "--skip-existing"));
    CHECK(rest["skipped"] == Numbers{2, 3});
    CHECK(rest["written"] == Numbers{1, 4, 5});
    write_bytes(folder / "frame.0004.exr", "broken");
    auto const ran = denoise(at + "--preset svgf");
    check_refused(ran, {"frame.0004.exr"});
    CHECK(json(ran)["written"] == Numbers{1, 2, 3});
    CHECK(contains(json(ran)["error"], "frame.0004.exr"));
    CHECK(contains(json(denoise(at + "--chunk 7/6"))["error"], "--chunk"));
}

TEST_CASE("bad lists, chunks and their like are refused before the first frame") {
    Folder const folder;
    write_sequence(folder, 1, 3);
    auto const both = input(folder) + output(folder) + "--quiet ";
    check_refused(denoise(both + "--frames 3-1"), {"--frames", "'3-1'"});
    check_refused(denoise(both + "--frames 1,,3"), {"--frames", "1,,3"});
    check_refused(denoise(both + "--frames 1-3 --first 2"), {"--frames", "--first or --last is there too"});
    check_refused(denoise(both + "--chunk 7/6"), {"--chunk", "'7/6'", "1/6 to 6/6"});
    check_refused(denoise(both + "--frames 8-9"), {"frame.0008.exr", "no such file"});
    check_refused(denoise(input(folder) + "--diagnose --skip-existing"), {"--skip-existing", "--out is missing"});
    CHECK(folder.files() == 3);
}

TEST_CASE("memory doesn't grow with the sequence") {
    Folder const folder;
    write_sequence(folder, 1, 60, {160, 90});
    auto const few = resident(folder, 10), many = resident(folder, 60);
    MESSAGE("resident set in MiB: 10 frames ", few, ", 60 frames ", many);
    CHECK(many < few + 12.); // 50 frames are 33 MiB, as the program has them
}

TEST_CASE("a run that is killed leaves whole frames, and another goes on behind them") {
    Folder const folder;
    write_sequence(folder, 1, 24, {160, 90});
    auto const child =
        started(QUELL_DENOISE, {"--in", (folder / "frame.%04d.exr").string(), "--out", (folder / "out.%04d.exr").string(), "--quiet"});
    while (!std::filesystem::exists(folder / "out.0003.exr")) usleep(1000);
    kill(child, SIGKILL);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFSIGNALED(status)); // it had not ended by itself
    int there = 0;
    for (int i = 1; i <= 24; ++i)
        if (auto const file = folder / numbered("out.", i); std::filesystem::exists(file)) {
            CHECK(io::read_exr(file)["R"].values.size() == 160 * 90);
            ++there;
        }
    CHECK(there < 24);
    REQUIRE(denoise(input(folder) + output(folder) + "--quiet --skip-existing").code == 0);
    REQUIRE(denoise(input(folder) + output(folder, "whole.") + "--quiet").code == 0);
    for (int i = 1; i <= 24; ++i) CHECK(bytes_of(folder / numbered("out.", i)) == bytes_of(folder / numbered("whole.", i)));
}

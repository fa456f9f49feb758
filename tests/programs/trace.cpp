#include "programs.hpp"

#include <set>

using namespace quell;
using namespace quell::tests;

namespace {
std::vector<std::string> channels_of(std::filesystem::path const& file) {
    std::vector<std::string> names;
    for (auto const& channel : io::ExrFile(file).channels) names.push_back(channel.name);
    return names;
}
std::string to(Folder const& folder) { return "--out '" + folder.path.string() + "' --size 24x16 "; }
using Names = std::vector<std::string>;
} // namespace

TEST_CASE("quell-trace writes what quell-denoise reads") {
    Folder const folder;
    auto const ran = trace(to(folder) + "--scene room --frames 3 --first 5 --reference 4");
    INFO(ran.err);
    CHECK(ran.code == 0);
    CHECK(contains(ran.out, "room: 3 frames of 24x16; rays: 1152 primary"));
    CHECK(folder.files() == 6);
    CHECK(channels_of(folder / "frame.0005.exr") ==
          Names{"B", "G", "R", "albedo.B", "albedo.G", "albedo.R", "depth.Z", "motion.X", "motion.Y", "normal.X", "normal.Y", "normal.Z"});
    CHECK(channels_of(folder / "reference.0007.exr") == Names{"B", "G", "R"});
    auto const done = denoise(input(folder) + output(folder) + "--reference '" + (folder / "reference.%04d.exr").string() + "'");
    CHECK(done.code == 0);
    CHECK(done.lines().size() == 5);
}

TEST_CASE("only the channels and the rays of the chosen effects") {
    Folder const folder;
    auto const ran = trace(to(folder) + "--frames 1 --effects shadow");
    CHECK(contains(ran.out, " 0 glossy, 0 indirect"));
    auto const shadow = channels_of(folder / "frame.0000.exr");
    for (auto const* const name : {"visibility.V", "direct.R", "light.X", "light_previous.Y", "blocker.Z", "blocker_previous.X",
                                   "receiver_previous.X", "depth.Z", "normal.X", "motion.X", "position.X"})
        CHECK(std::ranges::find(shadow, name) != shadow.end());
    for (auto const* const name : {"R", "albedo.R", "glossy.R", "indirect.R", "sweep.X", "time.T"})
        CHECK(std::ranges::find(shadow, name) == shadow.end());
    CHECK(trace(to(folder) + "--frames 1 --effects blur,indirect,glossy --reference 4").code == 0);
    auto const others = channels_of(folder / "frame.0000.exr"), converged = channels_of(folder / "reference.0000.exr");
    for (auto const* const name : {"R", "sweep.Y", "time.T", "indirect_direction.Z", "glossy_hit_previous.X", "roughness.R"})
        CHECK(std::ranges::find(others, name) != others.end());
    for (auto const* const name : {"R", "indirect.B", "albedo.G", "glossy.R"}) CHECK(std::ranges::find(converged, name) != converged.end());
    CHECK(std::ranges::find(others, "visibility.V") == others.end());
}

TEST_CASE("masks lie beside the frames, those of the chosen effects") {
    Folder const folder;
    auto const ran = trace(to(folder) + "--scene restaurant --first 30 --frames 1 --effects glossy --masks");
    INFO(ran.err);
    CHECK(ran.code == 0);
    CHECK(folder.files() == 3);
    CHECK(std::filesystem::exists(folder / "mask_glossy.0030.png"));
    CHECK(std::filesystem::exists(folder / "mask_curved.0030.png"));
    CHECK(trace(to(folder) + "--scene fence --frames 1 --effects shadow,indirect --masks").code == 0);
    CHECK(std::filesystem::exists(folder / "mask_shadow.0000.png"));
    CHECK(std::filesystem::exists(folder / "mask_indirect.0000.png"));
}

TEST_CASE("blur of a scene in which nothing is noisy but time") {
    Folder const folder;
    auto const ran = trace(to(folder) + "--scene spheres --first 32 --frames 1 --effects blur --shutter 0.5 --masks");
    INFO(ran.err);
    CHECK(ran.code == 0);
    CHECK(contains(ran.out, "384 primary, 0 shadow, 0 glossy, 0 indirect"));
    CHECK(std::filesystem::exists(folder / "mask_blur.0032.png"));
    auto const channels = channels_of(folder / "frame.0032.exr");
    for (auto const* const name :
         {"R", "G", "B", "depth.Z", "motion.X", "motion.Y", "sweep.X", "sweep.Y", "sweep_bend.X", "sweep_bend.Y", "time.T"})
        CHECK(std::ranges::find(channels, name) != channels.end());
}

TEST_CASE("any scene without secondary rays, and with straight motion") {
    Folder const folder;
    auto const run = [&](std::string const& more) {
        auto const ran = trace(to(folder) + "--frames 1 --first 20 --effects blur " + more);
        INFO(ran.err);
        CHECK(ran.code == 0);
        return ran.out;
    };
    CHECK_FALSE(contains(run("--scene room"), " 0 shadow"));
    CHECK(contains(run("--scene room --primary-only"), "384 primary, 0 shadow, 0 glossy, 0 indirect"));
    run("--scene propeller");
    auto const curved = bytes_of(folder / "frame.0020.exr");
    run("--scene propeller --shutter-keys 2");
    CHECK(bytes_of(folder / "frame.0020.exr") != curved);
    check_refused(trace(to(folder) + "--effects blur --shutter-keys 1"), {"--shutter-keys", "1", "2 to 129"});
}

TEST_CASE("the previous camera is the last frame's") {
    Folder const folder;
    CHECK(trace(to(folder) + "--scene temple --frames 2 --quiet").out.empty());
    auto const first = io::read_exr(folder / "frame.0000.exr"), second = io::read_exr(folder / "frame.0001.exr");
    REQUIRE(io::camera_of(first).has_value());
    CHECK(io::camera_of(second, "_previous") == io::camera_of(first));
    CHECK_FALSE(io::camera_of(second) == io::camera_of(first));
}

TEST_CASE("with jitter files are usable, and say where a frame's samples lie") {
    for (auto const* const jitter : {"none", "frame", "pixel"}) {
        INFO(jitter);
        Folder const folder;
        auto const ran = trace(to(folder) + "--scene room --frames 3 --first 5 --spp 2 --reference 4 --jitter " + jitter);
        INFO(ran.err);
        CHECK(ran.code == 0);
        bool const of_samples = jitter == std::string("pixel");
        CHECK(contains(ran.out, of_samples ? "rays: 2304 primary" : "rays: 1152 primary"));
        std::set<std::pair<float, float>> offsets;
        for (int i = 5; i < 8; ++i) {
            auto const image = io::read_exr(folder / numbered("frame.", i));
            auto const now = io::camera_of(image), then = io::camera_of(image, "_previous");
            REQUIRE((now && then));
            offsets.emplace(now->jitter.x, now->jitter.y);
            if (i > 5) CHECK(*then == *io::camera_of(io::read_exr(folder / numbered("frame.", i - 1))));
            CHECK(io::camera_of(io::read_exr(folder / numbered("reference.", i)))->jitter == now->jitter);
        }
        CHECK(offsets.size() == (jitter == std::string("frame") ? 3 : 1));
        if (jitter != std::string("frame")) CHECK(offsets.contains({0.f, 0.f}));
        auto const done =
            denoise(input(folder) + output(folder) + "--preset general --reference '" + (folder / "reference.%04d.exr").string() + "'");
        INFO(done.err);
        CHECK(done.code == 0);
        CHECK(done.lines().size() == 5);
    }
    Folder const folder;
    check_refused(trace(to(folder) + "--jitter halton"), {"--jitter", "halton", "none,frame,pixel"});
    CHECK(folder.files() == 0);
}

TEST_CASE("jitter of the samples goes with every effect, an open shutter and gradients") {
    Folder const folder;
    for (auto const* const more : {"--effects shadow,glossy,indirect", "--effects blur", "--effects gradient"})
        for (auto const* const jitter : {"frame", "pixel"}) {
            auto const ran = trace(to(folder) + "--frames 2 --reference 4 " + more + " --jitter " + jitter);
            INFO(ran.err);
            CHECK(ran.code == 0);
        }
}

TEST_CASE("the same seed and any number of threads give the same files, another seed other noise") {
    Folder const folder;
    auto const run = [&](std::string const& more) {
        CHECK(trace(to(folder) + "--frames 1 " + more).code == 0);
        return bytes_of(folder / "frame.0000.exr");
    };
    auto const one = run("--threads 1");
    CHECK(run("--threads 3") == one);
    CHECK(run("--threads 3 --jitter none") == one);
    CHECK(run("--threads 1 --jitter pixel") == run("--threads 3 --jitter pixel"));
    CHECK(run("--seed 9") != one);
}

TEST_CASE("several scenes get a folder each") {
    Folder const folder;
    CHECK(trace(to(folder) + "--frames 1 --scene room --scene boxes --quiet").code == 0);
    CHECK(std::filesystem::exists(folder / "room/frame.0000.exr"));
    CHECK(std::filesystem::exists(folder / "boxes/frame.0000.exr"));
}

TEST_CASE("a glTF file with a camera of one's own" * doctest::test_suite("shared data")) {
    auto const scene = shared("data/scenes/cornell_box/cornell_bevy.glb");
    if (scene.empty()) return;
    Folder const folder;
    auto const ran =
        trace(to(folder) + "--frames 1 --scene '" + scene.string() + "' --eye 0,1,-4 --target 0,1,0 --fov 40 --orbit 2 --dolly -0.1,0,0");
    INFO(ran.err);
    CHECK(ran.code == 0);
    CHECK(std::filesystem::exists(folder / "frame.0000.exr"));
}

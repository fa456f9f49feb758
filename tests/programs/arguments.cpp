#include "programs.hpp"

#include <baselines/named.hpp>

#include <OpenEXR/ImfTiledOutputFile.h>

using namespace quell;
using namespace quell::tests;

namespace {

/// Writes an image as tiles of several levels; all but the largest are 0.
void write_levels(std::filesystem::path const& path, io::ExrImage const& image, Imf::LevelMode mode) {
    Imf::Header header(image.size.width, image.size.height);
    header.setTileDescription({16, 16, mode});
    for (auto const& each : image.planes) header.channels().insert(each.name, Imf::Channel(Imf::FLOAT));
    Imf::TiledOutputFile file(path.string().c_str(), header);
    std::vector<float> const zeros(image.pixels(), 0.f);
    for (int x = 0; x < file.numXLevels(); ++x)
        for (int y = 0; y < file.numYLevels(); ++y) {
            if (!file.isValidLevel(x, y)) continue;
            Imf::FrameBuffer buffer;
            for (auto const& each : image.planes)
                buffer.insert(each.name,
                              Imf::Slice::Make(Imf::FLOAT, (x == 0 && y == 0 ? each.values : zeros).data(), file.dataWindowForLevel(x, y)));
            file.setFrameBuffer(buffer);
            file.writeTiles(0, file.numXTiles(x) - 1, 0, file.numYTiles(y) - 1, x, y);
        }
}

} // namespace

TEST_CASE("help and lists end well") {
    CHECK(denoise("--help").code == 0);
    CHECK(contains(denoise("--help").out, "--warmup"));
    std::vector<std::string> names;
    for_each_preset(all_presets, [&](auto const& preset) { names.emplace_back(preset.name); });
    CHECK(denoise("--list").lines() == names);
    for (auto const* const group : {"general: none, surface", "effects: shadow, ", "blur: blur, ", "published: asvgf, "})
        CHECK(contains(denoise("--help").out, group));
    CHECK(trace("--help").code == 0);
    CHECK(trace("--list").code == 0);
    CHECK(contains(trace("--list").out, "room\n"));
}

TEST_CASE("every preset has its row in the documentation") {
    auto const page = bytes_of(QUELL_ROOT "/docs/presets.md");
    for_each_preset(all_presets, [&](auto const& preset) {
        CAPTURE(preset.name);
        CHECK(contains(page, "`" + std::string(preset.name) + "`"));
    });
}

TEST_CASE("quell-denoise refuses what it can't use in one line") {
    Folder const folder;
    write_sequence(folder, 1, 3);
    auto const in = input(folder), both = in + output(folder);
    check_refused(denoise(""), {"--in is missing"});
    check_refused(denoise(in), {"none of --out, --reference and --diagnose"});
    check_refused(denoise(both + "--device tpu"), {"--device", "'tpu'", "cpu, cuda"});
#if !defined(QUELL_CUDA_CODE)
    check_refused(denoise(both + "--device cuda"), {"--device", "without CUDA", "QUELL_CUDA=ON"});
#endif
    check_refused(denoise(both + "--nonsense"), {"--nonsense", "--help"});
    check_refused(denoise(both + "--first x"), {"--first"});
    check_refused(denoise(both + "--preset best"), {"'best'", "none, surface, ", ", final-frame, "});
    check_refused(denoise(both + "--threads=-2"), {"--threads", "-2"});
    check_refused(denoise(both + "--threads=70000"), {"--threads", "70000"});
    check_refused(denoise(both + "--warmup=-1"), {"--warmup", "-1"});
    check_refused(denoise(both + "--first 3 --last 2"), {"the first is 3 and the last is 2", "1 to 3"});
    check_refused(denoise("--in frame.exr " + output(folder)), {"frame.exr", "%04d"});
    check_refused(denoise("--in '" + (folder / "g.%d.exr").string() + "' " + output(folder)), {"g.%d.exr", "no such file"});
    check_refused(denoise(in + output(folder, "frame.")), {"--out", "input's own files"});
    write_bytes(folder / "ref.2.exr", "x");
    auto const reference = (folder / "ref.%d.exr").string();
    check_refused(denoise(in + "--reference '" + reference + "' --out '" + reference + "'"), {"--out", "ref.1.exr", "the references"});
    std::filesystem::remove(folder / "ref.2.exr");
    check_refused(denoise(in + "--out '" + (folder / "frame.000%d.exr").string() + "'"), {"--out", "frame.0001.exr"});
    check_refused(denoise(in + "--out '/proc/quell/f.%d.exr'"), {"/proc/quell", "can't be made"});
    check_refused(denoise(in + "--out '" + (folder / "f.%d.PNG").string() + "'"), {"--out", "another format than EXR", ".exr"});
    check_refused(denoise(in + "--out '/proc/f.%d.exr'"), {"/proc", "no file can be written there"});
    check_refused(denoise(both + "--reference '" + (folder / "ref.%d.exr").string() + "'"), {"ref.%d.exr", "none for frames 1 to 3"});
    check_refused(denoise(both + "--map '" + (folder / "map.json").string() + "'"), {"map.json", "can't be read"});
    CHECK(folder.files() == 3);
}

TEST_CASE("quell-trace refuses what it can't use in one line") {
    Folder const folder;
    auto const out = "--out '" + (folder / "t").string() + "' ";
    check_refused(trace(""), {"--out is missing"});
    check_refused(trace(out + "--size 16"), {"--size", "1920x1080"});
    check_refused(trace(out + "--size 0x5"), {"--size", "'0x5'"});
    check_refused(trace(out + "--size 99999x99999"), {"--size", "'99999x99999'", "at most"});
    check_refused(trace("--out /proc"), {"/proc", "no file can be written there"});
    check_refused(trace(out + "--scene a/x.glb --scene b/x.glb"), {"--scene", "'a/x.glb' and 'b/x.glb'"});
    check_refused(trace(out + "--first 2147483647 --frames 2"), {"--first", "2147483647", "16777216"});
    check_refused(trace(out + "--first=-2147483648 --frames 2"), {"--first", "-16777216"});
    check_refused(trace(out + "--threads 70000"), {"--threads", "70000"});
    check_refused(trace(out + "--scene cellar"), {"cellar", "room"});
    check_refused(trace(out + "--scene cellar.gltf"), {"cellar.gltf", "no such file"});
    check_refused(trace(out + "--effects shadow,smoke"), {"--effects", "smoke", "shadow,glossy,indirect,blur"});
    check_refused(trace(out + "--effects gradient,shadow"), {"gradient with shadow", "by itself"});
    check_refused(trace(out + "--effects blur --shutter 0"), {"--shutter"});
    check_refused(trace(out + "--shutter 2"), {"--shutter", "2", "0.0", " to 1.0"});
    check_refused(trace(out + "--shutter nan"), {"shutter", "nan"});
    check_refused(trace(out + "--shutter-keys 1"), {"--shutter-keys", "1", "2 to 129"});
    check_refused(trace(out + "--jitter wobble"), {"--jitter", "wobble", "none,frame,pixel"});
    check_refused(trace(out + "--spp 0"), {"--spp", "0"});
    check_refused(trace(out + "--spp many"), {"--spp", "many"});
    check_refused(trace(out + "--frames 0"), {"--frames", "0"});
    check_refused(trace(out + "--first 16777216 --frames 2"), {"--first", "16777216 and 2 frames"});
    check_refused(trace(out + "--reference 1"), {"--reference", "1", "2 to"});
    check_refused(trace(out + "--eye 1,2"), {"--eye", "three"});
    check_refused(trace(out + "--eye nan,1,1"), {"--eye", "nan"});
    check_refused(trace(out + "--eye 1,1,1 --target 1,1,1"), {"--eye", "1.0", "what the camera looks at"});
    check_refused(trace(out + "--fov 0"), {"--fov", "less than 180"});
}

TEST_CASE("tiles of several levels are refused before anything is denoised") {
    for (auto const mode : {Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS}) {
        Folder const folder;
        write_sequence(folder, 1, 3);
        write_levels(folder / numbered("frame.", 2), noisy_image({48, 32}, 2), mode);
        auto const at = input(folder) + output(folder) + "--preset none --quiet ";
        check_refused(denoise(at + "--first 2"), {"frame.0002.exr", "several levels", "one level"});
        CHECK(folder.files() == 3);
        check_refused(denoise(at + "--signal radiance --first 2"), {"several levels"});
        check_refused(denoise(at + "--frames 1-3"), {"frame.0002.exr", "several levels"}); // those before it are written
        CHECK(folder.files() == 4);
        CHECK(denoise(input(folder) + "--preset none --quiet --first 2 --last 2 --reference '" + (folder / "frame.%04d.exr").string() + "'")
                  .code == 0);
    }
}

TEST_CASE("what is no fault of the arguments or the input is exit code 1") {
    Folder const folder;
    write_sequence(folder, 1, 2);
    std::filesystem::create_directory(folder / "out.0001.exr"); // can't be replaced by a file, in a folder that files can be written to
    auto const ran = denoise(input(folder) + output(folder));
    CHECK(ran.code == 1);
    CHECK(contains(ran.err, "out.0001.exr"));
    CHECK(contains(ran.err, "can't be written"));
    check_refused(denoise(input(folder) + "--out '" + (folder / "out.0001.exr/x/%04d.exr").string() + "' --field-of-view 0"),
                  {"--field-of-view"});
}

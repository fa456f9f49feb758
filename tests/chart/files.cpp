#include "../io/files.hpp"
#include "chart/file_sequence.hpp"
#include "chart_in.hpp"

#include <baselines/named.hpp>
#include <denoise/presets.hpp>
#include <quell/metrics/picture.hpp>
#include <quell/quell.hpp>

#include <cmath>
#include <random>

using namespace quell;
using namespace quell::bench;
using namespace quell::tests;

namespace {

constexpr Extent small{24, 16};

std::string numbered(std::string const& name, int number) {
    return name + (number < 10 ? ".000" : ".00") + std::to_string(number) + ".exr";
}

float texture(int x, int y, int number) { return ((x - number + 100) / 4 + y / 4) % 2 == 0 ? 0.8f : 0.3f; }

/// A textured plane that moves to the right by a pixel a frame, under noisy light; or under the light that there is on average.
template <class Set> io::ExrImage plane_image(Set, int number, bool noisy, Extent size = small) {
    Frame<decltype(Set{} | Channels<Radiance, Albedo, Normal, Depth, Motion>{})> frame(size);
    std::mt19937 random(static_cast<unsigned>(number));
    std::exponential_distribution<float> light(1.f);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            frame[albedo].set(x, y, glm::vec3(texture(x, y, number)));
            frame[radiance].set(x, y, glm::vec3(texture(x, y, number) * (noisy ? light(random) : 1.f)));
            frame[normal].set(x, y, {0.f, 0.f, 1.f});
            frame[depth].set(x, y, 5.f);
            frame[motion].set(x, y, {-1.f, 0.f});
        }
    io::ExrImage image{.size = size};
    for_each_channel(Set{}, [&](auto channel) { io::put(image, channel, frame[channel].view()); });
    io::put_camera(image, frame.camera);
    return image;
}

using Guided = Channels<Radiance, Albedo, Normal, Depth, Motion>;

template <class Set = Guided> void write_frames(std::filesystem::path const& folder, int first, int last) {
    std::filesystem::create_directories(folder);
    for (int i = first; i <= last; ++i) io::write_exr(folder / numbered("frame", i), plane_image(Set{}, i, true));
}
void write_references(std::filesystem::path const& folder, std::initializer_list<int> numbers, Extent size = small) {
    for (int const i : numbers) io::write_exr(folder / numbered("reference", i), plane_image(Channels<Radiance>{}, i, false, size));
}

ChartOptions options_of(std::vector<std::filesystem::path> const& folders, std::filesystem::path const& out,
                        std::vector<std::string> more = {}) {
    std::vector<std::string> words{"quell-chart", "--quiet", "--threads", "2", "--out", out.string()};
    for (auto const& folder : folders)
        for (std::string const name : {"frame", "reference"})
            words.insert(words.end(), {name == "frame" ? "--in" : "--reference", (folder / (name + ".%04d.exr")).string()});
    words.insert(words.end(), more.begin(), more.end());
    std::vector<char const*> arguments;
    for (auto const& word : words) arguments.push_back(word.c_str());
    return chart_options(static_cast<int>(arguments.size()), arguments.data());
}

void chart(ChartOptions const& options) {
    auto const sequences = file_sequences(options);
    Results results(options);
    for (auto const& sequence : sequences)
        chart_files(
            options, sequence, [](auto const&) {}, results);
}

/// As a screen shows it, by the standard's own formula.
double shown(float linear) {
    double const a = std::clamp(static_cast<double>(linear), 0., 1.);
    return a <= 0.0031308 ? 12.92 * a : 1.055 * std::pow(a, 1 / 2.4) - 0.055;
}

/// The root mean square difference of two files.
double rmse_of(std::filesystem::path const& a, std::filesystem::path const& b) {
    auto const one = io::read_exr(a), other = io::read_exr(b);
    double sum = 0;
    for (auto const* const name : {"R", "G", "B"})
        for (std::size_t i = 0; i < one.pixels(); ++i) sum += std::pow(shown(one[name].values[i]) - shown(other[name].values[i]), 2);
    return std::sqrt(sum / (3. * static_cast<double>(one.pixels())));
}

std::string methods_of(std::map<std::string, Cells> const& rows) {
    std::string names;
    for (auto const& [method, row] : rows) names += method + " ";
    return names;
}
/// The same of all compiled presets that denoise any signal by what the files above have, with and without later frames.
std::string methods_of_guided() {
    std::map<std::string, Cells> rows;
    for_each_preset(all_presets, [&]<class P>(P const& preset) {
        if constexpr (std::is_same_v<typename P::signal_type, AnySignal>)
            if (std::string const name(preset.name);
                examples::find_preset(name) && contained_in<typename decltype(P::usual())::reads, Guided>) {
                rows[name];
                if (P::is_two_sided) rows[name + "-two-sided"];
            }
    });
    return methods_of(rows);
}

} // namespace

TEST_CASE("files are charted by all presets whose channels they have, and by no other") {
    Folder const folder;
    auto const shot = folder / "shot.01";
    write_frames(shot, 5, 16);
    write_references(shot, {4, 13, 14, 16, 17}); // not all are of frames that there are
    chart(options_of({shot}, folder / "out"));
    auto rows = chart_in(folder / "out");
    CHECK(methods_of(rows) == methods_of_guided());
    CHECK(rows.size() >= 4);
    for (auto& named : rows) {
        auto const& method = named.first;
        auto& row = named.second;
        INFO(method);
        CHECK(row["scene"] == "shot.01");
        CHECK(row["effect"] == "composite");
        CHECK(row["width"] + "x" + row["height"] == "24x16");
        CHECK(row["frames"] == "12");
        CHECK(row["threads"] == "2");
        for (auto const* column : {"rmse", "ssim", "flip", "flip_median", "flicker", "ms_per_frame", "bytes_per_pixel"})
            CHECK(std::stod(row[column]) > 0);
        for (auto const* column : {"mask_rmse", "mask_ssim", "mask_flip"}) CHECK(row[column].empty());
        if (method != "none") CHECK(std::stod(row["rmse"]) < std::stod(rows["none"]["rmse"]));
        CHECK(std::filesystem::file_size(folder / "out/pictures/shot.01-composite" / (method + ".png")) > 0);
    }
    CHECK(bytes_of(folder / "out/chart.csv").starts_with(csv_header() + "\n"));
    double sum = 0;
    for (int const i : {13, 14, 16}) sum += rmse_of(shot / numbered("frame", i), shot / numbered("reference", i));
    CHECK(std::stod(rows["none"]["rmse"]) == doctest::Approx(sum / 3).epsilon(1e-4));
    CHECK(rows["general"]["rmse"] != rows["general-two-sided"]["rmse"]);
    CHECK(std::stod(rows["general"]["bytes_per_pixel"]) < std::stod(rows["general-two-sided"]["bytes_per_pixel"]));
    for (auto const* file : {"index.html", "pictures/shot.01-composite/reference.png"})
        CHECK(std::filesystem::file_size(folder / "out" / file) > 0);
}

TEST_CASE("a preset has no row where the files lack a channel that it needs, nor where it makes only a part of the picture") {
    Folder const bare, rich;
    write_frames<Channels<Radiance, Depth, Motion>>(bare.path, 0, 1);
    write_references(bare.path, {1});
    chart(options_of({bare.path}, bare / "out"));
    CHECK(methods_of(chart_in(bare / "out")) == "none ");

    constexpr auto all = presets::trmv();
    write_frames<decltype(Guided{} | typename decltype(all)::reads{})>(rich.path, 0, 0);
    write_references(rich.path, {0});
    auto const sequences = file_sequences(options_of({rich.path}, rich / "out"));
    std::string names;
    for (auto const& method : sequences.front().methods) names += method.name + " ";
    CHECK(contains(names, " trmv "));
    CHECK_FALSE(contains(names, " shadow "));
    CHECK_FALSE(contains(names, " blur "));
}

TEST_CASE("a map names the channels, and a part of the frames can be charted") {
    Folder const folder;
    write_frames(folder.path, 1, 4);
    write_references(folder.path, {1, 3});
    write_bytes(folder / "names.json", R"({"signals": [{"irradiance": "albedo", "albedo": 1}]})");
    chart(options_of({folder.path}, folder / "out", {"--first", "2", "--last", "4", "--map", (folder / "names.json").string()}));
    auto rows = chart_in(folder / "out");
    CHECK(rows["none"]["frames"] == "3");
    CHECK(std::stod(rows["none"]["rmse"]) < 1e-3); // the albedo is what the light shows
    CHECK(rows["none"]["flicker"].empty());
}

TEST_CASE("sequences in folders of one name are told apart by the folders around") {
    Folder const folder;
    std::vector<std::filesystem::path> shots;
    for (auto const* shot : {"a", "b"}) {
        shots.push_back(folder / shot / "noisy");
        write_frames<Channels<Radiance>>(shots.back(), 0, 1);
        write_references(shots.back(), {1});
    }
    chart(options_of(shots, folder / "out"));
    auto const table = bytes_of(folder / "out/chart.csv");
    CHECK(contains(table, "\na-noisy,composite,none,"));
    CHECK(contains(table, "\nb-noisy,composite,none,"));
    CHECK(std::filesystem::exists(folder / "out/pictures/b-noisy-composite/none.png"));
    shots.push_back(shots.front());
    check_error([&] { chart(options_of(shots, folder / "out")); }, {"--in", "two sequences lie in one folder"});
}

TEST_CASE("files that can't be charted are refused by name") {
    Folder const folder;
    auto const run = [&](std::vector<std::string> const& more = {}) { chart(options_of({folder.path}, folder / "out", more)); };
    check_error(run, {"frame.%04d.exr", "no such file"});
    write_frames(folder.path, 3, 6);
    write_references(folder.path, {2});
    check_error(run, {"reference.%04d.exr", "there is none for frames 3 to 6"});
    check_error([&] { run({"--first", "5", "--last", "4"}); }, {"the first is 5 and the last is 4"});
    write_references(folder.path, {5}, {12, 8});
    check_error(run, {"reference.0005.exr", "it is 12x8 but the frame is 24x16"});
    write_references(folder.path, {5});
    std::filesystem::remove(folder / numbered("frame", 4));
    check_error(run, {"frame.0004.exr", "it is missing"});
    io::write_exr(folder / numbered("frame", 4), plane_image(Guided{}, 4, true, {12, 8}));
    check_error(run, {"frame.0004.exr", "it is 12x8 but the frames before it are 24x16"});
    io::write_exr(folder / numbered("frame", 3), plane_image(Channels<Depth>{}, 3, true));
    check_error(run, {"frame.0003.exr", "R"});
}

TEST_CASE("files are not mixed with scenes, and have their references") {
    auto const refused = [](std::vector<std::string> const& more, std::initializer_list<std::string> parts) {
        check_error([&] { options_of({"a"}, "out", more); }, parts);
    };
    refused({"--scene", "fence"}, {"--scene", "--in is for files"});
    refused({"--frames", "40"}, {"--frames", "--in is for files"});
    refused({"--in", "b/frame.%04d.exr"}, {"--reference", "there are 1 for 2 of --in", "one for each"});
    check_error([&] { options_of({}, "out", {"--reference", "x.%04d.exr"}); }, {"--reference", "there is no --in"});
    CHECK(options_of({"a", "b"}, "out").cases.empty());
    CHECK(options_of({"a", "b"}, "out").files.at(1).reference == "b/reference.%04d.exr");
}

TEST_CASE("files of Blender's Cycles are charted as they are" * doctest::test_suite("shared data")) {
    auto const cycles = shared("data/sequences/cycles_occlusion");
    if (cycles.empty()) return;
    Folder const folder;
    auto options = options_of({}, folder / "out");
    options.files = {{(cycles / "frame_%04d.exr").string(), (cycles / "reference_%04d.exr").string()}};
    options.first = 38, options.last = 41;
    chart(options);
    auto rows = chart_in(folder / "out");
    CHECK(methods_of(rows) == methods_of_guided());
    CHECK(rows["none"]["scene"] == "cycles_occlusion");
    CHECK(std::stod(rows["general-two-sided"]["flip"]) < std::stod(rows["general"]["flip"]));
    CHECK(std::stod(rows["general"]["flip"]) < std::stod(rows["none"]["flip"]));
}

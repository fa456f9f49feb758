#include "flickering.hpp"

#include "../io/files.hpp"

using namespace quell;
using namespace quell::tests;

namespace {

std::string numbered(std::string const& name, long long number) {
    return name + (number < 10 ? ".000" : ".00") + std::to_string(number) + ".exr";
}

/// The wall as files of quell-trace, from frame `first` on.
void write_wall(Folder const& folder, int first) {
    FlickeringWall wall;
    bench::FitFrame frame(wall.size);
    for (auto const number : wall.numbers) {
        wall.load(number, frame);
        io::write_exr(folder / numbered("frame", number + first), io::image_of(frame));
    }
}
void write_reference(Folder const& folder, int number) {
    FlickeringWall wall;
    bench::FitFrame frame(wall.size);
    bench::put_picture(wall.clean(number), frame);
    io::ExrImage image{.size = wall.size};
    io::put(image, radiance, frame[radiance].view());
    io::write_exr(folder / numbered("reference", number), image);
}
auto open(Folder const& folder) {
    bench::FitOptions options;
    options.in = (folder / "frame.%04d.exr").string(), options.reference = (folder / "reference.%04d.exr").string();
    return bench::file_sequence(options);
}

} // namespace

TEST_CASE("files are read as they were written, and scored where there is a reference") {
    Folder const folder;
    write_wall(folder, 5);
    for (int const number : {6, 24}) write_reference(folder, number);
    auto const sequence = open(folder);
    CHECK(sequence->numbers.size() == 30);
    REQUIRE(sequence->converged.size() == 1); // frame 6 comes before any history is full
    CHECK(sequence->converged[0].frame == 24);
    CHECK(sequence->channels.contains("visibility"));
    FlickeringWall wall;
    bench::FitFrame written(wall.size), read(wall.size);
    wall.load(3, written);
    sequence->load(8, read);
    CHECK(*read.number == 3);
    for_each_channel(bench::FitFrame::channels{}, [&](auto channel) {
        INFO(channel.name);
        CHECK(read[channel].view().get(0, 3, 4) == doctest::Approx(written[channel].view().get(0, 3, 4)).epsilon(0.001));
    });
}

TEST_CASE("channels that files lack are known") {
    Folder const folder;
    FlickeringWall wall;
    Frame<Channels<Radiance, Albedo, Normal, Depth, Motion>> frame(wall.size);
    for (int i = 0; i < 12; ++i) io::write_exr(folder / numbered("frame", i), io::image_of(frame));
    write_reference(folder, 11);
    auto const sequence = open(folder);
    CHECK(sequence->channels == std::set<std::string>{"radiance", "albedo", "normal", "depth", "motion"});
}

TEST_CASE("files that can't be fitted to are refused") {
    Folder const folder;
    check_error([&] { open(folder); }, {"--in", "0 frames"});
    write_wall(folder, 0);
    check_error([&] { open(folder); }, {"--reference", "at least one"});
    write_reference(folder, 24);
    std::filesystem::remove(folder / numbered("frame", 7));
    check_error([&] { open(folder); }, {"--in", "missing between 0 and 29"});
}

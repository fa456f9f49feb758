#include "../temporary_folder.hpp"

#include <quell/io/exr.hpp>

#include <cstdint>
#include <cstdlib>

// libFuzzer's program for EXR files: any bytes are an image, which must be one of numbers for each pixel, or an Error.
using namespace quell;

namespace {

std::filesystem::path write(std::uint8_t const* data, std::size_t size) {
    static tests::Folder const folder;
    auto const file = folder / "any.exr";
    tests::write_bytes(file, {reinterpret_cast<char const*>(data), size});
    return file;
}

void check(bool holds) {
    if (!holds) std::abort();
}

void load_what_fits(io::ExrImage const& image) {
    Frame<Channels<Radiance, Depth, Motion, Instance>> frame(image.size);
    io::ChannelNames names;
    // Without both frames' jitter, a file would be refused before its other channels are read.
    bool const jittered = image.attribute<glm::vec2>("quell:jitter") && image.attribute<glm::vec2>("quell:jitter_previous");
    using Jitter = MotionConvention::Jitter;
    names.motion = {.unit = MotionConvention::Unit::uv, .jitter = jittered ? Jitter::left_in : Jitter::left_out};
    // Files that have fewer channels: all of them come from the first one.
    auto const first = image.planes.front().name;
    if (!image.find("R")) names.sources = {{"radiance", {{{first}}, {{first}}, {{first}}}}, {"depth", {{{first}}}}};
    if (!image.find("motion.X")) names.sources["motion"] = {{{first}}, {{first}, 2.f}};
    if (!image.find("instance.ID")) names.sources["instance"] = {{{first}}};
    io::load(frame, image, names);
}

/// What can be read can be written again.
void copy_what_fits(std::filesystem::path const& file) {
    io::ExrOriginal const original(file);
    auto const canvas = original.canvas();
    if (io::detail::size_of(canvas).pixels() >= 10000) return;
    static_cast<void>(original.is_whole());
    auto const& channel = original.listed.channels.front();
    auto const image = original.read(std::vector{channel.name}, canvas);
    auto copy = file;
    copy += ".copy";
    io::write_copy(copy, original,
                   {.canvas = canvas, .numbers = {{channel.part, channel.in_part, channel.type, image.planes.front().values}}});
    check(io::ExrFile(copy).size == original.listed.size);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    auto const file = write(data, size);
    try {
        auto const image = io::read_exr(file);
        for (auto const& plane : image.planes) check(plane.values.size() == image.pixels());
        // What is larger only takes longer.
        if (image.pixels() < 10000) load_what_fits(image);
        copy_what_fits(file);
    } catch (Error const& error) {
        check(std::string_view(error.what()).find('\n') == std::string_view::npos);
    }
    return 0;
}

// The functions of quell_exr.h.
#define QUELL_CALL __attribute__((visibility("default")))
#include "quell_exr.h"

#include "calls.hpp"
#include "loaded_frame.hpp"
#include "take_rows.hpp"

#include <quell/io/camera_attributes.hpp>
#include <quell/io/exr_file.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/io/part_names.hpp>
#include <quell/io/write_exr.hpp>

#include <glm/gtc/type_ptr.hpp>

#include <array>

using namespace quell_library;
namespace io = quell::io;
using quell::Error;

struct quell_exr {
    io::ExrFile file;
    std::vector<std::string> attributes{};  ///< names
    std::vector<io::SignalNames> signals{}; ///< by which it is read
    std::optional<Error> unknown{};         ///< why there are none
    std::optional<std::size_t> chosen{};    ///< of the signals

    /// A channel to read.
    struct Wanted {
        ReadChannel channel;
        std::vector<io::Source> sources{}; ///< in place of those that are recognised
    };
    std::vector<Wanted> wanted{};

    LoadedFrame frame{};
    std::vector<quell_channel> channels{}; ///< of the frame
    std::vector<std::string> names{};      ///< of the channels
    std::optional<quell_camera> camera{};

    explicit quell_exr(char const* path) : file(path) {
        for (auto const& [name, value] : file.attributes) attributes.push_back(name);
        try {
            signals = io::names_in_parts(io::recognise(file), file).of_signals;
        } catch (Error const& error) {
            unknown = error; // whoever names all channels does not mind
        }
    }
    /// Its header alone, for what reads attributes.
    [[nodiscard]] io::ExrImage header() const { return {file.name, file.size, {}, file.attributes}; }
};

namespace {

/// Calls f, whose errors are those of files and of what is to be read or written.
template <class F> quell_status with_files(F const& f) {
    return guarded([&] {
        try {
            return f();
        } catch (quell::Failure const& error) {
            return fail(QUELL_FAILED, error.what());
        } catch (Error const& error) {
            return fail(QUELL_INVALID_ARGUMENT, error.what());
        }
    });
}

quell_status null_argument(char const* function, char const* argument, char const* remedy) {
    return fail(QUELL_INVALID_ARGUMENT, std::string(function) + ": `" + argument + "` is null; " + remedy);
}
constexpr auto open_one = "open one by quell_exr_open";

/// An element's name, as C has it.
template <class T> char const* name_at(std::vector<T> const& all, int32_t index, auto const& name_of) {
    if (index < 0 || static_cast<std::size_t>(index) >= all.size()) return nullptr;
    return name_of(all[static_cast<std::size_t>(index)]).c_str();
}

quell_camera in_c(quell::Camera const& camera) {
    quell_camera made;
    std::copy_n(glm::value_ptr(camera.view), 16, made.view);
    std::copy_n(glm::value_ptr(camera.projection), 16, made.projection);
    std::copy_n(glm::value_ptr(camera.jitter), 2, made.jitter);
    return made;
}
quell_image in_c(Image const& image, int components) {
    return {image.data, QUELL_FLOAT32, components, image.component_stride, image.pixel_stride, image.row_stride};
}

/// The names by which the wanted channels are read.
io::ChannelNames names_for(quell_exr const& file) {
    io::ChannelNames names;
    bool const has_own_light = std::ranges::any_of(file.wanted, [](auto const& each) {
        return !each.sources.empty() && (each.channel.name == "radiance" || each.channel.name == "radiance_alpha");
    });
    if (file.chosen || file.signals.size() == 1)
        names = file.signals[file.chosen.value_or(0)].channels;
    else if (!has_own_light && file.signals.empty())
        throw *file.unknown;
    else if (!has_own_light)
        throw Error(file.file.name, "it has several signals",
                    "choose one by quell_exr_choose_signal: " + io::detail::list_of_names(file.signals));
    for (auto const& each : file.wanted)
        if (!each.sources.empty()) names.sources[each.channel.name] = each.sources;
    return names;
}

void read(quell_exr& file, quell_frame& frame) {
    auto const names = names_for(file);
    std::vector<ReadChannel> channels;
    std::vector<std::string> planes;
    for (auto const& each : file.wanted) {
        channels.push_back(each.channel);
        auto const more = planes_of(each.channel, names);
        if (!each.channel.optional || file.file.has_all(more)) planes.insert(planes.end(), more.begin(), more.end());
    }
    auto const image = file.file.read(planes);
    LoadedFrame loaded;
    loaded.load(channels, image, names, {});
    auto const shutter = io::shutter_of(image, names);

    file.frame = std::move(loaded);
    file.channels.clear(), file.names.clear();
    for (auto const& channel : channels) file.names.push_back(channel.name);
    for (std::size_t i = 0; i < channels.size(); ++i)
        if (auto const& read = file.frame.images.channels[i]; read.data != nullptr)
            file.channels.push_back({file.names[i].c_str(), in_c(read, channels[i].components)});
    file.camera.reset();
    if (auto const camera = io::camera_of(image)) file.camera = in_c(*camera);
    frame.channels = file.channels.data(), frame.channel_count = file.channels.size();
    frame.camera = file.camera ? &*file.camera : nullptr;
    if (shutter) frame.shutter = *shutter;
}

/// What files call the components of an image.
std::vector<std::string> names_in_file(std::string const& name, int components) {
    if (auto const* const known = find_file_channel(name)) return known->planes({});
    if (components == 1) return {name};
    std::vector<std::string> names;
    for (int c = 0; c < components; ++c)
        names.push_back(name + "." + (components > 4 ? std::to_string(c) : std::string(1, (components == 2 ? "XY" : "RGBA")[c])));
    return names;
}

/// Adds the planes of an image; a sentence where it can't be.
std::string add(io::ExrImage& to, quell_channel const& channel, std::string const& what, io::SampleType type) {
    if (channel.name == nullptr || *channel.name == '\0') return what + ": no name; give it one, such as radiance";
    auto const subject = "channel '" + std::string(channel.name) + "'";
    auto const* const known = find_file_channel(channel.name);
    int const components = known != nullptr ? known->components : channel.image.components;
    if (components < 1) return subject + ": " + std::to_string(components) + " components; give at least one";
    Image image;
    if (auto const wrong = take(image, channel.image, subject, components, to.size.width); !wrong.empty()) return wrong;
    auto const names = names_in_file(channel.name, components);
    std::vector<std::vector<float>> planes(names.size(), std::vector<float>(to.pixels()));
    std::vector<float*> rows;
    for (auto& plane : planes) rows.push_back(plane.data());
    take_rows(image, components, rows.data(), to.size.width, to.size.width, 0, to.size.height);
    for (std::size_t c = 0; c < names.size(); ++c) {
        if (to.find(names[c]) != nullptr) return subject + ": the file has '" + names[c] + "' twice; give each image a name of its own";
        to.planes.push_back({.name = names[c], .type = type, .values = std::move(planes[c])});
    }
    return {};
}

constexpr std::array compressions{Imf::ZIP_COMPRESSION, Imf::NO_COMPRESSION,   Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION,
                                  Imf::PIZ_COMPRESSION, Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION};

/// The image to write; a sentence where it can't be.
std::string take(io::ExrImage& image, quell_exr_output const& output) {
    image.size = {output.width, output.height};
    if (output.width == 0 && output.height == 0 && output.like != nullptr) image.size = output.like->file.size;
    auto const [width, height] = image.size;
    if (width < 1 || height < 1 || std::int64_t(width) * height > io::detail::max_pixels)
        return "output: a size of " + to_string(image.size) + "; give a width and a height of at least one pixel and at most 2^28 pixels";
    if (output.format != QUELL_FLOAT16 && output.format != QUELL_FLOAT32)
        return "output.format: " + std::to_string(output.format) + "; give QUELL_FLOAT16 or QUELL_FLOAT32";
    if (output.compression < 0 || static_cast<std::size_t>(output.compression) >= compressions.size())
        return "output.compression: " + std::to_string(output.compression) + "; give QUELL_EXR_ZIP or another quell_exr_compression";
    if (output.channels == nullptr || output.channel_count == 0) return "output.channels: none; give at least one image";
    auto const type = output.format == QUELL_FLOAT16 ? io::SampleType::half : io::SampleType::float32;
    for (std::size_t i = 0; i < output.channel_count; ++i)
        if (auto const wrong = add(image, output.channels[i], "output.channels[" + std::to_string(i) + "]", type); !wrong.empty())
            return wrong;
    if (output.like == nullptr) return {};
    image.attributes = output.like->file.attributes;
    // They describe the other file: its parts, tiles and deep samples.
    for (auto const* const own : {"type", "name", "view", "version", "chunkCount", "maxSamplesPerPixel"}) image.attributes.erase(own);
    return {};
}

} // namespace

char const* quell_exr_error(void) { return last_error().c_str(); }

quell_status quell_exr_open(char const* path, quell_exr** file) {
    return with_files([&]() -> quell_status {
        if (file == nullptr) return null_argument("quell_exr_open", "file", "point it at a quell_exr *");
        *file = nullptr;
        if (path == nullptr) return null_argument("quell_exr_open", "path", "give the path of an EXR file");
        *file = std::make_unique<quell_exr>(path).release();
        return QUELL_OK;
    });
}
void quell_exr_close(quell_exr* file) { delete file; }

quell_status quell_exr_get_info(quell_exr const* file, quell_exr_info* info) {
    return with_files([&]() -> quell_status {
        if (file == nullptr) return null_argument("quell_exr_get_info", "file", open_one);
        if (info == nullptr) return null_argument("quell_exr_get_info", "info", "start from QUELL_EXR_INFO");
        quell_exr_info own = QUELL_EXR_INFO;
        if (auto const wrong =
                take_struct(own, reinterpret_cast<std::byte const*>(info), "info", "QUELL_EXR_INFO", sizeof(quell_exr_info), "quell_exr.h");
            !wrong.empty())
            return fail(QUELL_INVALID_ARGUMENT, wrong);
        own = QUELL_EXR_INFO;
        own.struct_size = std::min(info->struct_size, sizeof(own)); // an earlier version's is shorter
        own.width = file->file.size.width, own.height = file->file.size.height;
        auto const header = file->header();
        if (auto const camera = io::camera_of(header)) own.has_camera = 1, own.camera = in_c(*camera);
        if (auto const shutter = io::shutter_of(header)) own.has_shutter = 1, own.shutter = *shutter;
        std::memcpy(info, &own, own.struct_size);
        return QUELL_OK;
    });
}

char const* quell_exr_channel_name(quell_exr const* file, int32_t index) {
    return file != nullptr ? name_at(
                                 file->file.channels, index, [](auto const& each) -> auto const& { return each.name; })
                           : nullptr;
}
char const* quell_exr_attribute_name(quell_exr const* file, int32_t index) {
    return file != nullptr ? name_at(
                                 file->attributes, index, [](auto const& each) -> auto const& { return each; })
                           : nullptr;
}
char const* quell_exr_attribute_text(quell_exr const* file, char const* name) {
    if (file == nullptr || name == nullptr) return nullptr;
    auto const found = file->file.attributes.find(std::string_view(name));
    auto const* const text = found != file->file.attributes.end() ? std::get_if<std::string>(&found->second) : nullptr;
    return text != nullptr ? text->c_str() : nullptr;
}
int32_t quell_exr_attribute_numbers(quell_exr const* file, char const* name, double numbers[16]) {
    if (file == nullptr || name == nullptr || numbers == nullptr) return 0;
    auto const found = file->file.attributes.find(std::string_view(name));
    if (found == file->file.attributes.end()) return 0;
    auto const take = [&](auto const* values, int32_t count) { return std::copy_n(values, count, numbers), count; };
    auto const& value = found->second;
    if (auto const* const whole = std::get_if<int>(&value)) return take(whole, 1);
    if (auto const* const number = std::get_if<float>(&value)) return take(number, 1);
    if (auto const* const pair = std::get_if<glm::vec2>(&value)) return take(glm::value_ptr(*pair), 2);
    if (auto const* const matrix = std::get_if<glm::mat4>(&value)) return take(glm::value_ptr(*matrix), 16);
    return 0;
}

char const* quell_exr_signal_name(quell_exr const* file, int32_t index) {
    return file != nullptr ? name_at(
                                 file->signals, index, [](auto const& each) -> auto const& { return each.name; })
                           : nullptr;
}
quell_status quell_exr_choose_signal(quell_exr* file, char const* name) {
    return with_files([&]() -> quell_status {
        if (file == nullptr) return null_argument("quell_exr_choose_signal", "file", open_one);
        if (name == nullptr) return null_argument("quell_exr_choose_signal", "name", "give one that quell_exr_signal_name lists");
        auto const found = std::ranges::find(file->signals, std::string_view(name), &io::SignalNames::name);
        if (found == file->signals.end())
            throw Error(file->file.name, "it has no signal '" + std::string(name) + "'",
                        "name one of: " + io::detail::list_of_names(file->signals));
        file->chosen = static_cast<std::size_t>(found - file->signals.begin());
        return QUELL_OK;
    });
}

quell_status quell_exr_want(quell_exr* file, char const* channel, int32_t optional, char const* const* planes) {
    return with_files([&]() -> quell_status {
        if (file == nullptr) return null_argument("quell_exr_want", "file", open_one);
        if (channel == nullptr) return null_argument("quell_exr_want", "channel", "give one that quell_channel_name lists");
        auto const* const known = find_file_channel(channel);
        if (known == nullptr)
            throw Error("channel '" + std::string(channel) + "'", "files have none of that name",
                        "name one of: " + io::detail::list_of_names([] {
                            std::vector<ReadChannel> all;
                            for (auto const& each : file_channels()) all.push_back({.name = std::string(each.name)});
                            return all;
                        }()));
        quell_exr::Wanted wanted{{.name = channel, .components = known->components, .optional = optional != 0}};
        for (int c = 0; planes != nullptr && c < known->components; ++c) {
            if (planes[c] == nullptr)
                throw Error("channel '" + std::string(channel) + "'", "planes[" + std::to_string(c) + "] is null",
                            "name " + std::to_string(known->components));
            wanted.sources.push_back({{planes[c]}});
        }
        auto const same = std::ranges::find_if(file->wanted, [&](auto const& each) { return each.channel.name == channel; });
        if (same != file->wanted.end())
            *same = std::move(wanted);
        else
            file->wanted.push_back(std::move(wanted));
        return QUELL_OK;
    });
}
quell_status quell_exr_read(quell_exr* file, int32_t width, int32_t height, quell_frame* frame) {
    return with_files([&]() -> quell_status {
        if (file == nullptr) return null_argument("quell_exr_read", "file", open_one);
        if (frame == nullptr) return null_argument("quell_exr_read", "frame", "start from QUELL_FRAME");
        quell_frame own = QUELL_FRAME;
        if (auto const wrong =
                take_struct(own, reinterpret_cast<std::byte const*>(frame), "frame", "QUELL_FRAME", offsetof(quell_frame, fractions));
            !wrong.empty())
            return fail(QUELL_INVALID_ARGUMENT, wrong);
        if (file->wanted.empty()) return fail(QUELL_INVALID_ARGUMENT, "quell_exr_read: no channels are wanted; say so by quell_exr_want");
        bool const fits = (width == 0 || width == file->file.size.width) && (height == 0 || height == file->file.size.height);
        if (!fits)
            throw Error(file->file.name,
                        "it is " + to_string(file->file.size) + " but frames are " + to_string(quell::Extent{width, height}),
                        "make a denoiser of that size, or render all frames in one size");
        read(*file, *frame);
        return QUELL_OK;
    });
}

quell_status quell_exr_write(char const* path, quell_exr_output const* output) {
    return with_files([&]() -> quell_status {
        if (path == nullptr) return null_argument("quell_exr_write", "path", "give the path of the file to write");
        if (output == nullptr) return null_argument("quell_exr_write", "output", "start from QUELL_EXR_OUTPUT");
        quell_exr_output own = QUELL_EXR_OUTPUT;
        auto wrong = take_struct(own, reinterpret_cast<std::byte const*>(output), "output", "QUELL_EXR_OUTPUT", sizeof(quell_exr_output),
                                 "quell_exr.h");
        io::ExrImage image{.name = path, .size = {}};
        if (wrong.empty()) wrong = take(image, own);
        if (!wrong.empty()) return fail(QUELL_INVALID_ARGUMENT, wrong);
        io::write_exr(path, image, compressions[static_cast<std::size_t>(own.compression)]);
        return QUELL_OK;
    });
}

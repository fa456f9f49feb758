#include <support/png.hpp>

#include <quell/io/replace_file.hpp>

#include <png.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace quell::examples {

namespace {

/// libpng's simplified interface, which reports errors by return value and not by longjmp; frees what it holds on every way out.
struct Image {
    png_image png{};

    explicit Image(png_uint_32 width = 0, png_uint_32 height = 0) {
        png.version = PNG_IMAGE_VERSION;
        png.width = width;
        png.height = height;
        png.format = PNG_FORMAT_RGB;
    }
    Image(Image const&) = delete;
    Image& operator=(Image const&) = delete;
    ~Image() { png_image_free(&png); }
};

std::vector<unsigned char> bytes_of(std::filesystem::path const& path) {
    std::error_code why;
    std::vector<unsigned char> bytes;
    if (auto const size = std::filesystem::file_size(path, why); !why) {
        bytes.resize(size);
        std::ifstream file(path, std::ios::binary);
        if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
            why.assign(errno, std::generic_category());
    }
    if (why) throw Error(path.string(), "can't be read: " + why.message(), "give the path of a PNG file");
    return bytes;
}

std::vector<unsigned char> encode(std::string const& name, metrics::Picture const& displayed) {
    metrics::detail::check_displayed(name, displayed);
    std::vector<unsigned char> components;
    components.reserve(displayed.pixels.size() * 3);
    for (auto const& p : displayed.pixels)
        for (auto const component : {p.x, p.y, p.z}) components.push_back(static_cast<unsigned char>(component * 255.f + 0.5f));
    Image image(static_cast<png_uint_32>(displayed.size.width), static_cast<png_uint_32>(displayed.size.height));
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image.png);
    std::vector<unsigned char> bytes(size);
    if (!png_image_write_to_memory(&image.png, bytes.data(), &size, 0, components.data(), 0, nullptr))
        throw Failure(name, std::string("can't be encoded: ") + image.png.message, "give a picture that PNG can hold");
    bytes.resize(size);
    return bytes;
}

} // namespace

metrics::Picture read_png(std::filesystem::path const& path) {
    auto const bytes = bytes_of(path);
    Image image;
    auto const fail = [&] { throw Error(path.string(), std::string("isn't a PNG file: ") + image.png.message, "write it anew"); };
    if (!png_image_begin_read_from_memory(&image.png, bytes.data(), bytes.size())) fail();
    if ((image.png.format & PNG_FORMAT_FLAG_LINEAR) != 0) throw Error(path.string(), "has 16 bits a component", "save it with 8 bits");
    Extent const size{static_cast<int>(image.png.width), static_cast<int>(image.png.height)};
    // A header can claim any size; a billion bytes is more than a picture on a screen has.
    if (size.pixels() > (1 << 28)) throw Error(path.string(), "claims a size of " + to_string(size), "give at most 2^28 pixels");
    image.png.format = PNG_FORMAT_RGB;
    std::vector<unsigned char> components(static_cast<std::size_t>(size.pixels()) * 3);
    png_color const black{0, 0, 0};
    if (!png_image_finish_read(&image.png, &black, components.data(), 0, nullptr)) fail();
    metrics::Picture result{size, {}};
    result.pixels.reserve(static_cast<std::size_t>(size.pixels()));
    for (auto const* c = components.data(); c != components.data() + components.size(); c += 3)
        result.pixels.push_back(glm::vec3(c[0], c[1], c[2]) / 255.f);
    return result;
}

void write_png(std::filesystem::path const& path, metrics::Picture const& displayed) {
    auto const bytes = encode(path.string(), displayed);
    io::replace_file(path, {reinterpret_cast<char const*>(bytes.data()), bytes.size()});
}

std::vector<unsigned char> encode_png(metrics::Picture const& displayed) { return encode("PNG in memory", displayed); }

} // namespace quell::examples

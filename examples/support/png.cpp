#include <support/png.hpp>

#include <quell/io/replace_file.hpp>

#include <png.h>

#include <string>

namespace quell::examples {

namespace {

std::vector<unsigned char> encode(std::string const& name, metrics::Picture const& displayed) {
    metrics::detail::check_displayed(name, displayed);
    std::vector<unsigned char> components;
    components.reserve(displayed.pixels.size() * 3);
    for (auto const& p : displayed.pixels)
        for (auto const component : {p.x, p.y, p.z}) components.push_back(static_cast<unsigned char>(component * 255.f + 0.5f));
    png_image image{};
    image.version = PNG_IMAGE_VERSION, image.format = PNG_FORMAT_RGB;
    image.width = static_cast<png_uint_32>(displayed.size.width), image.height = static_cast<png_uint_32>(displayed.size.height);
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<unsigned char> bytes(size);
    if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, components.data(), 0, nullptr))
        throw Failure(name, std::string("can't be encoded: ") + image.message, "give a picture that PNG can hold");
    bytes.resize(size);
    return bytes;
}

} // namespace

void write_png(std::filesystem::path const& path, metrics::Picture const& displayed) {
    auto const bytes = encode(path.string(), displayed);
    io::replace_file(path, {reinterpret_cast<char const*>(bytes.data()), bytes.size()});
}

std::vector<unsigned char> encode_png(metrics::Picture const& displayed) { return encode("PNG in memory", displayed); }

} // namespace quell::examples

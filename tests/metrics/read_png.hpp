#pragma once

#include <quell/metrics/picture.hpp>

#include <doctest/doctest.h>
#include <png.h>

#include <filesystem>

/// The picture in a PNG file of 8 bits a component, as stored.
inline quell::metrics::Picture read_png(std::filesystem::path const& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_file(&image, path.string().c_str()) != 0);
    image.format = PNG_FORMAT_RGB;
    std::vector<unsigned char> bytes(PNG_IMAGE_SIZE(image));
    REQUIRE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) != 0);
    quell::metrics::Picture picture{{static_cast<int>(image.width), static_cast<int>(image.height)}, {}};
    for (std::size_t i = 0; i < bytes.size(); i += 3) picture.pixels.push_back(glm::vec3(bytes[i], bytes[i + 1], bytes[i + 2]) / 255.f);
    return picture;
}

// Writes the picture of an EXR file (R, G, B) as PNG, as a screen shows it: write_png IN.exr OUT.png
#include <quell/io/exr.hpp>
#include <quell/metrics/picture.hpp>
#include <support/png.hpp>

#include <array>
#include <cstdio>
#include <exception>
#include <string>

using namespace quell;

int main(int count, char** arguments) try {
    if (count != 3) return std::fputs("write_png IN.exr OUT.png\n", stderr), 2;
    static std::array<std::string, 3> const names{"R", "G", "B"};
    auto const image = io::ExrFile(arguments[1]).read(names);
    metrics::Picture picture{image.size, std::vector<glm::vec3>(image.pixels())};
    for (int c = 0; c < 3; ++c) {
        auto const& values = image[names[static_cast<std::size_t>(c)]].values;
        for (std::size_t i = 0; i < values.size(); ++i) picture.pixels[i][c] = values[i];
    }
    examples::write_png(arguments[2], metrics::displayed(picture));
} catch (std::exception const& error) {
    std::fprintf(stderr, "write_png: %s\n", error.what());
    return 1;
}

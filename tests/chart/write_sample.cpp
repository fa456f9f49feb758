// Writes the sample chart that the browser test opens: chart_sample FOLDER.
#include "chart/page.hpp"
#include "made_up_rows.hpp"

#include <support/png.hpp>

#include <cstdio>
#include <exception>

namespace {

/// A picture of one colour, so that the test can tell the methods' pictures apart.
std::string picture(std::filesystem::path const& folder, std::string const& name, float shade) {
    quell::Extent const size{16, 9};
    std::vector<glm::vec3> const pixels(static_cast<std::size_t>(size.pixels()), glm::vec3(shade, 0.5f, 1.f - shade));
    quell::examples::write_png(folder / name, {size, pixels});
    return name;
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: chart_sample FOLDER\n");
        return 2;
    }
    try {
        std::filesystem::path const folder = arguments[1];
        auto rows = quell::bench::made_up_rows();
        int number = 0;
        auto const reference = picture(folder, "reference.png", 1.f);
        for (auto& row : rows) {
            row.reference = reference;
            row.picture = picture(folder, "method " + std::to_string(number) + ".png", 0.05f * static_cast<float>(number));
            ++number;
        }
        quell::bench::write_chart_page(rows, folder / "index.html");
        quell::bench::write_chart_page({}, folder / "empty.html");
    } catch (std::exception const& error) {
        std::fprintf(stderr, "chart_sample: %s\n", error.what());
        return 1;
    }
}

#include "flickering.hpp"
#include "small_contenders.hpp"

#include "../temporary_folder.hpp"
#include "fit/fit.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <sstream>

using namespace quell;
using namespace quell::bench;
using quell::tests::FlickeringWall;
using quell::tests::Folder;

namespace {

Fitted fitted_to(FlickeringWall& wall, std::vector<Contender> const& contenders) {
    FitOptions options;
    options.bounds.rmse = 0.08, options.threads = 1, options.quiet = true;
    std::ostringstream nowhere;
    return fit(wall, contenders, options, nowhere);
}

void put_values(std::ostream& out, auto const& view, int components) {
    for (int y = 0; y < view.size.height; ++y)
        for (int x = 0; x < view.size.width; ++x)
            for (int c = 0; c < components; ++c) out << view.get(c, x, y) << ' ';
}

/// What a host has: in each frame the channels that the header lists, and what the picture should be in the scored ones.
void write_frames(std::filesystem::path const& file, FlickeringWall& wall, std::vector<std::string> const& channels) {
    std::ofstream out(file);
    FitFrame frame(wall.size);
    out.precision(9);
    out << wall.size.width << ' ' << wall.size.height << ' ' << wall.numbers.size() << '\n';
    for (auto const number : wall.numbers) {
        wall.load(number, frame);
        // As the header asks: the picture less the shadow's share.
        for (int y = 0; y < wall.size.height; ++y)
            for (int x = 0; x < wall.size.width; ++x) frame[radiance].set(x, y, glm::vec3(0.5f * FlickeringWall::bounced));
        for (auto const& name : channels)
            for_each_channel(FitFrame::channels{}, [&]<class C>(C channel) {
                if (name == C::name) put_values(out, frame[channel].view(), C::components);
            });
        auto const scored = std::ranges::find(wall.converged, number, &Converged::frame);
        out << (scored != wall.converged.end()) << '\n';
        if (scored == wall.converged.end()) continue;
        for (auto const& pixel : scored->displayed.pixels) out << pixel.x << ' ' << pixel.y << ' ' << pixel.z << ' ';
    }
}

/// The exit code of a command, whose output goes to a file.
int shell(std::string const& command, std::filesystem::path const& output) {
    return std::system((command + " > '" + output.string() + "' 2>&1").c_str());
}

} // namespace

TEST_CASE("a host that compiles the header gets the promised figure") {
    Folder const folder;
    FlickeringWall wall;
    auto const contenders = small_contenders();
    auto const fitted = fitted_to(wall, contenders);
    REQUIRE(has(fitted.composition.split, Part::shadow));
    std::ofstream(folder / "fit.hpp") << header_text(fitted.composition, fitted.origin);
    write_frames(folder / "frames", wall, channels_of(fitted.composition));
    auto const in = folder.path.string();
    auto const compiled =
        shell(QUELL_COMPILER " -std=c++20 -O1 -march=native -Wall -Wextra -Wpedantic -Wconversion -Werror -x c++ -I" QUELL_INCLUDE " -I'" +
                  in + "' " QUELL_HOST " -o '" + in + "/host'",
              folder / "log");
    INFO(tests::bytes_of(folder / "fit.hpp"), tests::bytes_of(folder / "log"));
    REQUIRE(compiled == 0);
    REQUIRE(shell("'" + in + "/host' '" + in + "/frames'", folder / "said") == 0);
    std::istringstream said(tests::bytes_of(folder / "said"));
    double promised = 0, measured = 0;
    said >> promised >> measured;
    CHECK(promised == doctest::Approx(fitted.composition.figures.rmse).epsilon(1e-4));
    CHECK(measured == doctest::Approx(promised).epsilon(1e-3));
}

TEST_CASE("a header says what it is for and what was left out") {
    FlickeringWall wall;
    auto const contenders = small_contenders();
    auto const fitted = fitted_to(wall, contenders);
    auto const text = header_text(fitted.composition, fitted.origin);
    for (auto const* part :
         {"flickering wall", "RMSE 0.08 or less", "24x16", "frames 24, 29", "Left out: glossy: no pixel reflects",
          "the noisy picture - direct * visibility", "// Memory: halves do: ", "using Storage = quell::Planar<quell::Float16>;"}) {
        INFO(part);
        CHECK(text.find(part) != std::string::npos);
    }
}

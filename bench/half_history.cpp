// What a history in half costs: RMSE, SSIM and FLIP of `svgf` against a converged reference with the history in float and in half.
//
//   quell-half-history 'dir/frame.%04d.exr' LAST reference.exr          frames 0 to LAST of quell-trace, of which the last is compared

#include <quell/io/exr.hpp>
#include <quell/metrics/flip.hpp>
#include <quell/metrics/rmse.hpp>
#include <quell/metrics/ssim.hpp>
#include <quell/quell.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace quell;

constexpr auto denoise = presets::svgf(radiance, Demodulate{});

/// `pattern` with the frame's number at its %04d.
std::string numbered(std::string pattern, int number) {
    auto const digits = std::to_string(number);
    auto const at = pattern.find("%04d");
    if (at == std::string::npos) throw Error(pattern, "it has no %04d", "put that where the frame's number stands");
    return pattern.replace(at, 4, std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits);
}

template <class Storage>
double compare(char const* name, std::string const& pattern, int last, metrics::Picture const& reference, Storage const& storage) {
    Frame frame{reference.size, denoise};
    History history{reference.size, denoise, storage};
    for (int number = 0; number <= last; ++number) {
        frame.number = number;
        io::load(frame, io::read_exr(numbered(pattern, number)));
        auto const clean = run(denoise, frame, history);
        if (number < last) continue;
        auto const picture = metrics::displayed(metrics::picture_of(clean));
        auto const error = metrics::rmse(reference, picture);
        std::printf("%-6s RMSE %.6f  SSIM %.6f  FLIP %.6f  %.0f bytes per pixel\n", name, error, metrics::ssim(reference, picture),
                    metrics::flip(reference, picture).mean(), history.bytes_per_pixel());
        return error;
    }
    return 0;
}

} // namespace

int main(int count, char** arguments) try {
    if (count != 4)
        throw Error("quell-half-history", std::to_string(count - 1) + " arguments", "give 'dir/frame.%04d.exr' LAST reference.exr");
    auto const image = io::read_exr(arguments[3]);
    Frame<Channels<Radiance>> converged{image.size};
    io::load(converged, image);
    auto const reference = metrics::displayed(metrics::picture_of(converged[radiance].view()));
    int const last = std::atoi(arguments[2]);
    double const in_float = compare("float", arguments[1], last, reference, Planar<>{});
    double const in_half = compare("half", arguments[1], last, reference, Planar<Float16>{});
    std::printf("RMSE of half over that of float: %.5f\n", in_half / in_float);
} catch (std::exception const& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}

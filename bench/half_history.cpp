// What a history in half costs: RMSE, SSIM and FLIP of `svgf` against a converged reference with the history in float and in half.
//
//   quell-half-history 'dir/frame.%04d.exr' LAST reference.exr          frames 0 to LAST of quell-trace, of which the last is compared

#include <quell/io/exr.hpp>
#include <quell/quell.hpp>
#include <support/frame_pattern.hpp>
#include <support/image_errors.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <string>

namespace {

using namespace quell;

constexpr auto denoise = presets::svgf(radiance, Demodulate{});

template <class Storage>
double compare(char const* name, examples::FramePattern const& pattern, int last, metrics::Picture const& reference,
               Storage const& storage) {
    Frame frame{reference.size, denoise};
    History history{reference.size, denoise, storage};
    for (int number = 0; number <= last; ++number) {
        frame.number = number;
        io::load(frame, io::read_exr(pattern.path(number).string()));
        auto const clean = run(denoise, frame, history);
        if (number < last) continue;
        auto const picture = metrics::displayed(metrics::picture_of(clean));
        auto const errors = examples::image_errors(reference, picture);
        fmt::print("{:<6} RMSE {:.6f}  SSIM {:.6f}  FLIP {:.6f}  {:.0f} bytes per pixel\n", name, errors.rmse, errors.ssim, errors.flip,
                   history.bytes_per_pixel());
        return errors.rmse;
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
    examples::FramePattern const pattern(arguments[1]);
    int const last = std::atoi(arguments[2]);
    double const in_float = compare("float", pattern, last, reference, Planar<>{});
    double const in_half = compare("half", pattern, last, reference, Planar<Float16>{});
    fmt::print("RMSE of half over that of float: {:.5f}\n", in_half / in_float);
} catch (std::exception const& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
}

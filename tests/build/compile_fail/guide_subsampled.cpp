// error: Subsampled<pattern, Channels<...>>: albedo, normal, depth, motion and motion_next must be there for every pixel
// error: Subsampled<pattern, Channels<...>, Storage>: a block of the pattern has 1 to 8 columns and rows
#include <quell/quell.hpp>
using namespace quell;

#ifdef CORRECT
using Rays = Channels<Radiance>;
constexpr SamplePattern third{.columns = 3};
#else
using Rays = Channels<Radiance, Depth>;
constexpr SamplePattern third{.columns = 0};
#endif

int main() {
    constexpr auto denoise = presets::surface(radiance);
    Frame frame{{8, 8}, denoise, Subsampled<half_size, Rays>{}};
    History history{{8, 8}, denoise};
    run(denoise, frame, history);
    static_cast<void>(Subsampled<third, Rays>{});
}

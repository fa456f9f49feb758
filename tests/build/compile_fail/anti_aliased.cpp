// error: Remodulated<P, frames>: it keeps 0 to 4 frames
// error: run(remodulated, frame, ...): the frame lacks a channel that the pipeline or the anti-aliasing reads (albedo, depth, motion)
// error: run_into(target, remodulated, frame, ...): the frame lacks a channel that the pipeline or the anti-aliasing reads
// error: run_into(target, remodulated, frame, ...): the target must have three components
#include <quell/presets/anti_aliased.hpp>
#include <quell/quell.hpp>
using namespace quell;

#ifdef CORRECT
#define CALL(right, ...) right
#else
#define CALL(right, ...) __VA_ARGS__
#endif

constexpr auto pipeline = presets::none(radiance);
constexpr auto denoise = presets::anti_aliased(pipeline);
constexpr Extent size{8, 8};

constexpr auto of_many = CALL(presets::anti_aliased<4>(pipeline), presets::anti_aliased<5>(pipeline));

void run_them(Planar<>::Image<3>& picture, Planar<>::Image<1>& grey) {
    Frame frame{size, denoise};
    Frame bare{size, pipeline};
    History history{size, denoise};
    CALL(run(denoise, frame, history), run(denoise, bare, history));
    CALL(run_into(picture.view(), denoise, frame, history), run_into(picture.view(), denoise, bare, history));
    CALL(run_into(picture.view(), denoise, frame, history), run_into(grey.view(), denoise, frame, history));
}

// error: ByEvidence{pipeline, judge, rule}: the first must be a Pipeline with a Temporal{...}
// error: ByEvidence{pipeline, judge, rule}: the judge goes on from the pipeline's history
// error: run(by_evidence, frame, ...): the frame lacks a channel that the pipeline or its judge reads
// error: run_into(target, by_evidence, frame, ...): the frame lacks a channel that the pipeline or its judge reads
// error: run_into(target, by_evidence, frame, ...): the target has another number of components than the pipeline's signal
#include <quell/presets/by_evidence.hpp>
#include <quell/quell.hpp>
using namespace quell;

#ifdef CORRECT
#define CALL(right, ...) right
#else
#define CALL(right, ...) __VA_ARGS__
#endif

constexpr Pipeline pipeline{radiance, Temporal{SurfaceMotion{}, RunningMean{}}};
constexpr Pipeline of_irradiance{radiance, Demodulate{}, Temporal{SurfaceMotion{}, RunningMean{}}};
constexpr auto denoise = presets::by_evidence(pipeline);
constexpr Extent size{8, 8};

constexpr auto of_none = CALL(presets::by_evidence(pipeline), presets::by_evidence(presets::none(radiance)));
constexpr auto of_two = CALL(presets::by_evidence(pipeline, pipeline), presets::by_evidence(pipeline, of_irradiance));

void run_them(Planar<>::Image<3>& picture, Planar<>::Image<1>& grey) {
    Frame frame{size, denoise};
    Frame bare{size, presets::none(radiance)};
    History history{size, denoise};
    CALL(run(denoise, frame, history), run(denoise, bare, history));
    CALL(run_into(picture.view(), denoise, frame, history), run_into(picture.view(), denoise, bare, history));
    CALL(run_into(picture.view(), denoise, frame, history), run_into(grey.view(), denoise, frame, history));
}

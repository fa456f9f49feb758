// error: record(pipeline): it takes a Pipeline, a Composite, a ByEvidence or a Chain; of a TwoSided give it the member `pipeline`
// error: plan_of(pipeline): it takes a Pipeline, a Composite, a ByEvidence, a TwoSided, a Chain, or what presets::resolve makes
// error: warm_up_frames(pipeline): it takes a Pipeline, a Composite, a ByEvidence, a TwoSided, a Chain, or what presets::resolve
#include <quell/pipeline/plan.hpp>
#include <quell/pipeline/warm_up.hpp>
#include <quell/presets/resolve.hpp>
#include <quell/quell.hpp>
#include <quell/shader/record.hpp>
using namespace quell;

#ifdef CORRECT
#define OF(behind) behind.pipeline
#define PIPELINE accumulated
#else
#define OF(behind) behind
#define PIPELINE std::get<0>(accumulated.stages)
#endif

constexpr Pipeline accumulated{radiance, Temporal{SurfaceMotion{}, RunningMean{}}};
constexpr auto upscaled = presets::resolve(accumulated);

int main() {
    auto const recorded = record(OF(upscaled), "upscaled").passes.size();
    auto const planned = plan_of(PIPELINE).passes.size();
    return static_cast<int>(recorded + planned) + warm_up_frames(PIPELINE);
}

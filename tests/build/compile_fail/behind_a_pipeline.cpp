// error: record(pipeline): it takes a Pipeline, a Composite, a ByEvidence or a Chain; of anti_aliased() and resolve() give it
// error: plan_of(pipeline): it takes a Pipeline, a Composite, a ByEvidence or a Chain; of anti_aliased() and resolve() give it
// error: warm_up_frames(pipeline): it takes a Pipeline, a Composite, a ByEvidence or a Chain; of anti_aliased() and resolve() give it
#include <quell/pipeline/plan.hpp>
#include <quell/pipeline/warm_up.hpp>
#include <quell/presets/anti_aliased.hpp>
#include <quell/presets/resolve.hpp>
#include <quell/quell.hpp>
#include <quell/shader/record.hpp>
using namespace quell;

#ifdef CORRECT
#define OF(behind) behind.pipeline
#else
#define OF(behind) behind
#endif

constexpr Pipeline accumulated{radiance, Temporal{SurfaceMotion{}, RunningMean{}}};
constexpr auto smooth = presets::anti_aliased(accumulated);
constexpr auto upscaled = presets::resolve(accumulated);

int main() {
    auto const recorded = record(OF(smooth)).passes.size() + record(OF(upscaled), "upscaled").passes.size();
    auto const planned = plan_of(OF(smooth)).passes.size() + plan_of(OF(upscaled), Planar<>{}).passes.size();
    return static_cast<int>(recorded + planned) + warm_up_frames(OF(smooth)) + warm_up_frames(OF(upscaled));
}

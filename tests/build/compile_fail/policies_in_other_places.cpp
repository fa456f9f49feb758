// error: Atrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp
// error: Bilateral{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp
// error: Clamped{inner, range}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp
// error: CleanUp{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp
// error: ConservingAtrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp
// error: FirstValid{sources...}: each must have previous(px), see quell/motion/motion_source.hpp
// error: ForgetBiased{inner}: `inner` must keep the history's length, as RunningMean does
// error: VarianceGuidedAtrous{edge}: `edge` must have around(px), see quell/filter/filter_kernel.hpp
// error: Product{edges...}: each must have around(px), see quell/filter/filter_kernel.hpp
// error: Spatial{kernel}: `kernel` must have filter(px) or for_each_pass(pass), see quell/filter/filter_kernel.hpp
// error: Temporal{motion, blend}: `blend` must have blend(px, past), see quell/blend/blend_policy.hpp
// error: Temporal{motion, blend}: `motion` must have previous(px), see quell/motion/motion_source.hpp
// error: WithCleanUp{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp
// error: WithGuides{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp
// error: WithMoments{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp
// error: WithVariance{inner}: `inner` must have blend(px, past), see quell/blend/blend_policy.hpp
// error: Pipeline{channel, options..., stages...}: each must be Temporal{...}, Spatial{...}, Demodulate{}, SuppressFireflies{},
// error: Pipeline{channel, options..., stages...}: one Temporal at most, since there is one history; use FirstValid
// error: Pipeline{channel, options..., stages...}: a stage reads what only a later one makes
// error: a stage looks at what no blend policy keeps
// error: Pipeline{channel, options..., stages...}: a stage reads what none of them makes
// error: Temporal{motion, blend, fetch}: `fetch` must have fetch(px, found)
// error: Clamped{inner, range}: `range` must have a Gatherer with add(value, weight, dx, dy)
// error: Clamped{inner, range, axes}: `axes` must have from(value) and to(value)
// error: Pipeline{channel, options..., stages...}: a modulation must have inward(px, sample) and outward(px, value)
#include <quell/quell.hpp>
using namespace quell;

// Policies in the place of others, and stages that do not fit together.
#ifdef CORRECT
#define PART(right, wrong) right
#else
#define PART(right, wrong) wrong
#endif

constexpr Atrous wavelet{PART(NormalEdge, RunningMean){}};
constexpr Bilateral<PART(NormalEdge, RunningMean)> blur{};
constexpr CleanUp<PART(NormalEdge, RunningMean)> clean_up{};
constexpr ConservingAtrous conserving{PART(NormalEdge, RunningMean){}};
constexpr VarianceGuidedAtrous guided{PART(NormalEdge, RunningMean){}};
constexpr Product edges{NormalEdge{}, PART(DepthEdge, RunningMean){}};
constexpr Clamped clamped{PART(RunningMean, StillMotion){}};
constexpr WithCleanUp with_clean_up{PART(RunningMean, StillMotion){}};
constexpr WithGuides with_guides{PART(RunningMean, StillMotion){}};
constexpr WithMoments with_moments{PART(RunningMean, StillMotion){}};
constexpr WithVariance with_variance{PART(RunningMean, StillMotion){}};
constexpr ForgetBiased forgetting{PART(RunningMean, Exponential){}};
FirstValid either{StillMotion{}, PART(StillMotion, RunningMean){}};
constexpr Spatial smooth{PART(Atrous<>, RunningMean){}};
constexpr Temporal of_blend{StillMotion{}, PART(RunningMean, Atrous<>){}};
constexpr Temporal of_motion{PART(StillMotion, Exponential){}, RunningMean{}};
constexpr Clamped by_range{RunningMean{}, PART(MinMax, YCoCg){}};
constexpr Clamped in_axes{RunningMean{}, MinMax{}, PART(YCoCg, MinMax){}};

// Parts of pipelines. An empty PART is left out.
constexpr Temporal still{StillMotion{}, RunningMean{}};
constexpr Temporal with_variances{StillMotion{}, WithMoments{RunningMean{}}};
constexpr Temporal with_deviation{StillMotion{}, WithCleanUp{RunningMean{}}};
constexpr Temporal with_variance_and_bias{StillMotion{}, WithVariance{RunningMean{}}};
constexpr Spatial variance_guided{VarianceGuidedAtrous<>{}};
constexpr Pipeline stages{radiance, PART(Spatial{Atrous{}}, Atrous{})};
constexpr Pipeline one_past{radiance, still, PART(Spatial{Atrous{}}, still)};
constexpr Pipeline in_order{radiance, PART(with_variances, variance_guided), PART(variance_guided, with_variances)};
constexpr Pipeline kept{radiance, Spatial{BiasEstimate<>{}}, PART(with_variance_and_bias, still)};
constexpr Pipeline made{radiance, PART(with_deviation, still), Spatial{CleanUp<>{}}};

struct OneWay {
    template <ChannelTag S> using Signal = S;
    QUELL_KERNEL auto inward(auto const&, auto const& sample) const { return sample; }
    QUELL_KERNEL auto PART(outward, backward)(auto const&, auto const& value) const { return value; }
};
constexpr Pipeline converted{radiance, OneWay{}, still};

struct OwnFetch {
    QUELL_KERNEL auto fetch(auto const& px, PART(auto const& found, int)) const { return Nearest{}.fetch(px, PART(found, 0)); }
};
void host(Extent size) {
    constexpr Pipeline denoise{radiance, Temporal{StillMotion{}, RunningMean{}, OwnFetch{}}};
    Frame frame{size, denoise};
    History history{size, denoise};
    run(denoise, frame, history, Serial{});
}

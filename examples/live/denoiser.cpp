#include "denoiser.hpp"

#include <quell/presets/general.hpp>
#include <quell/presets/resolve.hpp>
#include <quell/quell.hpp>

namespace quell::live {
namespace {

/// The Denoiser of a pipeline.
template <class P> class DenoiserOf final : public Denoiser {
    P pipeline;
    History<P> history;

public:
    DenoiserOf(P const& p, Extent size) : pipeline(p), history(size, p) {}
    void run(TracedFrame const& frame, Planar<>::Image<3>& out) override {
        for (auto& time : times) time.seconds = 0;
        run_into(out.view(), pipeline, frame, history, Timed{&times});
    }
    void forget() override { history.forget(); }
};

template <class P> std::unique_ptr<Denoiser> denoiser_of(P const& pipeline, Extent size) {
    return std::make_unique<DenoiserOf<P>>(pipeline, size);
}

} // namespace

std::unique_ptr<Denoiser> make_denoiser(int preset, Extent size) {
    if (preset == 0) return denoiser_of(presets::general(radiance, Demodulate{}), size);
    if (preset == 1) return denoiser_of(presets::svgf(radiance, Demodulate{}), size);
    if (preset == 2) return denoiser_of(presets::surface_clamp(radiance, Demodulate{}), size);
    return nullptr;
}

std::unique_ptr<Denoiser> make_anti_aliasing(Extent size) { return denoiser_of(presets::resolve(presets::none(radiance)), size); }

} // namespace quell::live

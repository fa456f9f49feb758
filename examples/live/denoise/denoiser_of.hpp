#pragma once

#include "denoiser.hpp"

#include <quell/presets/general.hpp>
#include <quell/quell.hpp>

namespace quell::live {

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

template <class P> std::unique_ptr<Denoiser> make_denoiser(P const& pipeline, Extent size) {
    return std::make_unique<DenoiserOf<P>>(pipeline, size);
}

} // namespace quell::live

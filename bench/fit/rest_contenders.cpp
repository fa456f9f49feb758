#include "contenders.hpp"

std::vector<quell::bench::Contender> quell::bench::rest_contenders() {
    return {
        contender("none", false, QUELL_FIT_CODE(presets::none(radiance))),
        contender("surface", false, QUELL_FIT_CODE(presets::surface(radiance, Demodulate{}))),
        contender("surface-clamp", false, QUELL_FIT_CODE(presets::surface_clamp(radiance, Demodulate{}))),
        contender("surface-clamp/alpha=0.2", false, QUELL_FIT_CODE([] {
                      auto pipeline = presets::surface_clamp(radiance, Demodulate{});
                      std::get<0>(pipeline.stages).blending.inner.alpha = 0.2f;
                      return pipeline;
                  }())),
        contender("svgf/levels=2", false, QUELL_FIT_CODE([] {
                      auto pipeline = presets::svgf(radiance, Demodulate{});
                      std::get<1>(pipeline.stages).kernel.levels = 2;
                      return pipeline;
                  }())),
        contender("svgf/levels=3", false, QUELL_FIT_CODE([] {
                      auto pipeline = presets::svgf(radiance, Demodulate{});
                      std::get<1>(pipeline.stages).kernel.levels = 3;
                      return pipeline;
                  }())),
        contender("svgf", false, QUELL_FIT_CODE(presets::svgf(radiance, Demodulate{}))),
        contender("svgf/cap=16", false, QUELL_FIT_CODE([] {
                      auto pipeline = presets::svgf(radiance, Demodulate{});
                      std::get<0>(pipeline.stages).blending.inner.cap = 16;
                      return pipeline;
                  }())),
        contender("general", false, QUELL_FIT_CODE(presets::general(radiance, Demodulate{}))),
        contender("final-frame", false, QUELL_FIT_CODE(presets::final_frame(radiance, Demodulate{}))),
    };
}

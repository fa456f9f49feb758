#include "contenders.hpp"

std::vector<quell::bench::Contender> quell::bench::glossy_contenders() {
    return {
        contender("surface-clamp", false, QUELL_FIT_CODE(presets::surface_clamp(glossy))),
        contender("glossy/levels=2", true, QUELL_FIT_CODE([] {
                      auto pipeline = presets::glossy(glossy);
                      std::get<2>(pipeline.stages).kernel.levels = 2;
                      return pipeline;
                  }())),
        contender("glossy/cap=8", true, QUELL_FIT_CODE([] {
                      auto pipeline = presets::glossy(glossy);
                      std::get<1>(pipeline.stages).blending.inner.inner.cap = 8;
                      return pipeline;
                  }())),
        contender("glossy", true, QUELL_FIT_CODE(presets::glossy(glossy))),
    };
}

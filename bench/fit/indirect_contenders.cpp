#include "contenders.hpp"

#include <quell/presets/published.hpp>

std::vector<quell::bench::Contender> quell::bench::indirect_contenders() {
    return {
        contender("svgf/levels=3", false, QUELL_FIT_CODE([] {
                      auto pipeline = presets::svgf(indirect);
                      std::get<1>(pipeline.stages).kernel.levels = 3;
                      return pipeline;
                  }())),
        contender("svgf", false, QUELL_FIT_CODE(presets::svgf(indirect))),
        contender("svgf/cap=16", false, QUELL_FIT_CODE([] {
                      auto pipeline = presets::svgf(indirect);
                      std::get<0>(pipeline.stages).blending.inner.cap = 16;
                      return pipeline;
                  }())),
        contender("dual-color", true, QUELL_FIT_CODE(presets::dual_color(indirect))),
        contender("dual-cone/levels=1", true, QUELL_FIT_CODE([] {
                      auto pipeline = presets::dual_cone(indirect);
                      std::get<3>(pipeline.stages).kernel.levels = 1;
                      return pipeline;
                  }())),
        contender("dual-cone/cap=48", true, QUELL_FIT_CODE([] {
                      auto pipeline = presets::dual_cone(indirect);
                      std::get<1>(pipeline.stages).blending.inner.inner.inner.cap = 48;
                      return pipeline;
                  }())),
        contender("dual-cone", true, QUELL_FIT_CODE(presets::dual_cone(indirect))),
    };
}

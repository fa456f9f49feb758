#include "contenders.hpp"

std::vector<quell::bench::Contender> quell::bench::shadow_contenders() {
    return {
        contender("surface-clamp", false, QUELL_FIT_CODE(presets::surface_clamp(visibility))),
        contender("shadow/radius=5", true, QUELL_FIT_CODE([] {
                      auto pipeline = presets::shadow(visibility);
                      std::get<2>(pipeline.stages).kernel.radius = 5;
                      return pipeline;
                  }())),
        contender("shadow", true, QUELL_FIT_CODE(presets::shadow(visibility))),
    };
}

#include "small_contenders.hpp"

#include <quell/presets/published.hpp>

std::vector<quell::bench::Contender> quell::bench::small_contenders() {
    return {
        contender("none", false, QUELL_FIT_CODE(presets::none(radiance))),
        contender("surface", false, QUELL_FIT_CODE(presets::surface(radiance, Demodulate{}))),
        contender("blurred", true, QUELL_FIT_CODE(presets::gather_blur(radiance))),
        contender("none", false, QUELL_FIT_CODE(presets::none(visibility))),
        contender("follower", true, QUELL_FIT_CODE(presets::surface(visibility))),
        contender("short", false, QUELL_FIT_CODE([] {
                      auto pipeline = presets::surface(visibility);
                      std::get<0>(pipeline.stages).blending.alpha = 0.25f;
                      return pipeline;
                  }())),
    };
}

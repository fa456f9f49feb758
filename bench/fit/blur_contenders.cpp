#include "contenders.hpp"

#include <quell/presets/blur.hpp>

std::vector<quell::bench::Contender> quell::bench::blur_contenders() {
    return {
        contender("blur-straight/count=24", true, QUELL_FIT_CODE(presets::blur<StraightTrajectories>(radiance, {}, {.count = 24}))),
        contender("blur-straight", true, QUELL_FIT_CODE(presets::blur<StraightTrajectories>(radiance))),
        contender("blur", true, QUELL_FIT_CODE(presets::blur(radiance))),
    };
}

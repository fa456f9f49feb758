#pragma once

#include <gauntlet/shot.hpp>

#include <string>
#include <vector>

namespace quell::gauntlet {

/// A sequence in which one assumption of a denoiser does not hold.
struct Situation {
    std::string name;
    std::string about;   ///< what is broken
    std::string stage{}; ///< what of the denoiser takes it for granted
    Shot shot;
    std::string twin{};    ///< the situation in which it is not; empty: nothing is broken here
    bool is_small = false; ///< whether the smallest form has it
    std::string options{}; ///< of quell-denoise
    std::vector<int> samples{1, 4, 16, 64};
};

/// All of them. Those in which nothing is broken come first.
[[nodiscard]] std::vector<Situation> situations();

} // namespace quell::gauntlet

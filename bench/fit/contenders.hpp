#pragma once

#include "contender.hpp"

namespace quell::bench {

// What quell-fit chooses from, a file for each part since they take long to compile. Variants of one type cost nothing more.
[[nodiscard]] std::vector<Contender> rest_contenders();
[[nodiscard]] std::vector<Contender> blur_contenders();
[[nodiscard]] std::vector<Contender> shadow_contenders();
[[nodiscard]] std::vector<Contender> glossy_contenders();
[[nodiscard]] std::vector<Contender> indirect_contenders();

} // namespace quell::bench

#include "judge.hpp"

#include "known_limits.hpp"

#include <algorithm>
#include <ostream>

namespace quell::stability {

int judge(Results const& results, std::ostream& out) {
    int broken = 0;
    for (auto const& p : results.promises) {
        bool const known = known_limit(p) != nullptr;
        if (p.held() && !known) continue;
        if (!p.held() && !known) ++broken;
        out << (p.held() ? "holds, though a known limit: "
                : known  ? "known limit: "
                         : "broken: ")
            << p.subject << ' ' << p.method << ' ' << p.metric << ' ' << p.value << ", limit " << p.limit << '\n';
    }
    auto const held = std::ranges::count_if(results.promises, &Promise::held);
    out << held << " of " << results.promises.size() << " promises hold\n";
    return broken;
}

} // namespace quell::stability

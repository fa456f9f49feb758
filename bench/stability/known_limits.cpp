#include "known_limits.hpp"

#include <algorithm>

namespace quell::stability {

std::vector<KnownLimit> const& known_limits() {
    static std::vector<KnownLimit> const all{};
    return all;
}

KnownLimit const* known_limit(Promise const& promise) {
    auto const found = std::ranges::find_if(known_limits(), [&](auto const& each) {
        return each.subject == promise.subject && each.method == promise.method && each.metric == promise.metric;
    });
    return found == known_limits().end() ? nullptr : &*found;
}

} // namespace quell::stability

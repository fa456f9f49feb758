#pragma once

#include "results.hpp"

namespace quell::stability {

/// A promise that is known not to hold, and why.
struct KnownLimit {
    std::string subject, method, metric, reason;
};

/// What docs/limits.md lists. Everything else has to hold.
[[nodiscard]] std::vector<KnownLimit> const& known_limits();

/// Null where a promise has to hold.
[[nodiscard]] KnownLimit const* known_limit(Promise const& promise);

} // namespace quell::stability

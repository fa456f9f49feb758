#pragma once

#include "results.hpp"

#include <iosfwd>

namespace quell::stability {

/// A promise that is known not to hold, and why.
struct KnownLimit {
    std::string subject, method, metric, reason;
};

/// What docs/limits.md lists. Everything else has to hold.
[[nodiscard]] std::vector<KnownLimit> const& known_limits();

/// Null where a promise has to hold.
[[nodiscard]] KnownLimit const* known_limit(Promise const& promise);

/// Says which promises don't hold, which hold though they are known not to, and how many hold. Returns how many are broken that aren't
/// known limits.
int judge(Results const& results, std::ostream& out);

} // namespace quell::stability

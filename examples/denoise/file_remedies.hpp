#pragma once

#include <quell/diagnose/finding.hpp>

#include <string>

namespace quell::examples {

/// What a file's user can do about a finding beside what its remedy tells the host's code: the end of a sentence; empty: nothing.
[[nodiscard]] std::string remedy_for_files(Finding const& finding);

} // namespace quell::examples

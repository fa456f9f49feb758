#pragma once

namespace quell::bench {

/// What each value of a history, and of the scratch, is kept in: a float, or a half.
enum class Precision { single, half };

} // namespace quell::bench

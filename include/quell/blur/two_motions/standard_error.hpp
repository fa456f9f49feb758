#pragma once

#include <quell/core/real.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Standard error of a weighted mean.
template <class Real> struct StandardError {
    Real sum = Real(0.f), squares = Real(0.f), count = Real(0.f);

    QUELL_KERNEL void add(Real value, Real weight) {
        sum = fma(value, weight, sum);
        squares = fma(value * value, weight, squares);
        count = count + weight;
    }
    /// Whether the relative standard error is above `part`: (squares / n - mean^2) / n > (part mean)^2.
    QUELL_KERNEL auto above(float part) const {
        return fma(sum, sum * (-1.f / max(count, Real(1e-6f))), squares) > sum * sum * (part * part);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

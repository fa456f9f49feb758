#pragma once

#include <quell/frame/cursor/taps.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Weighted least-squares fit of a constant and five slopes. The result is the constant: the value where all regressors are 0.
template <class V> struct LeastSquares {
    using Real = real_of<V>;
    static constexpr int slopes = 5;
    Real products[slopes][slopes], regressors[slopes], weights;
    V of_regressor[slopes], sum;

    QUELL_KERNEL LeastSquares() : weights(0.f), sum(zero<V>()) {
        repeat<slopes>([&](auto i) QUELL_INLINED {
            regressors[i] = Real(0.f);
            of_regressor[i] = zero<V>();
            for (int j = 0; j < slopes; ++j) products[i][j] = Real(0.f);
        });
    }
    QUELL_KERNEL void add(Real const (&at)[slopes], V const& value, Real w) {
        repeat<slopes>([&](auto i) QUELL_INLINED {
            auto const weighted = at[i] * w;
            repeat<slopes>([&](auto j) QUELL_INLINED {
                if constexpr (j <= i) products[i][j] = fma(weighted, at[j], products[i][j]);
            });
            regressors[i] = regressors[i] + weighted;
            of_regressor[i] = add_scaled(of_regressor[i], value, weighted);
        });
        weights = weights + w;
        sum = add_scaled(sum, value, w);
    }
    /// @param ridge regularises each slope: mean square of its regressor below which the slope tends to 0
    QUELL_KERNEL V constant(float const (&ridge)[slopes]) {
        // Factorises products = L D L^T, then solves products * slope = regressors.
        Real slope[slopes], inverse[slopes];
        for (int i = 0; i < slopes; ++i) {
            auto diagonal = fma(weights, Real(ridge[i]), products[i][i]);
            slope[i] = regressors[i];
            for (int k = 0; k < i; ++k) {
                auto const below = products[i][k] * inverse[k];
                for (int j = i; j < slopes; ++j) {
                    if (j == i)
                        diagonal = diagonal - products[i][k] * below;
                    else
                        products[j][i] = products[j][i] - products[j][k] * below;
                }
                slope[i] = slope[i] - slope[k] * below;
            }
            inverse[i] = 1.f / max(diagonal, weights * 1e-9f + 1e-30f);
        }
        for (int i = slopes - 1; i >= 0; --i) {
            slope[i] = slope[i] * inverse[i];
            for (int j = i + 1; j < slopes; ++j) slope[i] = slope[i] - products[j][i] * inverse[i] * slope[j];
        }
        auto value = sum;
        auto rest = weights;
        for (int i = 0; i < slopes; ++i) {
            value = add_scaled(value, of_regressor[i], -slope[i]);
            rest = rest - regressors[i] * slope[i];
        }
        return scale(value, 1.f / max(rest, weights * 1e-6f + 1e-30f));
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

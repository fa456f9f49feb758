#pragma once

#include <quell/frame/cursor/taps.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// Weighted least-squares fit of a constant and slopes by place and by a vector. The result is the constant: the value where all
/// regressors are 0.
template <class V> struct LeastSquares {
    using Real = real_of<V>;
    static constexpr int slopes = 5; ///< across, down, and the three components of the vector
    Real products[slopes][slopes], regressors[slopes], weights;
    V of_regressor[slopes], sum;

    QUELL_KERNEL LeastSquares() : weights(0.f), sum(zero<V>()) {
        repeat<slopes>([&](auto i) QUELL_INLINED {
            regressors[i] = Real(0.f);
            of_regressor[i] = zero<V>();
            for (int j = 0; j < slopes; ++j) products[i][j] = Real(0.f);
        });
    }
    /// Weighted sums over taps of one row: the first slope's regressor and the vector differ, the second slope's regressor is the same.
    /// They are few enough to stay in registers, those of values in a loop of their own.
    struct OfRow {
        Real weights, across, across_squared, vector[3], across_by_vector[3], vector_squared[6];
        V sum, of_across, of_vector[3]; ///< of values

        QUELL_KERNEL OfRow() : weights(0.f), across(0.f), across_squared(0.f), sum(zero<V>()), of_across(zero<V>()) {
            repeat<3>([&](auto i) QUELL_INLINED {
                vector[i] = across_by_vector[i] = vector_squared[i] = vector_squared[i + 3] = Real(0.f);
                of_vector[i] = zero<V>();
            });
        }
        QUELL_KERNEL void add_regressors(Real x, vec3<Real> const& v, Real w) {
            auto const weighted = w * x;
            weights = weights + w;
            across = across + weighted;
            across_squared = fma(weighted, x, across_squared);
            repeat<3>([&](auto i) QUELL_INLINED {
                auto const one = w * component<i>(v);
                vector[i] = vector[i] + one;
                across_by_vector[i] = fma(one, x, across_by_vector[i]);
                repeat<i + 1>([&](auto j) QUELL_INLINED {
                    auto& product = vector_squared[i * (i + 1) / 2 + j];
                    product = fma(one, component<j>(v), product);
                });
            });
        }
        QUELL_KERNEL void add_value(Real x, vec3<Real> const& v, V const& value, Real w) {
            sum = add_scaled(sum, value, w);
            of_across = add_scaled(of_across, value, w * x);
            repeat<3>([&](auto i) QUELL_INLINED { of_vector[i] = add_scaled(of_vector[i], value, w * component<i>(v)); });
        }
    };
    /// @param y the second slope's regressor
    QUELL_KERNEL void add(OfRow const& row, Real y) {
        auto const plus = [](auto a, auto b) QUELL_INLINED { return a + b; };
        products[0][0] = products[0][0] + row.across_squared;
        products[1][0] = fma(row.across, y, products[1][0]);
        products[1][1] = fma(row.weights, y * y, products[1][1]);
        repeat<3>([&](auto i) QUELL_INLINED {
            products[2 + i][0] = products[2 + i][0] + row.across_by_vector[i];
            products[2 + i][1] = fma(row.vector[i], y, products[2 + i][1]);
            repeat<i + 1>([&](auto j)
                              QUELL_INLINED { products[2 + i][2 + j] = products[2 + i][2 + j] + row.vector_squared[i * (i + 1) / 2 + j]; });
            regressors[2 + i] = regressors[2 + i] + row.vector[i];
            of_regressor[2 + i] = map(plus, of_regressor[2 + i], row.of_vector[i]);
        });
        regressors[0] = regressors[0] + row.across;
        regressors[1] = fma(row.weights, y, regressors[1]);
        weights = weights + row.weights;
        of_regressor[0] = map(plus, of_regressor[0], row.of_across);
        of_regressor[1] = add_scaled(of_regressor[1], row.sum, y);
        sum = map(plus, sum, row.sum);
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

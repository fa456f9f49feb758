#pragma once

#include <quell/resolve/planes.hpp>

#include <array>
#include <cstddef>
#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET::detail {

/// How many pixels a square around a pixel has in the image, along one side of it.
/// @param at     the pixel's column or row
/// @param length of the image that way
template <class Real> QUELL_KERNEL Real pixels_around(Real at, int radius, int length) {
    auto const reach = Real(static_cast<float>(radius));
    return min(at + reach, Real(static_cast<float>(length - 1))) - max(at - reach, Real(0.f)) + 1.f;
}

/// How many pixels the square around each pixel has in the image.
template <class Real> QUELL_KERNEL Real pixels_in_square(int x, int y, int radius, Extent size) {
    return pixels_around(Real(static_cast<float>(x)) + lanes<Real>(), radius, size.width) *
           pixels_around(Real(static_cast<float>(y)), radius, size.height);
}

/// Sums of numbers over the square around each pixel, as far as that lies in the image. No sum is a difference of larger ones, so that
/// what is dark beside something bright stays exact.
/// @tparam most numbers a pixel
template <int most> class WindowSums {
    Extent size;
    Planes<most> terms, along_rows;

public:
    static constexpr int largest_radius = 16; ///< what lies beside a row in memory is zero so far

    explicit WindowSums(Extent s) : size(s), terms(s), along_rows(s) {}

    /// @tparam N   how many numbers
    /// @param radius   of the square, in pixels, at most largest_radius: its side is 2 radius + 1
    /// @param terms_of its value at (AtOnce<Real>, x, y) is a std::array of N numbers of each pixel
    /// @param use      is given (AtOnce<Real>, x, y, count, sums), and writes to no image of the sums
    template <int N, Executor E, class Terms, class Use> void around(E const& executor, int radius, Terms terms_of, Use use) {
        static_assert(N <= most);
        auto const from = terms.view(), rows = along_rows.view();
        auto const put = []<class Real>(auto const& view, int x, int y, std::array<Real, std::size_t{N}> const& values, int count) {
            for (int c = 0; c < N; ++c) store_plane<Real>(view, c, x, y, values[static_cast<std::size_t>(c)], count);
        };
        for_all_pixels(executor, size, [=]<class Real>(AtOnce<Real> at, int x, int y, int count) {
            put.template operator()<Real>(from, x, y, terms_of(at, x, y), count);
        });
        for_all_pixels(executor, size, [=]<class Real>(AtOnce<Real>, int x, int y, int count) {
            put.template operator()<Real>(rows, x, y, sums_of<N, Real>(from, x, y, -radius, radius, 1, 0), count);
        });
        int const height = size.height;
        for_all_pixels(executor, size, [=]<class Real>(AtOnce<Real> at, int x, int y, int count) {
            int const first = y - radius > 0 ? -radius : -y, last = y + radius < height ? radius : height - 1 - y;
            use(at, x, y, count, sums_of<N, Real>(rows, x, y, first, last, 0, 1));
        });
    }

private:
    template <int N, class Real>
    QUELL_KERNEL static std::array<Real, std::size_t{N}> sums_of(PlanesView<most> const& view, int x, int y, int first, int last,
                                                                 int columns, int rows) {
        std::array<Real, std::size_t{N}> sums;
        for (auto& each : sums) each = Real(0.f);
        for (int i = first; i <= last; ++i)
            for (int c = 0; c < N; ++c)
                sums[static_cast<std::size_t>(c)] =
                    sums[static_cast<std::size_t>(c)] + view.template load_component<Real>(c, x + i * columns, y + i * rows);
        return sums;
    }
    template <class Real>
    QUELL_KERNEL static void store_plane(PlanesView<most> const& view, int c, int x, int y, Real const& value, int count) {
        PlanesView<1> plane{{view.planes[c]}, view.size};
        store_pixels<Real>(plane, x, y, Value<1, Real>(value), count);
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

#pragma once

#include <quell/core/value.hpp>
#include <quell/resolve/gaussian_blur.hpp>
#include <quell/resolve/planes.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

/// Bands of frequencies of a residual, and of those of frames around, for RepeatedResidual.
namespace quell::inline QUELL_INSTRUCTION_SET::detail {

inline constexpr std::size_t repeated_bands = 3;

/// A residual and what it is smoothed by the Gaussians between the bands.
struct BlurredResidual {
    Planes<3> whole;
    std::array<Planes<3>, repeated_bands - 1> blurred;
    float of_white; ///< the part of white noise's product with itself that is left where one of both is blurred by the first

    template <Executor E>
    BlurredResidual(E const& executor, std::array<float, repeated_bands - 1> const& deviation, Planes<3> residual)
        : whole(std::move(residual)), blurred{detail::blurred(executor, whole.view(), deviation[0]),
                                              detail::blurred(executor, whole.view(), deviation[1])},
          of_white(GaussianTaps(deviation[0]).of_own_pixel()) {}
};
/// One band of it: what is finer than one Gaussian, and not finer than the one before.
struct ResidualBand {
    PlanesView<3> finer, wider;
    bool is_widest;

    ResidualBand(BlurredResidual const& residual, std::size_t band)
        : finer((band == 0 ? residual.whole : residual.blurred[band - 1]).view()),
          wider(residual.blurred[band + 1 < repeated_bands ? band : band - 1].view()), is_widest(band + 1 == repeated_bands) {}
    template <class Real> QUELL_KERNEL vec3<Real> at(int x, int y) const {
        auto const value = load_pixels<Real>(finer, x, y);
        return is_widest ? value : value - load_pixels<Real>(wider, x, y);
    }
};

/// A residual of a frame before or after, where its surfaces are now.
struct ResidualAround {
    BlurredResidual residual;
    Planes<1> is_known; ///< 1 or 0, or less where it is no new witness
};
/// One band of the residuals of the frames around.
struct BandsAround {
    struct Band {
        ResidualBand residual;
        PlanesView<1> is_known;
    };
    std::array<std::optional<Band>, 2> frames{};

    /// Of what frames around lack.
    template <class Real> struct Mean {
        vec3<Real> value;
        Real squares; ///< the mean of their squares
        Real known;   ///< how far they count, from 0 to 1
    };
    template <class Real> QUELL_KERNEL Mean<Real> mean_at(int x, int y) const {
        auto sum = zero<vec3<Real>>();
        Real squares(0.f), known(0.f);
        for (auto const& frame : frames) {
            if (!frame) continue;
            auto const here = load_pixels<Real>(frame->is_known, x, y);
            auto const value = frame->residual.template at<Real>(x, y);
            sum = add_scaled(sum, value, here), squares = fma(dot(value, value), here, squares), known = known + here;
        }
        auto const part = masked(known > Real(0.f), 1.f / max(known, Real(1e-6f)));
        return {scale(sum, part), squares * part, min(known, Real(1.f))};
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET::detail

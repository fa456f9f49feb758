#pragma once

#include <quell/link/residual/new_witness.hpp>
#include <quell/link/residual/shared_noise.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Of RepeatedResidual: the part of frames around that is left out as they have the same noise, and how far noise was taken for that of
/// single pixels.
struct RepeatedRefusal : ExactChannel<2> {
    static constexpr auto name = "repeated_refusal"; ///< of the channel
};
inline constexpr RepeatedRefusal repeated_refusal; ///< of a history

namespace detail {

/// Of a band of this frame's residual r and the mean m of those around, by the square of the light: r m, (r m)^2, r^2, m^2, and the mean of
/// the squares of those around. All but the third by how far frames around count.
template <int band> struct RepeatedProducts : ExactChannel<5> {
    static constexpr auto name = band == 0 ? "repeated_products_fine" : band == 1 ? "repeated_products_middle" : "repeated_products_wide";
};
template <int band> struct RepeatedProductsOfRows : ExactChannel<5> {
    static constexpr auto name = band == 0 ? "products_of_rows_fine" : band == 1 ? "products_of_rows_middle" : "products_of_rows_wide";
};

/// The frames around that are there.
template <bool has_next> struct FramesAround {
    using reads =
        union_of<bands_reads<Around::before>, Channels<Witness<Around::before>>,
                 std::conditional_t<has_next, union_of<bands_reads<Around::after>, Channels<Witness<Around::after>>>, Channels<>>>;

    /// Of what frames around lack, in one band.
    template <class Real> struct Mean {
        vec3<Real> value;
        Real squares; ///< the mean of their squares
    };
    template <class Real> struct Means {
        Mean<Real> of[3];
        Real known; ///< how far they count, from 0 to 1
    };
    template <class Px> QUELL_KERNEL static auto means(Px const& px) {
        using Real = typename Px::Real;
        Means<Real> all{{{zero<vec3<Real>>(), Real(0.f)}, {zero<vec3<Real>>(), Real(0.f)}, {zero<vec3<Real>>(), Real(0.f)}}, Real(0.f)};
        auto const add = [&]<Around frame>() QUELL_INLINED {
            auto const here = px[Witness<frame>{}].x;
            auto const bands = bands_of<frame>(px);
            for (int band = 0; band < 3; ++band) {
                auto const value = bands.of[band];
                auto& mean = all.of[band];
                mean.value = add_scaled(mean.value, value, here), mean.squares = fma(dot(value, value), here, mean.squares);
            }
            all.known = all.known + here;
        };
        add.template operator()<Around::before>();
        if constexpr (has_next) add.template operator()<Around::after>();
        auto const part = masked(all.known > Real(0.f), 1.f / max(all.known, Real(1e-6f)));
        for (auto& mean : all.of) mean.value = scale(mean.value, part), mean.squares = mean.squares * part;
        all.known = min(all.known, Real(1.f));
        return all;
    }
};

/// Takes the products of all bands.
template <bool has_next> struct TakeRepeated {
    static constexpr auto name = "repeated";
    using reads = union_of<bands_reads<Around::now>, typename FramesAround<has_next>::reads, Channels<LightAround>, FrameBrightness::whole>;
    using emits = Channels<RepeatedProducts<0>, RepeatedProducts<1>, RepeatedProducts<2>>;
    static constexpr int farthest_tap = 0;

    QUELL_KERNEL auto emit_channels(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const light = px[LightAround{}], per_square = 1.f / (light * light);
        auto const here = bands_of<Around::now>(px);
        auto const around = FramesAround<has_next>::means(px);
        auto const known = per_square * around.known;
        auto const products = [&](int band) QUELL_INLINED {
            auto const& mean = around.of[band];
            auto const common = dot(here.of[band], mean.value) * known;
            return Components<5, Real>{{common, common * common, dot(here.of[band], here.of[band]) * per_square,
                                        dot(mean.value, mean.value) * known, mean.squares * known}};
        };
        return emitted<Real>(RepeatedProducts<0>{}, products(0))
            .with(RepeatedProducts<1>{}, products(1))
            .with(RepeatedProducts<2>{}, products(2));
    }
};

/// Adds what all residuals tell that the picture lacks.
template <bool has_next, bool reports> struct AddRepeated {
    static constexpr auto name = "repeated residual";
    using reads = union_of<bands_reads<Around::now>, typename FramesAround<has_next>::reads,
                           Channels<RepeatedProductsOfRows<0>, RepeatedProductsOfRows<1>, RepeatedProductsOfRows<2>>,
                           FrameBrightness::whole, typename FindSharedNoise<Lacking>::whole>;
    using keeps = std::conditional_t<reports, Channels<RepeatedRefusal>, Channels<>>;
    static constexpr int farthest_tap = 16;
    float samples, caution[3], darkest;
    int radius[3];

    QUELL_KERNEL auto filter(auto px) const {
        using Real = typename decltype(px)::Real;
        auto const here = bands_of<Around::now>(px);
        auto const around = FramesAround<has_next>::means(px);
        auto off = zero<vec3<Real>>();
        auto const add = [&]<int band>() QUELL_INLINED {
            auto const sums = sum_along_column(px, RepeatedProductsOfRows<band>{}, radius[band]);
            auto const& of_window = sums.at;
            auto const v = of_window[2], u = of_window[3], w = max(of_window[4], u);
            auto const sure = of_window[0] - sqrt(of_window[1]) * caution[band];
            auto const c = min(min(sure, sqrt(u) * sqrt(v) * .98f), min(u, v));
            auto const is_common = c > Real(1e-30f);
            // x and y as they are, with each sum divided by v or u: products of small ones would be 0.
            auto const tiny = Real(1e-30f);
            auto const of_v = c / max(v, tiny), of_u = c / max(u, tiny);
            auto const b_of_v = max(c / max(w, tiny), of_v), rest = 1.f / max(1.f - of_v * of_u, Real(.03f));
            auto const x_share = clamp((b_of_v - of_v * of_u) * rest, Real(0.f), Real(1.f));
            auto const y_share = clamp(of_u * (1.f - b_of_v) * rest, Real(0.f), 1.f - x_share);
            float const part = band == 0 ? 1.f - 1.f / samples : 1.f;
            off = add_scaled(off, here.of[band], masked(is_common, x_share * part));
            off = add_scaled(off, around.of[band].value, masked(is_common, y_share * part));
        };
        add.template operator()<0>(), add.template operator()<1>(), add.template operator()<2>();
        // Of a surface that no frame around sees, the window around it tells.
        auto const known = select(around.known > Real(0.f), around.known, Real(1.f));
        auto const trust = independence(px);
        auto const by = known * trust * frame_brightness(px);
        auto const made = map(
            [&](Real old, Real more) QUELL_INLINED {
                auto const sum = fma(more, by, old);
                return select(is_finite(sum), max(sum, min(old, old * darkest)), old);
            },
            px.signal(), off);
        if constexpr (reports)
            return Result{made}.with(RepeatedRefusal{}, vec2<Real>{left_out(px), trust});
        else
            return made;
    }

private:
    template <class Px> QUELL_KERNEL static auto left_out(Px const& px) {
        auto const of = [&]<Around frame>() QUELL_INLINED { return px[ResidualThere<frame>{}].w - px[Witness<frame>{}].y; };
        if constexpr (has_next)
            return .5f * (of.template operator()<Around::before>() + of.template operator()<Around::after>());
        else
            return of.template operator()<Around::before>();
    }
};

} // namespace detail

/// Gives back to a denoised picture what frames in a row lack. Noise of samples is new in each frame, but what a filter takes out by
/// mistake, such as leaves smaller than a pixel or reflections, is lacking again where their surface has moved to. So what the residual
/// (samples minus picture) of this frame has in common with those of the frames before and after, over a window, is a measure of that
/// mistake, whatever the noise is.
///
///     Chain{presets::general(radiance), Pipeline{denoised, Spatial{RepeatedResidual<>{.samples = 4.f}}}}
///
/// All residuals are split into three bands, and those of the frames around, where their surfaces are now, are put together as their mean.
/// For each band, over a window, c is the sum of the product of this residual and that mean, less its standard error times `caution`; v and
/// u are the sums of their squares, and w is the mean of the sums of squares of each frame around: its noise is not less for the mean. The
/// mistake that is in the residual of now is b = c v / w, at least c: moving residuals between pixels takes as much off c as off w where
/// detail is finer than pixels. What is added is x now + y mean, with the least expected error: v x + c y = b and c x + u y = c.
///
/// Where a pixel holds fewer samples, more of what the finest band repeats is no mistake: a single sample sees the same point of a leaf
/// again, wherever in its pixel that lies, and a picture of such points is jagged. Of that band a part of 1 / samples is left out. And
/// noise of few samples is skewed, so that by chance more of it is alike: caution is 1 + 2 / samples times as large.
///
/// A frame around is left out where it says nothing new (NewWitness). In a first frame, and in one without frames around, the picture stays
/// as it is. The history keeps `lacking`.
/// @tparam Samples  the channel of three components that the picture was made of, linear
/// @tparam has_next whether the host knows what the frame after lacks: then frames have lacking_next and motion_next
/// @tparam reports  whether the history keeps repeated_refusal
template <ChannelTag Samples = Radiance, bool has_next = false, bool reports = false> struct RepeatedResidual {
    float samples = 1.f;                ///< of each pixel
    float caution[3] = {.7f, 1.f, 2.f}; ///< of each band: more for wider ones, whose neighbouring pixels hold the same noise
    NewWitness witness{};               ///< how far a frame around counts
    float most = 20.f;                  ///< a residual is at most so many times the light around
    float darkest = 0.2f;               ///< of the picture's light so much stays at least
    SharedNoise of_neighbours{};        ///< where neighbours share their noise, less is added, or nothing
    /// @cond
    using Next = std::conditional_t<has_next, Parts<detail::CallWitness<detail::Around::after>>, Parts<>>;
    struct NextFrame {
        using parts = Next;
    };
    template <int band> using Rows = detail::SumRows<detail::RepeatedProducts<band>, detail::RepeatedProductsOfRows<band>>;
    using parts =
        Parts<detail::FrameBrightness, detail::SumBrightnessOfRows, detail::TakeLacking<Samples>, detail::FindSharedNoise<Lacking>,
              detail::BlurResidual<detail::Around::now>, detail::CallWitness<detail::Around::before>, NextFrame,
              detail::TakeRepeated<has_next>, Rows<0>, Rows<1>, Rows<2>, detail::AddRepeated<has_next, reports>>;
    /// @endcond

    /// Its passes.
    constexpr void for_each_pass(auto&& pass) const {
        using namespace detail;
        constexpr int radius[] = {8, 10, 16};
        FrameBrightness{}.for_each_pass(pass);
        pass(SumBrightnessOfRows{}), pass(TakeLacking<Samples>{most});
        FindSharedNoise<Lacking>{of_neighbours}.for_each_pass(pass);
        BlurResidual<Around::now>{}.for_each_pass(pass);
        CallWitness<Around::before>{witness, most}.for_each_pass(pass);
        if constexpr (has_next) CallWitness<Around::after>{witness, most}.for_each_pass(pass);
        pass(TakeRepeated<has_next>{});
        pass(Rows<0>{radius[0]}), pass(Rows<1>{radius[1]}), pass(Rows<2>{radius[2]});
        float const few = max(samples, 1.f), more = 1.f + 2.f / few;
        pass(AddRepeated<has_next, reports>{
            few, {caution[0] * more, caution[1] * more, caution[2] * more}, darkest, {radius[0], radius[1], radius[2]}});
    }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

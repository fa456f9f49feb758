#pragma once

#include <quell/resolve/moved_image.hpp>
#include <quell/resolve/new_witness.hpp>
#include <quell/resolve/picture_residual.hpp>
#include <quell/resolve/residual_bands.hpp>
#include <quell/resolve/residual_sizes.hpp>
#include <quell/resolve/shared_noise.hpp>
#include <quell/resolve/window_sums.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Gives back to a denoised picture what frames in a row lack. Noise of samples is new in each frame, but what a filter takes out by
/// mistake, such as leaves smaller than a pixel or reflections, is lacking again where their surface has moved to. So what the residual
/// (samples minus picture) of this frame has in common with those of the frames before and after, over a window, is a measure of that
/// mistake, whatever the noise is.
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
/// A frame around is left out where it says nothing new (NewWitness).
struct RepeatedResidual {
    float samples = 1.f;                         ///< of each pixel
    std::array<float, 2> deviation{0.7f, 2.f};   ///< of the Gaussians between the bands, in pixels
    std::array<int, 3> radius{8, 10, 16};        ///< of each band's windows, in pixels
    std::array<float, 3> caution{.7f, 1.f, 2.f}; ///< more for wider bands, whose neighbouring pixels hold the same noise
    NewWitness witness{};                        ///< how far a frame around counts
    float most = 20.f;                           ///< a residual is at most so many times the light around
    float darkest = 0.2f;                        ///< of the picture's light so much stays at least
    SharedNoise of_neighbours{};                 ///< where neighbours share their noise, less is added, or nothing
};

namespace detail {

/// Limits values to so many times the light; what is not finite becomes 0.
template <class Real> QUELL_KERNEL vec3<Real> limited(vec3<Real> const& value, Real most) {
    return map([&](Real a) QUELL_INLINED { return masked(is_finite(a), clamp(a, -most, most)); }, value);
}

/// Adds to an image what one band of all residuals tells that a picture lacks.
/// @param caution standard errors that are taken off
/// @param part    of the band
template <Executor E>
void add_repeated(E const& executor, WindowSums<6>& sums, ResidualBand const& now, BandsAround const& around, PlanesView<1> light,
                  int radius, float caution, float part, PlanesView<3> to) {
    sums.around<5>(
        executor, radius,
        [=]<class Real>(AtOnce<Real>, int x, int y) {
            auto const bright = load_pixels<Real>(light, x, y), per_square = 1.f / (bright * bright);
            auto const here = now.template at<Real>(x, y);
            auto const [mean, squares, known] = around.template mean_at<Real>(x, y);
            auto const common = dot(here, mean) * per_square * known;
            return std::array{common, common * common, dot(here, here) * per_square, dot(mean, mean) * per_square * known,
                              squares * per_square * known};
        },
        [=]<class Real>(AtOnce<Real>, int x, int y, int count, auto const& of_window) {
            auto const v = of_window[2], u = of_window[3], w = max(of_window[4], u);
            auto const sure = of_window[0] - sqrt(of_window[1]) * caution;
            auto const c = min(min(sure, sqrt(u) * sqrt(v) * .98f), min(u, v));
            auto const is_common = c > Real(1e-30f);
            // x and y as they are, with each sum divided by v or u: products of small ones would be 0.
            auto const tiny = Real(1e-30f);
            auto const of_v = c / max(v, tiny), of_u = c / max(u, tiny);
            auto const b_of_v = max(c / max(w, tiny), of_v), rest = 1.f / max(1.f - of_v * of_u, Real(.03f));
            auto const x_share = clamp((b_of_v - of_v * of_u) * rest, Real(0.f), Real(1.f));
            auto const y_share = clamp(of_u * (1.f - b_of_v) * rest, Real(0.f), 1.f - x_share);
            auto const of_now = masked(is_common, x_share * part), of_mean = masked(is_common, y_share * part);
            auto const here = now.template at<Real>(x, y);
            auto const [mean, squares, known] = around.template mean_at<Real>(x, y);
            // Of a surface that no frame around sees, the window around it tells.
            auto const sum = load_pixels<Real>(to, x, y), more = add_scaled(scale(here, of_now), mean, of_mean);
            store_pixels<Real>(to, x, y, add_scaled(sum, more, select(known > Real(0.f), known, Real(1.f))), count);
        });
}

/// Adds a plane, times a factor, to numbers row by row.
inline void add_plane(PlanesView<1> plane, float factor, std::vector<float>& to) {
    auto sum = to.begin();
    for (int y = 0; y < plane.size.height; ++y)
        for (int x = 0; x < plane.size.width; ++x) *sum++ += factor * plane.get(0, x, y);
}

/// @throws Error where a radius or deviation is beyond reach
inline void check_rule(RepeatedResidual const& rule, std::size_t frames_around) {
    for (int const radius : rule.radius)
        if (radius < 0 || radius > WindowSums<6>::largest_radius)
            raise_error("RepeatedResidual, a radius", std::to_string(radius), "give 0 to " + std::to_string(WindowSums<6>::largest_radius));
    for (float const deviation : rule.deviation)
        if (!(deviation > 0.f && deviation <= GaussianTaps::largest_deviation))
            raise_error("RepeatedResidual::deviation", std::to_string(deviation), "give more than 0, at most 5 pixels");
    check_rule(rule.witness);
    if (frames_around > 2)
        raise_error("give_back_repeated, frames around", std::to_string(frames_around), "give that before, that after, or both");
}

} // namespace detail

/// What a picture lacks of its samples (RepeatedResidual): these minus the picture, within limits, and 0 where there is no sample.
/// @param rule     how
/// @param executor runs the passes
/// @param size     of the images
/// @param samples  that the picture was made of, linear, row by row; not finite where there is none
/// @param picture  the denoised one
/// @throws Error where these are not of one size, std::bad_alloc
template <Executor E>
[[nodiscard]] std::vector<glm::vec3> lacking_of_samples(RepeatedResidual const& rule, E const& executor, Extent size,
                                                        std::vector<glm::vec3> const& samples, std::vector<glm::vec3> const& picture) {
    using namespace detail;
    check_residual_sizes("lacking_of_samples", samples, size, size, picture);
    float const unit = light_unit(picture);
    auto const from = in_planes(size, samples, unit), of_picture = in_planes(size, picture, unit);
    WindowSums<1> sums(size);
    auto const light = light_around(executor, sums, Brightness(executor, of_picture.view()));
    auto const in = from.view(), to = of_picture.view();
    auto const bright = light.view();
    for_all_pixels(executor, size, [=, most = rule.most]<class Real>(AtOnce<Real>, int x, int y, int count) {
        auto const sample = load_pixels<Real>(in, x, y);
        auto const is_sample = is_light(sample);
        auto const off = map([&](Real s, Real p) QUELL_INLINED { return masked(is_sample, s - p); }, sample, load_pixels<Real>(to, x, y));
        store_pixels<Real>(to, x, y, limited(off, load_pixels<Real>(bright, x, y) * most), count);
    });
    std::vector<glm::vec3> lacking(samples.size());
    copy_out(to, lacking, unit);
    return lacking;
}

/// What the picture of a frame before or after lacks.
struct LackingAround {
    std::vector<glm::vec3> moved;     ///< where its surfaces are now; not finite where that is not known
    std::vector<glm::vec3> on_screen; ///< where they were there
};

/// What the picture of a frame before or after lacks, where its surfaces are now.
/// @param executor runs the pass
/// @param lacking  of that frame: what lacking_of_samples() says
/// @param motion   a view of where each surface is in that frame, less where it is now, in pixels; not finite: unknown
/// @throws Error where these are not of one size, std::bad_alloc
template <Executor E> [[nodiscard]] LackingAround lacking_moved(E const& executor, std::vector<glm::vec3> lacking, ImageView auto motion) {
    detail::check_residual_sizes("lacking_moved", lacking, motion.size, motion.size, lacking);
    auto moved = detail::moved(executor, lacking, motion, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    return {std::move(moved), std::move(lacking)};
}

/// Adds to a picture what it and the pictures of frames around lack (RepeatedResidual). Where there are none, it stays as it is.
/// @param rule     how
/// @param executor runs the passes
/// @param size     of the images
/// @param lacking  of the picture: what lacking_of_samples() says
/// @param around   what lacking_moved() says of the frame before, of that after, or of both
/// @param picture  the denoised one; is changed
/// @param same     which part of the frames around is left out, as they have the same noise, from 0 to 1 for each pixel; null: not wanted
/// @return how far noise was taken for that of single pixels, from 0, where nothing is added, to 1
/// @throws Error where these are not of one size or there are more than two frames around, std::bad_alloc
template <Executor E>
float give_back_repeated(RepeatedResidual const& rule, E const& executor, Extent size, std::vector<glm::vec3> const& lacking,
                         std::vector<LackingAround> const& around, std::vector<glm::vec3>& picture, std::vector<float>* same = nullptr) {
    using namespace detail;
    check_residual_sizes("give_back_repeated", lacking, size, size, picture);
    for (auto const& each : around)
        for (auto const* residual : {&each.moved, &each.on_screen})
            check_residual_sizes("give_back_repeated, a frame around", *residual, size, size, picture);
    check_rule(rule, around.size());
    if (same) same->assign(picture.size(), 0.f);
    if (around.empty()) return 1.f;
    float const unit = light_unit(picture);
    auto const before = in_planes(size, picture, unit);
    WindowSums<6> sums(size);
    auto const light = light_around(executor, sums, Brightness(executor, before.view()));
    auto const bright = light.view();
    BlurredResidual const now(executor, rule.deviation, in_planes(size, lacking, unit));
    std::vector<ResidualAround> frames;
    for (auto const& each : around) {
        auto residual = in_planes(size, each.moved, unit), unmoved = in_planes(size, each.on_screen, unit);
        Planes<1> is_known(size), has_new_samples(size);
        auto const value = residual.view(), on_screen = unmoved.view();
        for_all_pixels(executor, size, [=, known = is_known.view(), most = rule.most]<class Real>(AtOnce<Real>, int x, int y, int count) {
            auto const there = load_pixels<Real>(value, x, y);
            auto const limit = load_pixels<Real>(bright, x, y) * most;
            store_pixels<Real>(known, x, y, masked(is_finite(there.x), Real(1.f)), count);
            store_pixels<Real>(value, x, y, limited(there, limit), count);
            store_pixels<Real>(on_screen, x, y, limited(load_pixels<Real>(on_screen, x, y), limit), count);
        });
        if (same) add_plane(is_known.view(), 1.f / static_cast<float>(around.size()), *same);
        BlurredResidual there(executor, rule.deviation, std::move(residual));
        count_witness(executor, rule.witness, sums, now.whole.view(), there, on_screen, bright, is_known.view(), has_new_samples.view());
        if (same) add_plane(has_new_samples.view(), -1.f / static_cast<float>(around.size()), *same);
        frames.push_back({std::move(there), std::move(is_known)});
    }
    Planes<3> off(size);
    float const per_samples = 1.f / std::max(rule.samples, 1.f);
    float const trust = rule.of_neighbours.independence(shared_noise(rule.of_neighbours, now.whole.view()));
    for (std::size_t band = 0; band < repeated_bands; ++band) {
        BandsAround bands;
        for (std::size_t k = 0; k < frames.size(); ++k)
            bands.frames[k].emplace(BandsAround::Band{ResidualBand(frames[k].residual, band), frames[k].is_known.view()});
        add_repeated(executor, sums, ResidualBand(now, band), bands, bright, rule.radius[band],
                     rule.caution[band] * (1.f + 2.f * per_samples), trust * (band == 0 ? 1.f - per_samples : 1.f), off.view());
    }
    auto const to = before.view();
    for_all_pixels(executor, size, [=, off = off.view(), darkest = rule.darkest]<class Real>(AtOnce<Real>, int x, int y, int count) {
        auto const made = [&](Real old, Real more) QUELL_INLINED {
            auto const sum = old + more;
            return select(is_finite(sum), max(sum, min(old, old * darkest)), old);
        };
        store_pixels<Real>(to, x, y, map(made, load_pixels<Real>(to, x, y), load_pixels<Real>(off, x, y)), count);
    });
    copy_out(to, picture, unit);
    return trust;
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

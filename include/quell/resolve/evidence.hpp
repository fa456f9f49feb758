#pragma once

#include <quell/core/error.hpp>
#include <quell/core/light.hpp>
#include <quell/image/image_storage.hpp>
#include <quell/resolve/box_sums.hpp>
#include <quell/resolve/light_unit.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace quell::inline QUELL_INSTRUCTION_SET {

/// Chooses between two estimates of a picture by samples that neither has used: the part of the first that brings the sum of both nearest
/// to what is true, without bias whatever the noise is. Let I be the samples, A and B the estimates. Over a window, the part is
///
///     w = sum (I - B)(A - B) / sum (A - B)^2
///
/// limited to [0, 1]: the least squares of I - B by A - B. Terms are divided by the square of the luminance of A and B, so that dark and
/// bright count alike, and samples are limited to a multiple of it. Samples are held out by a checkerboard: A and B are made once without
/// the even pixels, and once without the odd ones.
///
/// What is chosen for are estimates that do use a pixel's own sample, and have a part of its noise. In A, which has many samples, that is
/// little. In B it is d, what the sample changes of B. Where samples are noisy, sum d^2 is added above and below: it is the error that
/// comes with 1 - w.
///
/// Where samples speak against A, as they do where light moves that A remembers, caution would keep a part of it. `doubt` lessens caution
/// there: it counts 1 - doubt (1 - v) of what it does, where v is the part of A without caution.
///
/// The part's own variance, n / (sum (A - B)^2)^2 with n = sum ((I - (A + B) / 2)(A - B))^2, says how far it is to be trusted over what was
/// taken before any sample was seen: a normal distribution about `at_first`.
struct Evidence {
    int radius = 12;      ///< of the window
    float dark = 0.02f;   ///< part of the picture's mean luminance that is added to the luminance that terms are divided by
    float most = 20.f;    ///< samples are at most so many times that luminance
    float caution = 2.f;  ///< how often sum d^2 counts, at least 0
    float at_first = 1.f; ///< the part where nothing is known
    float spread = 1.f;   ///< standard deviation of the part about that, before samples are seen
    float trust = 1.f;    ///< what samples say counts so much, from 0, which leaves A, to 1: less where their noise is shared (SharedNoise)
    float doubt = 0.f;    ///< how much less caution counts where samples leave nothing of A: from 0, the same, to 1, not at all

    /// For frames of so many samples of each pixel, of which caution depends: 2 at 1 sample, 0 from 16 on. Files may tell of more samples
    /// than were taken.
    /// @param samples of each pixel; less than 1 counts as 1
    [[nodiscard]] static Evidence of_samples(float samples) {
        return {.caution = std::max(2.f - 0.5f * std::log2(std::max(samples, 1.f)), 0.f)};
    }
    /// For a history that has seen later frames too, and deserves more trust: caution is 2 up to 32 samples, with a doubt that goes up to 1
    /// at 16; from then on it falls, to 0.75 at 64 samples and 0 from 97 on.
    /// @param samples of each pixel; less than 1 counts as 1
    [[nodiscard]] static Evidence with_later_frames(float samples) {
        float const octaves = std::log2(std::max(samples, 1.f)), beyond = std::max(octaves - 5.f, 0.f);
        return {.caution = std::max(2.f - 1.25f * beyond, 0.f), .doubt = std::min(octaves / 4.f, 1.f)};
    }
};

namespace detail {
/// What samples say: terms of the sums, or the sums.
struct EvidenceTerms {
    double product = 0.; ///< of I - B and A - B
    double square = 0.;  ///< of A - B
    double noise = 0.;   ///< the variance of the product
    double own = 0.;     ///< what caution has added to the product and to the square
};
/// What a held-out sample says; nothing where it is not light.
/// @param mean of the picture's luminance
QUELL_KERNEL EvidenceTerms evidence_of(Evidence const& rule, float mean, vec3<float> const& sample, vec3<float> const& a,
                                       vec3<float> const& b, vec3<float> const& b_with) {
    if (!is_light(sample)) return {};
    float const bright = fma(mean, rule.dark, 0.5f * abs(luminance(a) + luminance(b))), per = 1.f / bright;
    float product = 0, square = 0, noise = 0, cautious = 0;
    for (int c = 0; c < 3; ++c) {
        float const limited = min(sample[c], rule.most * bright), off = (a[c] - b[c]) * per, own = (b_with[c] - b[c]) * per;
        float const of_own = rule.caution * own * own;
        product += fma((limited - b[c]) * per, off, of_own);
        square += fma(off, off, of_own);
        noise += (limited - 0.5f * (a[c] + b[c])) * per * off;
        cautious += of_own;
    }
    noise = noise * noise;
    if (!is_finite(product) || !is_finite(square) || !is_finite(noise)) return {};
    return {static_cast<double>(product), static_cast<double>(square), static_cast<double>(noise), static_cast<double>(cautious)};
}
/// The part of A that sums over a window speak for, with caution or without some of it.
QUELL_KERNEL double part_without(Evidence const& rule, EvidenceTerms const& sums, double of_caution) {
    double const per_spread = 1. / (static_cast<double>(rule.spread) * static_cast<double>(rule.spread));
    double const before = sums.noise * per_spread + 1e-30, own = of_caution * sums.own;
    double const product = sums.product - own, square = sums.square - own;
    double const w = (product * square + before * static_cast<double>(rule.at_first)) / (square * square + before);
    return w < 0. ? 0. : w > 1. ? 1. : w;
}
/// The part of A that sums over a window speak for.
QUELL_KERNEL float part_of_first(Evidence const& rule, EvidenceTerms const& sums) {
    double const less = rule.doubt > 0.f ? static_cast<double>(rule.doubt) * (1. - part_without(rule, sums, 1.)) : 0.;
    return 1.f - rule.trust * (1.f - static_cast<float>(part_without(rule, sums, less)));
}
} // namespace detail

/// Sums over windows, and what follows from them.
class EvidenceSums {
    Extent size;
    float mean;
    std::vector<double> of_product, of_square, of_noise, of_own;

public:
    /// @param s               of the images
    /// @param mean_luminance of the picture
    /// @throws std::bad_alloc
    explicit EvidenceSums(Extent s, float mean_luminance = 1.f)
        : size(s), mean(mean_luminance), of_product(static_cast<std::size_t>(s.pixels()), 0.),
          of_square(static_cast<std::size_t>(s.pixels()), 0.), of_noise(static_cast<std::size_t>(s.pixels()), 0.),
          of_own(static_cast<std::size_t>(s.pixels()), 0.) {}

    /// Adds a held-out sample. What is not finite says nothing.
    /// @param rule   how terms weigh
    /// @param pixel  its place, row by row
    /// @param sample linear, as are the estimates
    /// @param a      the first estimate
    /// @param b      the second one
    /// @param b_with the second one with this sample
    void add(Evidence const& rule, std::size_t pixel, vec3<float> const& sample, vec3<float> const& a, vec3<float> const& b,
             vec3<float> const& b_with) {
        auto const terms = detail::evidence_of(rule, mean, sample, a, b, b_with);
        of_product[pixel] += terms.product, of_square[pixel] += terms.square, of_noise[pixel] += terms.noise;
        of_own[pixel] += terms.own;
    }
    /// The part of A for each pixel, row by row.
    [[nodiscard]] std::vector<float> parts(Evidence const& rule) {
        for (auto* const sums : {&of_product, &of_square, &of_noise, &of_own}) box_sums(size, *sums, rule.radius);
        std::vector<float> result(of_square.size());
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = detail::part_of_first(rule, {of_product[i], of_square[i], of_noise[i], of_own[i]});
        return result;
    }
};

/// Takes half of a view's samples out, by a checkerboard: they become missing ones.
/// @param view     of the samples; is changed
/// @param left_out pixels whose x + y is even (0) or odd (1)
inline void leave_out(ImageView auto const& view, int left_out) {
    for (int y = 0; y < view.size.height; ++y)
        for (int x = (left_out + y) % 2; x < view.size.width; x += 2)
            for (int c = 0; c < std::remove_cvref_t<decltype(view)>::components; ++c)
                view.set(c, x, y, std::numeric_limits<float>::quiet_NaN());
}

namespace detail {
/// @throws Error where an image of parts_by_evidence() has another number of pixels
inline void check_evidence(char const* what, std::size_t count, Extent size) {
    if (count != static_cast<std::size_t>(size.pixels()))
        raise_error(std::string("parts_by_evidence: ") + what, std::to_string(count) + " pixels for an image of " + to_string(size),
                    "give one value for each pixel, row by row");
}
} // namespace detail

/// What part of the first of two estimates is best at each pixel, row by row: see Evidence.
/// @param rule      how
/// @param size      of the images
/// @param samples   what the estimates are made of, linear, row by row
/// @param b         the second estimate, made of all samples
/// @param a_without a_without(left_out): the first estimate, made without the samples that leave_out() takes out; row by row
/// @param b_without the same of the second
/// @throws Error where one of these is not of that size, std::bad_alloc
template <class A, class B>
[[nodiscard]] std::vector<float> parts_by_evidence(Evidence const& rule, Extent size, std::vector<glm::vec3> const& samples,
                                                   std::vector<glm::vec3> const& b, A&& a_without, B&& b_without) {
    detail::check_evidence("the samples", samples.size(), size);
    detail::check_evidence("the second estimate", b.size(), size);
    EvidenceSums sums(size, static_cast<float>(detail::mean_brightness(b)));
    for (int const left_out : {0, 1}) {
        std::vector<glm::vec3> const first = a_without(left_out), second = b_without(left_out);
        detail::check_evidence("the first estimate without samples", first.size(), size);
        detail::check_evidence("the second estimate without samples", second.size(), size);
        for (int y = 0; y < size.height; ++y)
            for (int x = (left_out + y) % 2; x < size.width; x += 2) {
                auto const at = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x);
                sums.add(rule, at, samples[at], first[at], second[at], b[at]);
            }
    }
    return sums.parts(rule);
}

} // namespace quell::inline QUELL_INSTRUCTION_SET

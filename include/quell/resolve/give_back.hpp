#pragma once

#include <quell/frame/frame.hpp>
#include <quell/resolve/repeated_residual.hpp>
#include <quell/resolve/residual_feedback.hpp>

#include <utility>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {

/// An image of three components, row by row.
template <ImageView V> std::vector<glm::vec3> colours_in(V const& image) {
    static_assert(V::components == 3,
                  "GiveBack: the signal and the picture must have three components; what comes back into colours would not "
                  "come back into alpha");
    std::vector<glm::vec3> colours;
    colours.reserve(static_cast<std::size_t>(image.size.pixels()));
    for (int y = 0; y < image.size.height; ++y)
        for (int x = 0; x < image.size.width; ++x) colours.emplace_back(image.get(0, x, y), image.get(1, x, y), image.get(2, x, y));
    return colours;
}

/// An image of a frame as planes of floats: a copy, where the frame keeps it in another way.
template <ChannelTag C> struct AsPlanes {
    std::optional<ImageOf<Planar<>, C>> copy{};
    ViewOf<Planar<>, C> view{};

    template <ImageView V> explicit AsPlanes(V const& from) {
        if constexpr (std::is_same_v<V, ViewOf<Planar<>, C>>)
            view = from;
        else {
            view = copy.emplace(from.size).view();
            for (int y = 0; y < from.size.height; ++y)
                for (int x = 0; x < from.size.width; ++x)
                    for (int c = 0; c < C::components; ++c) view.set(c, x, y, from.get(c, x, y));
        }
    }
};

} // namespace detail

/// Gives back to each picture, behind a pipeline, the light that its filter took out by mistake: by ResidualFeedback, and of what is still
/// lacking then by RepeatedResidual, for which it keeps what the last picture lacked. A picture that is as its samples stays as it is.
///
///     GiveBack give_back{16}; // samples of each pixel
///     for (;;) {
///         render(frame);
///         auto const denoised = run(denoise, frame, history);
///         show(give_back.apply(radiance, denoised, frame, history));
///     }
///
/// For a CPU, behind a pipeline of one signal of three components. With alpha it is not there: colours of a film that is not opaque would
/// no longer be those of what covers it. What puts the picture together from several frames
/// or makes it larger stands behind it.
class GiveBack {
    std::vector<glm::vec3> lacking{};

public:
    /// What tells surfaces apart, and where they were.
    using Guides = Views<Planar<>, Channels<Normal, Depth, Motion>>;

    /// How a picture was made of the frame before.
    struct Past {
        bool has_past = false;  ///< the frame before was given too, and history went on from it
        bool is_judged = false; ///< samples chose between history and the frame by itself
    };

    ResidualFeedback feedback; ///< how light is given back by one frame
    RepeatedResidual repeated; ///< how by two

    /// @param samples of each pixel; where they are not known, 1
    explicit GiveBack(float samples) : feedback{.samples = samples}, repeated{.samples = samples} {}

    /// Gives light back to what a pipeline made of a frame.
    /// @param signal   the channel that it denoises
    /// @param denoised the view that run() returned
    /// @param frame    with the signal, normal, depth and motion, the latter in quell's own convention
    /// @param history  that the frame was run with: it says whether the frame had a past
    /// @param executor runs the kernels
    /// @return the picture, linear, row by row
    /// @throws Error where images are not of one size, std::bad_alloc
    template <ChannelTag Signal, ImageView V, class Set, class Storage, class H, Executor E = Simd>
    [[nodiscard]] std::vector<glm::vec3> apply(Signal signal, V const& denoised, Frame<Set, Storage> const& frame, H const& history,
                                               E const& executor = {}) {
        auto picture = detail::colours_in(denoised);
        detail::AsPlanes<Normal> const normals(frame[normal].view());
        detail::AsPlanes<Depth> const depths(frame[depth].view());
        detail::AsPlanes<Motion> const motions(frame[motion].view());
        Guides const guides{{normals.view}, {depths.view}, {motions.view}};
        apply(executor, detail::colours_in(frame[signal].view()), guides, {.has_past = history.statistics().frames > 1}, picture);
        return picture;
    }
    /// The same for images of any other origin.
    /// @param executor runs the kernels
    /// @param samples  that the picture was made of, linear, row by row; not finite where there is none
    /// @param guides   a normal of zero or an infinite depth: none; motion that is not finite: unknown
    /// @param past     how the picture was made of the frame before
    /// @param picture  the denoised one; is changed
    /// @throws Error where images are not of one size, std::bad_alloc
    template <Executor E>
    void apply(E const& executor, std::vector<glm::vec3> const& samples, Guides const& guides, Past past, std::vector<glm::vec3>& picture) {
        auto before = std::exchange(lacking, {}); // after an error it is not known
        if (!past.has_past || before.size() != picture.size()) before.clear();
        auto rule = feedback;
        if (!rule.shares) rule.shares = ResidualFeedbackShares::of_frame(rule.samples, past.has_past, past.is_judged);
        feed_back_residual(rule, executor, samples, guides.view(normal), guides.view(depth), picture);
        auto const size = guides.view(motion).size;
        auto now = lacking_of_samples(repeated, executor, size, samples, picture);
        if (!before.empty())
            give_back_repeated(repeated, executor, size, now, {lacking_moved(executor, before, guides.view(motion))}, picture);
        lacking = std::move(now);
    }
    /// Drops what it keeps: for cuts.
    void forget() { lacking = std::vector<glm::vec3>(); }
    /// What it keeps.
    [[nodiscard]] std::size_t bytes() const { return lacking.capacity() * sizeof(glm::vec3); }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET

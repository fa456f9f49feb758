#include <denoise/residual_links.hpp>

#include <quell/execute/threads.hpp>
#include <quell/image/borrowed.hpp>
#include <quell/link/residual/repeated_residual.hpp>
#include <quell/link/residual/residual_feedback.hpp>
#include <quell/pipeline/chain.hpp>
#include <quell/pipeline/plan.hpp>

#include <limits>

namespace quell::examples {

namespace detail {

inline constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// From now on an image of a frame is this one, where it lies.
inline void refer(auto& image, quell_library::Image const& to) {
    std::ptrdiff_t constexpr element = sizeof(float);
    image = {reinterpret_cast<float const*>(to.data), image.extent, to.pixel_stride / element, to.row_stride / element,
             to.component_stride / element};
}
inline void refer(Borrowed<>::Image<3>& image, LinearPicture const& to) {
    image = {to.values.data(), to.size, 1, to.size.width, static_cast<std::ptrdiff_t>(to.pixels())};
}

/// A link with its frame and history.
template <class Policy> struct Link {
    using Of = Pipeline<Denoised, Spatial<Policy>>;
    Frame<typename Of::reads, Borrowed<>> frame;
    History<Of> history;

    explicit Link(Extent size) : frame(size), history(size, of({})) {}
    static Of of(Policy const& policy) { return Pipeline{denoised, Spatial{policy}}; }
    void run(Policy const& policy, int threads, LinearPicture& to) {
        run_into(to.target(), of(policy), frame, history, Threads<>{.count = threads});
    }
    void take(LinearPicture const& samples, LinearPicture const& picture) {
        refer(frame[radiance], samples), refer(frame[denoised], picture);
    }
};

/// The link of frames of a size.
template <class L> L& link_of(std::unique_ptr<L>& link, Extent size) {
    if (!link || !(link->frame.size == size)) link = std::make_unique<L>(size);
    return *link;
}

} // namespace detail

using namespace detail;

struct ResidualLinks::Feedback : Link<ResidualFeedback<Radiance, true>> {
    using Link::Link;
};
template <bool has_next> struct ResidualLinks::Repeated : Link<RepeatedResidual<Radiance, has_next, true>> {
    using Link<RepeatedResidual<Radiance, has_next, true>>::Link;
};
struct ResidualLinks::Next : Link<LackingOfSamples<Radiance>> {
    using Link::Link;
};

ResidualLinks::ResidualLinks(int count) : threads(count) {}
ResidualLinks::~ResidualLinks() = default;

std::optional<float> ResidualLinks::feed_back(Denoiser const& denoiser, ResidualFeedbackShares const& shares, LinearPicture& light) {
    auto const normals = denoiser.seen(normal.name), depths = denoiser.seen(depth.name);
    if (normals.data == nullptr || depths.data == nullptr) return std::nullopt;
    auto& link = link_of(feedback, light.size);
    refer(link.frame[normal], normals), refer(link.frame[depth], depths);
    refer(link.frame[radiance], denoiser.seen_light()), refer(link.frame[denoised], light);
    if (other.values.size() != light.values.size()) other = LinearPicture(light.size);
    link.run({.shares = shares}, threads, other);
    std::swap(light, other);
    return link.history[noise_independence].get(0, 0, 0);
}

ResidualLinks::Refusal ResidualLinks::give_back_repeated(PictureOfSamples const& here, long long number, int count,
                                                         PictureOfSamples const* after, LinearPicture& picture) {
    auto const size = here.samples.size;
    auto const give_back = [&](auto& link) {
        refer(link.frame[motion], here.motion->image);
        link.take(here.samples, here.denoised);
        link.frame.number = number;
        link.run({.samples = static_cast<float>(count)}, threads, picture);
        auto const refused = link.history[repeated_refusal];
        Refusal told{refused.get(1, 0, 0), {}};
        told.same.reserve(picture.pixels());
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) told.same.push_back(refused.get(0, x, y));
        return told;
    };
    if (!here.motion_next) return give_back(link_of(alone, size));
    auto& link = link_of(with_next, size);
    refer(link.frame[motion_next], here.motion_next->image);
    LinearPicture lacks(size, none);
    if (after != nullptr) {
        auto& lacking = link_of(next, size);
        lacking.take(after->samples, after->denoised);
        lacking.run({}, threads, lacks);
    }
    refer(link.frame[lacking_next], lacks);
    return give_back(link);
}

void ResidualLinks::forget() { feedback.reset(), alone.reset(), with_next.reset(), next.reset(); }
void ResidualLinks::release_scratch() {
    feedback.reset(), next.reset(), other = {};
    if (alone) alone->history.release_scratch();
    if (with_next) with_next->history.release_scratch();
}
double ResidualLinks::bytes_per_pixel() const {
    auto const of = [](auto const& link) { return link ? link->history.bytes_per_pixel() : 0.; };
    return of(feedback) + of(alone) + of(with_next) + of(next) + (other.empty() ? 0. : static_cast<double>(sizeof(glm::vec3)));
}

std::string plans_of_residual_links() {
    auto const plan = [](auto const& policy) { return to_string(plan_of(Pipeline{denoised, Spatial{policy}})); };
    return "\nresidual feedback, behind each signal\n\n" + plan(ResidualFeedback<Radiance, true>{}) +
           "\nrepeated residual, behind the picture\n\n" + plan(RepeatedResidual<Radiance, true, true>{});
}

} // namespace quell::examples

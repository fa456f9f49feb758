#include <denoise/guide_images.hpp>
#include <denoise/layout_changes.hpp>
#include <denoise/light_split.hpp>
#include <denoise/residual_links.hpp>

#include <quell/execute/threads.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/link/residual/repeated_residual.hpp>
#include <quell/link/residual/residual_feedback.hpp>
#include <quell/pipeline/chain.hpp>
#include <quell/pipeline/plan.hpp>

#include <limits>

namespace quell::examples {

namespace detail {

inline constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// A picture as an image that pipelines write.
struct PictureView {
    static constexpr int components = 3;
    Extent size;
    glm::vec3* pixels;

    explicit PictureView(metrics::Picture& picture) : size(picture.size), pixels(picture.pixels.data()) {}
    [[nodiscard]] glm::vec3& at(int x, int y) const { return pixels[static_cast<std::ptrdiff_t>(y) * size.width + x]; }
    [[nodiscard]] float get(int c, int x, int y) const { return at(x, y)[c]; }
    void set(int c, int x, int y, float value) const { at(x, y)[c] = value; }
};

inline void fill(ImageView auto const& to, metrics::Picture const& from) {
    LayoutChanges::add();
    auto pixel = from.pixels.begin();
    for (int y = 0; y < from.size.height; ++y)
        for (int x = 0; x < from.size.width; ++x, ++pixel)
            for (int c = 0; c < 3; ++c) to.set(c, x, y, (*pixel)[c]);
}

/// A link with its frame and history.
template <class Policy> struct Link {
    using Of = Pipeline<Denoised, Spatial<Policy>>;
    Frame<typename Of::reads> frame;
    History<Of> history;

    explicit Link(Extent size) : frame(size), history(size, of({})) {}
    static Of of(Policy const& policy) { return Pipeline{denoised, Spatial{policy}}; }
    void run(Policy const& policy, int threads, metrics::Picture& to) {
        run_into(PictureView(to), of(policy), frame, history, Threads<>{.count = threads});
    }
    void take(metrics::Picture const& samples, metrics::Picture const& picture) {
        fill(frame[radiance].view(), samples), fill(frame[denoised].view(), picture);
    }
    [[nodiscard]] double bytes_per_pixel() const {
        int floats = 0;
        for_each_channel(typename Of::reads{}, [&](auto channel) { floats += channel.components; });
        return history.bytes_per_pixel() + static_cast<double>(floats) * sizeof(float);
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

std::optional<float> ResidualLinks::feed_back(io::ExrImage const& image, io::ChannelNames const& names,
                                              ResidualFeedbackShares const& shares, metrics::Picture& light) {
    if (!image.has_all(io::planes_of(Channels<Normal, Depth>{}, names))) return std::nullopt;
    auto& link = link_of(feedback, image.size);
    load_guides(Channels<Normal, Depth>{}, link.frame, image, names);
    link.take(picture_of(image, io::sources_of(names, radiance), none), light);
    link.run({.shares = shares}, threads, light);
    return link.history[noise_independence].get(0, 0, 0);
}

ResidualLinks::Refusal ResidualLinks::give_back_repeated(PictureOfSamples const& here, long long number, int count,
                                                         PictureOfSamples const* after, metrics::Picture& picture) {
    auto const size = here.image.size;
    auto const give_back = [&](auto& link) {
        load_guides(Channels<Motion>{}, link.frame, here.image, here.names);
        link.take(here.samples, here.denoised);
        link.frame.number = number;
        link.run({.samples = static_cast<float>(count)}, threads, picture);
        auto const refused = link.history[repeated_refusal];
        Refusal told{refused.get(1, 0, 0), {}};
        told.same.reserve(picture.pixels.size());
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) told.same.push_back(refused.get(0, x, y));
        return told;
    };
    if (!here.image.has_all(io::planes_of(Channels<MotionNext>{}, here.names))) return give_back(link_of(alone, size));
    auto& link = link_of(with_next, size);
    load_guides(Channels<MotionNext>{}, link.frame, here.image, here.names);
    metrics::Picture lacks{size, std::vector<glm::vec3>(here.image.pixels(), glm::vec3(none))};
    if (after != nullptr) {
        auto& lacking = link_of(next, size);
        lacking.take(after->samples, after->denoised);
        lacking.run({}, threads, lacks);
    }
    fill(link.frame[lacking_next].view(), lacks);
    return give_back(link);
}

void ResidualLinks::forget() { feedback.reset(), alone.reset(), with_next.reset(), next.reset(); }
void ResidualLinks::release_scratch() {
    feedback.reset(), next.reset();
    if (alone) alone->history.release_scratch();
    if (with_next) with_next->history.release_scratch();
}
double ResidualLinks::bytes_per_pixel() const {
    auto const of = [](auto const& link) { return link ? link->bytes_per_pixel() : 0.; };
    return of(feedback) + of(alone) + of(with_next) + of(next);
}

std::string plans_of_residual_links() {
    auto const plan = [](auto const& policy) { return to_string(plan_of(Pipeline{denoised, Spatial{policy}})); };
    return "\nresidual feedback, behind each signal\n\n" + plan(ResidualFeedback<Radiance, true>{}) +
           "\nrepeated residual, behind the picture\n\n" + plan(RepeatedResidual<Radiance, true, true>{});
}

} // namespace quell::examples

#include "resolved_denoiser.hpp"

#include "images_of_frame.hpp"
#include "strips.hpp"
#include "wrapped_denoiser.hpp"

#include <quell/presets/general.hpp>
#include <quell/presets/resolve.hpp>

#include <algorithm>

namespace quell_library {

namespace {

using quell::Extent;

/// What is denoised already.
template <class Signal> inline constexpr auto resolve_of = quell::presets::resolve(quell::presets::none(Signal{}));
template <class Signal> using ResolveOf = std::remove_const_t<decltype(resolve_of<Signal>)>;
constexpr int past_frames = quell::Resolve<>::past_frames;

/// What was resolved so far: a colour and alpha of their own, as a colour is clamped by its brightness.
/// @tparam Signal of so many components: none has another meaning here
template <class Signal> class Resolver {
    static constexpr int n = Signal::components;
    quell::History<ResolveOf<Signal>, OwnImages> history;

public:
    explicit Resolver(Extent output) : history(output, resolve_of<Signal>, OwnImages{}) {}

    /// @throws quell::Error for a jitter that is out of range
    void before_picture(auto const& frame) { quell::detail::ResolvedRun::before_picture(frame, history); }
    /// @param picture has the components in its planes from `first` on
    void run(auto const& picture, int first, auto const& frame, Strips const& executor, Image const& output) {
        typename OwnImages::Image<n>::View part{};
        part.size = picture.size;
        std::copy_n(picture.planes + first, n, part.planes);
        HostTarget<n> const target{output.data + first * output.component_stride,
                                   history.size(),
                                   output.component_stride,
                                   output.pixel_stride,
                                   output.row_stride,
                                   output.is_half};
        quell::detail::ResolvedRun::of_picture(part, resolve_of<Signal>, frame, history, executor, target);
    }
    void forget() { history.forget(); }
    void release_scratch() { history.release_scratch(); }
    [[nodiscard]] std::size_t bytes() const { return history.bytes(); }
};

/// @tparam n       components of the output
/// @tparam Signals its parts, in order: a colour, alpha
template <int n, class... Signals> class ResolvedDenoiser final : public WrappedDenoiser {
    using Guides = quell::Channels<quell::Motion, quell::Depth>;

    std::size_t motion, depth; ///< among a frame's channels
    Extent output_size;
    Memory memory;
    StripPool strips;
    Strips executor;
    quell::Frame<Guides, HostImages> frame;
    std::optional<OwnImages::Image<n>> picture;                ///< denoised, before it is resolved
    std::optional<std::tuple<Resolver<Signals>...>> resolvers; ///< made by the first frame

public:
    ResolvedDenoiser(std::unique_ptr<CompiledDenoiser> d, Way const& way, Extent size, Extent output, Parallel const& parallel,
                     Memory const& m)
        : WrappedDenoiser(std::move(d)), output_size(quell::detail::checked(output)), memory(m), executor{parallel, &strips}, frame(size) {
        auto const channels = channels_of_resolved(way);
        auto const place_of = [&](std::string_view name) {
            return static_cast<std::size_t>(std::ranges::find(channels, name, &ReadChannel::name) - channels.begin());
        };
        motion = place_of(quell::motion.name), depth = place_of(quell::depth.name);
    }

    void run(std::span<FrameImages const> window, Image const& output) override {
        try {
            resolve(window, output);
        } catch (quell::Error const&) { // a frame that is refused changes nothing
            throw;
        } catch (...) { // a history has seen a frame that another one, or the caller, has not
            forget();
            throw;
        }
    }
    void forget() override {
        denoiser->forget();
        each([](auto& resolver, int) { resolver.forget(); });
    }
    void release_scratch() override {
        denoiser->release_scratch();
        each([](auto& resolver, int) { resolver.release_scratch(); });
        picture.reset(), frame = decltype(frame)({1, 1}), strips.release();
    }
    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = denoiser->bytes() + strips.bytes() + (picture ? picture->bytes() : 0);
        if (resolvers) std::apply([&](auto const&... resolver) { ((sum += resolver.bytes()), ...); }, *resolvers);
        return sum;
    }

private:
    void use_memory() const { CallersMemory::current() = memory; }
    /// The denoiser does not look at channels behind its own.
    void resolve(std::span<FrameImages const> window, Image const& output) {
        auto const& given = window.front();
        use_memory();
        take(given);
        if (!resolvers) resolvers.emplace(Resolver<Signals>(output_size)...);
        if (!picture || !(picture->size() == given.size)) picture.emplace(given.size);
        auto const view = picture->view();
        denoiser->run(window, image_of_view(view));
        use_memory();
        each([&](auto& resolver, int) { resolver.before_picture(frame); });
        each([&](auto& resolver, int first) { resolver.run(view, first, frame, executor, output); });
    }
    /// @throws quell::Error where there is no motion or no depth
    void take(FrameImages const& given) {
        if (!(frame.size == given.size)) frame = decltype(frame)(given.size);
        auto const refer = [&](auto channel, std::size_t place) {
            if (given.channels[place].data == nullptr)
                throw quell::Error("channel '" + std::string(channel.name) + "'", "no memory", "point it at its pixels");
            frame[channel].refer_to(given.channels[place]);
        };
        refer(quell::motion, motion), refer(quell::depth, depth);
        frame.camera = given.camera, frame.number = given.number;
    }
    void each(auto const& function) {
        if (!resolvers) return;
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            int first = 0;
            ((function(std::get<i>(*resolvers), first), first += Signals::components), ...);
        }
        (std::index_sequence_for<Signals...>{});
    }
};

} // namespace

bool can_resolve(Way const& way) { return way.output_components == 1 || way.output_components == 3 || way.output_components == 4; }

std::vector<ReadChannel> channels_of_resolved(Way const& way) {
    auto channels = way.channels;
    for_each_channel(quell::Channels<quell::Motion, quell::Depth>{}, [&](auto channel) {
        if (!way.place_of(channel.name))
            channels.push_back({.name = channel.name, .components = channel.components, .is_guide = channel.is_guide});
    });
    return channels;
}

std::string plan_of_resolved(Way const& way) {
    int const n = way.output_components, parts = n == 4 ? 2 : 1;
    int const kept = (past_frames + 1) * (n + 3 * parts), scratch = 2 * (n + parts) + n;
    return way.plan() + "Then anti-aliased, each pixel of the output from " + std::to_string(past_frames + 1) + " frames, which takes " +
           std::to_string((kept + scratch) * static_cast<int>(sizeof(float))) + " bytes a pixel of the frames.\n";
}

std::unique_ptr<CompiledDenoiser> make_resolved(std::unique_ptr<CompiledDenoiser> denoiser, Way const& way, Extent size, Extent output,
                                                Parallel const& parallel, Memory const& memory) {
    using namespace quell;
    switch (way.output_components) {
    case 1:
        return std::make_unique<ResolvedDenoiser<1, Visibility>>(std::move(denoiser), way, size, output, parallel, memory);
    case 4:
        return std::make_unique<ResolvedDenoiser<4, Radiance, Visibility>>(std::move(denoiser), way, size, output, parallel, memory);
    default:
        return std::make_unique<ResolvedDenoiser<3, Radiance>>(std::move(denoiser), way, size, output, parallel, memory);
    }
}

} // namespace quell_library

#include "steady_denoiser.hpp"

#include "host_images.hpp"
#include "images_of_frame.hpp"
#include "on_own_images.hpp"
#include "take_rows.hpp"
#include "wrapped_denoiser.hpp"

#include <quell/pipeline/steady_guides.hpp>

#include <algorithm>

namespace quell_library {

namespace {

template <class C> class SteadyDenoiser final : public WrappedDenoiser {
    using Copied = quell::Channels<quell::Motion, C>;

    std::vector<ReadChannel> const& channels;
    Memory memory;
    OnOwnImages executor;
    quell::Frame<Copied, OwnImages> frame;
    quell::SteadyGuides<quell::Channels<C>, OwnImages> steady;
    std::vector<FrameImages> changed{1};

public:
    SteadyDenoiser(std::unique_ptr<CompiledDenoiser> d, std::vector<ReadChannel> const& c, quell::Extent size, Parallel const& parallel,
                   Memory const& m)
        : WrappedDenoiser(std::move(d)), channels(c), memory(m), executor{parallel}, frame((use(m), size)), steady(size) {}

    void run(std::span<FrameImages const> window, Image const& output) override {
        use(memory);
        take(window.front());
        try {
            steady.apply(frame, executor);
            denoiser->run(changed, output);
        } catch (...) { // the frame is among the guide's already
            steady.forget();
            throw;
        }
    }
    void forget() override { denoiser->forget(), steady.forget(); }
    void release_scratch() override { denoiser->release_scratch(), frame = decltype(frame)({1, 1}); }
    [[nodiscard]] std::size_t bytes() const override {
        return denoiser->bytes() + steady.bytes() + frame[quell::motion].bytes() + frame[C{}].bytes();
    }

private:
    static void use(Memory const& memory) { CallersMemory::current() = memory; }
    /// Copies motion and guide, and lets the frame that is denoised have these.
    void take(FrameImages const& given) {
        if (!(frame.size == given.size)) frame = decltype(frame)(given.size);
        auto& images = changed.front();
        images = given;
        for_each_channel(Copied{}, [&](auto channel) {
            auto const place = std::ranges::find(channels, channel.name, &ReadChannel::name);
            auto& image = images.channels[static_cast<std::size_t>(place - channels.begin())];
            auto const view = frame[channel].view();
            for_each_strip(executor.parallel, frame.size.height, [&](int y0, int y1) {
                take_rows(image, channel.components, view.planes, view.row_stride(), frame.size.width, y0, y1);
            });
            image = image_of_view(view);
        });
        frame.camera = given.camera, frame.number = given.number;
    }
};

} // namespace

template <class C> std::string plan_of_steady() {
    // A copy of motion and guide; of the guide a mean and its number of frames, of this frame and the last one, and what comes out.
    constexpr int floats = quell::Motion::components + C::components + 2 * (C::components + 1) + C::components;
    return "Before it, " + std::string(C::name) + " is accumulated along the motion, over 8 frames at most, which takes " +
           std::to_string(floats * static_cast<int>(sizeof(float))) + " bytes a pixel of the frames.\n\n";
}
template <class C>
std::unique_ptr<CompiledDenoiser> with_steady_guide(std::unique_ptr<CompiledDenoiser> denoiser, std::vector<ReadChannel> const& channels,
                                                    quell::Extent size, Parallel const& parallel, Memory const& memory) {
    return std::make_unique<SteadyDenoiser<C>>(std::move(denoiser), channels, size, parallel, memory);
}

#define QUELL_STEADY(C)                                                                                                                    \
    template std::string plan_of_steady<C>();                                                                                              \
    template std::unique_ptr<CompiledDenoiser> with_steady_guide<C>(std::unique_ptr<CompiledDenoiser>, std::vector<ReadChannel> const&,    \
                                                                    quell::Extent, Parallel const&, Memory const&);
QUELL_STEADY(quell::Depth)
QUELL_STEADY(quell::Albedo)
#undef QUELL_STEADY

} // namespace quell_library

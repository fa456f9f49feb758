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

using quell::Extent;

class SteadyDenoiser final : public WrappedDenoiser {
    template <class C> using Steady = quell::SteadyGuides<quell::Channels<C>, OwnImages>;
    using Copied = quell::Channels<quell::Motion, quell::Depth, quell::Albedo>;

    std::vector<ReadChannel> const& channels;
    SteadyChoice which;
    Memory memory;
    OnOwnImages executor;
    quell::Frame<Copied, OwnImages> frame;
    std::optional<Steady<quell::Depth>> depth;
    std::optional<Steady<quell::Albedo>> albedo;
    std::vector<FrameImages> changed{1};

public:
    SteadyDenoiser(std::unique_ptr<CompiledDenoiser> d, std::vector<ReadChannel> const& c, SteadyChoice w, Extent size,
                   Parallel const& parallel, Memory const& m)
        : WrappedDenoiser(std::move(d)), channels(c), which(w), memory(m), executor{parallel}, frame((use(m), size)) {
        make_histories();
    }

    void run(std::span<FrameImages const> window, Image const& output) override {
        use(memory);
        take(window.front());
        try {
            if (depth) depth->apply(frame, executor);
            if (albedo) albedo->apply(frame, executor);
            denoiser->run(changed, output);
        } catch (...) { // the frame is among the guides' already
            forget_guides();
            throw;
        }
    }
    void forget() override { denoiser->forget(), forget_guides(); }
    void release_scratch() override { denoiser->release_scratch(), frame = decltype(frame)({1, 1}); }
    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = denoiser->bytes() + (depth ? depth->bytes() : 0) + (albedo ? albedo->bytes() : 0);
        for_each_channel(Copied{}, [&](auto channel) { sum += frame[channel].bytes(); });
        return sum;
    }

private:
    static void use(Memory const& memory) { CallersMemory::current() = memory; }
    void make_histories() {
        if (which.depth) depth.emplace(frame.size);
        if (which.albedo) albedo.emplace(frame.size);
    }
    void forget_guides() {
        if (depth) depth->forget();
        if (albedo) albedo->forget();
    }
    /// Copies motion and guides, and lets the frame that is denoised have these.
    void take(FrameImages const& given) {
        if (!(frame.size == given.size)) frame = decltype(frame)(given.size);
        auto& images = changed.front();
        images = given;
        for_each_channel(Copied{}, [&]<class C>(C channel) {
            auto const place = std::ranges::find(channels, channel.name, &ReadChannel::name);
            if (place == channels.end()) return;
            auto& image = images.channels[static_cast<std::size_t>(place - channels.begin())];
            auto const view = frame[channel].view();
            for_each_strip(executor.parallel, frame.size.height, [&](int y0, int y1) {
                take_rows(image, C::components, view.planes, view.row_stride(), frame.size.width, y0, y1);
            });
            image = image_of_view(view);
        });
        frame.camera = given.camera, frame.number = given.number;
    }
};

} // namespace

std::unique_ptr<CompiledDenoiser> with_steady_guides(std::unique_ptr<CompiledDenoiser> denoiser, std::vector<ReadChannel> const& channels,
                                                     SteadyChoice which, Extent size, Parallel const& parallel, Memory const& memory) {
    return std::make_unique<SteadyDenoiser>(std::move(denoiser), channels, which, size, parallel, memory);
}

} // namespace quell_library

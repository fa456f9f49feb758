#include "given_back.hpp"

#include "host_images.hpp"
#include "on_own_images.hpp"
#include "take_rows.hpp"
#include "wrapped_denoiser.hpp"

#include <quell/resolve/give_back.hpp>

#include <algorithm>

namespace quell_library {

namespace {

using quell::Extent;
using Colours = std::vector<glm::vec3>;

/// That the functions of quell's take a pixel while they run, as measured.
constexpr int bytes_while_running = 276;

/// A guide of the running frame, in the caller's memory.
template <quell::ChannelTag C> struct Guide {
    std::size_t place; ///< among a frame's channels
    std::optional<quell::ImageOf<OwnImages, C>> image{};

    explicit Guide(Way const& way) : place(way.place_of(C::name).value()) {}
    quell::ViewOf<quell::Planar<>, C> take(FrameImages const& frame, Parallel const& parallel) {
        if (!(image && image->size() == frame.size)) image.emplace(frame.size);
        auto const own = image->view();
        for_each_strip(parallel, frame.size.height, [&](int y0, int y1) {
            take_rows(frame.channels[place], C::components, own.planes, own.row_stride(), frame.size.width, y0, y1);
        });
        quell::ViewOf<quell::Planar<>, C> view{{}, frame.size};
        std::copy_n(own.planes, C::components, view.planes);
        return view;
    }
    [[nodiscard]] std::size_t bytes() const { return image ? image->bytes() : 0; }
};

class GivenBack final : public WrappedDenoiser {
    static constexpr int components = 3;

    std::size_t signal; ///< among a frame's channels
    bool is_judged;
    Memory memory;
    OnOwnImages executor;
    quell::GiveBack give_back;
    Guide<quell::Normal> normal;
    Guide<quell::Depth> depth;
    Guide<quell::Motion> motion;

public:
    GivenBack(std::unique_ptr<CompiledDenoiser> d, Way const& way, bool judged, float samples, Parallel const& parallel, Memory const& m)
        : WrappedDenoiser(std::move(d)), signal(way.place_of(way.signal).value()), is_judged(judged), memory(m), executor{parallel},
          give_back(samples), normal(way), depth(way), motion(way) {}

    void run(std::span<FrameImages const> window, Image const& output) override {
        auto const& frame = window.front();
        Colours made;
        auto const image = image_of(made, frame.size);
        denoiser->run(window, image);
        try {
            give(frame, made);
        } catch (...) { // the history has seen a frame that the caller has no picture of
            forget();
            throw;
        }
        write(made, frame.size, output);
    }
    void forget() override { denoiser->forget(), give_back.forget(); }
    void release_scratch() override {
        denoiser->release_scratch();
        normal.image.reset(), depth.image.reset(), motion.image.reset();
    }
    [[nodiscard]] std::size_t bytes() const override {
        return denoiser->bytes() + give_back.bytes() + normal.bytes() + depth.bytes() + motion.bytes();
    }
    void remember(quell::HistoryContents const& contents) override { denoiser->remember(contents), give_back.forget(); }
    void learn(quell::detail::KnownPast const& past) override { denoiser->learn(past), give_back.forget(); }

private:
    /// An image for compiled code to write.
    static Image image_of(Colours& pixels, Extent size) {
        std::ptrdiff_t constexpr element = sizeof(float);
        pixels.resize(static_cast<std::size_t>(size.pixels()));
        return {.data = reinterpret_cast<std::byte*>(pixels.data()),
                .component_stride = element,
                .pixel_stride = components * element,
                .row_stride = components * element * size.width};
    }
    /// The signal's samples.
    [[nodiscard]] Colours samples_of(FrameImages const& frame) const {
        auto const width = static_cast<std::size_t>(frame.size.width);
        std::vector<float> row(components * width);
        float* planes[std::size_t{components}];
        for (std::size_t c = 0; c < std::size_t{components}; ++c) planes[c] = row.data() + c * width;
        Colours samples;
        samples.reserve(static_cast<std::size_t>(frame.size.pixels()));
        for (int y = 0; y < frame.size.height; ++y) {
            take_rows(frame.channels[signal], components, planes, 0, frame.size.width, y, y + 1);
            for (std::size_t x = 0; x < width; ++x) samples.emplace_back(planes[0][x], planes[1][x], planes[2][x]);
        }
        return samples;
    }
    void give(FrameImages const& frame, Colours& made) {
        CallersMemory::current() = memory;
        quell::GiveBack::Guides const guides{
            {normal.take(frame, executor.parallel)}, {depth.take(frame, executor.parallel)}, {motion.take(frame, executor.parallel)}};
        give_back.apply(executor, samples_of(frame), guides, {denoiser->statistics().frames > 1, is_judged}, made);
    }
    void write(Colours const& made, Extent size, Image const& output) const {
        HostTarget<components> const to{output.data, size, output.component_stride, output.pixel_stride, output.row_stride, output.is_half};
        for_each_strip(executor.parallel, size.height, [&](int y0, int y1) {
            for (int y = y0; y < y1; ++y)
                for (int x = 0; x < size.width; ++x)
                    for (int c = 0; c < components; ++c)
                        to.set(c, x, y,
                               made[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x)][c]);
        });
    }
};

} // namespace

bool can_give_back(Way const& way) {
    bool reads_guides = true;
    for_each_channel(quell::Channels<quell::Normal, quell::Depth, quell::Motion>{},
                     [&](auto channel) { reads_guides = reads_guides && way.place_of(channel.name); });
    return !way.signal.empty() && way.output_components == 3 && reads_guides;
}

std::string plan_of_given_back() {
    constexpr int kept = quell::Normal::components + quell::Depth::components + quell::Motion::components + 3;
    return "Behind it, light is given back that it took out by mistake, by shares for the number of samples, and where two frames in a row "
           "lack it. That takes " +
           std::to_string(kept * static_cast<int>(sizeof(float))) + " bytes a pixel of the frames, and " +
           std::to_string(bytes_while_running) + " more while a frame is denoised.\n\n";
}

std::unique_ptr<CompiledDenoiser> with_light_given_back(std::unique_ptr<CompiledDenoiser> denoiser, Way const& way, bool is_judged,
                                                        float samples, Parallel const& parallel, Memory const& memory) {
    return std::make_unique<GivenBack>(std::move(denoiser), way, is_judged, samples, parallel, memory);
}

} // namespace quell_library

#include "given_back.hpp"

#include "compile_preset.hpp"
#include "images_of_frame.hpp"
#include "wrapped_denoiser.hpp"

#include <quell/link/light_given_back.hpp>

namespace quell_library {

namespace {

using Link = decltype(quell::light_given_back(quell::radiance, 1.f));
using Compiled = OneSided<Link>;

class GivenBack final : public WrappedDenoiser {
    Way const link_way = way_of<Compiled, Link>();
    std::vector<std::size_t> places; ///< of the link's channels among a frame's
    Memory memory;
    Compiled link;
    OwnImages::Image<3> made{};
    FrameImages seen{};

public:
    GivenBack(std::unique_ptr<CompiledDenoiser> d, Way const& way, Link const& l, quell::Extent size, Parallel const& parallel,
              Memory const& m)
        : WrappedDenoiser(std::move(d)), memory(m), link(l, size, parallel, m) {
        for (auto const& channel : link_way.channels)
            places.push_back(way.place_of(channel.name == quell::Radiance::name ? way.signal : channel.name).value_or(0));
    }

    void run(std::span<FrameImages const> window, Image const& output) override {
        auto const& frame = window.front();
        if (!(made.size() == frame.size)) {
            CallersMemory::current() = memory;
            made = OwnImages::Image<3>(frame.size);
        }
        denoiser->run(window, image_of_view(made.view()));
        try {
            seen.size = frame.size, seen.camera = frame.camera, seen.number = frame.number, seen.shutter = frame.shutter;
            seen.channels.clear();
            for (std::size_t place : places) seen.channels.push_back(frame.channels[place]);
            seen.channels[link_way.place_of(quell::Denoised::name).value()] = image_of_view(made.view());
            link.run({&seen, 1}, output);
        } catch (...) { // the history has seen a frame that the caller has no picture of
            forget();
            throw;
        }
    }
    void forget() override { denoiser->forget(), link.forget(); }
    void release_scratch() override {
        denoiser->release_scratch(), link.release_scratch();
        made = OwnImages::Image<3>();
    }
    [[nodiscard]] std::size_t bytes() const override { return denoiser->bytes() + link.bytes() + made.bytes(); }
    void remember(quell::HistoryContents const& contents) override { denoiser->remember(contents), link.forget(); }
    void learn(quell::detail::KnownPast const& past) override { denoiser->learn(past), link.forget(); }
};

} // namespace

bool can_give_back(Way const& way) {
    bool reads_guides = true;
    for_each_channel(quell::Channels<quell::Normal, quell::Depth, quell::Motion>{},
                     [&](auto channel) { reads_guides = reads_guides && way.place_of(channel.name); });
    return !way.signal.empty() && way.output_components == 3 && reads_guides;
}

std::string plan_of_given_back() {
    return "Behind it, light is given back that it took out by mistake, by shares for the number of samples, and where two frames in a row "
           "lack it:\n\n" +
           to_string(plan_of(quell::light_given_back(quell::radiance, 1.f))) + "\n";
}

std::unique_ptr<CompiledDenoiser> with_light_given_back(std::unique_ptr<CompiledDenoiser> denoiser, Way const& way, bool is_judged,
                                                        float samples, quell::Extent size, Parallel const& parallel, Memory const& memory) {
    return std::make_unique<GivenBack>(std::move(denoiser), way, quell::light_given_back(quell::radiance, samples, is_judged), size,
                                       parallel, memory);
}

} // namespace quell_library

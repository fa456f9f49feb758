#include "all_stages.hpp"
#include "compile_preset.hpp"
#include "images_of_frame.hpp"
#include "stage.hpp"
#include "wrapped_denoiser.hpp"

namespace quell_library {

namespace {

using Compiled = std::unique_ptr<CompiledDenoiser>;

/// The channel of a preset that a stage's channel is, by its name; none is what the preset makes.
std::string_view name_behind(Way const& way, std::string_view channel) { return channel == quell::Radiance::name ? way.signal : channel; }

/// A denoiser with a pipeline behind it.
template <class Link> class LinkedDenoiser final : public WrappedDenoiser {
    using Behind = OneSided<Link>;

    Way const link_way = way_of<Behind, Link>();
    std::vector<std::size_t> places; ///< of the link's channels among a frame's
    Memory memory;
    Behind link;
    OwnImages::Image<3> made{};
    FrameImages seen{};

public:
    LinkedDenoiser(Compiled d, Link const& l, StagePlace const& at)
        : WrappedDenoiser(std::move(d)), memory(at.memory), link(l, at.size, at.parallel, at.memory) {
        for (auto const& channel : link_way.channels) places.push_back(at.way.place_of(name_behind(at.way, channel.name)).value_or(0));
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

template <class Named> Stage link_stage(Named const& named) {
    using Link = std::remove_const_t<decltype(MadeStage<Named>{}())>;
    static_assert(Link::reads::template has<quell::Denoised> && Link::Output::components == 3,
                  "a stage behind presets is a Pipeline{denoised, ...}: it reads what a preset makes, three components of each pixel");
    Stage stage{.name = std::string(named.name), .needs_jitter = Link::checks_jitter};
    stage.refusal = [](Way const& way) -> std::string {
        if (way.signal.empty() || way.output_components != 3) return "makes no single colour with its history, or makes alpha too";
        for (auto const& channel : way_of<OneSided<Link>, Link>().channels)
            if (channel.name != quell::Denoised::name && !way.place_of(name_behind(way, channel.name))) return "reads no " + channel.name;
        return {};
    };
    stage.plan = [name = stage.name](std::string const& inner, Way const&, Way const&) {
        return inner + "\nBehind it, " + name + ":\n\n" + to_string(plan_of(MadeStage<Named>{}()));
    };
    stage.put = [](Compiled denoiser, StagePlace const& at) -> Compiled {
        auto const link = decltype(Named::make){}(quell::StandsBehind{.samples = at.samples, .is_judged = at.is_judged});
        return std::make_unique<LinkedDenoiser<Link>>(std::move(denoiser), link, at);
    };
    return stage;
}

} // namespace

std::vector<Stage> link_stages() {
    std::vector<Stage> all;
    for_each_stage_before_resolve([&](auto const& named) { all.push_back(link_stage(named)); });
    return all;
}

} // namespace quell_library

#include "history_choice.hpp"

#include "host_images.hpp"
#include "images_of_frame.hpp"
#include "on_own_images.hpp"
#include "take_rows.hpp"
#include "wrapped_denoiser.hpp"

#include <quell/link/evidence/choose_by_evidence.hpp>
#include <quell/link/evidence/held_out.hpp>
#include <quell/pipeline/plan.hpp>
#include <quell/pipeline/run.hpp>

#include <algorithm>

namespace quell_library {

namespace {

using quell::Extent;

/// The samples that estimates are made of.
template <int n> struct GivenSamples : quell::Channel<n> { static constexpr auto name = "samples"; };

/// @tparam n components of what comes out; of four the last is alpha
template <int n> class HistoryChoiceOf final : public HistoryChoice {
    using Samples = GivenSamples<n>;
    using First = quell::FirstEstimate<n>;
    using Second = quell::SecondEstimate<n>;
    using Choice = quell::Pipeline<First, quell::Spatial<quell::ChooseByEvidence<Samples, true>>>;
    /// Without the samples of every second pixel.
    struct LeftOver : quell::Channel<n> {
        static constexpr auto name = "left over";
    };
    using Images = quell::Frame<quell::union_of<typename Choice::reads, quell::Channels<LeftOver>>, OwnImages>;

    std::vector<ReadChannel> const channels, judged_channels;
    std::size_t place, judged_place; ///< of the signal among these
    std::unique_ptr<CompiledDenoiser> alone, judge;
    CompiledDenoiser& judging;
    Memory memory;
    OnOwnImages executor;
    Images images{{1, 1}};
    quell::History<Choice, OwnImages> history;
    quell::detail::KnownPast past{};
    std::vector<FrameImages> judged{};
    float of_each_pixel = 1.f; ///< samples
    bool has_chosen = false;   ///< between two estimates of the last frame

    static Choice choice_by(quell::Evidence const& rule) {
        return Choice{First{}, quell::Spatial{quell::ChooseByEvidence<Samples, true>{rule}}};
    }

public:
    HistoryChoiceOf(Way const& way, Way const& of_judge, Extent size, Parallel const& parallel, Memory const& m)
        : channels(way.channels), judged_channels(of_judge.channels), place(way.place_of(way.signal).value()),
          judged_place(of_judge.place_of(way.signal).value()), alone(way.make(size, parallel, m)),
          judge(&way != &of_judge ? of_judge.make(size, parallel, m) : nullptr), judging(judge ? *judge : *alone),
          memory(m), executor{parallel}, history(size, choice_by({})) {}

    void run(CompiledDenoiser& denoiser, std::span<FrameImages const> window, Image const& output) override {
        auto const& frame = window.front();
        denoiser.tell(past);
        has_chosen = past.is_before(frame.size, frame.number);
        if (!has_chosen) {
            past.drop();
            return denoiser.run(window, output);
        }
        use_memory();
        take(frame);
        by_itself(*alone, window.first(1), Second{});
        auto const rule =
            window.size() > 1 ? quell::Evidence::with_later_frames(of_each_pixel) : quell::Evidence::of_samples(of_each_pixel);
        look_at_samples(window, rule.both_halves);
        past.drop();
        denoiser.run(window, image_of(First{}));
        use_memory();
        run_into(target_of(output, frame.size), choice_by(rule), images, history, executor);
    }
    bool copy_alone(Image const& output) override { return copy_made(Second{}, output); }
    bool copy_with_history(Image const& output) override { return copy_made(First{}, output); }
    [[nodiscard]] float trust() const override { return has_chosen ? history[quell::noise_independence].get(0, 0, 0) : 1.f; }
    void tell_samples(float count) override { of_each_pixel = count; }
    void release_scratch() override {
        alone->release_scratch();
        if (judge) judge->release_scratch();
        history.release();
        images = Images({1, 1});
        has_chosen = false;
    }
    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = alone->bytes() + (judge ? judge->bytes() : 0) + history.bytes();
        quell::for_each_channel(typename Images::channels{}, [&](auto channel) { sum += images[channel].bytes(); });
        return sum;
    }

private:
    void use_memory() const { CallersMemory::current() = memory; }
    [[nodiscard]] Image image_of(auto channel) const { return image_of_view(images[channel].view()); }
    static HostTarget<n> target_of(Image const& image, Extent size) {
        return {image.data, size, image.component_stride, image.pixel_stride, image.row_stride, image.is_half};
    }
    template <class From, class To> void copy(From const& from, To const& to, int held_out = quell::detail::none_held_out) const {
        executor.for_each_pixel({0, 0, to.size.width, to.size.height}, quell::detail::HoldOut<From, To>{from, to, held_out});
    }

    bool copy_made(auto which, Image const& output) const {
        if (has_chosen) copy(images[which].view(), target_of(output, images.size));
        return has_chosen;
    }
    void take(FrameImages const& frame) {
        if (!(images.size == frame.size)) images = Images(frame.size);
        auto const view = images[Samples{}].view();
        for_each_strip(executor.parallel, frame.size.height, [&](int y0, int y1) {
            take_rows(frame.channels[place], n, view.planes, view.row_stride(), frame.size.width, y0, y1);
        });
    }
    void by_itself(CompiledDenoiser& denoiser, std::span<FrameImages const> frame, auto to) {
        denoiser.forget();
        denoiser.run(frame, image_of(to));
    }
    /// The judge reads the channels in an order of its own.
    void show_judge(std::span<FrameImages const> window) {
        judged.resize(window.size());
        for (std::size_t i = 0; i < window.size(); ++i) {
            auto its_own = std::move(judged[i].channels);
            its_own.assign(judged_channels.size(), {});
            for (std::size_t to = 0; to < its_own.size(); ++to) {
                auto const from = std::ranges::find(channels, judged_channels[to].name, &ReadChannel::name);
                if (from != channels.end()) its_own[to] = window[i].channels[static_cast<std::size_t>(from - channels.begin())];
            }
            auto const& shown = window[i];
            judged[i] = {shown.size, std::move(its_own), shown.camera, shown.number, shown.shutter};
        }
    }
    void look_at_samples(std::span<FrameImages const> window, bool both_halves) {
        show_judge(window);
        auto const first = std::span<FrameImages const>(judged).first(1);
        using Judged = quell::SecondJudged<n>;
        if (judge)
            by_itself(*judge, first, Judged{});
        else
            copy(images[Second{}].view(), images[Judged{}].view());
        judged.front().channels[judged_place] = image_of(LeftOver{});
        auto const without = [&](int half, auto first_estimate, auto second_estimate) {
            use_memory();
            copy(images[Samples{}].view(), images[LeftOver{}].view(), half);
            by_itself(judging, first, second_estimate);
            judging.learn(past);
            judging.run(judged, image_of(first_estimate));
        };
        without(0, quell::FirstWithoutEven<n>{}, quell::SecondWithoutEven<n>{});
        if (both_halves) without(1, quell::FirstWithoutOdd<n>{}, quell::SecondWithoutOdd<n>{});
    }
};

class ChoosingDenoiser final : public WrappedDenoiser {
    std::unique_ptr<HistoryChoice> choice;

public:
    ChoosingDenoiser(std::unique_ptr<CompiledDenoiser> d, std::unique_ptr<HistoryChoice> c)
        : WrappedDenoiser(std::move(d)), choice(std::move(c)) {}

    void run(std::span<FrameImages const> window, Image const& output) override { choice->run(*denoiser, window, output); }
    void forget() override { denoiser->forget(); }
    void release_scratch() override { denoiser->release_scratch(), choice->release_scratch(); }
    [[nodiscard]] std::size_t bytes() const override { return denoiser->bytes() + choice->bytes(); }
};

} // namespace

bool can_choose_history(Way const& way) {
    int const n = way.output_components;
    return !way.signal.empty() && (n == 1 || n == 3 || n == 4);
}

CompiledPreset const& judge_of(CompiledPreset const& preset) {
    auto const& all = compiled_presets();
    auto const judge = std::ranges::find(all, preset.judge, &CompiledPreset::name);
    return judge != all.end() ? *judge : preset;
}

std::string plan_of_choice(Way const& way, Way const& judge) {
    bool const is_own_judge = &way == &judge;
    constexpr int images = 9;
    return "With its history and without, put together by evidence: each frame is denoised once more by itself, and " +
           std::string(is_own_judge ? "" : "by its judge, by itself and ") +
           "with and without history, with half of the samples left out: from 2 samples on once, else twice. That takes " +
           std::to_string(images * way.output_components * static_cast<int>(sizeof(float))) + " bytes a pixel, history and scratch " +
           (is_own_judge ? "once more" : "once more and of its judge") + ", and:\n\n" +
           to_string(plan_of(quell::Pipeline{quell::FirstEstimate<3>{}, quell::Spatial{quell::ChooseByEvidence<GivenSamples<3>>{}}})) +
           "\n";
}

std::unique_ptr<HistoryChoice> make_history_choice(Way const& way, Way const& judge, Extent size, Parallel const& parallel,
                                                   Memory const& memory) {
    switch (way.output_components) {
    case 1:
        return std::make_unique<HistoryChoiceOf<1>>(way, judge, size, parallel, memory);
    case 4:
        return std::make_unique<HistoryChoiceOf<4>>(way, judge, size, parallel, memory);
    default:
        return std::make_unique<HistoryChoiceOf<3>>(way, judge, size, parallel, memory);
    }
}

std::unique_ptr<CompiledDenoiser> with_history_choice(std::unique_ptr<CompiledDenoiser> denoiser, std::unique_ptr<HistoryChoice> choice) {
    return std::make_unique<ChoosingDenoiser>(std::move(denoiser), std::move(choice));
}

} // namespace quell_library

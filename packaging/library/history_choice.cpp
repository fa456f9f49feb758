#include "history_choice.hpp"

#include "host_images.hpp"
#include "images_of_frame.hpp"
#include "on_own_images.hpp"
#include "take_rows.hpp"
#include "wrapped_denoiser.hpp"

#include <quell/resolve/evidence_passes.hpp>
#include <quell/resolve/shared_noise.hpp>

#include <algorithm>
#include <array>

namespace quell_library {

namespace {

using quell::Extent;

/// @tparam n components of what comes out; of four the last is alpha
template <int n> class HistoryChoiceOf final : public HistoryChoice {
    using OneImage = typename OwnImages::template Image<n>;
    using View = typename OneImage::View;
    /// What is made of a frame: each by the preset or its judge, with the history (a) or without (b).
    enum Made { samples, left_over, a, b, b_with, alone_with, made };

    std::vector<ReadChannel> const channels, judged_channels;
    std::size_t place, judged_place; ///< of the signal among these
    std::unique_ptr<CompiledDenoiser> alone, judge;
    CompiledDenoiser& judging;
    Memory memory;
    OnOwnImages executor;
    quell::EvidenceMix<CallersMemory> mix;
    quell::detail::KnownPast past{};
    std::array<std::optional<OneImage>, made> images{};
    std::vector<FrameImages> judged{};
    float of_each_pixel = 1.f; ///< samples
    quell::Evidence rule{};
    bool has_chosen = false; ///< between two estimates of the last frame

public:
    HistoryChoiceOf(Way const& way, Way const& of_judge, Extent size, Parallel const& parallel, Memory const& m)
        : channels(way.channels), judged_channels(of_judge.channels), place(way.place_of(way.signal).value()),
          judged_place(of_judge.place_of(way.signal).value()), alone(way.make(size, parallel, m)),
          judge(&way != &of_judge ? of_judge.make(size, parallel, m) : nullptr), judging(judge ? *judge : *alone),
          memory(m), executor{parallel} {}

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
        rule = window.size() > 1 ? quell::Evidence::with_later_frames(of_each_pixel) : quell::Evidence::of_samples(of_each_pixel);
        by_itself(*alone, window.first(1), alone_with);
        look_at_samples(window);
        past.drop();
        denoiser.run(window, image_of(a));
        use_memory();
        quell::SharedNoise const noise;
        rule.trust = independence(noise, quell::shared_noise(quell::LightLess{view_of(samples), view_of(a)}));
        mix.mix(rule, executor, view_of(a), view_of(alone_with), target_of(output, frame.size));
    }
    bool copy_alone(Image const& output) override { return copy_made(alone_with, output); }
    bool copy_with_history(Image const& output) override { return copy_made(a, output); }
    [[nodiscard]] float trust() const override { return has_chosen ? rule.trust : 1.f; }
    void tell_samples(float count) override { of_each_pixel = count; }
    void release_scratch() override {
        alone->release_scratch();
        if (judge) judge->release_scratch();
        mix.release();
        for (auto& each : images) each.reset();
        has_chosen = false;
    }
    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = alone->bytes() + (judge ? judge->bytes() : 0) + mix.bytes();
        for (auto const& each : images) sum += each ? each->bytes() : 0;
        return sum;
    }

private:
    void use_memory() const { CallersMemory::current() = memory; }
    [[nodiscard]] auto view_of(Made which) const { return images[which]->view(); }
    [[nodiscard]] Image image_of(Made which) const { return image_of_view(view_of(which)); }
    static HostTarget<n> target_of(Image const& image, Extent size) {
        return {image.data, size, image.component_stride, image.pixel_stride, image.row_stride, image.is_half};
    }
    template <class To> void copy(View const& from, To const& to, int left_out = -1) const {
        executor.for_each_pixel({0, 0, to.size.width, to.size.height}, quell::detail::CopyAllBut<View, To>{from, to, left_out});
    }

    bool copy_made(Made which, Image const& output) const {
        if (has_chosen) copy(view_of(which), target_of(output, images[which]->size()));
        return has_chosen;
    }
    void take(FrameImages const& frame) {
        for (auto const which : {samples, left_over, a, b, b_with, alone_with}) {
            bool const is_wanted = which != b_with || judge;
            if (is_wanted && !(images[which] && images[which]->size() == frame.size)) images[which].emplace(frame.size);
        }
        auto const view = view_of(samples);
        for_each_strip(executor.parallel, frame.size.height, [&](int y0, int y1) {
            take_rows(frame.channels[place], n, view.planes, view.row_stride(), frame.size.width, y0, y1);
        });
    }
    void by_itself(CompiledDenoiser& denoiser, std::span<FrameImages const> frame, Made to) {
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
    void look_at_samples(std::span<FrameImages const> window) {
        show_judge(window);
        auto const first = std::span<FrameImages const>(judged).first(1);
        if (judge) by_itself(*judge, first, b_with);
        judged.front().channels[judged_place] = image_of(left_over);
        for (int const left_out : {0, 1}) {
            use_memory();
            copy(view_of(samples), view_of(left_over), left_out);
            by_itself(judging, first, b);
            judging.learn(past);
            judging.run(judged, image_of(a));
            use_memory();
            mix.judge(rule, executor, left_out, view_of(samples), view_of(a), view_of(b), view_of(judge ? b_with : alone_with));
        }
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
    auto const general = std::ranges::find(all, "general", &CompiledPreset::name);
    return preset.name == "final-frame" && general != all.end() ? *general : preset;
}

std::string plan_of_choice(Way const& way, Way const& judge) {
    bool const is_own_judge = &way == &judge;
    int const images = is_own_judge ? 5 : 6, sums = 4;
    auto const bytes = images * way.output_components * static_cast<int>(sizeof(float)) + sums * static_cast<int>(sizeof(double));
    return "With its history and without, put together by evidence: each frame is denoised once more by itself, and " +
           std::string(is_own_judge ? "" : "by its judge, general, by itself and ") +
           "with and without history twice each, with half of the samples left out. That takes " + std::to_string(bytes) +
           " bytes a pixel, and history and scratch " + (is_own_judge ? "once more" : "once more and of its judge") + ".\n\n";
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

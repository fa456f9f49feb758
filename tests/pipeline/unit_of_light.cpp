#include "../frames.hpp"
#include "../views.hpp"

#include <library/history_choice.hpp>
#include <library/images_of_frame.hpp>
#include <library/resolved_denoiser.hpp>
#include <library/stage.hpp>

#include <algorithm>
#include <limits>

using namespace quell;
namespace library = quell_library;
using library::Way;

// Light may be of any unit: light times a power of two, which rounds nothing, gives the same bits times that. By presets as they are
// compiled, so that none is compiled anew.
namespace {

constexpr Extent size{61, 24};
constexpr unsigned frame_count = 5;
constexpr int later_frames = 2;
using LightFrame = Frame<decltype(AllChannels{} | Channels<RadianceAlpha>{})>;
using Denoiser = std::unique_ptr<library::CompiledDenoiser>;

template <class C> constexpr bool is_light = false;
template <> constexpr bool is_light<Radiance> = true;
template <> constexpr bool is_light<RadianceAlpha> = true;
template <> constexpr bool is_light<Direct> = true;
template <> constexpr bool is_light<Glossy> = true;
template <> constexpr bool is_light<Indirect> = true;
template <> constexpr bool is_light<GradientOf<Radiance>> = true;

/// A dark half, black blocks, and samples that are missing farther than filters of a level look.
float changed(float light, int x, int y) {
    if (x > 44 && x < 58 && y > 3 && y < 20) return std::numeric_limits<float>::quiet_NaN();
    return (x / 8 + y / 8) % 3 == 0 ? 0.f : x < size.width / 2 ? light * light * 0x1p-9f : light;
}

std::vector<LightFrame> frames_of(float unit) {
    std::vector<LightFrame> frames;
    for (unsigned i = 0; i < frame_count; ++i) {
        auto& frame = frames.emplace_back(size);
        tests::fill_randomly(frame, i);
        frame.camera = tests::View({0.1 * i, 1, 8}, {1, 1, 0}, size).camera();
        frame.camera.jitter = {0.1f * static_cast<float>(i) - 0.2f, 0.2f};
        frame.number = static_cast<long long>(i);
        for_each_channel(LightFrame::channels{}, [&]<class C>(C channel) {
            auto const view = frame[channel].view();
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    for (int c = 0; c < C::components; ++c) {
                        if (std::is_same_v<C, SampleVariance>) view.set(c, x, y, view.get(c, x, y) * unit * unit);
                        if (is_light<C> && c < 3) view.set(c, x, y, changed(view.get(c, x, y), x, y) * unit);
                    }
        });
    }
    return frames;
}

library::Parallel const here{.run = library::run_here, .user = nullptr, .threads = 1};

/// What comes out of all frames.
std::vector<float> pictures(Way const& way, Denoiser const& denoiser, Extent of_output, std::vector<LightFrame> const& frames) {
    std::vector<float> all;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::vector<library::FrameImages> window;
        for (std::size_t k = i; k < frames.size() && k <= i + later_frames; ++k) window.push_back(library::images_of(way, frames[k]));
        std::vector<float> picture;
        denoiser->run(window, library::image_of(picture, way.output_components, of_output));
        all.insert(all.end(), picture.begin(), picture.end());
    }
    return all;
}

/// @param make a denoiser of the way
void check_way(Way const& way, auto const& make, Extent of_output = size) {
    auto const usual = pictures(way, make(), of_output, frames_of(1.f));
    CHECK(tests::all_finite(usual));
    bool const is_unscaled = way.signal == visibility.name && way.output_components == 1;
    for (float const unit : {0x1p-12f, 0x1p12f}) {
        CAPTURE(unit);
        auto const scaled = pictures(way, make(), of_output, frames_of(unit));
        std::size_t others = 0;
        for (std::size_t i = 0; i < usual.size(); ++i) {
            bool const is_alpha = way.output_components == 4 && i % 4 == 3;
            others += scaled[i] == (is_unscaled || is_alpha ? usual[i] : usual[i] * unit) ? 0 : 1;
        }
        CHECK(others == 0);
    }
}

} // namespace

TEST_CASE("the unit of light changes no bit: all presets") {
    for (auto const& preset : library::compiled_presets()) {
        CAPTURE(preset.name);
        for (auto const& [purpose, way] : {std::pair{std::string("usual"), &preset.usual},
                                           {"picture", &preset.picture},
                                           {"two-sided", &preset.two_sided},
                                           {"two-sided, with alpha", &preset.two_sided_alpha}}) {
            CAPTURE(purpose);
            if (auto const& made_by = *way; made_by) check_way(made_by, [&] { return made_by.make(size, here, {}); });
        }
    }
}

TEST_CASE("the unit of light changes no bit: what stands behind presets") {
    for (auto const& preset : library::compiled_presets()) {
        if (preset.name != "general" && preset.name != "final-frame" && preset.name != "svgf") continue;
        CAPTURE(preset.name);
        auto const& judge = library::judge_of(preset);
        Extent const twice{2 * size.width, 2 * size.height};
        auto const staged = [&](library::Way const& way, library::Way const& of_judge, std::vector<std::string_view> const& names) {
            library::Memory const memory;
            auto denoiser = way.make(size, here, memory);
            for (auto const& stage : library::stages())
                if (std::ranges::find(names, stage.name) != names.end())
                    denoiser = stage.put(std::move(denoiser), {way, of_judge, way.channels, size, twice, 4.f, true, here, memory});
            return denoiser;
        };
        for (bool const is_two_sided : {false, true}) {
            auto const &way = is_two_sided ? preset.two_sided : preset.usual, &of_judge = is_two_sided ? judge.two_sided : judge.usual;
            if (way) check_way(way, [&] { return staged(way, of_judge, {"evidence", "light"}); });
        }
        auto resolved = preset.usual;
        resolved.channels = library::channels_of_resolved(preset.usual);
        check_way(
            resolved, [&] { return staged(preset.usual, preset.usual, {"resolve"}); }, twice);
    }
}

#pragma once

#include "../images.hpp"

#include <quell/pipeline/chain.hpp>
#include <quell/shader/interpreter.hpp>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>

// The frames by which shaders of presets are compared with the CPU, wherever they run. Without doctest.
namespace quell::tests {

/// How missing samples are told.
enum class Missing {
    as_it_comes, ///< NaN, infinite, too large
    marked       ///< -1 in every component: WGSL lets devices assume that no number is NaN or infinite
};

/// A few random frames with missing samples and a cut between them, and what the CPU makes of the recorded steps: with the bits of Serial,
/// and as devices do that round a product and the sum behind it one by one.
class PresetFrames {
public:
    static constexpr Extent size{41, 23};
    static constexpr int count = 4, cut = 3;

    bool has_past = false; ///< whether this frame has one
    FrameBlock block;      ///< of this frame

private:
    using Input = Frame<decltype(AllChannels{} + denoised)>; // stages behind presets read that
    ShaderPlan const& plan;
    Missing missing;
    Input frame{size};
    int number = -1;
    std::array<PlanInterpreter, 2> interpreters;

public:
    std::array<float, 2> off{}; ///< largest differences so far, from each of both ways to round

    /// @param of must outlive it
    PresetFrames(ShaderPlan const& of, Missing how)
        : plan(of), missing(how), interpreters{PlanInterpreter(of, size, true), PlanInterpreter(of, size, false)} {}

    /// Makes the next frame, and runs the CPU. False behind the last one.
    bool next() {
        if (++number == count) return false;
        fill();
        has_past = number > 0 && number != cut;
        block = {.size = size,
                 .frame_index = number,
                 .camera = frame.camera,
                 .camera_then = has_past ? camera_of(number - 1) : frame.camera,
                 .shutter = frame.shutter,
                 .shutter_then = frame.shutter,
                 .needs_camera = plan.needs_camera};
        for (auto& each : interpreters) {
            if (!has_past) each.forget();
            copy_inputs(each);
            each.run(block);
        }
        return true;
    }
    /// Of the picture.
    [[nodiscard]] int components() const { return static_cast<int>(plan.output.size()); }
    /// What is counted of this frame, in the order of the plan.
    [[nodiscard]] std::vector<double> totals() {
        std::vector<double> all;
        for (auto const& count : plan.counts) all.push_back(plan.total(count, size, wanted(0, count.slot)));
        return all;
    }
    [[nodiscard]] std::span<float const> input(int slot) { return interpreters[0].plane(ShaderBuffer::inputs, slot); }
    /// @param way 0: a product and the sum behind it are rounded as one; 1: one by one
    [[nodiscard]] std::span<float const> wanted(std::size_t way, int component) {
        return interpreters[way].plane(ShaderBuffer::output, component);
    }
    /// A component of the picture as a device has made it.
    void compare(int component, std::span<float const> found) {
        for (std::size_t way = 0; way < off.size(); ++way) off[way] = std::max(off[way], difference(wanted(way, component), found));
    }

    /// What devices may be off: five times what docs/limits.md allows Serial itself. Random frames have pixels where something is just or
    /// just not chosen, so that it is enough to be near one of both ways to round.
    static float allowed(std::string_view preset) {
        bool const keeps_halves = preset == "dual-cone" || preset == "trmv" || preset.ends_with("-half");
        return keeps_halves ? 1e-3f : 1e-4f;
    }

private:
    static Camera camera_of(int of_frame) {
        auto const n = static_cast<float>(of_frame);
        auto const aspect = static_cast<float>(size.width) / static_cast<float>(size.height);
        return {glm::lookAt(glm::vec3(0.1f * n, 1, 8), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)), glm::perspective(0.9f, aspect, 0.1f, 100.f),
                glm::vec2(0.3f * n - 0.2f, 0.1f * n)};
    }
    /// Some samples are missing, some parts of the image are sky.
    void fill() {
        fill_randomly(frame, static_cast<unsigned>(number) + 7);
        std::mt19937 random(static_cast<unsigned>(number) + 99);
        auto const spoil = [&](auto& image, auto const& value) {
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    if (random() % 40 == 0) image.set(x, y, value);
        };
        constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
        auto const sample = [&](glm::vec3 const& as_it_comes) { return missing == Missing::marked ? glm::vec3(-1) : as_it_comes; };
        spoil(frame[radiance], sample({nan, 1, 1}));
        spoil(frame[glossy], sample({1, -infinity, 1}));
        spoil(frame[indirect], sample({1, 1, 2e16f}));
        spoil(frame[visibility], sample({infinity, 1, 1}).x);
        spoil(frame[depth], infinity);
        if (!plan.counts.empty()) break_frame(spoil);
        frame.camera = camera_of(number);
    }
    /// Guides that no scene has, and holes.
    void break_frame(auto const& spoil) {
        spoil(frame[albedo], glm::vec3(3, 0.5f, -0.5f));
        spoil(frame[normal], glm::vec3(0, 2, 1));
        spoil(frame[depth], -1.f);
        for (int y = 0; y < 7; ++y)
            for (int x = 0; x < 7; ++x) frame[radiance].set(x + 9, y, glm::vec3(-1));
    }
    void copy_inputs(PlanInterpreter& to) {
        int slot = 0;
        for (auto const& each : plan.inputs) {
            auto const plane = to.plane(ShaderBuffer::inputs, slot++);
            for_each_channel(typename Input::channels{}, [&]<class C>(C c) {
                if (each.channel == C::name)
                    for (int y = 0; y < size.height; ++y)
                        for (int x = 0; x < size.width; ++x)
                            plane[static_cast<std::size_t>(y * size.width + x)] = frame[c].get(each.component, x, y);
            });
        }
    }
    /// The largest difference, relative where the picture is above 1.
    static float difference(std::span<float const> one, std::span<float const> other) {
        float worst = 0.f;
        for (std::size_t i = 0; i < one.size(); ++i) {
            float const by = std::abs(one[i] - other[i]) / std::max(1.f, std::abs(one[i]));
            // NaN counts as infinite: it would give way to the next number.
            worst = std::max(worst, std::isnan(by) ? std::numeric_limits<float>::infinity() : by);
        }
        return worst;
    }
};

} // namespace quell::tests

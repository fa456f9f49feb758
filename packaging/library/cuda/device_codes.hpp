#pragma once

#include "../preset_code.hpp"

#include <algorithm>

// Presets on a device, and the stages behind them: each is compiled by itself, and they are put together here.
namespace quell_library {

/// A pipeline compiled for a device: a preset, or a stage behind one, which reads `denoised`.
struct DeviceCode {
    std::string name{};
    std::string signal{}; ///< the channel that its one history is of; empty: it has none, or several
    PresetWay way{};
    /// Makes an image of three components in the device's memory, and what keeps it.
    /// @param may_move see Memory
    /// @param error    what is wrong, where there is none
    std::shared_ptr<void const> (*make_image)(Sizes const&, bool may_move, Image& image, Outcome& outcome, std::string& error) = nullptr;
};

/// A denoiser with a stage behind it, on a device.
class StagedInstance final : public Instance {
    std::unique_ptr<Instance> denoiser, stage;
    std::vector<std::size_t> places; ///< of the stage's channels among a frame's; for `denoised` one behind the last
    std::shared_ptr<void const> memory;
    Image between;
    std::vector<Frame> seen{1};

public:
    StagedInstance(std::unique_ptr<Instance> d, std::unique_ptr<Instance> s, std::vector<std::size_t> p, std::shared_ptr<void const> m,
                   Image const& b)
        : denoiser(std::move(d)), stage(std::move(s)), places(std::move(p)), memory(std::move(m)), between(b) {}

    Outcome run(std::vector<Frame> const& frames, Image const& output, std::string& error) noexcept override {
        auto const made = denoiser->run(frames, between, error);
        if (made != Outcome::ok) return made;
        auto const& given = frames.front();
        auto& frame = seen.front();
        frame.width = given.width, frame.height = given.height, frame.camera = given.camera, frame.shutter = given.shutter;
        frame.number = given.number, frame.has_number = given.has_number;
        frame.channels.resize(places.size()); // as many in each frame
        for (std::size_t i = 0; i < places.size(); ++i)
            frame.channels[i] = places[i] < given.channels.size() ? given.channels[places[i]] : between;
        auto const outcome = stage->run(seen, output, error);
        if (outcome != Outcome::ok) forget(); // the history has seen a frame that the caller has no picture of
        return outcome;
    }
    Outcome copy_guide(std::string const& name, Image const& output, std::string& error) noexcept override {
        return denoiser->copy_guide(name, output, error);
    }
    void forget() noexcept override { denoiser->forget(), stage->forget(); }
    [[nodiscard]] Statistics statistics() const noexcept override {
        auto counted = denoiser->statistics();
        auto const height = static_cast<std::size_t>(seen.front().height);
        counted.bytes += stage->statistics().bytes + 3 * static_cast<std::size_t>(between.row_stride) * height;
        return counted;
    }
};

/// A preset with stages; null where one of them can't be behind it.
inline std::shared_ptr<PresetWay const> with_stages(DeviceCode const& preset, std::vector<DeviceCode> const& stages,
                                                    std::vector<std::string> const& names, std::string& refusal) {
    auto way = preset.way;
    auto const is_wanted = [&](std::string_view name) { return std::ranges::find(names, name) != names.end(); };
    if (is_wanted(resolve_stage) && is_wanted(colours_stage)) {
        refusal = "settings.stages: '" + preset.name + "' " + colours_and_resolve;
        return nullptr;
    }
    for (auto const& stage : stages) {
        if (!is_wanted(stage.name)) continue;
        auto const refuse = [&](std::string const& why) {
            refusal = "settings.stages: '" + preset.name + "' " + why + "; leave '" + stage.name + "' out";
            return nullptr;
        };
        if (preset.signal.empty() || way.output_components != 3) return refuse("makes no single colour with its history");
        std::vector<std::size_t> places;
        for (auto const& channel : stage.way.channels) {
            auto const name = channel.name == "radiance" ? preset.signal : channel.name;
            auto const found = std::ranges::find(way.channels, name, &Channel::name);
            if (found == way.channels.end() && name != "denoised") return refuse("reads no " + name);
            places.push_back(static_cast<std::size_t>(found - way.channels.begin()));
        }
        if (auto const& jittered = stage.way.needs_jitter; !jittered.empty()) way.needs_jitter = jittered, way.needs_camera = true;
        way.plan = [before = way.plan, &stage] { return before() + "\nBehind it, " + stage.name + ":\n\n" + stage.way.plan(); };
        way.make = [before = way.make, &stage, places](Sizes const& sizes, float samples, Motion const& motion, Parallel const& parallel,
                                                       Memory const& memory, Outcome& outcome,
                                                       std::string& error) -> std::unique_ptr<Instance> {
            auto denoiser = before(sizes, samples, motion, parallel, memory, outcome, error);
            if (outcome != Outcome::ok) return nullptr;
            auto behind = stage.way.make(sizes, samples, motion, parallel, memory, outcome, error);
            if (outcome != Outcome::ok) return nullptr;
            Image between;
            auto kept = stage.make_image(sizes, memory.may_move, between, outcome, error);
            if (outcome != Outcome::ok) return nullptr;
            return std::make_unique<StagedInstance>(std::move(denoiser), std::move(behind), places, std::move(kept), between);
        };
    }
    return std::make_shared<PresetWay const>(std::move(way));
}

/// All that is compiled for a device.
inline Codes codes_of_device(std::vector<DeviceCode> presets, std::vector<DeviceCode> stages) {
    auto const all_stages = std::make_shared<std::vector<DeviceCode> const>(std::move(stages));
    Codes all;
    for (auto& preset : presets)
        all.presets.push_back({preset.name, [made = std::make_shared<DeviceCode const>(std::move(preset)),
                                             all_stages](std::vector<std::string> const& names, bool /*alpha*/, std::string& refusal) {
                                   return with_stages(*made, *all_stages, names, refusal);
                               }});
    for (auto const& stage : *all_stages) all.stages.push_back(stage.name);
    return all;
}

} // namespace quell_library

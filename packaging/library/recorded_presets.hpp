#pragma once

#include <quell/shader/record_options.hpp>
#include <quell/shader/shader_plan.hpp>

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

namespace quell::shaders {

/// A preset that can be recorded, or a stage behind presets.
struct RecordedPreset {
    std::string_view name;
    /// @param samples of each pixel, for stages
    std::function<ShaderPlan(RecordOptions const&, float samples)> record{};
};

/// Those of a unit, in the order of all_presets.
template <std::size_t unit> std::vector<RecordedPreset> presets_of_unit();

/// The stages behind presets.
std::vector<RecordedPreset> recorded_stages();

/// All presets, and the stages behind them.
std::vector<RecordedPreset> recorded_presets();

/// The plan of one.
/// @param samples of each pixel, for stages
/// @throws Error where it is not compiled in
ShaderPlan recorded_preset_named(std::string_view name, RecordOptions const& options = {}, float samples = 1.f);

} // namespace quell::shaders

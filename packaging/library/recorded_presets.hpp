#pragma once

#include <quell/shader/record_options.hpp>
#include <quell/shader/shader_plan.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace quell::shaders {

/// A preset that can be recorded.
struct RecordedPreset {
    std::string_view name;
    ShaderPlan (*record)(RecordOptions const&) = nullptr;
};

/// Those of a unit, in the order of all_presets.
template <std::size_t unit> std::vector<RecordedPreset> presets_of_unit();

/// All of them.
std::vector<RecordedPreset> recorded_presets();

/// The plan of one.
/// @throws Error where it is not compiled in
ShaderPlan recorded_preset_named(std::string_view name, RecordOptions const& options = {});

} // namespace quell::shaders

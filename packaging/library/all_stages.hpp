#pragma once

#include <quell/presets/named_stages.hpp>

// The stages of the headers, and those of QUELL_OWN_STAGES: a header with `inline constexpr std::tuple
// own_stages{quell::NamedStage{...}};`.
#if defined(QUELL_OWN_STAGES)
#include QUELL_OWN_STAGES
#endif

namespace quell_library {

#if defined(QUELL_OWN_STAGES)
inline constexpr auto stages_before_resolve = std::tuple_cat(quell::named_stages, ::own_stages);
#else
inline constexpr auto& stages_before_resolve = quell::named_stages;
#endif

/// Calls function(stage) for each stage behind presets but `resolve`, in order.
constexpr void for_each_stage_before_resolve(auto const& function) {
    std::apply([&](auto const&... stage) { (function(stage), ...); }, stages_before_resolve);
}
/// The same for all of them.
constexpr void for_each_stage(auto const& function) { for_each_stage_before_resolve(function), function(quell::named_resolve); }

/// The function that makes a stage's pipeline without being told anything: for its type, its plan, and recording.
template <class Named> struct MadeStage {
    constexpr auto operator()() const { return decltype(Named::make){}(quell::StandsBehind{}); }
};

} // namespace quell_library

#pragma once

#include "compiled_preset.hpp"

namespace quell_library {

/// Whether light can be given back behind a compiled preset: it must denoise one colour with its history, without alpha, and read what
/// tells surfaces apart and where they were.
[[nodiscard]] bool can_give_back(Way const& way);

/// What is done then: a sentence before the preset's plan.
[[nodiscard]] std::string plan_of_given_back();

/// A compiled preset behind which light is given back that its filter took out by mistake (quell::light_given_back()). It is compiled once,
/// not for each preset.
/// @param denoiser made by the way, with a choice of its history or without
/// @param way      that can_give_back()
/// @param is_judged whether samples choose between its history and the frame by itself
/// @param samples  of each pixel
/// @throws quell::Error, std::bad_alloc
[[nodiscard]] std::unique_ptr<CompiledDenoiser> with_light_given_back(std::unique_ptr<CompiledDenoiser> denoiser, Way const& way,
                                                                      bool is_judged, float samples, quell::Extent size,
                                                                      Parallel const& parallel, Memory const& memory);

} // namespace quell_library

#pragma once

// Everything that needs GLM and xsimd only. Include separately: quell/execute/threads.hpp (oneTBB), quell/io/exr.hpp (OpenEXR),
// quell/metrics/*.hpp, quell/presets/blur.hpp (motion blur), quell/diagnose/diagnose.hpp.

#include <quell/blend/clamped.hpp>
#include <quell/blend/exponential.hpp>
#include <quell/blend/non_planar_falloff.hpp>
#include <quell/blend/running_mean.hpp>
#include <quell/blend/with_clean_up.hpp>
#include <quell/blend/with_moments.hpp>
#include <quell/execute/executor.hpp>
#include <quell/execute/list_executor.hpp>
#include <quell/filter/atrous.hpp>
#include <quell/filter/bilateral.hpp>
#include <quell/filter/shadow_splat.hpp>
#include <quell/filter/variance_guided_atrous.hpp>
#include <quell/image/borrowed.hpp>
#include <quell/image/interleaved.hpp>
#include <quell/image/planar.hpp>
#include <quell/image/subsampled.hpp>
#include <quell/motion/catmull_rom.hpp>
#include <quell/motion/dual_motion.hpp>
#include <quell/motion/first_valid.hpp>
#include <quell/motion/reflection/thin_lens.hpp>
#include <quell/motion/surface_motion.hpp>
#include <quell/pipeline/pipeline.hpp>
#include <quell/pipeline/run.hpp>
#include <quell/presets/effects.hpp>
#include <quell/presets/general.hpp>
#include <quell/radiance/cone_fetch.hpp>
#include <quell/radiance/cone_gather.hpp>
#include <quell/radiance/with_cones.hpp>
#include <quell/version.hpp>

#pragma once

// Plain types only, and no header of quell's: this is included by code for different instruction sets.

/// Denoises frames of a wall in noisy light, and writes the last one as RGB.
using DenoiseFunction = void(int width, int height, int frames, float* rgb);

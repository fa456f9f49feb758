"""Denoises eight frames of a grey wall in noisy light. Prints the noise that is left, as a part of the input's."""

import numpy as np

import quell

height, width = 180, 320
random = np.random.default_rng(1)
guides = {
    "albedo": np.full((height, width, 3), 0.5, np.float32),
    "normal": np.zeros((height, width, 3), np.float32),
    "depth": np.full((height, width), 4, np.float32),
    "motion": np.zeros((height, width, 2), np.float32),
}
guides["normal"][..., 2] = 1
picture = np.empty((height, width, 3), np.float32)

denoiser = quell.Denoiser("svgf", (height, width))
for number in range(8):
    radiance = random.random((height, width, 3), np.float32)
    denoiser(guides, radiance=radiance, number=number, out=picture)

print(f"noise left: {picture.var() / radiance.var():.4f}")

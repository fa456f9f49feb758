"""A stage of a host's own, in quell for Python: own_stage.hpp."""

import numpy as np
import quell

assert quell.stages().count("half") == 1, quell.stages()
frame = {
    "radiance": np.random.default_rng(1).random((34, 61, 3), np.float32),
    "albedo": np.full((34, 61, 3), 0.5, np.float32),
    "normal": np.full((34, 61, 3), (0, 0, 1), np.float32),
    "depth": np.full((34, 61), 4, np.float32),
    "motion": np.zeros((34, 61, 2), np.float32),
}
preset = "svgf" if "svgf" in quell.presets() else "general"
plain, halved = (quell.Denoiser(preset, (34, 61), stages=stages)(frame) for stages in ([], ["half"]))
np.testing.assert_allclose(halved, (plain + frame["radiance"]) / 2, rtol=1e-6)

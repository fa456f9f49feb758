"""What tests share: frames of a grey wall in noisy light, and what C makes of them."""

import os
import pathlib
import subprocess
import tempfile

import numpy as np

import quell


def wall(height, width, seed=1):
    """A frame as Denoiser("svgf") reads it."""
    random = np.random.default_rng(seed)
    normal = np.zeros((height, width, 3), np.float32)
    normal[..., 2] = 1
    return {
        "radiance": random.random((height, width, 3), np.float32),
        "albedo": np.full((height, width, 3), 0.5, np.float32),
        "normal": normal,
        "depth": np.linspace(3, 5, height * width, dtype=np.float32).reshape(height, width),
        "motion": np.full((height, width, 2), (0.25, -0.5), np.float32),
    }


LETTERS = {"radiance": "RGB", "albedo": "RGB", "normal": "XYZ", "depth": "Z", "motion": "XY"}


def planes_of(frame):
    """As quell's programs name them."""
    planes = {}
    for name, letters in LETTERS.items():
        for c, letter in enumerate(letters):
            plane = frame[name] if frame[name].ndim == 2 else frame[name][..., c]
            planes[letter if name == "radiance" else f"{name}.{letter}"] = plane
    return planes


def in_c(preset, frames):
    """The pictures that C makes of these frames."""
    height, width = frames[0]["radiance"].shape[:2]
    denoiser = quell.Denoiser(preset, (height, width))
    with tempfile.TemporaryDirectory() as folder:
        given, made = pathlib.Path(folder) / "in", pathlib.Path(folder) / "out"
        given.write_bytes(b"".join(np.ascontiguousarray(frame[name], np.float32).tobytes() for frame in frames for name in denoiser.reads))
        command = [os.environ["QUELL_IN_C"], preset, str(width), str(height), str(len(frames)), str(given), str(made)]
        subprocess.run(command, check=True)
        return np.fromfile(made, np.float32).reshape(len(frames), height, width, 3)


def pictures(denoiser, frames, **options):
    """The pictures that a denoiser makes of these frames."""
    return np.stack([denoiser(frame, **options).copy() for frame in frames])


def same_bits(a, b):
    """Whether two arrays of floats have the same bits."""
    return a.shape == b.shape and a.dtype == b.dtype and a.tobytes() == b.tobytes()

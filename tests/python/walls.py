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


def some_camera():
    """A camera that no transposition leaves as it is."""
    view = np.eye(4, dtype=np.float32)
    view[:3, 3] = 0.5, 0.25, -1
    return quell.Camera(view, [[1.5, 0, 0, 0], [0, 2, 0, 0], [0, 0, -1, -0.2], [0, 0, -1, 0]], (0.25, -0.125))


def of_all_channels(denoiser, seed):
    """A frame of noise in all channels that a preset reads, seen by some_camera()."""
    random = np.random.default_rng(seed)
    frame = {name: random.random((*denoiser.size, components), np.float32) for name, components in {**denoiser.reads, **denoiser.may_read}.items()}
    return {**frame, "camera": some_camera()}


def in_c(preset, frames, output_size=None):
    """The pictures that C makes of these frames, seen by some_camera(): anti-aliased where there is a size."""
    height, width = next(iter(frames[0].values())).shape[:2]
    denoiser = quell.Denoiser(preset, (height, width), output_size=output_size, stages=["resolve"] if output_size else [])
    camera = some_camera()
    columns = [camera.view.ravel(order="F"), camera.projection.ravel(order="F"), camera.jitter]
    with tempfile.TemporaryDirectory() as folder:
        given, made = pathlib.Path(folder) / "in", pathlib.Path(folder) / "out"
        channels = b"".join(np.ascontiguousarray(frame[name], np.float32).tobytes() for frame in frames for name in denoiser._channels)
        given.write_bytes(np.concatenate(columns).tobytes() + channels)
        command = [os.environ["QUELL_IN_C"], preset, str(width), str(height), str(len(frames)), str(given), str(made)]
        command += [str(length) for length in (output_size or ())[::-1]]
        subprocess.run(command, check=True)
        return np.fromfile(made, np.float32).reshape(len(frames), *(output_size or (height, width)), -1)


def pictures(denoiser, frames, **options):
    """The pictures that a denoiser makes of these frames."""
    return np.stack([denoiser(frame, **options).copy() for frame in frames])


def same_bits(a, b):
    """Whether two arrays of floats have the same bits."""
    return a.shape == b.shape and a.dtype == b.dtype and a.tobytes() == b.tobytes()

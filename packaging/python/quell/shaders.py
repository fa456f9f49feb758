"""Presets as compute shaders, for WebGPU and Vulkan."""

import json
import os
import pathlib
from typing import Any, NamedTuple, Optional, Union

from . import _shaders
from ._denoiser import Camera, _packed

__all__ = ["Shaders", "languages", "presets", "record", "write"]

Path = Union[str, "os.PathLike[str]"]


class Shaders(NamedTuple):
    """A preset as shaders, one or two for each pass."""

    plan: dict[str, Any]  #: what a host must know to run them: docs/shaders.md
    texts: dict[str, str]  #: by the file names that the plan has, such as "06-temporal.wgsl"

    def block(
        self,
        size: tuple[int, int],
        number: int,
        camera: Optional[Camera] = None,
        camera_then: Optional[Camera] = None,
        shutter: float = 0.5,
        shutter_then: Optional[float] = None,
    ) -> bytes:
        """The block of uniforms of a frame, as shaders read it.

        size: (height, width). number: the frame's, seed of random numbers. camera_then, shutter_then: of the previous frame; None for the
        same, as in a frame without a past. shutter: as a part of the time between frames.
        """
        height, width = size
        then = shutter if shutter_then is None else shutter_then
        seen, seen_then = (_packed(name, each) for name, each in (("camera", camera), ("camera_then", camera_then)))
        return _shaders.block(width, height, number, self.plan["needs_camera"], shutter, then, seen, seen_then)


def presets() -> list[str]:
    """Names of the presets that can be written, and behind them of stages, which read `denoised`: what a preset has made."""
    return _shaders.presets()


def languages() -> list[str]:
    """Names of the languages that they can be written in."""
    return _shaders.languages()


def record(preset: str, language: str = "wgsl", **options: Any) -> Shaders:
    """A preset as shaders, in memory. Languages are "wgsl", and "glsl" for Vulkan; the program quell-shaders has others.

    Options are added to the preset's passes. repair_guides=True: repairs guides that no scene has. fill_holes=n: so many passes give missing
    samples what stands 2, 4, 8, ... pixels away. counts=True: counts missing samples, impossible guides and suppressed light.
    most_slots=n: of a buffer. half_precision=True: history and scratch are kept in 16 bits a component. texel_loads=True: GLSL loads planes by
    texelFetch, for devices that are a CPU. workgroup=(width, height): threads of a workgroup. samples_per_pixel=n: for stages.
    """
    plan, texts = _created(preset, language, **options)
    return Shaders(json.loads(plan), texts)


def write(preset: str, folder: Path, language: str = "wgsl", **options: Any) -> None:
    """Writes the shaders and plan.json into a folder, which is made where it is not there. Options are those of record()."""
    plan, texts = _created(preset, language, **options)
    to = pathlib.Path(folder)
    to.mkdir(parents=True, exist_ok=True)
    for name, text in {**texts, "plan.json": plan}.items():
        (to / name).write_bytes(text.encode())


def _created(
    preset: str,
    language: str,
    *,
    repair_guides: bool = False,
    fill_holes: int = 0,
    counts: bool = False,
    most_slots: int = 0,
    half_precision: bool = False,
    texel_loads: bool = False,
    workgroup: tuple[int, int] = (8, 8),
    samples_per_pixel: int = 1,
) -> tuple[str, dict[str, str]]:
    return _shaders.create(
        preset, language, repair_guides, fill_holes, counts, most_slots, half_precision, texel_loads, workgroup, samples_per_pixel
    )

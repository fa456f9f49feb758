"""quell: real-time denoising of ray-traced images.

    import quell
    denoiser = quell.Denoiser("general", (1080, 1920))
    picture = denoiser(radiance=rgb, albedo=albedo, normal=normal, depth=depth, motion=motion)

Arrays are NumPy's, or any object that lends its memory (DLPack, __array_interface__, buffers). They are read where they lie: shape
(height, width, components), float32 or float16, any strides. docs/python.md says more.
"""

from . import metrics
from ._denoiser import Camera, Denoiser, Samples, Statistics, instruction_sets, presets, stages
from ._errors import Error, Status
from ._library import version
from ._sequence import denoise
from . import exr, shaders

__version__ = version
__all__ = [
    "Camera",
    "Denoiser",
    "Error",
    "Samples",
    "Statistics",
    "Status",
    "denoise",
    "exr",
    "instruction_sets",
    "metrics",
    "presets",
    "shaders",
    "stages",
    "version",
]

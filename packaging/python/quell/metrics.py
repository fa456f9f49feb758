"""How far a picture is from its reference.

Pictures are *displayed* ones: sRGB-encoded, components in [0, 1], shape (height, width, 3). displayed() makes them of linear light.
A mask has shape (height, width); its non-zero pixels count.
"""

from typing import Any, NamedTuple, Optional

import numpy as np

from . import _metrics
from ._arrays import Array, lent
from ._errors import Error

__all__ = ["Flip", "displayed", "flip", "rmse", "ssim"]


class Flip(NamedTuple):
    """What flip() returns."""

    mean: float  #: over the pixels that count
    errors: Array  #: of each pixel, from 0 (none) to 1; shape (height, width)


def displayed(linear: Any) -> Array:
    """What a screen shows of linear light: components clamped to [0, 1] and sRGB-encoded."""
    return _metrics.displayed(_picture("linear", linear))


def rmse(reference: Any, test: Any, mask: Any = None) -> float:
    """Root of the mean squared difference: 0 if equal, at most 1."""
    return _metrics.rmse(_picture("reference", reference), _picture("test", test), _mask(mask))


def ssim(reference: Any, test: Any, mask: Any = None) -> float:
    """Mean structural similarity of luminance: 1 if equal, at least -1."""
    return _metrics.ssim(_picture("reference", reference), _picture("test", test), _mask(mask))


def flip(reference: Any, test: Any, mask: Any = None, pixels_per_degree: float = 67.0) -> Flip:
    """FLIP: the difference that a viewer sees when the pictures alternate."""
    return Flip(*_metrics.flip(_picture("reference", reference), _picture("test", test), _mask(mask), pixels_per_degree))


def _picture(what: str, value: Any) -> Array:
    array = lent(what, value).array
    if array.dtype.kind != "f" or array.dtype.itemsize > 4:
        raise Error(f"{what}: its numbers are {array.dtype}; give float32 or float16, components of 8 bits divided by 255")
    if array.ndim != 3 or array.shape[2] < 3:
        raise Error(f"{what}: its shape is {array.shape}; give (height, width, 3)")
    return np.ascontiguousarray(array[:, :, :3], np.float32)


def _mask(value: Any) -> Optional[Array]:
    return None if value is None else np.ascontiguousarray(lent("mask", value).array != 0).view(np.uint8)

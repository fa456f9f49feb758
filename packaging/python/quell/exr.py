"""OpenEXR files, by the names that quell's programs have for channels."""

import os
from typing import Any, Iterable, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np

from ._arrays import Array, lent
from ._denoiser import Camera
from ._errors import Error, Status

try:
    from . import _exr
except ImportError:
    _exr = None  # type: ignore[assignment] # built without OpenEXR

__all__ = ["Image", "read", "read_frame", "signals", "write"]

Path = Union[str, "os.PathLike[str]"]
_TYPES = {"half": np.float16, "float": np.float32, "uint": np.uint32}
_NAMES = {np.dtype(number): name for name, number in _TYPES.items()}


class Image(NamedTuple):
    """Contents of a file."""

    planes: dict[str, Array]  #: by name, such as "albedo.R": shape (height, width), of the type that the file has
    attributes: dict[str, Any]  #: str, int, float, (x, y), or a 4x4 matrix that is indexed by row and column


def read(path: Path, names: Optional[Iterable[str]] = None) -> Image:
    """Reads these planes, or all. A part's name stands before those that an earlier part has too."""
    planes, attributes = _module().read(os.fspath(path), None if names is None else list(names))
    found = {}
    for name, kind, is_exact, values in planes:
        if not is_exact:
            raise Error(f"{os.fspath(path)} channel '{name}': it holds integers above 2^24; read the other channels by `names`")
        found[name] = values.astype(_TYPES[kind], copy=False)
    return Image(found, attributes)


def write(path: Path, planes: Mapping[str, Any], attributes: Optional[Mapping[str, Any]] = None) -> None:
    """Writes planes of shape (height, width): float16 as half, float32, uint32. The file is replaced at once or not at all.

    What has the name of a channel and as many components is written by quell's names, so that read_frame() and quell-denoise read it:
    "depth" as depth.Z, "motion" as motion.X and motion.Y, "radiance" as R, G and B. Else an array of three or four components is written
    as name.R, name.G, name.B, name.A; of an empty name as R, G, B, A.
    """
    listed = []
    for name, value in planes.items():
        array = lent(f"plane '{name}'", value).array
        kind = _NAMES.get(array.dtype)
        if kind is None:
            raise Error(f"plane '{name}': its numbers are {array.dtype}; give float16, float32 or uint32")
        names = _plane_names(name, array.shape)
        components = [array] if array.ndim == 2 else [array[:, :, c] for c in range(len(names))]
        listed += [(plane, kind, _floats(component)) for plane, component in zip(names, components)]
    if not listed:
        raise Error(f"{os.fspath(path)}: it has no planes; give at least one")
    for name, _, array in listed:
        if array.shape != listed[0][2].shape:
            raise Error(f"plane '{name}': its shape is {array.shape}, that of '{listed[0][0]}' {listed[0][2].shape}; give planes of one size")
    _module().write(os.fspath(path), listed, dict(attributes or {}))


def signals(path: Path) -> list[str]:
    """The signals of a file of quell's or of Blender's: each is denoised by itself."""
    names: list[str] = _module().signals(os.fspath(path))
    return names


def read_frame(
    path: Path,
    channels: Optional[Iterable[str]] = None,
    *,
    names: Optional[Mapping[str, Sequence[str]]] = None,
    signal: Optional[str] = None,
) -> dict[str, Any]:
    """Reads a frame: the dict that a Denoiser takes, with "camera" and "shutter" where the file has them.

    channels: those to read, such as denoiser.reads; None: all that the file has.
    names: planes of the file by channel, one for each component, as {"depth": ["Z"]}. The rest goes by quell's names or by Blender's.
    signal: which of several, see signals().
    """
    found: dict[str, Any]
    found, camera, shutter = _module().read_frame(
        os.fspath(path),
        None if channels is None else list(channels),
        {channel: [planes] if isinstance(planes, str) else list(planes) for channel, planes in (names or {}).items()},
        signal,
    )
    if camera is not None:
        found["camera"] = Camera(*camera)
    if shutter is not None:
        found["shutter"] = shutter
    return found


def _plane_names(name: str, shape: tuple[int, ...]) -> list[str]:
    count = 1 if len(shape) == 2 else shape[2] if len(shape) == 3 else 0
    of_channel: list[str] = _module().names_of_channels().get(name, [])
    if len(of_channel) == count > 0:
        return of_channel
    if len(shape) == 2:
        return [name]
    if count in (3, 4):
        return [f"{name}.{letter}" if name else letter for letter in "RGBA"[:count]]
    found = f"plane '{name}': its shape is {shape}"
    if of_channel:
        raise Error(f"{found}; the channel has {len(of_channel)} components: {', '.join(of_channel)}")
    raise Error(f"{found}; give (height, width), or (height, width, 3 or 4)")


def _floats(array: Array) -> Array:
    floats = np.ascontiguousarray(array, np.float32)
    if array.dtype == np.uint32 and array.size and array.max() > 2**24:
        raise Error(f"a plane of integers: one is {array.max()}; give at most 2^24")
    return floats


def _module() -> Any:
    if _exr is None:
        raise Error("quell.exr: quell was built without OpenEXR; install it (libopenexr-dev) and build quell again", Status.NOT_SUPPORTED)
    return _exr

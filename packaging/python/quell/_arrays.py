"""Arrays of others as NumPy's, without a copy."""

from typing import Any, NamedTuple

import numpy as np

from ._errors import Error, Status

# DLPack's numbers of devices whose memory the CPU reaches: CPU, CUDA's host memory, ROCm's, CUDA's managed memory.
_HOST_DEVICES = (1, 3, 11, 13)
_DEVICE_NAMES = {2: "CUDA", 4: "OpenCL", 7: "Vulkan", 8: "Metal", 10: "ROCm", 14: "oneAPI"}
# DLPack before its version 1 does not say whether memory may be written, and NumPy before 2.1 takes it for read-only.
_DLPACK_SAYS_READ_ONLY = tuple(int(part) for part in np.__version__.split(".")[:2]) >= (2, 1)


Array = np.ndarray[Any, Any]


class Lent(NamedTuple):
    """Memory of another's."""

    array: Array
    is_writable: bool


def lent(what: str, value: Any) -> Lent:
    """The memory of an object as an array. `what` names it in errors."""
    if isinstance(value, np.ma.MaskedArray):
        raise Error(f"{what}: it has a mask, which would be lost; give array.filled(0)")
    if isinstance(value, np.ndarray):
        return Lent(value, value.flags.writeable)
    kind = type(value).__name__
    device = getattr(value, "__dlpack_device__", None)
    if device is not None:
        number = int(device()[0])
        if number not in _HOST_DEVICES:
            _refuse_device(what, _DEVICE_NAMES.get(number, f"device type {number} of DLPack"))
    if hasattr(value, "__cuda_array_interface__"):
        _refuse_device(what, "CUDA")
    try:
        if device is not None and hasattr(value, "__dlpack__"):
            array = np.from_dlpack(value)
            return Lent(array, array.flags.writeable or not _DLPACK_SAYS_READ_ONLY)
        array = np.asarray(value if hasattr(value, "__array_interface__") else memoryview(value))
    except Exception as error:
        raise Error(f"{what}: it is a {kind}, which does not lend its memory ({error}); give a NumPy array") from error
    return Lent(array, array.flags.writeable)


def _refuse_device(what: str, device: str) -> None:
    raise Error(f"{what}: its memory is on a device ({device}), which is not supported yet; copy it to the host first", Status.NOT_SUPPORTED)

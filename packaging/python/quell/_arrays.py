"""Arrays of others as NumPy's, without a copy."""

from typing import Any, NamedTuple, Optional, Union

import numpy as np

from . import _library
from ._errors import Error, Status

# DLPack's numbers of devices whose memory the CPU reaches: CPU, CUDA's host memory, ROCm's, CUDA's managed memory.
_HOST_DEVICES = (1, 3, 11, 13)
# CUDA's memory, also managed.
_CUDA_DEVICES = (2, 13)
_DEVICE_NAMES = {2: "CUDA", 4: "OpenCL", 7: "Vulkan", 8: "Metal", 10: "ROCm", 14: "oneAPI"}
# DLPack before its version 1 does not say whether memory may be written, and NumPy before 2.1 takes it for read-only.
_DLPACK_SAYS_READ_ONLY = tuple(int(part) for part in np.__version__.split(".")[:2]) >= (2, 1)


Array = np.ndarray[Any, Any]


class OnDevice(NamedTuple):
    """Memory of a CUDA device, which NumPy can't show, in its words."""

    address: int
    shape: tuple[int, ...]
    strides: tuple[int, ...]  #: in bytes
    type: str  #: of its numbers, such as <f4
    owner: Any  #: keeps it alive

    @property
    def ndim(self) -> int:
        return len(self.shape)


class Lent(NamedTuple):
    """Memory of another's."""

    array: Union[Array, OnDevice]
    is_writable: bool


def lent(what: str, value: Any, stream: Optional[int] = None) -> Lent:
    """The memory of an object as an array. `what` names it in errors. `stream`: of a denoiser that takes memory of CUDA; else None."""
    if isinstance(value, np.ma.MaskedArray):
        raise Error(f"{what}: it has a mask, which would be lost; give array.filled(0)")
    if isinstance(value, np.ndarray):
        return Lent(value, value.flags.writeable)
    _refuse_negative_bit(what, value)
    if stream is not None:
        on_device = _on_device(what, value, stream)
        if on_device is not None:
            return on_device
    kind = type(value).__name__
    device = _dlpack_device(what, value)
    if device is not None and device not in _HOST_DEVICES:
        _refuse_device(what, _DEVICE_NAMES.get(device, f"device type {device} of DLPack"))
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


def _refuse_negative_bit(what: str, value: Any) -> None:
    """PyTorch keeps the sign of views such as z.conj().imag beside their memory, and no protocol tells of it."""
    is_negative = getattr(value, "is_neg", None)
    if callable(is_negative) and is_negative():
        raise Error(f"{what}: its negative bit is set, so that its memory holds the numbers with the other sign; give tensor.resolve_neg()")


def _dlpack_device(what: str, value: Any) -> Optional[int]:
    """DLPack's number of the device that an object lies on; None where it has no DLPack."""
    device = getattr(value, "__dlpack_device__", None)
    if device is None:
        return None
    try:
        return int(device()[0])
    except Exception as error:
        name = getattr(value, "device", None)
        where = "on no device that DLPack knows" if name is None else f"on the device '{name}', which DLPack does not know"
        raise Error(f"{what}: it is a {type(value).__name__} {where} ({error}); give an array that has its numbers in memory", Status.NOT_SUPPORTED) from error


def _on_device(what: str, value: Any, stream: int) -> Optional[Lent]:
    """What lies on a CUDA device; None for all else."""
    interface = getattr(value, "__cuda_array_interface__", None)
    if interface is not None:
        return _by_interface(what, interface, value, stream)
    if _dlpack_device(what, value) not in _CUDA_DEVICES:
        return None
    try:
        # 1 is the default stream here. The producer lets that stream wait for what it has to do.
        capsule = value.__dlpack__(stream=stream or 1)
        address, shape, strides, type_ = _library.tensor_in(capsule)
    except Exception as error:
        raise Error(f"{what}: it is a {type(value).__name__}, which does not lend its memory on a device ({error}); copy it to the host") from error
    return Lent(OnDevice(address, shape, strides or _usual_strides(shape, type_), type_, capsule), True)


def _by_interface(what: str, interface: Any, owner: Any, stream: int) -> Lent:
    try:
        shape = tuple(int(length) for length in interface["shape"])
        type_, (address, is_read_only) = str(interface["typestr"]), interface["data"]
        given = interface.get("strides")
        strides = _usual_strides(shape, type_) if given is None else tuple(int(stride) for stride in given)
        its_stream = interface.get("stream")
        lent_memory = Lent(OnDevice(int(address or 0), shape, strides, type_, owner), not is_read_only)
    except (KeyError, TypeError, ValueError) as error:
        raise Error(f"{what}: its __cuda_array_interface__ can't be read ({error!r}); give an array of CuPy, PyTorch or Numba") from error
    if interface.get("mask") is not None:
        raise Error(f"{what}: it has a mask, which would be lost; give an array without one")
    # 1 is the default stream there, which is 0 to a denoiser.
    if its_stream is not None and (0 if its_stream == 1 else its_stream) != (0 if stream == 1 else stream):
        raise Error(f"{what}: its stream is {its_stream}, the denoiser's {stream}; make the denoiser by Denoiser(..., stream={its_stream})")
    return lent_memory


def _usual_strides(shape: tuple[int, ...], type_: str) -> tuple[int, ...]:
    strides, stride = [], np.dtype(type_).itemsize
    for length in reversed(shape):
        strides.append(stride)
        stride *= length
    return tuple(reversed(strides))


def _refuse_device(what: str, device: str) -> None:
    remedy = 'make the denoiser by Denoiser(..., device="cuda"), where quell was built for that, or copy' if device == "CUDA" else "copy"
    raise Error(f"{what}: its memory is on a device ({device}); {remedy} it to the host first", Status.NOT_SUPPORTED)

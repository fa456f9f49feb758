import operator
from typing import Any, Mapping, NamedTuple, Optional, Sequence

import numpy as np

from . import _library
from ._arrays import Array, lent
from ._errors import Error


class Camera:
    """A perspective camera.

    `view` (world to camera) and `projection` (without jitter) are 4x4 matrices for column vectors, indexed by row and column:
    clip = projection @ view @ world. The camera looks down -z; y is up. `jitter` is the offset of the samples from the pixels' centres,
    in pixels, x and y, y down.
    """

    __slots__ = ("view", "projection", "jitter", "_packed")

    def __init__(self, view: Any, projection: Any, jitter: Sequence[float] = (0.0, 0.0)) -> None:
        self.view = _numbers("camera.view", view, (4, 4))
        self.projection = _numbers("camera.projection", projection, (4, 4))
        self.jitter = _numbers("camera.jitter", jitter, (2,))
        # As quell.h has it: columns one after another.
        self._packed = np.concatenate([self.view.T.ravel(), self.projection.T.ravel(), self.jitter])

    def __repr__(self) -> str:
        return f"Camera({self.view.tolist()}, {self.projection.tolist()}, {self.jitter.tolist()})"


class Statistics(NamedTuple):
    """Counts of a denoiser."""

    frames: int  #: since the history began
    resets: int  #: how often it began
    missing_samples: int  #: in the last frame: not finite, beyond 1e16, of negative luminance
    repaired_guides: int  #: pixels of the last frame with impossible normals, albedo, depth or motion
    bytes: int  #: of history and scratch


class Denoiser:
    """Denoises the frames of one view, which has a history.

    `preset` is one of presets(), `size` is (height, width). `threads`: 0 for all that there are; results do not depend on it.
    `instruction_set`: one of instruction_sets(), or None for the best that the machine has.

    A denoiser is for one thread of Python at a time; another one gets an Error of Status.BUSY. While it runs, other threads do.
    """

    def __init__(self, preset: str, size: Sequence[int], *, threads: int = 0, instruction_set: Optional[str] = None) -> None:
        if len(size) != 2:
            raise Error(f"size: it is {tuple(size)}; give (height, width)")
        height, width = (_whole("size", each, 32) for each in size)
        self._denoiser = _library.Denoiser(preset, width, height, _whole("threads", threads, 32), instruction_set)
        self._reads = self._denoiser.reads()
        self._preset = preset
        self._size = (height, width)

    def __call__(
        self,
        frame: Optional[Mapping[str, Any]] = None,
        /,
        *,
        camera: Optional[Camera] = None,
        number: Optional[int] = None,
        shutter: Optional[float] = None,
        out: Any = None,
        **channels: Any,
    ) -> Any:
        """Denoises a frame and returns a new array, or `out`, which it then writes.

        Channels are given by name: radiance=..., albedo=..., or as a dict, which may also have "camera", "number" and "shutter". A dict
        may hold more channels than the preset reads.

        camera: where needs_camera. number: of the frame; where numbers do not follow each other, history starts afresh. shutter: the time
        that it is open as a part of the frame time, for motion blur; 0.5 if it is not said.
        """
        if frame is not None:
            camera = frame.get("camera") if camera is None else camera
            number = frame.get("number") if number is None else number
            shutter = frame.get("shutter") if shutter is None else shutter
            channels = {**{name: frame[name] for name in self._reads if name in frame}, **channels}
        if out is None:
            written = out = np.empty(self._output_shape(), np.float32)
        else:
            written, is_writable = lent("out", out)
            if not is_writable:
                raise Error("out: its memory is read-only; give memory that may be written, such as a new array")
        self._denoiser.run(
            {name: lent(f"channel '{name}'", value).array for name, value in channels.items()},
            written,
            _packed(camera),
            None if number is None else _whole("number", number, 64),
            0.5 if shutter is None else float(shutter),
        )
        return out

    def forget(self) -> None:
        """Drops the history: for cuts and teleports."""
        self._denoiser.forget()

    @property
    def preset(self) -> str:
        """The name of the preset."""
        return self._preset

    @property
    def size(self) -> tuple[int, int]:
        """Height and width."""
        return self._size

    @property
    def reads(self) -> dict[str, int]:
        """The channels that a frame must have, and how many components each has. docs/channels.md says what they hold."""
        return dict(self._reads)

    @property
    def needs_camera(self) -> bool:
        """Whether frames must have a camera."""
        return self._denoiser.needs_camera()

    @property
    def instruction_set(self) -> str:
        """What it is compiled for."""
        return self._denoiser.instruction_set()

    @property
    def plan(self) -> str:
        """Its passes in order, what each reads and writes, and memory: a table in Markdown."""
        return self._denoiser.plan()

    @property
    def statistics(self) -> Statistics:
        """Counts so far."""
        return Statistics(*self._denoiser.statistics())

    def __repr__(self) -> str:
        return f"Denoiser({self._preset!r}, {self._size})"

    def _output_shape(self) -> tuple[int, ...]:
        components = self._denoiser.output_components()
        return self._size if components == 1 else (*self._size, components)


def presets() -> list[str]:
    """Names of presets: docs/presets.md says what they are for."""
    return _library.presets()


def instruction_sets() -> list[str]:
    """Names of instruction sets that quell is compiled for, the best first."""
    return _library.instruction_sets()


def _packed(camera: Optional[Camera]) -> Optional[Array]:
    if camera is None or isinstance(camera, Camera):
        return None if camera is None else camera._packed
    raise Error(f"camera: it is a {type(camera).__name__}; give a quell.Camera")


def _whole(what: str, value: Any, bits: int) -> int:
    number = operator.index(value)
    if not -(2 ** (bits - 1)) <= number < 2 ** (bits - 1):
        raise Error(f"{what}: {number} is no integer of {bits} bits; give a smaller one")
    return number


def _numbers(what: str, values: Any, shape: tuple[int, ...]) -> Array:
    """A few numbers of any type as floats: a copy."""
    try:
        numbers = np.array(values, np.float32)
    except (TypeError, ValueError) as error:
        raise Error(f"{what}: it holds no numbers ({error}); give an array of shape {shape}") from error
    if numbers.shape != shape:
        raise Error(f"{what}: its shape is {numbers.shape}; give {shape}")
    return numbers

import operator
from typing import Any, Iterable, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _library
from ._arrays import Array, OnDevice, lent
from ._errors import Error, Status


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


class Samples(NamedTuple):
    """Which pixels have a sample of a channel that has fewer samples than the frame has pixels: one in each block of columns x rows.

    Samples(2, 2) is half size, Samples(2, 1, True) a checkerboard. `phase` is the pixel of each block, x and y, that this frame's samples
    are of; let it move from frame to frame. The channel's array holds the samples side by side, a part of the frame's size rounded up or
    down; or it is of the frame's size, and other pixels are not read.
    """

    columns: int  #: of a block, in pixels, 1 to 8
    rows: int  #: of a block, in pixels, 1 to 8
    staggered: bool = False  #: one column further to the right in each row of blocks
    phase: tuple[int, int] = (0, 0)  #: x and y


class Statistics(NamedTuple):
    """Counts of a denoiser."""

    frames: int  #: since the history began
    resets: int  #: how often it began
    missing_samples: int  #: in the last frame: not finite, beyond 1e16, of negative luminance
    repaired_guides: int  #: pixels of the last frame with impossible guides (docs/channels.md)
    bytes: int  #: of history and scratch


class Denoiser:
    """Denoises the frames of one view, which has a history.

    preset: one of presets(). size: (height, width). threads: 0 for all that there are; results do not depend on it.
    instruction_set: one of instruction_sets(), or None for the best that the machine has.
    stages: what is done before the preset, with it and behind it: some of stages(), in any order (docs/library.md). With "two-sided" calls
    take `later`; "steady-depth" and "steady-albedo" accumulate noisy guides first; with "evidence" samples choose between history and the
    frame by itself; "light" gives back what the filter took out by mistake; "resolve" is temporal anti-aliasing: move the samples of each
    frame by another `jitter`, and say which. With it frames may be of several sizes, one after another; what was resolved stays.
    samples_per_pixel: for "evidence" and "light"; 0 where that is not known.
    alpha: for radiance with alpha, the channel radiance_alpha, which the presets general and final-frame can.
    motion: what motion vectors mean where it is not quell's convention, in the words of channel maps:
    {"points": "from_previous", "unit": "uv" or "ndc", "y": "up", "jitter": "left_in"}, or some of these.
    output_size: (height, width) of the pictures, 1 to 4 times the frames', which adds "resolve"; None for the frames' own.
    device: "cpu", or "cuda" for presets("cuda"). Arrays may then lie on the GPU (__cuda_array_interface__, DLPack), where they are read and
    written as they are, or in the host's memory, from which they are copied.
    stream: with "cuda", the number of the stream that the work goes into, such as torch.cuda.current_stream().cuda_stream; 0 is CUDA's
    default. Where all arrays and `out` lie on the GPU, a call returns before the work is done: `out` is complete in the order of the stream.

    A denoiser is for one thread of Python at a time; another one gets an Error of Status.BUSY. While it runs, other threads do.
    """

    def __init__(
        self,
        preset: str,
        size: Sequence[int],
        *,
        threads: int = 0,
        instruction_set: Optional[str] = None,
        stages: Sequence[str] = (),
        samples_per_pixel: int = 0,
        alpha: bool = False,
        motion: Mapping[str, str] = {},
        output_size: Optional[Sequence[int]] = None,
        device: str = "cpu",
        stream: int = 0,
    ) -> None:
        height, width = _height_and_width("size", size)
        output = (0, 0) if output_size is None else _height_and_width("output_size", output_size)
        if output_size is not None and output == (0, 0):
            raise Error("output_size: it is (0, 0); give 1 to 4 times the frames' height and width, or leave it out")
        count = _whole("threads", threads, 32)
        on_device = _device(device)
        if stream and not on_device:
            raise Error(f'stream: {stream}, and the device is "cpu"; make it by Denoiser(..., device="cuda"), or leave it out')
        self._stream = _whole("stream", stream, 65) if on_device else None
        self._denoiser = _library.Denoiser(
            preset,
            width,
            height,
            count,
            instruction_set,
            _names("stages", stages),
            _whole("samples_per_pixel", samples_per_pixel, 32),
            alpha,
            _motion(motion),
            output,
            on_device,
            self._stream or 0,
        )
        self._channels = {name: (components, is_optional) for name, components, is_optional in self._denoiser.channels()}
        self._preset = preset
        self._is_two_sided = "two-sided" in stages
        self._size = (height, width)
        self._output_size = self._size if output_size is None else output
        self._resolves = "resolve" in stages or self._output_size != self._size
        self._takes_jitter = self._resolves or "colours" in stages

    def __call__(
        self,
        frame: Optional[Mapping[str, Any]] = None,
        /,
        *,
        later: Iterable[Mapping[str, Any]] = (),
        camera: Optional[Camera] = None,
        jitter: Optional[Sequence[float]] = None,
        number: Optional[int] = None,
        shutter: Optional[float] = None,
        samples: Optional[Mapping[str, Samples]] = None,
        out: Any = None,
        **channels: Any,
    ) -> Any:
        """Denoises a frame and returns a new array, or `out`, which it then writes.

        Channels are given by name: radiance=..., albedo=..., or as a dict, which may also have "camera", "jitter", "number", "shutter" and
        "samples". A dict may hold more channels than the preset reads.

        camera: where needs_camera. jitter: (x, y) of a denoiser with the stage resolve or colours, where there is no camera that says it: where the frame's
        samples lie, from the pixels' centres, in pixels, y down. number: of the frame; where numbers do not follow each other, history
        starts afresh. shutter: the time that it is open as a part of the frame time, for motion blur; 0.5 if it is not said. samples: by
        name, of the channels that have fewer samples than the frame has pixels: {"radiance": Samples(2, 2)}; guides must have all. later:
        the frames after it, as dicts, where the denoiser is two-sided; two are enough. Each call moves one frame on.
        """
        given = dict(frame or {}, **channels)
        for name, value in (("camera", camera), ("jitter", jitter), ("number", number), ("shutter", shutter), ("samples", samples)):
            if value is not None:
                given[name] = value
        frames = [self._given(given, "", [*self._channels, *channels])]
        frames += [self._given(each, f"later[{i}]: ", self._channels) for i, each in enumerate(later)]
        if len(frames) > 1 and not self._is_two_sided:
            raise Error("later: the denoiser takes one frame at a time; make it by Denoiser(..., stages=['two-sided'])", Status.NOT_SUPPORTED)
        if out is None:
            written = out = np.empty(self._output_shape(), np.float32)
        else:
            written, is_writable = lent("out", out, self._stream)
            if not is_writable:
                raise Error("out: its memory is read-only; give memory that may be written, such as a new array")
        self._denoiser.run(frames, written)
        return out

    def guide(self, name: str) -> Array:
        """A guide that was accumulated with the light of the last frame, for a denoiser behind this one: a new array of three components.

        name: mean_albedo or mean_normal of the preset accumulated.
        """
        out = np.empty((*self._denoiser.guide_size(), 3), np.float32)
        self._denoiser.copy_guide(name, out)
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
        """Height and width of frames."""
        return self._size

    @property
    def output_size(self) -> tuple[int, int]:
        """Height and width of pictures."""
        return self._output_size

    @property
    def reads(self) -> dict[str, int]:
        """The channels that a frame must have, and how many components each has. docs/channels.md says what they hold."""
        return {name: components for name, (components, is_optional) in self._channels.items() if not is_optional}

    @property
    def may_read(self) -> dict[str, int]:
        """The channels that a frame may have too."""
        return {name: components for name, (components, is_optional) in self._channels.items() if is_optional}

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

    def _given(
        self, frame: Mapping[str, Any], prefix: str, names: Iterable[str]
    ) -> tuple[dict[str, Union[Array, OnDevice]], Optional[Array], Optional[int], float, dict[str, tuple[int, int, int, int, int]], tuple[int, int]]:
        """What the library takes of a frame. `prefix` stands before what errors name."""
        number, shutter = frame.get("number"), frame.get("shutter")
        samples = frame.get("samples") or {}
        for name in samples:
            if name not in frame:
                raise Error(f"{prefix}samples: there is no channel '{name}'; give it, or leave its samples out")
        arrays = {name: lent(f"{prefix}channel '{name}'", frame[name], self._stream).array for name in names if name in frame}
        # Depth is there for every pixel.
        varies = self._resolves and "depth" in arrays and arrays["depth"].ndim in (2, 3)
        return (
            arrays,
            self._seen_by(prefix, frame.get("camera"), frame.get("jitter")),
            None if number is None else _whole(f"{prefix}number", number, 64),
            0.5 if shutter is None else float(shutter),
            {name: _block(f"{prefix}samples of channel '{name}'", each) for name, each in samples.items()},
            (int(arrays["depth"].shape[0]), int(arrays["depth"].shape[1])) if varies else self._size,
        )

    def _seen_by(self, prefix: str, camera: Optional[Camera], jitter: Optional[Sequence[float]]) -> Optional[Array]:
        if jitter is None:
            return _packed(f"{prefix}camera", camera)
        if camera is not None:
            raise Error(f"{prefix}jitter: there is a camera too; let quell.Camera say the jitter, or leave the camera out")
        if not self._takes_jitter:
            raise Error(f"{prefix}jitter: this denoiser makes no use of it; make it by Denoiser(..., stages=['resolve']), or leave it out")
        return np.concatenate([np.zeros(32, np.float32), _numbers(f"{prefix}jitter", jitter, (2,))])

    def _output_shape(self) -> tuple[int, ...]:
        components = self._denoiser.output_components()
        return self._output_size if components == 1 else (*self._output_size, components)


def presets(device: str = "cpu") -> list[str]:
    """Names of presets: docs/presets.md says what they are for. Of "cuda": none where quell was built without CUDA."""
    return _library.presets(_device(device))


def stages(device: str = "cpu") -> list[str]:
    """Names of stages, for Denoiser(..., stages=[...]): docs/library.md says what they do."""
    return _library.stages(_device(device))


def instruction_sets() -> list[str]:
    """Names of instruction sets that quell is compiled for, the best first."""
    return _library.instruction_sets()


def _block(what: str, samples: Samples) -> tuple[int, int, int, int, int]:
    if not isinstance(samples, Samples):
        raise Error(f"{what}: it is a {type(samples).__name__}; give quell.Samples(columns, rows)")
    try:
        x, y = samples.phase
    except (TypeError, ValueError):
        raise Error(f"{what}: a phase of {samples.phase!r}; give two whole numbers, x and y") from None
    whole = [_whole(what, each, 32) for each in (samples.columns, samples.rows, x, y)]
    return whole[0], whole[1], int(samples.staggered), whole[2], whole[3]


def _packed(what: str, camera: Optional[Camera]) -> Optional[Array]:
    if camera is None or isinstance(camera, Camera):
        return None if camera is None else camera._packed
    raise Error(f"{what}: it is a {type(camera).__name__}; give a quell.Camera")


# Each member's words, in the order of quell_motion's numbers.
_MOTION = {
    "points": ("to_previous", "from_previous"),
    "unit": ("pixel", "uv", "ndc"),
    "y": ("down", "up"),
    "jitter": ("left_out", "left_in"),
}


def _motion(convention: Mapping[str, str]) -> tuple[int, int, int, int]:
    for name, word in convention.items():
        if word not in _MOTION.get(name, ()):
            raise Error(f"motion: {{{name!r}: {word!r}}}; give some of: " + "; ".join(f"{n}: {', '.join(w)}" for n, w in _MOTION.items()))
    points, unit, y, jitter = (words.index(convention.get(name, words[0])) for name, words in _MOTION.items())
    return points, unit, y, jitter


# In the order of quell_device's numbers.
_DEVICES = ("cpu", "cuda")


def _device(name: str) -> int:
    if name not in _DEVICES:
        raise Error(f"device: {name!r}; give one of: {', '.join(_DEVICES)}")
    return _DEVICES.index(name)


def _names(what: str, names: Sequence[str]) -> str:
    if isinstance(names, str) or any("," in name for name in names):
        raise Error(f"{what}: {names!r}; give names as a tuple or list, such as ['evidence', 'light']")
    return ",".join(names)


def _height_and_width(what: str, size: Sequence[int]) -> tuple[int, int]:
    if len(size) != 2:
        raise Error(f"{what}: it is {tuple(size)}; give (height, width)")
    return _whole(what, size[0], 32), _whole(what, size[1], 32)


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

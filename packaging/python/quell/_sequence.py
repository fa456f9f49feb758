from typing import Any, Callable, Iterable, Iterator, Mapping, Optional, Sized

from ._arrays import Array, lent
from ._denoiser import Denoiser
from ._errors import Error


def denoise(
    frames: Iterable[Mapping[str, Any]],
    preset: str = "final-frame",
    *,
    progress: Optional[Callable[[int, Optional[int]], None]] = None,
    threads: int = 0,
    instruction_set: Optional[str] = None,
) -> Iterator[Array]:
    """Denoises a sequence and yields a new array for each frame.

    Each frame is a dict as Denoiser takes it. Frames are taken from `frames` as they are needed, and let go of when they are done with.
    After each, progress(done, total) is called; the total is None where `frames` has no length. Ctrl-C and exceptions of `progress` end
    it between two frames.
    """
    total = len(frames) if isinstance(frames, Sized) else None
    denoiser: Optional[Denoiser] = None
    for done, frame in enumerate(frames, 1):
        if denoiser is None:
            denoiser = Denoiser(preset, _size_of(frame), threads=threads, instruction_set=instruction_set)
        yield denoiser(frame)
        if progress is not None:
            progress(done, total)


def _size_of(frame: Mapping[str, Any]) -> Any:
    """That of the first channel."""
    for name, value in frame.items():
        if name not in ("camera", "number", "shutter"):
            array = lent(f"channel '{name}'", value).array
            if array.ndim in (2, 3):
                return array.shape[:2]
            raise Error(f"channel '{name}': its shape is {array.shape}; give (height, width, components)")
    raise Error("frames: the first has no channels; give dicts such as {'radiance': array, 'albedo': array}")

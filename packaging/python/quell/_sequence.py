from collections import deque
from itertools import count, islice
from typing import Any, Callable, Iterable, Iterator, Mapping, Optional, Sequence, Sized

from ._arrays import Array, lent
from ._denoiser import Denoiser, _names
from ._errors import Error


def denoise(
    frames: Iterable[Mapping[str, Any]],
    preset: str = "final-frame",
    *,
    later_frames: int = 2,
    progress: Optional[Callable[[int, Optional[int]], None]] = None,
    threads: int = 0,
    instruction_set: Optional[str] = None,
    stages: Sequence[str] = (),
    samples_per_pixel: int = 0,
    alpha: bool = False,
    motion: Mapping[str, str] = {},
    output_size: Optional[Sequence[int]] = None,
) -> Iterator[Array]:
    """Denoises a sequence and yields a new array for each frame.

    Each frame is a dict as Denoiser takes it, and is denoised with those before it and `later_frames` after it; 0 for presets that make no
    use of later frames. Frames are taken from `frames` as they are needed, and let go of when they are done with: only 1 + `later_frames`
    are held. When a picture has been used, progress(done, total) is called; the total is None where `frames` has no length. Ctrl-C and
    exceptions of `progress` end it between two frames. stages: as Denoiser takes them; "two-sided" is added where `later_frames` is not 0.
    """
    if later_frames < 0:
        raise Error(f"later_frames: {later_frames}; give 0 or more")
    total = len(frames) if isinstance(frames, Sized) else None
    coming = iter(frames)
    held = deque(islice(coming, 1 + later_frames))
    if not held:
        return
    options: dict[str, Any] = {"threads": threads, "instruction_set": instruction_set, "alpha": alpha, "motion": motion}
    _names("stages", stages)
    added = ["two-sided"] if later_frames > 0 and "two-sided" not in stages else []
    try:
        denoiser = Denoiser(preset, _size_of(held[0]), stages=[*stages, *added], output_size=output_size, samples_per_pixel=samples_per_pixel, **options)
    except Error as error:
        if added and "two-sided" in str(error):
            raise Error(f"later_frames: {later_frames}, of which '{preset}' makes no use with these stages; give 0", error.status) from error
        raise
    for done in count(1):
        yield denoiser(held[0], later=islice(held, 1, None))
        held.popleft()
        held.extend(islice(coming, 1))
        if progress is not None:
            progress(done, total)
        if not held:
            return


def _size_of(frame: Mapping[str, Any]) -> Any:
    """That of the first channel."""
    for name, value in frame.items():
        if name not in ("camera", "jitter", "number", "shutter", "samples") and name not in (frame.get("samples") or {}):
            array = lent(f"channel '{name}'", value).array
            if array.ndim in (2, 3):
                return array.shape[:2]
            raise Error(f"channel '{name}': its shape is {array.shape}; give (height, width, components)")
    raise Error("frames: the first has no channels; give dicts such as {'radiance': array, 'albedo': array}")

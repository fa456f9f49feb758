from collections import deque
from itertools import count, islice
from typing import Any, Callable, Iterable, Iterator, Mapping, Optional, Sequence, Sized

from ._arrays import Array, lent
from ._denoiser import Denoiser
from ._errors import Error


def denoise(
    frames: Iterable[Mapping[str, Any]],
    preset: str = "final-frame",
    *,
    later_frames: int = 2,
    progress: Optional[Callable[[int, Optional[int]], None]] = None,
    threads: int = 0,
    instruction_set: Optional[str] = None,
    alpha: bool = False,
    motion: Mapping[str, str] = {},
    anti_alias: bool = False,
    output_size: Optional[Sequence[int]] = None,
    steady_guides: Sequence[str] = (),
    choose_history: int = False,
    give_back: int = False,
) -> Iterator[Array]:
    """Denoises a sequence and yields a new array for each frame.

    Each frame is a dict as Denoiser takes it, and is denoised with those before it and `later_frames` after it; 0 for presets that make no
    use of later frames. Frames are taken from `frames` as they are needed, and let go of when they are done with: only 1 + `later_frames`
    are held. When a picture has been used, progress(done, total) is called; the total is None where `frames` has no length. Ctrl-C and
    exceptions of `progress` end it between two frames. steady_guides: as Denoiser takes it, where `later_frames` is 0.
    choose_history, give_back: as Denoiser takes them.
    """
    if later_frames < 0:
        raise Error(f"later_frames: {later_frames}; give 0 or more")
    if later_frames > 0 and steady_guides:
        raise Error(f"steady_guides: guides are accumulated of frames that are past, and later_frames is {later_frames}; give it 0")
    total = len(frames) if isinstance(frames, Sized) else None
    coming = iter(frames)
    held = deque(islice(coming, 1 + later_frames))
    if not held:
        return
    options: dict[str, Any] = {"threads": threads, "instruction_set": instruction_set, "alpha": alpha, "motion": motion}
    options.update(anti_alias=anti_alias, output_size=output_size, steady_guides=steady_guides, choose_history=choose_history, give_back=give_back)
    try:
        denoiser = Denoiser(preset, _size_of(held[0]), two_sided=later_frames > 0, **options)
    except Error as error:
        if "two_sided" in str(error):
            raise Error(f"later_frames: {later_frames}, of which '{preset}' makes no use; give 0", error.status) from error
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

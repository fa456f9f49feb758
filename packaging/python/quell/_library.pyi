from typing import Optional

from ._arrays import Array

version: str

def presets() -> list[str]: ...
def instruction_sets() -> list[str]: ...

class Denoiser:
    def __init__(
        self,
        preset: str,
        width: int,
        height: int,
        threads: int,
        instruction_set: Optional[str],
        two_sided: bool,
        alpha: bool,
        motion: tuple[int, int, int, int],
        anti_alias: bool,
        output_size: tuple[int, int],
        steady_guides: int,
        /,
    ) -> None: ...
    def run(
        self,
        frames: list[
            tuple[dict[str, Array], Optional[Array], Optional[int], float, dict[str, tuple[int, int, int, int, int]], tuple[int, int]]
        ],
        out: Array,
        /,
    ) -> None: ...
    def forget(self) -> None: ...
    def copy_guide(self, name: str, out: Array, /) -> None: ...
    def statistics(self) -> tuple[int, int, int, int, int]: ...
    def channels(self) -> list[tuple[str, int, bool]]: ...
    def output_components(self) -> int: ...
    def needs_camera(self) -> bool: ...
    def instruction_set(self) -> str: ...
    def plan(self) -> str: ...

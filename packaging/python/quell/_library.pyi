from typing import Any, Optional, Union

from ._arrays import Array, OnDevice

version: str

def presets(device: int, /) -> list[str]: ...
def instruction_sets() -> list[str]: ...
def tensor_in(capsule: Any, /) -> tuple[int, tuple[int, ...], Optional[tuple[int, ...]], str]: ...

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
        choose_history: int,
        give_back: int,
        device: int,
        stream: int,
        /,
    ) -> None: ...
    def run(
        self,
        frames: list[
            tuple[dict[str, Union[Array, OnDevice]], Optional[Array], Optional[int], float, dict[str, tuple[int, int, int, int, int]], tuple[int, int]]
        ],
        out: Union[Array, OnDevice],
        /,
    ) -> None: ...
    def forget(self) -> None: ...
    def copy_guide(self, name: str, out: Array, /) -> None: ...
    def guide_size(self) -> tuple[int, int]: ...
    def statistics(self) -> tuple[int, int, int, int, int]: ...
    def channels(self) -> list[tuple[str, int, bool]]: ...
    def output_components(self) -> int: ...
    def needs_camera(self) -> bool: ...
    def instruction_set(self) -> str: ...
    def plan(self) -> str: ...

from typing import Optional, Sequence

def presets() -> list[str]: ...
def languages() -> list[str]: ...
def create(
    preset: str,
    language: str,
    repair_guides: bool,
    fill_holes: int,
    counts: bool,
    most_slots: int,
    half_precision: bool,
    texel_loads: bool,
    workgroup: tuple[int, int],
    samples_per_pixel: int,
    /,
) -> tuple[str, dict[str, str]]: ...
def block(
    width: int,
    height: int,
    number: int,
    needs_camera: bool,
    shutter: float,
    shutter_then: float,
    camera: Optional[Sequence[float]],
    camera_then: Optional[Sequence[float]],
    /,
) -> bytes: ...

from enum import IntEnum
from typing import Any


class Status(IntEnum):
    """What is wrong, as quell.h has it."""

    INVALID_ARGUMENT = 1
    UNKNOWN_PRESET = 2
    NOT_SUPPORTED = 3
    NO_MEMORY = 4
    BUSY = 5
    FAILED = 6


class Error(ValueError):
    """What quell raises: a sentence that says what is wrong, what was found and what to do. Where memory runs out it is a MemoryError."""

    status: Status

    def __init__(self, sentence: str, status: int = Status.INVALID_ARGUMENT) -> None:
        super().__init__(sentence)
        self.status = Status(status)

    def __reduce__(self) -> tuple[Any, ...]:  # for processes that send it to others
        return type(self), (str(self), int(self.status))

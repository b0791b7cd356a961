"""A decorator for data classes with very many instances, and the text of long values in a repr."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar, dataclass_transform

T = TypeVar("T")


@dataclass_transform(frozen_default=True)
def record(*, slots: bool = False, eq: bool = True) -> Callable[[type[T]], type[T]]:
    """Return a decorator for data classes that type checkers treat as frozen, with a hash of their fields.

    A frozen data class assigns each field through `object.__setattr__`, which makes creation three times slower. At run
    time nothing prevents an assignment.
    """

    def decorated(cls: type[T]) -> type[T]:
        hashed = eq and "__hash__" not in vars(cls)
        return dataclass(cls, slots=slots, eq=eq, unsafe_hash=hashed)

    return decorated


def abridged(text: str, width: int = 60) -> str:
    """Return a text on one line, cut to at most `width` characters with an ellipsis at the end."""
    line = " ".join(text.split())
    return line if len(line) <= width else f"{line[: width - 1]}…"


def counted(number: int, noun: str, plural: str = "") -> str:
    """Return a number with its noun in the singular or plural, such as ``1 body`` or ``2 bodies``."""
    return f"{number} {noun if number == 1 else plural or f'{noun}s'}"

"""Faults of settings in words, which never repeat what was given: it may be a key."""

from collections.abc import Callable
from typing import TypeVar

from pydantic import ValidationError

from sim2reason.errors import Sim2ReasonError

__all__ = ["first_fault", "held_to"]

T = TypeVar("T")


def held_to(check: Callable[[T], object], value: T) -> T:
    """The value, for a validator; what `check` raises of ours is its ValueError, and so is told with its place."""
    try:
        check(value)
    except Sim2ReasonError as error:
        raise ValueError(str(error)) from None
    return value


def first_fault(error: ValidationError) -> str:
    """The first fault, in one line: where, and what is wrong with it."""
    detail = error.errors(include_url=False, include_input=False)[0]
    where = ".".join(map(str, detail["loc"])) or "all of it"
    said = {"extra_forbidden": "no such setting", "missing": "is missing"}.get(detail["type"], detail["msg"])
    return f"{where}: {said.removeprefix('Value error, ')}"

"""Faults of settings in words, which never repeat what was given: it may be a key."""

from pydantic import ValidationError

__all__ = ["first_fault"]


def first_fault(error: ValidationError) -> str:
    """The first fault, in one line: where, and what is wrong with it."""
    detail = error.errors(include_url=False, include_input=False)[0]
    where = ".".join(map(str, detail["loc"])) or "all of it"
    said = {"extra_forbidden": "no such setting", "missing": "is missing"}.get(detail["type"], detail["msg"])
    return f"{where}: {said.removeprefix('Value error, ')}"

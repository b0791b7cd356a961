"""The call of math-verify, in a separate module for a worker process."""

import logging
from importlib import import_module
from typing import Any

__all__ = ["verified"]


def verified(answer: str, said: str) -> tuple[bool, bool, str]:
    """Return whether `said` parses, whether it equals `answer`, and its parsed form; both contain a box."""
    library: Any = import_module("math_verify")
    logging.getLogger("math_verify").setLevel(logging.ERROR)  # it warns of the missing limits at each call
    limit = {"parsing_timeout": None}  # its own limits use signals; this process is killed instead
    right, found = library.parse(answer, **limit), library.parse(said, **limit)
    return bool(found), bool(found and library.verify(right, found, timeout_seconds=None)), str(found[:1])[:200]

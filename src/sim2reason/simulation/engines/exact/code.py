"""Straight-line code that the engine writes for itself and runs.

It is made of names that this package invents and of numbers, never of anything that a scene, a file or a person says;
so there is nothing in it that could be foreign.
"""

from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any

KEPT = 512  # pieces of code; a process that meets more shapes of mechanisms than that writes some of them again


def compiled(parameters: str, lines: Sequence[str], constants: str = "") -> Callable[..., Any]:
    """Return a function of `parameters` with the given lines; with `constants`, a function of those that gives it."""
    body = "\n".join(f"        {line}" for line in lines)
    return _made(f"def make({constants}):\n    def code({parameters}):\n{body}\n    return code\n", bool(constants))


@lru_cache(maxsize=KEPT)
def _made(text: str, curried: bool) -> Callable[..., Any]:  # noqa: FBT001 - a key of the cache
    space: dict[str, Any] = {}
    exec(compile(text, "<straight-line code>", "exec"), space)  # noqa: S102 - see above: all of it is our own
    made: Callable[..., Any] = space["make"]
    return made if curried else made()

"""Times numbered in the order in which a text introduces them."""

import re

from sim2reason.solutions.multipart.renaming import renamed
from sim2reason.solutions.solution import Solution

TIME = re.compile(r"t(?:_(?:(\d)|\{(\d+)\}))?")  # with its number, if it has one


def times_in_sequence(solution: Solution) -> Solution:
    """Return a solution whose times have the same names as before, in the order of the steps that give them."""
    given = [name for step in solution.steps for name in step.gives if TIME.fullmatch(name)]
    names = [name for name in dict.fromkeys(given) if name not in solution.stated]
    exchanged = dict(zip(names, sorted(names, key=_number), strict=True))
    return renamed(solution, exchanged)


def _number(name: str) -> int:
    match = TIME.fullmatch(name)
    assert match is not None
    return int(match[1] or match[2] or 0)

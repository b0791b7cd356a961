"""What is watched while a mode lasts: one list of margins, positive until something happens."""

from typing import NamedTuple


class Margin(NamedTuple):
    """What is left until something happens.

    kind: ``spare`` of an idle row · ``force`` of a row that acts · ``normal`` force of a contact · ``slip`` speed of
    one that slides · ``grip`` of one that sticks, on a side · ``gap`` of a meeting · ``reach`` of a straight piece of
    line · ``limit`` of a coordinate · ``burn`` time of an engine · ``border`` of a region, of a force, on a side ·
    ``brace``: all margins of forces that the motion leaves open.
    """

    kind: str
    number: int  # of the row, contact, rough contact, meeting, run, limit, engine, force or half spring
    side: int = 0  # to which a contact begins to slip; which border of a region


class StopReason(NamedTuple):
    """How long a mode lasted, and what is due then; nothing if it lasted as long as was asked for."""

    elapsed: float
    due: tuple[Margin, ...]


ENDS = frozenset({"reach", "limit", "normal"})
"""What ends the motion that is described."""

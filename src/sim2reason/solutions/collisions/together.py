"""Intervals in which both bodies of a possible collision move freely, and which collision ends each."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf

from sim2reason.dsl.mechanism import Meeting
from sim2reason.solutions.collisions.impacts import Impacts
from sim2reason.solutions.collisions.legs import Impact

SAME = 1e-9  # relative: a collision that comes with the time itself


@dataclass(frozen=True)
class Together:
    """An interval in which both bodies of a possible collision move freely; `legs` are their flights, by body."""

    meeting: int
    legs: dict[str, int]
    begins: Impact | None  # None: at the start
    ends: Impact | None  # None: when the motion that counts ends

    @property
    def meets(self) -> bool:
        """Return whether the two bodies collide at the end of the interval."""
        return self.ends is not None and self.ends.meeting == self.meeting


class Intervals:
    """The intervals, pair by pair, of a motion that counts until a time, in s, which may be infinite."""

    def __init__(self, flights: Impacts, time: float) -> None:
        """Take the flights of all bodies, and the time at which the motion ends, in s."""
        self._flights, self._time = flights, time
        self.early = [impact for impact in flights.impacts if impact.time < time * (1.0 - SAME)]

    def __iter__(self) -> Iterator[Together]:
        """Yield the intervals of each pair of bodies in turn."""
        for number, meeting in enumerate(self._flights.mechanism.meetings):
            changes = [held for held in self.early if {*held.bodies} & {*meeting.names}]
            for begins, ends in zip([None, *changes], [*changes, None], strict=True):
                legs = {body: self._number(body, begins) for body in meeting.names}
                yield Together(number, legs, begins, ends if ends is not None else self._last(meeting))

    @property
    def at_end(self) -> list[Impact]:
        """The collisions at the time at which the motion ends; an empty list if it has no end."""
        if self._time == inf:
            return []
        return [held for held in self._flights.impacts if abs(held.time - self._time) <= SAME * self._time]

    def following(self, begins: Impact | None) -> Impact | None:
        """Return the next collision that counts after one, or the first one."""
        number = 0 if begins is None else begins.number + 1
        return next((held for held in (*self.early, *self.at_end) if held.number >= number), None)

    def is_late(self, held: Together) -> bool:
        """Return whether the two bodies of an interval collide at its end, but others collide before."""
        return held.meets and held.ends is not self.following(held.begins)

    def _last(self, meeting: Meeting) -> Impact | None:
        """Return the collision that ends the motion if both bodies belong to the given meeting; else None."""
        return next((held for held in self.at_end if {*held.bodies} & {*meeting.names}), None)

    def _number(self, body: str, begins: Impact | None) -> int:
        if begins is None:
            return 0
        return self._flights.count(body, begins) + (body in begins.bodies)

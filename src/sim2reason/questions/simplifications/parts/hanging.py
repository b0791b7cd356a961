"""What hangs from which strings."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import hypot

from sim2reason.scenes.dsl.frames import Frames, start
from sim2reason.scenes.dsl.mechanism import Inextensible, Line, Mechanism, RigidBody
from sim2reason.scenes.dsl.vectors import minus

UPRIGHT = 1.0 - 1e-9  # cosine of the angle between what is upright and the vertical
PLAIN = Inextensible()


@dataclass(frozen=True, slots=True)
class HangingLoad:
    """A body that strings hold from above, with what hangs from it in turn."""

    body: str
    strings: tuple[str, ...]  # those that hold it, part by part
    runs: int  # of them that run up from it
    mass: float  # kg, of all of it


def hanging(mechanism: Mechanism) -> dict[str, HangingLoad]:
    """By name, what can only move straight up and down, and has strings to hold it and nothing else."""
    holding = _Holding(mechanism)
    found = ((body.name, holding.hanging(body.name)) for body in mechanism.bodies)
    return {name: held for name, held in found if held is not None}


def movable_pulleys(mechanism: Mechanism) -> tuple[str, ...]:
    """Return what has no mass but its wheel's, and moves up and down with a string that passes it."""
    passed = {mechanism.site[site].body for line in mechanism.lines for site in line.through[1:-1]}
    turned = {wheel.coordinate for line in mechanism.lines for wheel in line.wheels}
    passed |= {coordinate.body for coordinate in mechanism.coordinates if coordinate.name in turned}
    movable = {carried(mechanism, name) for name in passed}
    return tuple(body.name for body in mechanism.bodies if body.name in movable and not body.mass and _rises(body))


def carried(mechanism: Mechanism, name: str | None) -> str | None:
    """Return the body that slides, of a wheel on it; None of what is fixed."""
    while name is not None and not any(c.kind == "slide" for c in mechanism.body[name].coordinates):
        name = mechanism.body[name].parent
    return name


def _rises(body: RigidBody) -> bool:
    """Return whether it moves straight up and down in the room."""
    if body.parent is not None or len(body.coordinates) != 1:
        return False
    (way,) = body.coordinates
    return way.kind == "slide" and abs(way.axis[2]) > UPRIGHT


class _Holding:
    """Follows strings down from what they hold."""

    def __init__(self, mechanism: Mechanism) -> None:
        self._mechanism = mechanism
        self._runs = list(_runs(mechanism, start(mechanism)))

    def hanging(self, name: str, seen: frozenset[str] = frozenset()) -> HangingLoad | None:
        """Return a body with what hangs from it."""
        mechanism = self._mechanism
        body = mechanism.body[name]
        if name in seen or name in mechanism.contacts or not _rises(body):
            return None
        above = [line for line, low, _ in self._runs if low == name]
        if not above or any(line.law != PLAIN for line in above) or len({line.whole for line in above}) > 1:
            return None
        mass = body.mass + sum(other.mass for other in mechanism.bodies if other.parent == name)
        for low in (low for _, low, high in self._runs if high == name):
            held = self.hanging(low, seen | {name}) if low is not None else None
            if held is None:
                return None
            mass += held.mass
        return HangingLoad(name, tuple(dict.fromkeys(line.name for line in above)), len(above), mass)


def _runs(mechanism: Mechanism, frames: Frames) -> Iterator[tuple[Line, str | None, str | None]]:
    """Every straight piece of a line with what is at its lower and its upper end, both ways if it is not upright."""
    for line in mechanism.lines:
        for one, other in pairwise(line.through):
            ends = [carried(mechanism, mechanism.site[site].body) for site in (one, other)]
            x, y, z = (float(part) for part in minus(frames.site(other).place, frames.site(one).place))
            length = hypot(x, y, z)
            if ends[0] == ends[1] or not length:
                continue
            low, high = ends if z > 0.0 else ends[::-1]
            yield line, low, high
            if abs(z) < UPRIGHT * length:
                yield line, high, low

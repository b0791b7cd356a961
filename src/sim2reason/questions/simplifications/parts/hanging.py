"""Bodies that hang on strings, and movable pulleys."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import hypot

from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import Inextensible, Line, Mechanism, RigidBody
from sim2reason.scenes.dsl.vectors import minus

UPRIGHT = 1.0 - 1e-9  # cosine of the largest angle between a vertical string and the vertical
PLAIN = Inextensible()


@dataclass(frozen=True, slots=True)
class HangingLoad:
    """A body held by strings from above, with the loads that hang from it."""

    body: str
    strings: tuple[str, ...]  # those that hold it, part by part
    runs: int  # of them that run up from it
    mass: float  # kg, of all of it


def hanging(mechanism: Mechanism) -> dict[str, HangingLoad]:
    """Return the bodies that can only move vertically and are held by strings alone, with their loads, by name."""
    holding = _Holding(mechanism)
    found = ((body.name, holding.hanging(body.name)) for body in mechanism.bodies)
    return {name: held for name, held in found if held is not None}


def movable_pulleys(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the names of the massless bodies, apart from a wheel, that move vertically with a string around them."""
    passed = {mechanism.site[site].body for line in mechanism.lines for site in line.through[1:-1]}
    turned = {wheel.coordinate for line in mechanism.lines for wheel in line.wheels}
    passed |= {coordinate.body for coordinate in mechanism.coordinates if coordinate.name in turned}
    movable = {carried(mechanism, name) for name in passed}
    return tuple(body.name for body in mechanism.bodies if body.name in movable and not body.mass and _rises(body))


def carried(mechanism: Mechanism, name: str | None) -> str | None:
    """Return the sliding body that a body is or is mounted on, as a wheel is; None for a fixed point."""
    while name is not None and not any(c.kind == "slide" for c in mechanism.body[name].coordinates):
        name = mechanism.body[name].parent
    return name


def _rises(body: RigidBody) -> bool:
    """Return whether the body moves vertically in the world frame."""
    if body.parent is not None or len(body.coordinates) != 1:
        return False
    (way,) = body.coordinates
    return way.kind == "slide" and abs(way.axis[2]) > UPRIGHT


class _Holding:
    """A search for the loads that hang from a body, which follows strings from the body downwards."""

    def __init__(self, mechanism: Mechanism) -> None:
        self._mechanism = mechanism
        self._runs = list(_runs(mechanism, initial_frames(mechanism)))

    def hanging(self, name: str, seen: frozenset[str] = frozenset()) -> HangingLoad | None:
        """Return a body with the loads that hang from it; None if it is not held by strings alone."""
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
    """Yield straight pieces of lines with the bodies at the lower and upper end; in both orders if not vertical."""
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

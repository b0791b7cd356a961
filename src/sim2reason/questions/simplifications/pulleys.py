"""Misconceptions about pulleys and strings, and the bodies that hang on strings."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from math import hypot

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, FixedBody, misconception
from sim2reason.questions.simplifications.events import query_time
from sim2reason.questions.simplifications.inertia import string_wheels
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import ConstantTension, Inextensible, Line, Mechanism, Rigid, RigidBody
from sim2reason.scenes.dsl.structure import RESIDUAL_MASS_RATIO, replace_bodies, replace_lines
from sim2reason.scenes.dsl.vectors import subtract_triples

VERTICAL_COSINE = 1.0 - 1e-9  # cosine of the largest angle between a vertical string and the vertical
PLAIN_STRING = Inextensible()


@dataclass(frozen=True, slots=True)
class HangingLoad:
    """A body held by strings from above, with the loads that hang from it."""

    body: str
    strings: tuple[str, ...]  # those that hold it, part by part
    runs: int  # of them that run up from it
    mass: float  # kg, of all of it


def find_hanging_loads(mechanism: Mechanism) -> dict[str, HangingLoad]:
    """Return the bodies that can only move vertically and are held by strings alone, with their loads, by name."""
    holding = _Holding(mechanism)
    loads = ((body.name, holding.hanging(body.name)) for body in mechanism.bodies)
    return {name: load for name, load in loads if load is not None}


def movable_pulleys(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the names of the massless bodies, apart from a wheel, that move vertically with a string around them."""
    passed = {mechanism.site[site].body for line in mechanism.lines for site in line.through[1:-1]}
    turned = {wheel.coordinate for line in mechanism.lines for wheel in line.wheels}
    passed |= {coordinate.body for coordinate in mechanism.coordinates if coordinate.name in turned}
    movable = {find_carrier(mechanism, name) for name in passed}
    return tuple(body.name for body in mechanism.bodies if body.name in movable and not body.mass and _rises(body))


def find_carrier(mechanism: Mechanism, name: str | None) -> str | None:
    """Return the sliding body that a body is or is mounted on, as a wheel is; None for a fixed point."""
    while name is not None and not any(c.kind == "slide" for c in mechanism.body[name].coordinates):
        name = mechanism.body[name].parent
    return name


def _rises(body: RigidBody) -> bool:
    """Return whether the body moves vertically in the world frame."""
    if body.parent is not None or len(body.coordinates) != 1:
        return False
    (coordinate,) = body.coordinates
    return coordinate.kind == "slide" and abs(coordinate.axis[2]) > VERTICAL_COSINE


class _Holding:
    """A search for the loads that hang from a body, which follows strings from the body downwards."""

    def __init__(self, mechanism: Mechanism) -> None:
        self._mechanism = mechanism
        self._runs = list(_straight_runs(mechanism, initial_frames(mechanism)))

    def hanging(self, name: str, seen: frozenset[str] = frozenset()) -> HangingLoad | None:
        """Return a body with the loads that hang from it; None if it is not held by strings alone."""
        mechanism = self._mechanism
        body = mechanism.body[name]
        if name in seen or name in mechanism.contacts or not _rises(body):
            return None
        above = [line for line, low, _ in self._runs if low == name]
        if not above or any(line.law != PLAIN_STRING for line in above) or len({line.whole for line in above}) > 1:
            return None
        mass = body.mass + sum(other.mass for other in mechanism.bodies if other.parent == name)
        for low in (low for _, low, high in self._runs if high == name):
            load = self.hanging(low, seen | {name}) if low is not None else None
            if load is None:
                return None
            mass += load.mass
        return HangingLoad(name, tuple(dict.fromkeys(line.name for line in above)), len(above), mass)


def _straight_runs(mechanism: Mechanism, frames: Frames) -> Iterator[tuple[Line, str | None, str | None]]:
    """Yield straight pieces of lines with the bodies at the lower and upper end; in both orders if not vertical."""
    for line in mechanism.lines:
        for one, other in pairwise(line.through):
            ends = [find_carrier(mechanism, mechanism.site[site].body) for site in (one, other)]
            x, y, z = (float(part) for part in subtract_triples(frames.site(other).place, frames.site(one).place))
            length = hypot(x, y, z)
            if ends[0] == ends[1] or not length:
                continue
            low, high = ends if z > 0.0 else ends[::-1]
            yield line, low, high
            if abs(z) < VERTICAL_COSINE * length:
                yield line, high, low


@misconception
class FixedMovablePulley(FixedBody):
    """The acceleration relative to a movable pulley is taken for that relative to the ground."""

    name = "fixed movable pulley"
    reason = "a movable pulley is taken as fixed"
    holds = True
    sound_if_same = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the names of all movable pulleys."""
        del query
        return movable_pulleys(study.mechanism)


@misconception
class MasslessPulley(ChangedMechanism):
    """The inertia of all pulleys is ignored."""

    name = "massless pulley"
    reason = "pulleys are taken as light"
    common = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return all pulleys as one subject if they have mass."""
        del query
        return [""] if string_wheels(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with negligible mass and inertia of pulleys."""
        del subject
        return replace_bodies(mechanism, string_wheels(mechanism), _light)


def _light(body: RigidBody) -> RigidBody:
    inertia = tuple(RESIDUAL_MASS_RATIO * part for part in body.inertia)
    return replace(body, mass=RESIDUAL_MASS_RATIO * body.mass, inertia=inertia)


@misconception
class PulleyAsStringEnd(ChangedMechanism):
    """A pulley in the bight of a string with a fixed end is assumed to move as far as the string is drawn."""

    name = "pulley as string end"
    reason = "a movable pulley is taken to move as far as the end of its string, without the factor 2"
    sound_if_same = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the names of the strings that run from a movable pulley to a fixed end."""
        del query
        return dict.fromkeys(line.whole for line in study.mechanism.strings if _ends_beyond(study.mechanism, line))

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with the string tied to the pulley, as if one piece drew it up instead of two."""
        lines = (line if line.whole != subject else _tied(mechanism, line) for line in mechanism.lines)
        return replace(mechanism, lines=tuple(lines))


def _ends_beyond(mechanism: Mechanism, line: Line) -> str | None:
    """Return the name of the movable pulley beyond which a line ends at a fixed point; None if there is none."""
    pulleys = movable_pulleys(mechanism)
    for end, before in (line.through[:2], line.through[:-3:-1]):
        name = find_carrier(mechanism, mechanism.site[before].body)
        if mechanism.site[end].body is None and name in pulleys:
            return name
    return None


def _tied(mechanism: Mechanism, line: Line) -> Line:
    """Return the part of a string up to the movable pulley before its fixed end; a part beyond exerts no force."""
    parts = (part for part in mechanism.lines if part.whole == line.whole)
    pulley = next(name for part in parts if (name := _ends_beyond(mechanism, part)))
    turned = {c.name for c in mechanism.coordinates if find_carrier(mechanism, c.body) == pulley}
    free = replace(line, wheels=tuple(wheel for wheel in line.wheels if wheel.coordinate not in turned))
    if _ends_beyond(mechanism, line) is None:
        return free
    forth = mechanism.site[line.through[-1]].body is None
    through = line.through if forth else line.through[::-1]
    first = next(n for n, site in enumerate(through) if find_carrier(mechanism, mechanism.site[site].body) == pulley)
    if not first:
        return replace(free, law=ConstantTension(0.0))
    kept = through[: first + 1]
    return replace(free, through=kept if forth else kept[::-1])


@misconception
class PulleyRotationLeftOut(ChangedMechanism):
    """The rotational inertia of a pulley is ignored; its mass is still lifted and accelerated."""

    name = "pulley rotation left out"
    reason = "the rotational inertia of {subject} is left out"
    common = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return each of several pulleys with rotational inertia; a single one only if it is movable.

        A single one with a fixed axle is covered by taking all pulleys as light.
        """
        del query
        mechanism = study.mechanism
        turning = [name for name in string_wheels(mechanism) if any(mechanism.body[name].inertia)]
        return [name for name in turning if len(turning) > 1 or find_carrier(mechanism, name) is not None]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with a negligible moment of inertia of the pulley."""
        return replace_bodies(mechanism, [subject], without_rotation)


def without_rotation(body: RigidBody) -> RigidBody:
    """Return a body of the same mass with a small moment of inertia, which keeps the equations regular."""
    xx, yy, zz, xy, xz, yz = (RESIDUAL_MASS_RATIO * part for part in body.inertia)
    return replace(body, inertia=(xx, yy, zz, xy, xz, yz))


@misconception
class PulleyRotationsLeftOut(ChangedMechanism):
    """The rotational inertia of all pulleys is ignored; the mass of movable ones is kept."""

    name = "pulley rotations left out"
    reason = "the rotational inertia of all pulleys is left out"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return all pulleys as one subject if there are several, at least one of them movable."""
        del query
        turning = string_wheels(study.mechanism)
        several = len(turning) > 1 and any(find_carrier(study.mechanism, name) is not None for name in turning)
        return [""] if several else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with negligible moments of inertia of pulleys."""
        del subject
        return replace_bodies(mechanism, string_wheels(mechanism), without_rotation)


@misconception
class StringsLeftOut(ChangedMechanism):
    """Each body is assumed to move independently, without the strings between them."""

    name = "strings left out"
    reason = "each body is taken to move as if no string held it"
    sound_if_same = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if there are strings; else none."""
        del query
        return [""] if study.mechanism.strings else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with strings without tension and, instead of massless bodies, very light ones."""
        del subject
        light = [body.name for body in mechanism.bodies if not body.mass and body.coordinates]
        mass = RESIDUAL_MASS_RATIO * sum(body.mass for body in mechanism.bodies)
        movable = replace_bodies(mechanism, light, lambda body: replace(body, mass=mass))
        strings = (line.name for line in mechanism.strings if line.circle is None)
        return replace_lines(movable, strings, lambda line: replace(line, law=ConstantTension(0.0)))


@misconception
class TautStrings(ChangedMechanism):
    """Strings are assumed to stay taut, and to push where they should go slack."""

    name = "taut strings"
    reason = "a string that goes slack is taken as taut"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a string is slack before the moment; else none."""
        state = study.trace.state
        before = state.times <= query_time(query, study)
        slack = any((state.tension[line.name][before] <= 0.0).any() for line in _plain(study.mechanism))
        return [""] if slack else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with rods in place of strings."""
        del subject
        names = [line.name for line in _plain(mechanism)]
        return replace_lines(mechanism, names, lambda line: replace(line, law=Rigid()))


def _plain(mechanism: Mechanism) -> list[Line]:
    """Return the strings that are taut at the start and not drawn in."""
    law = Inextensible()
    return [line for line in mechanism.strings if line.law == law]

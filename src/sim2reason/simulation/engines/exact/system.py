"""A mechanism as the engine sees it at an instant: numbers of a `Problem`, and how far events are away."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import inf

from sim2reason.dsl.constancy import ALIGNED, changing
from sim2reason.dsl.frames import Point, start
from sim2reason.dsl.mechanism import Line, Mechanism, Meeting, Rigid
from sim2reason.dsl.triples import Number, Triple, minus, product
from sim2reason.errors import SceneError, UnsupportedError
from sim2reason.simulation.engines.exact.assembly import Assembly, Numbers
from sim2reason.simulation.engines.exact.lengths import Phase, RowKind, RowTerms, row_kinds
from sim2reason.simulation.engines.exact.linear import Row, solve
from sim2reason.simulation.engines.exact.problem import Gradient, Grip, gradient

TOUCHING = 1e-9  # m; two lengths that differ by less are one length


@dataclass(frozen=True, slots=True)
class Limit:
    """One end of a coordinate's travel: the room left is `room` + `sign`·q."""

    coordinate: int
    name: str
    room: float
    sign: float


@dataclass(frozen=True, slots=True)
class Near:
    """How the two of a meeting stand: gap, its rate, its second derivative at q̈ = 0, and minus its gradient."""

    meeting: Meeting
    gap: float
    rate: float
    bias: float
    closing: Gradient

    @property
    def touching(self) -> bool:
        """Whether the gap is closed."""
        return self.gap <= TOUCHING

    def second(self, a: Row) -> float:
        """The second derivative of the gap, m/s²."""
        return self.bias - self.closing.rate(a)


@dataclass(slots=True)
class Instant:
    """All that forces and impulses at one instant depend on."""

    time: float
    q: Row
    v: Row
    mass: list[Row]
    lifted: list[Row]
    heave: list[Row]
    force: Row
    press: Row
    rows: tuple[Gradient, ...]
    spare: Row  # what is left until each row acts, m
    rates: Row  # at which that is used up
    targets: Row
    slips: Row  # of each rough contact, m/s
    pairs: tuple[Near, ...]
    weightless: tuple[Row, ...]  # motions that need no force at all: a basis of the null space of `mass`


class System:
    """A mechanism, checked, with what stays the same throughout a motion."""

    def __init__(self, mechanism: Mechanism) -> None:
        """Check and count everything.

        Raises:
            UnsupportedError: a rough body slides in two directions, or off the face that it rests on.
            SceneError: two bodies overlap, or two sites of a line coincide, at the start.
        """
        self.mechanism = mechanism
        self.size, self.count = len(mechanism.coordinates), len(mechanism.faces)
        self.frames = start(mechanism)
        self.grips = _grips(mechanism)
        self.guided = tuple(number for number, face in enumerate(mechanism.faces) if face.guided)
        self.limits = _limits(mechanism)
        self.starts = {line.name: sum(self._check_runs(line)) for line in mechanism.lines}
        self.changing = changing(mechanism, self.frames)
        self.massless = any(body.coordinates and body.mass == 0.0 for body in mechanism.bodies)
        for meeting in mechanism.meetings:
            self._check_apart(meeting)

    def _check_runs(self, line: Line) -> list[float]:
        """The lengths of the runs of a line at the start."""
        found: list[float] = []
        for first, last in pairwise(line.through):
            one, other = self.frames.site(first), self.frames.site(last)
            length = math.dist(one.place, other.place)
            if length <= TOUCHING and moving(one, other) and not isinstance(line.law, Rigid):
                problem = f"sites {first} and {last} coincide at the start"
                raise SceneError(line.name, problem, "leave some string between")
            found.append(length)
        return found

    def _check_apart(self, meeting: Meeting) -> None:
        places = [
            (0.0, 0.0, 0.0) if name is None else self.frames.center(name).place for name in (meeting.a, meeting.b)
        ]
        apart = minus(places[1], places[0])
        gap = math.hypot(*apart) if meeting.normal is None else product(meeting.normal, apart)
        if gap < meeting.distance - TOUCHING:
            other = "what is fixed" if meeting.a is None else meeting.b
            raise SceneError(meeting.a or meeting.b, f"it overlaps {other} at the start", "move them apart")

    @cached_property
    def runs(self) -> dict[tuple[str, str], float]:
        """The straight pieces of lines whose ends move towards or away from each other, with their lengths, m."""
        found: dict[tuple[str, str], float] = {}
        for line in self.mechanism.lines:
            if isinstance(line.law, Rigid):
                continue
            for first, last in pairwise(line.through):
                one, other = self.frames.site(first), self.frames.site(last)
                if moving(one, other):
                    found[first, last] = math.dist(one.place, other.place)
        return found

    @cached_property
    def movable(self) -> tuple[tuple[str, ...], ...]:
        """The bodies of each meeting that can move."""
        return tuple(
            tuple(name for name in meeting.names if self.frames[name].steps) for meeting in self.mechanism.meetings
        )

    @property
    def phase(self) -> Phase:
        """What is on at the start: forces whose region the body is in, engines, nothing stuck."""
        inside = tuple(
            tuple(margin > 0.0 for margin in force.region.margins(self.frames.center(force.body).place, math))
            if force.region is not None
            else ()
            for force in self.mechanism.forces
        )
        burning = tuple(burn.until > 0.0 for burn in self.mechanism.burns)
        return Phase(inside, burning, (False,) * len(self.mechanism.meetings))

    def kinds(self, phase: Phase) -> list[RowKind]:
        """What the rows are."""
        return row_kinds(self.mechanism, phase)

    def instant(self, time: float, q: Row, v: Row, phase: Phase) -> Instant:
        """The numbers of one instant; SimulationError is the caller's business where they don't exist."""
        return self.numbers(Assembly(self.mechanism, phase, (q, v, time), math))

    def numbers(self, assembly: Assembly) -> Instant:
        """The numbers of an assembly."""
        time, q, v = assembly.time, list(assembly.q), list(assembly.v)
        rows = assembly.rows(self.starts)
        mass = [_plain(row) for row in assembly.full_mass()]
        return Instant(
            time,
            q,
            v,
            mass,
            [_plain(row) for row in assembly.lifted],
            [_plain(row) for row in assembly.heave],
            _plain(assembly.force),
            _plain(assembly.press),
            tuple(self._gradient(row) for row in rows),
            [float(row.value) for row in rows],
            [float(row.rate) for row in rows],
            [float(row.target) for row in rows],
            [grip.slip.rate(v) for grip in self.grips],
            tuple(self._near(assembly, meeting) for meeting in self.mechanism.meetings),
            self.weightless(mass),
        )

    def weightless(self, mass: list[Row]) -> tuple[Row, ...]:
        """Motions without mass."""
        return tuple(solve([[*row, 0.0] for row in mass]).nulls) if self.massless else ()

    def _gradient(self, row: RowTerms) -> Gradient:
        return gradient(spread(row.along, self.size), spread(row.lift, self.count))

    def _near(self, assembly: Assembly, meeting: Meeting) -> Near:
        apart = assembly.separation(meeting)
        along = [-part for part in spread(apart.along, self.size)]
        lift = [-part for part in spread(apart.lift, self.count)]
        return Near(meeting, float(apart.gap), float(apart.rate), float(apart.bias), gradient(along, lift))


def spread(entries: Mapping[int, Number], size: int) -> Row:
    """A row with the given entries."""
    row = [0.0] * size
    for number, part in entries.items():
        row[number] = float(part)
    return row


def _plain(numbers: Numbers) -> Row:
    """Whoever computes a mechanism with NumPy passes its scalars on, which are slow and print badly."""
    return [float(number) for number in numbers]


def moving(one: Point, other: Point) -> bool:
    """Whether two points move relative to each other, as their coordinates allow at the start."""
    for number in one.gradient.keys() | other.gradient.keys():
        way: Triple = minus(other.gradient.get(number, _NONE), one.gradient.get(number, _NONE))
        if math.hypot(*way) > ALIGNED:
            return True
    return one.lift.keys() != other.lift.keys()


_NONE = (0.0, 0.0, 0.0)


def _limits(mechanism: Mechanism) -> tuple[Limit, ...]:
    limits: list[Limit] = []
    for number, coordinate in enumerate(mechanism.coordinates):
        if coordinate.lower > -inf:
            limits.append(Limit(number, coordinate.name, -float(coordinate.lower), 1.0))
        if coordinate.upper < inf:
            limits.append(Limit(number, coordinate.name, float(coordinate.upper), -1.0))
    return tuple(limits)


def _grips(mechanism: Mechanism) -> tuple[Grip, ...]:
    grips: list[Grip] = []
    size, count = len(mechanism.coordinates), len(mechanism.faces)
    for number, face in enumerate(mechanism.faces):
        body = mechanism.body[face.subject]
        names = {coordinate.name for coordinate in body.coordinates}
        if not face.slip or not names >= {name for name, _ in face.slip}:
            raise SceneError(
                face.subject, "it rests on a face but has no slide along it", "let it slide along the face"
            )
        slides = [c for c in body.coordinates if c.kind == "slide"]
        if not face.turning and any(abs(product(slide.axis, face.normal)) > ALIGNED for slide in slides):
            raise UnsupportedError(f"{face.subject}: it slides off the face that it rests on")
        if face.friction > 0.0 and len(slides) > 1:
            raise UnsupportedError(f"{face.subject}: a rough contact that slides in two directions has no model here")
        if face.friction > 0.0:
            slip = [0.0] * size
            for name, factor in face.slip:
                slip[mechanism.number[name]] = float(factor)
            alone = mechanism.number[face.slip[0][0]] if len(face.slip) == 1 and face.slip[0][1] == 1.0 else -1
            grips.append(Grip(number, gradient(slip, [0.0] * count), float(face.friction), alone, face.guided))
    return tuple(grips)

"""The numerical equations of a mechanism at an instant, as a complementarity problem, and the distances to events."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from math import inf

from sim2reason.base.records import cached_property
from sim2reason.errors import SceneError, UnsupportedError
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import CollisionPair, Line, Mechanism, Rigid
from sim2reason.scenes.dsl.state import check_initial_speeds
from sim2reason.scenes.dsl.structure import PARALLEL_TOL, changing, steady
from sim2reason.scenes.dsl.vectors import Distance, Number, Triple, dot, subtract_triples
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.lengths import RowKind, RowTerms, SwitchState, row_kinds
from sim2reason.simulation.engines.exact.linear import Gradient, RoughContact, Row, gradient, solve, total
from sim2reason.simulation.trace import Budget

CONTACT_DISTANCE = 1e-9  # m; lengths with a smaller difference are equal


@dataclass(frozen=True, slots=True)
class Limit:
    """One travel limit of a coordinate; the remaining travel is `initial_travel` + `sign`·q."""

    coordinate: int
    name: str
    initial_travel: float
    sign: float


@dataclass(slots=True)
class PairState:
    """A collision pair at an instant: gap, rate, second derivative at q̈ = 0, and the gradient if the bodies touch."""

    meeting: CollisionPair
    gap: float
    rate: float
    bias: float
    along: Mapping[int, float]
    lift: Mapping[int, float]

    @property
    def touching(self) -> bool:
        """Return whether the gap is closed."""
        return self.gap <= CONTACT_DISTANCE

    def second(self, a: Row) -> float:
        """Return the second derivative of the gap, m/s²."""
        return self.bias + total(part * a[number] for number, part in self.along.items())

    def closing(self, size: int, count: int) -> Gradient:
        """Return the negative gradient of the gap over all coordinates and contacts."""
        along, lift = spread(self.along, size), spread(self.lift, count)
        return gradient([-part for part in along], [-part for part in lift])


@dataclass(frozen=True, slots=True)
class Loads:
    """The mass matrix and applied loads of the complementarity problem of forces at one instant."""

    mass: list[Row]
    lifted: list[Row]
    heave: list[Row]
    force: Row
    press: Row
    weightless: tuple[Row, ...]  # basis of the null space of `mass`: motions that need no force


@dataclass(slots=True)
class Instant:
    """The equations of motion at one instant: all that forces and impulses depend on."""

    time: float
    q: Row
    v: Row
    loads: Loads
    rows: tuple[Gradient, ...]
    spare: Row  # distance until each row acts, m
    rates: Row  # at which this distance shrinks
    targets: Row
    slips: Row  # of each rough contact, m/s
    pairs: tuple[PairState, ...]


class System:
    """A validated mechanism with all data that stay constant throughout a motion."""

    def __init__(self, mechanism: Mechanism) -> None:
        """Validate the mechanism and index its parts.

        Raises:
            UnsupportedError: a rough body slides in two directions, or off the face that it rests on.
            SceneError: two bodies overlap, two sites of a line coincide, or a rod's ends part, at the start.
        """
        self.mechanism = mechanism
        self.size, self.count = len(mechanism.coordinates), len(mechanism.faces)
        self.frames = initial_frames(mechanism)
        self.budget = Budget()
        self._kinds: dict[tuple[bool, ...], list[RowKind]] = {}
        self.grips = _grips(mechanism)
        self.guided = tuple(number for number, face in enumerate(mechanism.faces) if face.guided)
        self.limits = _limits(mechanism)
        self.starts = {line.name: self._check_line(line) for line in mechanism.lines}
        self.changing = changing(mechanism, self.frames)
        self.massless = any(body.coordinates and body.mass == 0.0 for body in mechanism.bodies)
        for meeting in mechanism.meetings:
            self._check_apart(meeting)
        check_initial_speeds(mechanism)

    def _check_line(self, line: Line) -> float:
        """Return the initial length of a line between its sites, without wheels."""
        total = 0.0
        for first, last in pairwise(line.through):
            try:
                run = self.frames.distance(first, last)
            except ZeroDivisionError:
                run = None
            if run is None or (run.value <= CONTACT_DISTANCE and (run.moved or run.lift)):
                problem = f"sites {first} and {last} coincide at the start"
                raise SceneError(line.name, problem, "leave some string between")
            total += run.value
        return total

    def _check_apart(self, meeting: CollisionPair) -> None:
        places = [
            (0.0, 0.0, 0.0) if name is None else self.frames.center(name).place for name in (meeting.a, meeting.b)
        ]
        offset = subtract_triples(places[1], places[0])
        gap = math.hypot(*offset) if meeting.normal is None else dot(meeting.normal, offset)
        if gap < meeting.distance - CONTACT_DISTANCE:
            other = "what is fixed" if meeting.a is None else meeting.b
            raise SceneError(meeting.a or meeting.b, f"it overlaps {other} at the start", "move them apart")

    @cached_property
    def runs(self) -> dict[tuple[str, str], Distance]:
        """Return the straight line segments whose ends move towards or away from each other."""
        segments: dict[tuple[str, str], Distance] = {}
        for line in self.mechanism.lines:
            if isinstance(line.law, Rigid):
                continue
            segments |= {
                ends: run
                for ends, run in zip(pairwise(line.through), self.frames.pieces(line), strict=True)
                if run.lift or any(math.hypot(*direction) > PARALLEL_TOL for direction in run.moved.values())
            }
        return segments

    @cached_property
    def steady(self) -> dict[tuple[str, str], Triple]:
        """Return the straight line segments of constant direction, with their directions."""
        return steady(self.mechanism, self.frames)

    @cached_property
    def movable(self) -> tuple[tuple[str, ...], ...]:
        """Return the movable bodies of each collision pair."""
        return tuple(
            tuple(name for name in meeting.names if self.frames[name].steps) for meeting in self.mechanism.meetings
        )

    @cached_property
    def phase(self) -> SwitchState:
        """Return the initial on/off state: regions that contain their body, burning engines, no stuck pairs."""
        inside = tuple(
            tuple(margin > 0.0 for margin in force.region.margins(self.frames.center(force.body).place, math))
            if force.region is not None
            else ()
            for force in self.mechanism.forces
        )
        burning = tuple(burn.until > 0.0 for burn in self.mechanism.burns)
        phase = SwitchState(inside, burning, (False,) * len(self.mechanism.meetings))
        return phase._replace(strained=self._strained(phase)) if self.mechanism.half_springs else phase

    def _strained(self, phase: SwitchState) -> tuple[bool, ...]:
        """Return for each one-sided spring whether it acts at the start, or immediately after if it is relaxed."""
        phase = phase._replace(strained=(False,) * len(self.mechanism.half_springs))
        speeds = [float(coordinate.speed) for coordinate in self.mechanism.coordinates]
        begun = Assembly(self.mechanism, phase, ([0.0] * self.size, speeds, 0.0), math)
        acting: list[bool] = []
        for line, law in self.mechanism.half_springs:
            length = begun.length(line)
            strain = law.side * float(length.value - law.length)
            acting.append(
                strain > CONTACT_DISTANCE or (abs(strain) <= CONTACT_DISTANCE and law.side * float(length.rate) > 0.0)
            )
        return tuple(acting)

    def kinds(self, phase: SwitchState) -> list[RowKind]:
        """Return the kinds of all constraint rows for an on/off state (phase) of forces, engines, pairs and springs."""
        cached = self._kinds.get(phase.stuck)
        if cached is None:
            cached = self._kinds[phase.stuck] = row_kinds(self.mechanism, phase)
        return cached

    def instant(self, time: float, q: Row, v: Row, phase: SwitchState) -> Instant:
        """Return the numerical equations of one instant; the caller handles arithmetic errors."""
        assembly = Assembly(self.mechanism, phase, (q, v, time), math)
        rows = assembly.rows(self.starts)
        return Instant(
            time,
            q,
            v,
            self.loads(assembly),
            tuple(self.gradient(row) for row in rows),
            [float(row.value) for row in rows],
            [float(row.rate) for row in rows],
            [float(row.target) for row in rows],
            [grip.slip.rate(v) for grip in self.grips],
            tuple(_near(assembly, meeting) for meeting in self.mechanism.meetings),
        )

    def loads(self, assembly: Assembly) -> Loads:
        """Return the inertia and loads of a numerical assembly, with NumPy scalars converted to floats."""
        mass = [list(map(float, row)) for row in assembly.full_mass()]
        lifted = [list(map(float, row)) for row in assembly.lifted]
        heave = [list(map(float, row)) for row in assembly.heave]
        weightless = tuple(solve([[*row, 0.0] for row in mass]).nulls) if self.massless else ()
        force, press = list(map(float, assembly.force)), list(map(float, assembly.press))
        return Loads(mass, lifted, heave, force, press, weightless)

    def gradient(self, row: RowTerms) -> Gradient:
        """Return the dense gradient of a constraint row."""
        return gradient(spread(row.along, self.size), spread(row.lift, self.count))


def _near(assembly: Assembly, meeting: CollisionPair) -> PairState:
    separation = assembly.separation(meeting)
    return PairState(
        meeting,
        float(separation.gap),
        float(separation.rate),
        float(separation.bias),
        separation.along,
        separation.lift,
    )


def spread(entries: Mapping[int, Number], size: int) -> Row:
    """Return a dense row with the given entries."""
    row = [0.0] * size
    for number, part in entries.items():
        row[number] = part if type(part) is float else float(part)
    return row


def _limits(mechanism: Mechanism) -> tuple[Limit, ...]:
    limits: list[Limit] = []
    for number, coordinate in enumerate(mechanism.coordinates):
        if coordinate.lower > -inf:
            limits.append(Limit(number, coordinate.name, -float(coordinate.lower), 1.0))
        if coordinate.upper < inf:
            limits.append(Limit(number, coordinate.name, float(coordinate.upper), -1.0))
    return tuple(limits)


def _grips(mechanism: Mechanism) -> tuple[RoughContact, ...]:
    grips: list[RoughContact] = []
    size, count = len(mechanism.coordinates), len(mechanism.faces)
    for number, face in enumerate(mechanism.faces):
        body = mechanism.body[face.subject]
        names = {coordinate.name for coordinate in body.coordinates}
        if not face.slip or not names >= {name for name, _ in face.slip}:
            raise SceneError(
                face.subject, "it rests on a face but has no slide along it", "let it slide along the face"
            )
        slides = [c for c in body.coordinates if c.kind == "slide"]
        if not face.turning and any(abs(dot(slide.axis, face.normal)) > PARALLEL_TOL for slide in slides):
            raise UnsupportedError(f"{face.subject}: it slides off the face that it rests on")
        if face.friction > 0.0 and len(slides) > 1:
            raise UnsupportedError(f"{face.subject}: a rough contact that slides in two directions has no model here")
        if face.friction > 0.0:
            slip = [0.0] * size
            for name, factor in face.slip:
                slip[mechanism.number[name]] = float(factor)
            alone = mechanism.number[face.slip[0][0]] if len(face.slip) == 1 and face.slip[0][1] == 1.0 else -1
            along, holds = gradient(slip, [0.0] * count), float(face.static_friction)
            grips.append(RoughContact(number, along, float(face.friction), alone, face.guided, holds))
    return tuple(grips)

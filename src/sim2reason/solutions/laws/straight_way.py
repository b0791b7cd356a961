"""Motion of bodies along straight lines as goals use it: components of accelerations, velocities, displacements."""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet

from sim2reason.base.records import cached_property
from sim2reason.questions import Target
from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.vectors import Vector, dot, subtract_triples
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.goals import AXES, GOALS, CollisionTerm, Components, Goal, MotionPart
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.writing.lexicon import DualValue
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

WORLD_AXES: tuple[Vector, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
COMPONENT_ATOL = 1e-9


class StraightMotion(ABC):
    """The derivation of one answer for bodies that move along straight lines."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Take the problem and the solution in progress."""
        self.setting, self.book = setting, book
        self.mechanism, self.query = setting.mechanism, setting.query
        self.target: Target | None = setting.target

    @property
    @abstractmethod
    def newton(self) -> Newton:
        """Return Newton's laws at the moment of the question."""

    @abstractmethod
    def rate(self, kind: str, k: int) -> Polynomial:
        """Return the velocity ``v``, acceleration ``a`` or displacement ``s`` along a coordinate."""

    @abstractmethod
    def force(self, kind: str, name: str) -> Symbol:
        """Return the symbol of a force from Newton's laws."""

    @property
    def goal(self) -> Goal | None:
        """Return the object that derives the quantity asked for from the motion; None if a time is asked for."""
        return GOALS[self.target.quantity] if self.target is not None else None

    @property
    def uses(self) -> str:
        """Return the kinds of vectors that the question's quantity needs; ``s`` for a time."""
        return self.goal.uses if self.goal is not None else "s"

    @cached_property
    def _start(self) -> Frames:
        """Return the initial geometry."""
        return initial_frames(self.mechanism)

    def moving(self, bodies: Sequence[str]) -> list[int]:
        """Return the coordinates that move given bodies."""
        ways = (self._start.center(body).gradient.items() for body in bodies)
        return sorted({k for entries in ways for k, direction in entries if dot(direction, direction) > COMPONENT_ATOL})

    def body_coordinates(self, body: str) -> list[int]:
        """Return the coordinates whose rates add up to a body's motion; by default all that move it."""
        return self.moving([body])

    def asked_coordinates(self) -> list[int]:
        """Return the coordinates that move the subjects of the question."""
        if self.target is None or self.goal is None:
            return []
        bodies, sense = list(self.goal.bodies(self.target)), self.target.sense
        if sense is not None and len(bodies) == 1 and self._own(bodies[0]):
            return [k for k in self._own(bodies[0]) if self._matters(bodies[0], k, sense.vector)]
        hinges = [k for body in bodies if self.goal.turns and (k := self.hinge(body)) is not None]
        drawn = [k for name in self.goal.lines(self.target) for k in self.stretching(name)]
        return sorted({*self.moving(bodies), *hinges, *drawn})

    def _matters(self, body: str, k: int, way: Vector) -> bool:
        """Return whether a coordinate moves a body along a direction."""
        return abs(dot(self._start.center(body).gradient[k], way)) >= COMPONENT_ATOL

    def stretching(self, line: str) -> list[int]:
        """Return the coordinates that change the length of a string or spring."""
        newton = Newton(self.setting.lexicon, self.setting.motion.segments[0])
        number = self.mechanism.lines.index(self.mechanism.line[line])
        return [k for k in range(len(self.mechanism.coordinates)) if newton.stretch(number, k)]

    def hinge(self, body: str) -> int | None:
        """Return the coordinate of a body's rotation about its centre; None if there is none."""
        own = self.mechanism.body[body]
        turning = [c.name for c in own.coordinates if c.kind == "hinge" and any(own.inertia)]
        return self.mechanism.number[turning[0]] if len(turning) == 1 else None

    @cached_property
    def first_speeds(self) -> Mapping[int, Polynomial]:
        """Return the nonzero initial velocities by coordinate."""
        lexicon = self.setting.lexicon
        pairs = zip(lexicon.mechanism.coordinates, lexicon.twin.coordinates, strict=True)
        turns = any(c.kind == "hinge" for c in self.mechanism.coordinates)
        scale = Newton(lexicon, self.setting.motion.segments[0]).scale if turns else None
        speeds = {k: DualValue(a.speed, b.speed) for k, (a, b) in enumerate(pairs) if a.speed}
        return {k: lexicon.read(speed * scale[k] if scale else speed) for k, speed in speeds.items()}

    def component(self, kind: str, body: str, way: Vector) -> Polynomial:
        """Return a vector's component along a world direction, or the body's own line; kind ``u``: initial velocity."""
        if kind == "u":
            moving = [k for k in self.moving([body]) if k in self.first_speeds]
            return self.projected(body, way, {k: self.first_speeds[k] for k in moving})
        along = [k for k in self.body_coordinates(body) if self._matters(body, k, way)]
        return self.projected(body, way, {k: self.rate(kind, k) for k in along})

    def projected(self, body: str, way: Vector, rates: Mapping[int, Polynomial]) -> Polynomial:
        """Return the component of a body's motion along a direction, given its rates by coordinate.

        An oblique direction depends on the scene's numbers, so it must not be used for the twin.
        """
        parts: list[Polynomial] = []
        for k, rate in rates.items():
            along = dot(self._start.center(body).gradient[k], way)
            if abs(along) < COMPONENT_ATOL:
                continue
            if abs(abs(along) - 1.0) < COMPONENT_ATOL:
                factor = Polynomial.from_expression(1.0 if along > 0.0 else -1.0)
            elif way in WORLD_AXES:
                factor = self.newton.along(body, k, (way[0], way[1], way[2]))
            else:
                raise UnsolvedError("a component along a direction that is neither the room's nor the body's own")
            parts.append(factor * rate if factor else NIL)
        return total(parts)

    def vector(self, kind: str, body: str) -> Components:
        """Return all three components along the body's axes in the text, or those of the world frame."""
        own = self._own(body)
        if own:
            rates = self.first_speeds if kind == "u" else {k: self.rate(kind, k) for k in own}
            parts = [*(rates.get(k, NIL) for k in own), NIL]
            return parts[0], parts[1], parts[2]
        x, y, z = (self.component(kind, body, direction) for direction in WORLD_AXES)
        return x, y, z

    def line_component(self, kind: str, body: str) -> Polynomial | None:
        """Return a vector's component along a body's only line, signed like the coordinate; None for several lines."""
        own = self.moving([body]) if kind == "u" else self.body_coordinates(body)
        ways = [self._start.center(body).gradient[k] for k in own]
        senses = [dot(direction, ways[-1]) for direction in ways]
        if not own or any(abs(abs(sense) - 1.0) > COMPONENT_ATOL for sense in senses):
            return None
        rates = [self.first_speeds.get(k, NIL) if kind == "u" else self.rate(kind, k) for k in own]
        return total(rate.scale(float(round(sense))) for rate, sense in zip(rates, senses, strict=True))

    def _own(self, body: str) -> list[int]:
        """Return the two coordinates of a free body along its own axes x and y; an empty list for other bodies."""
        slides = [c for c in self.mechanism.body[body].coordinates if c.label in AXES and c.kind == "slide"]
        free = self.mechanism.body[body].parent is None and len(slides) == 2
        return [self.mechanism.number[c.name] for c in slides] if free else []

    def initial_separation(self, one: str, other: str) -> Components:
        """Return the initial vector from the centre of one body to that of another."""
        lexicon = self.setting.lexicon
        places = [
            subtract_triples(f.center(other).place, f.center(one).place)
            for f in (self._start, initial_frames(lexicon.twin))
        ]
        own, ways = self._own(other), list[tuple[Vector, Vector]]()
        for n in range(3):
            axes = [
                (m.coordinates[own[n]].axis if n < len(own) else WORLD_AXES[n]) for m in (self.mechanism, lexicon.twin)
            ]
            ways.append((axes[0], axes[1]))
        pairs = (
            [float(dot(separation, direction)) for separation, direction in zip(places, axes, strict=True)]
            for axes in ways
        )
        x, y, z = (lexicon.read(DualValue(*pair)) for pair in pairs)
        return (x, y, NIL) if own else (x, y, z)

    def rim(self, kind: str, body: str) -> Polynomial:
        """Return acceleration, velocity or displacement of a rotating body's rim; zero for other bodies."""
        k = self.hinge(body)
        return self.rate(kind, k) if k is not None else NIL

    def radius(self, body: str) -> Polynomial:
        """Return the radius of a rotating body's rim."""
        k = self.hinge(body)
        if k is None:
            raise UnsolvedError(f"{body} does not turn")
        return self.setting.lexicon.read(self.newton.scale[k])

    def rim_inertia(self, body: str) -> Polynomial:
        """Return I/R² of a rotating body."""
        k = self.hinge(body)
        if k is None:
            raise UnsolvedError(f"{body} does not turn")
        return self.newton.turning(k, k)

    def write_arcs(self, body: str) -> None:
        """Write the arcs of a rotating body's rim; by default there is one, which needs no name."""
        del body

    def axes(self, body: str) -> tuple[str, ...]:
        """Return the names of a body's axes in the text."""
        own = [self.mechanism.coordinates[k].label for k in self._own(body)]
        return (*own, "") if own else AXES

    def spring(self, what: str, line: str) -> Polynomial:
        """Return a number of a spring; by default raise UnsolvedError."""
        raise UnsolvedError(f"no {what} of {line}")

    def growth(self, kind: str, line: str) -> Polynomial:
        """Return the increase of the length of a string or spring, or its rate; by default raise UnsolvedError."""
        raise UnsolvedError(f"no {kind} of {line}")

    @property
    def motion_parts(self) -> Sequence[MotionPart]:
        """Return the parts of the motion; by default raise UnsolvedError."""
        raise UnsolvedError("no way to what adds up over a motion")

    def work(self, line: str, body: str) -> Symbol | None:
        """Return the work of a varying tension; by default None, since tensions are constant in each part."""
        del line, body

    def impulse(self, line: str) -> Symbol | None:
        """Return the impulse of a varying tension; by default None, since tensions are constant in each part."""
        del line

    @property
    def impacts(self) -> Sequence[CollisionTerm]:
        """Return the collisions up to the moment; by default raise UnsolvedError."""
        raise UnsolvedError("there are no collisions")

    def mass(self, body: str) -> Polynomial:
        """Return the mass of a body."""
        return self.newton.mass(body)

    @property
    def gravity(self) -> Polynomial:
        """Return the gravitational acceleration."""
        return self.newton.gravity

    @property
    def speeds(self) -> AbstractSet[str]:
        """Return the names of initial speeds, and of the distances and times in the question."""
        first = {name for speed in self.first_speeds.values() for name in speed.names()}
        return first | set(self.book.stated)

"""What goals ask of a strategy for bodies on straight ways: components of accelerations, velocities, displacements."""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet

from sim2reason.base.lazy import cached_property
from sim2reason.questions import Target
from sim2reason.scenes.dsl.frames import Frames, start
from sim2reason.scenes.dsl.vectors import Vector, minus, product
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.goals import AXES, GOALS, Components, Goal, Stretch, Struck
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.writing.lexicon import Both
from sim2reason.solutions.writing.steps import Book, UnsolvedError

ROOM: tuple[Vector, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
STILL = 1e-9


class Way(ABC):
    """The way to one answer, for bodies that move along straight lines."""

    def __init__(self, setting: Setting, book: Book) -> None:
        """Nothing is written yet."""
        self.setting, self.book = setting, book
        self.mechanism, self.query = setting.mechanism, setting.query
        self.target: Target | None = setting.target

    @property
    @abstractmethod
    def newton(self) -> Newton:
        """The laws at the moment that is asked about."""

    @abstractmethod
    def rate(self, kind: str, k: int) -> Polynomial:
        """Return how fast a coordinate changes (``v``), how fast that does (``a``), or by how much it has (``s``)."""

    @abstractmethod
    def force(self, kind: str, name: str) -> Symbol:
        """Return a force that Newton's laws gave."""

    @property
    def goal(self) -> Goal | None:
        """Return how the quantity follows; None for a time."""
        return GOALS[self.target.quantity] if self.target is not None else None

    @property
    def uses(self) -> str:
        """Return what of the motion is needed; of a time, displacements."""
        return self.goal.uses if self.goal is not None else "s"

    @cached_property
    def _start(self) -> Frames:
        return start(self.mechanism)

    def moving(self, bodies: Sequence[str]) -> list[int]:
        """Return the coordinates that move some bodies."""
        ways = (self._start.center(body).gradient.items() for body in bodies)
        return sorted({k for found in ways for k, way in found if product(way, way) > STILL})

    def own(self, body: str) -> list[int]:
        """Return the coordinates whose rates add up to the motion of a body; by default all that move it."""
        return self.moving([body])

    def asked_coordinates(self) -> list[int]:
        """Return the coordinates that move what is asked about."""
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
        return abs(product(self._start.center(body).gradient[k], way)) >= STILL

    def stretching(self, line: str) -> list[int]:
        """Return the coordinates with which the length of a line changes."""
        newton = Newton(self.setting.lexicon, self.setting.motion.segments[0])
        number = self.mechanism.lines.index(self.mechanism.line[line])
        return [k for k in range(len(self.mechanism.coordinates)) if newton.stretch(number, k)]

    def hinge(self, body: str) -> int | None:
        """Return the coordinate that turns a body about its own centre; None if there is none."""
        own = self.mechanism.body[body]
        turning = [c.name for c in own.coordinates if c.kind == "hinge" and any(own.inertia)]
        return self.mechanism.number[turning[0]] if len(turning) == 1 else None

    @cached_property
    def first_speeds(self) -> Mapping[int, Polynomial]:
        """The rates of coordinates at the start, but for those that are zero."""
        lexicon = self.setting.lexicon
        pairs = zip(lexicon.mechanism.coordinates, lexicon.twin.coordinates, strict=True)
        turns = any(c.kind == "hinge" for c in self.mechanism.coordinates)
        scale = Newton(lexicon, self.setting.motion.segments[0]).scale if turns else None
        speeds = {k: Both(a.speed, b.speed) for k, (a, b) in enumerate(pairs) if a.speed}
        return {k: lexicon.read(speed * scale[k] if scale else speed) for k, speed in speeds.items()}

    def component(self, kind: str, body: str, way: Vector) -> Polynomial:
        """Along a direction of the room, or the line of the body's own motion; ``u`` is the velocity at the start."""
        if kind == "u":
            moving = [k for k in self.moving([body]) if k in self.first_speeds]
            return self.projected(body, way, {k: self.first_speeds[k] for k in moving})
        along = [k for k in self.own(body) if self._matters(body, k, way)]
        return self.projected(body, way, {k: self.rate(kind, k) for k in along})

    def projected(self, body: str, way: Vector, rates: Mapping[int, Polynomial]) -> Polynomial:
        """Return the component of what moves a body, by coordinate.

        A slanted sense holds the scene's own numbers, so that the twin's could not be read along it.
        """
        parts: list[Polynomial] = []
        for k, rate in rates.items():
            along = product(self._start.center(body).gradient[k], way)
            if abs(along) < STILL:
                continue
            if abs(abs(along) - 1.0) < STILL:
                factor = Polynomial.of(1.0 if along > 0.0 else -1.0)
            elif way in ROOM:
                factor = self.newton.along(body, k, (way[0], way[1], way[2]))
            else:
                raise UnsolvedError("a component along a direction that is neither the room's nor the body's own")
            parts.append(factor * rate if factor else NIL)
        return total(parts)

    def vector(self, kind: str, body: str) -> Components:
        """Return all three components, along the axes that the text gives the body, else those of the room."""
        own = self._own(body)
        if own:
            rates = self.first_speeds if kind == "u" else {k: self.rate(kind, k) for k in own}
            parts = [*(rates.get(k, NIL) for k in own), NIL]
            return parts[0], parts[1], parts[2]
        x, y, z = (self.component(kind, body, way) for way in ROOM)
        return x, y, z

    def lone(self, kind: str, body: str) -> Polynomial | None:
        """Return a vector of a body along its line of motion, signed like its coordinate; None for several lines."""
        own = self.moving([body]) if kind == "u" else self.own(body)
        ways = [self._start.center(body).gradient[k] for k in own]
        senses = [product(way, ways[-1]) for way in ways]
        if not own or any(abs(abs(sense) - 1.0) > STILL for sense in senses):
            return None
        rates = [self.first_speeds.get(k, NIL) if kind == "u" else self.rate(kind, k) for k in own]
        return total(rate.scaled(float(round(sense))) for rate, sense in zip(rates, senses, strict=True))

    def _own(self, body: str) -> list[int]:
        """Return the coordinates of a body that has axes of its own in the text, at right angles."""
        found = [c for c in self.mechanism.body[body].coordinates if c.label in AXES and c.kind == "slide"]
        free = self.mechanism.body[body].parent is None and len(found) == 2
        return [self.mechanism.number[c.name] for c in found] if free else []

    def apart(self, one: str, other: str) -> Components:
        """From the centre of one body to that of another, at the start."""
        lexicon = self.setting.lexicon
        places = [minus(f.center(other).place, f.center(one).place) for f in (self._start, start(lexicon.twin))]
        own, ways = self._own(other), list[tuple[Vector, Vector]]()
        for n in range(3):
            axes = [(m.coordinates[own[n]].axis if n < len(own) else ROOM[n]) for m in (self.mechanism, lexicon.twin)]
            ways.append((axes[0], axes[1]))
        pairs = ([float(product(place, way)) for place, way in zip(places, axes, strict=True)] for axes in ways)
        x, y, z = (lexicon.read(Both(*pair)) for pair in pairs)
        return (x, y, NIL) if own else (x, y, z)

    def rim(self, kind: str, body: str) -> Polynomial:
        """Return what the rim of a body does that turns about its own axis."""
        k = self.hinge(body)
        return self.rate(kind, k) if k is not None else NIL

    def radius(self, body: str) -> Polynomial:
        """Return the radius of that rim."""
        k = self.hinge(body)
        if k is None:
            raise UnsolvedError(f"{body} does not turn")
        return self.setting.lexicon.read(self.newton.scale[k])

    def rim_inertia(self, body: str) -> Polynomial:
        """I/R²."""
        k = self.hinge(body)
        if k is None:
            raise UnsolvedError(f"{body} does not turn")
        return self.newton.turning(k, k)

    def tell_arcs(self, body: str) -> None:
        """Name the distances along the rim of a turning body; by default there is at most one, which needs no name."""
        del body

    def axes(self, body: str) -> tuple[str, ...]:
        """Return what the text calls the room's directions for a body."""
        own = [self.mechanism.coordinates[k].label for k in self._own(body)]
        return (*own, "") if own else AXES

    def spring(self, what: str, line: str) -> Polynomial:
        """Return a number of a spring; by default there is none."""
        raise UnsolvedError(f"no {what} of {line}")

    def growth(self, kind: str, line: str) -> Polynomial:
        """By how much a line has grown, or how fast it does; by default it has no spring."""
        raise UnsolvedError(f"no {kind} of {line}")

    @property
    def stretches(self) -> Sequence[Stretch]:
        """The parts of the motion; by default it has none."""
        raise UnsolvedError("no way to what adds up over a motion")

    def work(self, line: str, body: str) -> Symbol | None:
        """Return that of a tension which changes all the while; by default it is constant, part by part."""
        del line, body

    def impulse(self, line: str) -> Symbol | None:
        """Return that of a tension which changes all the while; by default it is constant, part by part."""
        del line

    @property
    def impacts(self) -> Sequence[Struck]:
        """The collisions up to the moment; by default it has none."""
        raise UnsolvedError("there are no collisions")

    def mass(self, body: str) -> Polynomial:
        """Return the mass of a body."""
        return self.newton.mass(body)

    @property
    def gravity(self) -> Polynomial:
        """The acceleration of free fall."""
        return self.newton.gravity

    @property
    def speeds(self) -> AbstractSet[str]:
        """Speeds at the start, and distances and times that the question says."""
        first = {name for held in self.first_speeds.values() for name in held.names()}
        return first | set(self.book.stated)

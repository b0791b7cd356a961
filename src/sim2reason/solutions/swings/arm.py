"""A rigid body on a horizontal axle, made of pieces: their positions and moments of inertia."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import atan2, hypot, pi

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.regimes.directions import SideOfCenterOfMass
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.solids import Shape
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.vectors import Vector, apply_tensor, dot, subtract_triples
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.solution import with_unit
from sim2reason.solutions.swings.rigid_shapes import MeanSquares, candidates, mean_squares, tilted
from sim2reason.solutions.writing.lexicon import UnreadError
from sim2reason.solutions.writing.notation import INERTIA, METRES, latex
from sim2reason.solutions.writing.steps import SolutionBuilder, record_inequality

INERTIA_RTOL = 1e-9  # relative tolerance of moments of inertia, and tolerance of lengths in m
MOMENT = latex("kg m")
POINTS = {  # reference points of bodies in the text
    "Hemisphere": "the centre of its flat face",
    "SphericalCap": "the centre of its flat face",
    "Bowl": "the centre of its opening",
}


def single_axle_body(m: Mechanism) -> str:
    """Return the only body on a fixed horizontal axle, which may carry others fixed to it; else empty."""
    if len(m.coordinates) != 1 or m.coordinates[0].kind != "hinge" or abs(m.coordinates[0].axis[2]) > INERTIA_RTOL:
        return ""
    other = m.lines or m.faces or m.forces or m.attractions or m.burns or m.meetings or m.feet
    carrier = m.coordinates[0].body
    riding = all(carrier in (body.name, body.parent) for body in m.bodies)
    return carrier if riding and m.body[carrier].parent is None and not other else ""


@dataclass(frozen=True, slots=True)
class Piece:
    """A body on the axle: its mass, and the position of its centre of mass along the arm."""

    body: str
    mass: Expression
    place: Expression
    inertia: Expression  # about its own centre of mass


THIN_BODIES = ("Disc", "Hoop")  # thin bodies, in which a line across the axis is a diameter


class Arm:
    """The pieces of a rigid body on an axle, in the symbols of the text, written as needed."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder, carrier: str = "") -> None:
        """Take the arm on the axle of a carrying body, by default the only axle; UnreadError for an unknown number."""
        self.setting, self.book, self.carrier = setting, book, carrier or single_axle_body(setting.mechanism)
        self.axis: Vector = setting.mechanism.body[self.carrier].coordinates[0].axis
        turning = [body for body in setting.mechanism.bodies if self.carrier in (body.name, body.parent)]
        self.bodies = [body.name for body in turning if body.mass]
        self._pieces: dict[str, Piece] = {}

    def _read(self, number: Callable[[Mechanism], float]) -> Expression:
        return self.setting.lexicon.formula_for(number).expression()

    # ---- where the arm points

    def initial_direction(self, m: Mechanism) -> Vector:
        """Return the unit vector along the arm at the start, from the axle towards the first body on it."""
        frames = initial_frames(m)
        first = self.bodies[0]
        offset = subtract_triples(frames[first].origin, frames[self.carrier].origin)
        if hypot(*offset) < INERTIA_RTOL:
            offset = subtract_triples(frames.center(first).place, frames[self.carrier].origin)
        x, y, z = (float(part) / hypot(*offset) for part in offset)
        return x, y, z

    def at(self, time: float) -> tuple[float, float, float]:
        """Return angle from the downward vertical and angle turned, rad, and rate, rad/s, at a time, by the engine."""
        angles, turned, rates = self.seen(np.array([time]))
        return float(angles[0]), float(turned[0]), float(rates[0])

    def seen(self, times: Array) -> tuple[Array, Array, Array]:
        """Return angles from the downward vertical, angles turned and rates at some times, each (n,), by the engine.

        They are positive on the initial side and only determine signs.
        """
        m = self.setting.mechanism
        state, number = self.setting.study.trace.sample(times), m.number[m.body[self.carrier].coordinates[0].name]
        direction, side = self.initial_direction(m), 1.0 if self.begins_right else -1.0
        sense = -side * self.axis[1]  # about y, what points to the right goes down
        turned = sense * state.q[:, number]
        angles = side * atan2(direction[0], -direction[2]) + turned
        return (angles + pi) % (2.0 * pi) - pi, turned, sense * state.v[:, number]

    @property
    def begins_right(self) -> bool:
        """Return whether the arm points to the right at the start, or straight down or up."""
        return self.initial_direction(self.setting.mechanism)[0] >= 0.0

    def _deflection(self, m: Mechanism) -> float:
        x, _, z = self.initial_direction(m)
        return abs(atan2(x, -z))

    @cached_property
    def initial_angle(self) -> Expression:
        """Return the angle of the arm with the downward vertical at the start."""
        return self._read(self._deflection)

    @cached_property
    def launch(self) -> Expression:
        """Return the angular speed at the start, rad/s."""
        return self._read(lambda m: abs(m.body[self.carrier].coordinates[0].speed))

    @cached_property
    def gravity(self) -> Expression:
        """Return the acceleration of free fall, m/s²."""
        return self._read(lambda m: -m.gravity[2])

    # ---- one piece

    def piece(self, body: str) -> Piece:
        """Return mass, position and moment of inertia of a piece of the arm."""
        if body not in self._pieces:
            mass = self._read(lambda m: m.body[body].mass)
            self._pieces[body] = Piece(body, mass, self._place(body), self._own(body, mass))
        return self._pieces[body]

    def _size(self, body: str) -> Callable[[str], Expression]:
        """Return a function that returns the symbol of a body's parameter from the name of the parameter."""

        def size(field: str) -> Expression:
            given = self.setting.given(f"{body}.{field}")
            if given is None:
                raise UnreadError(f"the {field} of {body} is not said")
            return Symbol(given.symbol)

        return size

    def _shape(self, body: str) -> Shape | None:
        shape = self.setting.scene.bodies.get(body)
        return shape if isinstance(shape, Shape) else None

    def _place(self, body: str) -> Expression:
        """Return the position of a body's centre of mass along the arm, from the axle."""

        def origin(m: Mechanism) -> float:
            frames = initial_frames(m)
            return float(
                dot(subtract_triples(frames[body].origin, frames[self.carrier].origin), self.initial_direction(m))
            )

        def center(m: Mechanism) -> float:
            frames = initial_frames(m)
            return float(
                dot(subtract_triples(frames.center(body).place, frames[self.carrier].origin), self.initial_direction(m))
            )

        if not any(self.setting.mechanism.body[body].inertia):
            return self._read(center)  # a small body at the end of a rod
        plain = self._read(origin)
        here, aside = center(self.setting.mechanism), center(self.setting.mechanism) - origin(self.setting.mechanism)
        if abs(aside) <= INERTIA_RTOL:
            return plain
        shape = self._shape(body)
        spread = mean_squares(shape, self._size(body)) if shape is not None else None
        if spread is None:
            raise UnreadError(f"the centre of mass of {self.setting.display_name(body)} is in no table")
        name = self.book.fresh("c", self.setting.subscript_of(body))
        point = POINTS.get(type(shape).__name__, "its own centre")
        text = f"The distance of the centre of mass of {self.setting.display_name(body)} from {point} is"
        shift: Expression = self.book.add_step("table", text, name, spread.center, METRES)
        shift = shift if aside * self.book.value(shift) > 0.0 else -shift
        position = self.book.fresh("r", self.setting.subscript_of(body))
        self.book.add_step(
            "place", self._place_words(body, plain + shift, plain, shift), position, plain + shift, METRES
        )
        if abs(self.book.value(position) - here) > INERTIA_RTOL:
            raise UnreadError(f"the centre of mass of {self.setting.display_name(body)} is beside the arm")
        return position

    def _place_words(self, body: str, place: Expression, *parts: Expression) -> str:
        """Return the words before the position of a centre of mass on an arm."""
        plain = not any(part.negative for part in parts)
        if plain or (self.book.value(place) > 0.0 and not self.book.is_hidden(place)):
            return "Its distance from the axle is"
        whose, first = self.setting.display_name(body), self.setting.display_name(self.bodies[0])
        return f"Along the arm, from the axle and positive on the side of {first}, the centre of mass of {whose} is at"

    def _own(self, body: str, mass: Expression) -> Expression:
        """Write the moment of inertia of a body about its own centre of mass, parallel to the axle; return it."""
        rigid_body = self.setting.mechanism.body[body]
        actual = float(dot(self.axis, apply_tensor(rigid_body.inertia, self.axis)))
        if actual <= 0.0:
            return ZERO
        shape = self._shape(body)
        spread = mean_squares(shape, self._size(body)) if shape is not None else None
        for formula, why in self._inertias(spread):
            if abs(self.book.value(formula) * rigid_body.mass - actual) <= INERTIA_RTOL * actual:
                line = "the line through its centre of mass parallel to the axle"
                flat = type(shape).__name__ in THIN_BODIES and spread is not None and formula == candidates(spread)[0]
                line = f"{line}, a diameter of it," if flat else line
                text = f"The moment of inertia of {self.setting.display_name(body)} about {line} is"
                name = self.book.fresh("I", ",".join(p for p in ("0", self.setting.subscript_of(body)) if p))
                return self.book.add_step("table", f"{why} {text}".lstrip(), name, mass * formula, INERTIA)
        raise UnreadError(f"the moment of inertia of {self.setting.display_name(body)} is in no table")

    def _inertias(self, spread: MeanSquares | None) -> Iterator[tuple[Expression, str]]:
        """Yield (moment of inertia per mass, reason) about each axis of a body and each line at a given angle."""
        if spread is None:
            return
        yield from zip(candidates(spread), (spread.why, spread.why_own, spread.why), strict=True)
        for given in self.setting.lexicon.givens.values():
            if given.angle:
                yield tilted(spread, Symbol(given.symbol))

    # ---- all together

    @cached_property
    def inertia(self) -> Symbol:
        """Write the moment of inertia about the axle by the parallel-axis theorem and return its symbol."""
        total: Expression = ZERO
        for body in self.bodies:
            piece = self.piece(body)
            total = total + piece.inertia + piece.mass * _squared(piece.place)
        points = [body for body in self.bodies if not any(self.setting.mechanism.body[body].inertia)]
        as_points = "a point mass" if len(points) == 1 else "point masses"
        added = f", with {self.setting.bodies_phrase(points)} as {as_points}" if points else ""
        text = f"By the parallel-axis theorem{added}, the moment of inertia about the axle is"
        if all(self.piece(body).inertia == ZERO for body in self.bodies):
            text = "The moment of inertia about the axle is"
        return self.book.add_step("inertia", text, self.book.fresh("I"), total, INERTIA)

    @cached_property
    def moment(self) -> Expression:
        """Write Σ m r of the bodies on the arm, kg m, and return it; times g sin φ it is the torque of gravity."""
        parts = [self.piece(body) for body in self.bodies]
        total: Expression = ZERO
        for piece in parts:
            total = total + piece.mass * piece.place
        if len(parts) == 1:
            return total
        text, name = "The sum of the masses times their distances from the axle is", self.book.fresh("S")
        if all(self.book.value(piece.place) > 0.0 for piece in parts):
            return self.book.add_step("moment", text, name, total, MOMENT)
        step, first = self.book.begin_step("moment"), self.setting.display_name(self.bodies[0])
        counted = f"distances on the side of {first} being counted as positive,"
        step.add_text(f"{text[:-3]}, {counted} is {step.result(name, total, MOMENT, law=True)}.")
        sign, side = ("> 0", "this") if self.book.value(name) > 0.0 else ("< 0", "the opposite")
        if any(isinstance(premise, SideOfCenterOfMass) for premise in self.setting.assumed):
            step.add_text(f"By assumption, the centre of mass is on {side} side, so ${name.name} {sign}$.")
        elif not self.book.is_hidden(total):
            step.add_text(f"As ${name.name} {sign}$, the centre of mass is on {side} side.")
        elif not self.book.in_symbols:
            step.add_text(f"Assume that ${name.name} {sign}$, so that the centre of mass is on {side} side.")
            self.book.afterwards.append(lambda: self._tell_side(name, sign))
        step.close()
        return name

    def _tell_side(self, moment: Symbol, sign: str) -> None:
        """Write that the centre of mass is on the assumed side, once all numbers are known."""
        step = self.book.begin_step("verify")
        record_inequality(self.book, step, *((moment, ZERO) if sign == "> 0" else (ZERO, moment)))
        value = with_unit(self.book.value(moment), MOMENT)
        step.add_text(f"With this, ${moment.name} = {value} {sign}$, as was assumed.")
        step.close()

    def noun(self) -> str:
        """Return the capitalised noun phrase of the rotating body."""
        lone = self.bodies[0] if len(self.bodies) == 1 else self.carrier
        return capitalized(self.setting.display_name(lone if lone in self.setting.words.mentions else self.bodies[0]))


def _squared(expression: Expression) -> Expression:
    return Power(-expression if expression.negative else expression, 2)

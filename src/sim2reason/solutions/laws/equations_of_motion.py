"""Equations of motion of any mechanism in the symbols of its text, from those that the engine records."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import State
from sim2reason.scenes.dsl.vectors import Number as Quantity
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.lengths import RowTerms, SwitchState
from sim2reason.simulation.engines.exact.tape import Symbol as Recorded
from sim2reason.simulation.engines.exact.tape import Tape
from sim2reason.solutions.algebra.expressions import Expression, Quotient, Symbol
from sim2reason.solutions.algebra.functions import Call, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, square_root, total
from sim2reason.solutions.writing.lexicon import DualValue, Lexicon, UnreadError
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

ZERO_COORDINATE_ATOL = 1e-12  # m: smaller coordinates of a body count as zero


def _exact(mechanism: Mechanism) -> Mechanism:
    """Return the mechanism with rounding errors in coordinates set to zero, so that copies with other numbers match."""

    def rounded(vector: Vector) -> Vector:
        x, y, z = (0.0 if abs(part) < ZERO_COORDINATE_ATOL else part for part in vector)
        return x, y, z

    bodies = tuple(
        replace(
            body,
            at=rounded(body.at),
            center=rounded(body.center),
            coordinates=tuple(replace(c, axis=rounded(c.axis)) for c in body.coordinates),
        )
        for body in mechanism.bodies
    )
    return replace(mechanism, bodies=bodies, sites=tuple(replace(s, at=rounded(s.at)) for s in mechanism.sites))


def assembled(mechanism: Mechanism, phase: SwitchState) -> tuple[Assembly, Tape]:
    """Record the equations of motion of a mechanism in a phase as operations on time, coordinates and rates."""
    mechanism = _exact(mechanism)
    size = len(mechanism.coordinates)
    tape = Tape(["t", *(f"q{k}" for k in range(size)), *(f"v{k}" for k in range(size))])
    symbols = list(tape.inputs.values())
    return Assembly(mechanism, phase, (symbols[1 : size + 1], symbols[size + 1 :], symbols[0]), tape), tape


def phase_at(state: State) -> SwitchState:
    """Return the phase at an instant: active fields, engines and one-sided springs, without sticking contacts."""
    m, time = state.mechanism, float(state.times[0])
    inside: list[tuple[bool, ...]] = []
    for force in m.forces:
        position = state.vector(state.frames.center(force.body).place)[0]
        margins = (
            force.region.margins((position[0], position[1], position[2]), math) if force.region is not None else ()
        )
        inside.append((all(float(margin) >= 0.0 for margin in margins),))  # type: ignore[arg-type]
    lengths = {line.name: float(state.free_length(line)[0][0]) for line, _ in m.half_springs}
    return SwitchState(
        inside=tuple(inside),
        burning=tuple(time < burn.until for burn in m.burns),
        stuck=(False,) * len(m.meetings),
        strained=tuple(law.side * (lengths[line.name] - law.length) >= 0.0 for line, law in m.half_springs),
    )


UNREAD = "?"  # begins the symbols of numbers that are no simple functions of stated ones


@dataclass(frozen=True, slots=True)
class Names:
    """The symbols of coordinates, rates, accelerations and time.

    A coordinate q of the mechanism is `sense` · (place − origin): where the text gives the initial position or angle,
    the symbol stands for the position or angle itself instead of the displacement.
    """

    places: tuple[Symbol, ...]
    rates: tuple[Symbol, ...]
    accelerations: tuple[Symbol, ...]
    time: Symbol
    senses: tuple[float, ...]
    origins: tuple[Polynomial, ...]

    def place(self, k: int) -> Polynomial:
        """Return a coordinate of the mechanism in terms of its symbol."""
        return (Polynomial.from_expression(self.places[k]) - self.origins[k]).scale(self.senses[k])

    def rate(self, k: int) -> Polynomial:
        """Return the rate of a coordinate in terms of its symbol."""
        return Polynomial.from_expression(self.rates[k]).scale(self.senses[k])

    def acceleration(self, k: int) -> Polynomial:
        """Return the second derivative of a coordinate in terms of its symbol."""
        return Polynomial.from_expression(self.accelerations[k]).scale(self.senses[k])


class EquationsOfMotion:
    """The mass matrix, loads and constraints of a mechanism as polynomials in the text's symbols."""

    def __init__(self, lexicon: Lexicon, book: SolutionBuilder, phase: SwitchState, names: Names) -> None:
        """Record the equations of the mechanism and a copy with other numbers; UnsolvedError if they differ in form."""
        self._lexicon, self.book, self.names = lexicon, book, names
        self.mechanism = lexicon.mechanism
        self._here, one = assembled(lexicon.mechanism, phase)
        self._there, two = assembled(lexicon.twin, phase)
        self._tapes = one, two
        self._known: dict[tuple[int, int], Polynomial] = {}
        self._squares: dict[Expression, Polynomial] = {}  # radicands by root
        self._forms: tuple[dict[int, int], dict[int, int]] = {}, {}
        self._shared: dict[tuple[str | int, ...], int] = {}  # numbers of forms
        self._below: dict[Expression, Polynomial] = {}  # denominators of reciprocals

    def inertia(self, k: int) -> Polynomial:
        """Return row k of the mass matrix times the accelerations."""
        here, there = self._here.full_mass()[k], self._there.full_mass()[k]
        pairs = enumerate(zip(here, there, strict=True))
        return total(self.read(a, b) * self.names.acceleration(j) for j, (a, b) in pairs)

    def mass(self, k: int, j: int) -> Polynomial:
        """Return an element of the mass matrix."""
        return self.read(self._here.full_mass()[k][j], self._there.full_mass()[k][j])

    def load(self, k: int) -> Polynomial:
        """Return the generalized force along a coordinate, without constraints."""
        return self.read(self._here.force[k], self._there.force[k])

    def constraint_derivative(self, row: int, k: int) -> Polynomial:
        """Return the derivative of the length that a constraint fixes with respect to a coordinate."""
        here, there = (rows[row].along.get(k, 0.0) for rows in self._rows)
        return self.read(here, there)

    def constraint_sides(self, row: int) -> tuple[Polynomial, Polynomial]:
        """Return both sides of a constraint's second time derivative, which is linear in the accelerations."""
        size = range(len(self.mechanism.coordinates))
        left = total(self.constraint_derivative(row, k) * self.names.acceleration(k) for k in size)
        return left, self.read(*(rows[row].target for rows in self._rows))

    @cached_property
    def _rows(self) -> tuple[list[RowTerms], list[RowTerms]]:
        """Return the recorded constraints of the mechanism and of its copy with other numbers."""
        starts = {line.name: 0.0 for line in self.mechanism.lines}
        return self._here.rows(starts), self._there.rows(starts)

    def unconstrained_normal_force(self, face: int) -> Polynomial:
        """Return the normal force at a contact without the contributions of constraints."""
        size = range(len(self.mechanism.coordinates))
        parts = [
            self.read(self._here.lifted[face][k], self._there.lifted[face][k]) * self.names.acceleration(k)
            for k in size
        ]
        return total(parts) - self.read(self._here.press[face], self._there.press[face])

    def normal_force_contribution(self, row: int, face: int) -> Polynomial:
        """Return the contribution of a unit constraint force to the normal force at a contact."""
        return self.read(*(rows[row].lift.get(face, 0.0) for rows in self._rows))

    @property
    def assemblies(self) -> tuple[Assembly, Assembly]:
        """Return the recorded equations of the mechanism and of its copy with other numbers."""
        return self._here, self._there

    def read_recorded(self, quantity: Callable[[Assembly], Quantity]) -> Polynomial:
        """Return in the text's symbols a quantity that is read from the recorded equations."""
        return self.read(quantity(self._here), quantity(self._there))

    # ---- from tapes to names

    def read(self, here: Quantity, there: Quantity) -> Polynomial:
        """Return in the text's symbols a quantity recorded for the mechanism and for its copy with other numbers."""
        if isinstance(here, Recorded) and isinstance(there, Recorded):
            return self._node(here.id, there.id)
        if isinstance(here, Recorded) or isinstance(there, Recorded):
            raise UnsolvedError("the equations of motion are of another kind with other numbers")
        return self.number(DualValue(float(here), float(there)))  # type: ignore[arg-type]

    def number(self, both: DualValue) -> Polynomial:
        """Return a number of the mechanism in the text's symbols; if impossible, a symbol that must cancel later."""
        try:
            return self._lexicon.read(both)
        except UnreadError:
            name = f"{UNREAD}{both.value!r}"
            self.book.values[name] = both.value
            return Polynomial.from_expression(Symbol(name))

    def _node(self, here: int, there: int) -> Polynomial:
        """Return an intermediate result of the recorded equations in the symbols of the text, from the cache."""
        if (here, there) not in self._known:
            self._known[here, there] = self._made(here, there)
        return self._known[here, there]

    def _form(self, side: int, node: int) -> int:
        """Return a number that identifies the form of a recorded quantity: its operations, regardless of constants."""
        forms = self._forms[side]
        if node not in forms:
            operation, a, b = self._tapes[side].nodes[node]
            if operation in ("input", "constant"):
                parts = [a] if operation == "input" else []
            else:
                parts = [self._form(side, part) for part in (a, b) if part >= 0]
                if operation in ("+", "*"):
                    parts.sort()
            forms[node] = self._shared.setdefault((operation, *parts), len(self._shared))
        return forms[node]

    def _made(self, here: int, there: int) -> Polynomial:
        """Convert an intermediate result of the recorded equations to the symbols of the text."""
        one, two = self._tapes
        (operation, a, b), (other, c, d) = one.nodes[here], two.nodes[there]
        if operation != other:
            raise UnsolvedError("the equations of motion are of another kind with other numbers")
        if operation == "input":
            return self._input(a)
        if operation == "constant":
            return self.number(DualValue(one.constants[a], two.constants[c]))
        if operation in ("+", "*") and self._form(0, a) != self._form(1, c) and self._form(0, a) == self._form(1, d):
            c, d = d, c  # the tape orders operands by first use
        first = self._node(a, c)
        if operation in ("sin", "cos"):
            return self._trigonometric_value(operation, first)
        if operation == "sqrt":
            return self._root(first)
        if operation == "neg":
            return first.scale(-1.0)
        return self._joined(operation, first, self._node(b, d))

    def _input(self, number: int) -> Polynomial:
        """Return the symbol of an input: time, a coordinate or a rate."""
        size = len(self.mechanism.coordinates)
        if number == 0:
            return Polynomial.from_expression(self.names.time)
        return self.names.place(number - 1) if number <= size else self.names.rate(number - 1 - size)

    def _joined(self, operation: str, first: Polynomial, second: Polynomial) -> Polynomial:
        """Return an operation on two polynomials; a sum divided by itself, up to its sign, is ±1."""
        plain = first, second
        for one, other in (plain, plain[::-1]) if operation == "*" else ():
            (atom, part), *more = [*other.terms.items()] or [((), 0.0)]
            below = self._below.get(atom[0][0]) if len(atom) == 1 and atom[0][1] == 1 and not more else None
            if below is not None and (sign := _by_itself(one, below)):
                return Polynomial.from_expression(sign * part)
        if operation == "*" and (cube := self._cubed(first, second) or self._cubed(second, first)):
            return cube
        if operation == "/" and (sign := _by_itself(first, second)):
            return Polynomial.from_expression(sign)
        joined = _joined(operation, first, second)
        if operation == "/" and len(second.terms) > 1 and len(joined.terms) == 1 and first.number is not None:
            self._below[next(iter(joined.terms))[0][0]] = second.scale(1.0 / first.number)
        return joined

    def _cubed(self, one: Polynomial, other: Polynomial) -> Polynomial | None:
        """Return r³ for r times its radicand, r²; None for any other product."""
        if len(one.terms) != 1:
            return None
        (monomial, part), *_ = one.terms.items()
        root = monomial[0][0] if len(monomial) == 1 and monomial[0][1] == 1 else None
        inside = self._squares.get(root) if root is not None else None
        return Polynomial({((root, 3),): part}) if root is not None and inside is not None and inside == other else None

    def _trigonometric_value(self, operation: str, angle: Polynomial) -> Polynomial:
        """Return the sine or cosine of an angle; of a sum of symbols by the addition theorems."""
        symbol = angle.symbol
        if symbol is not None:
            sign = -1.0 if operation == "sin" and angle.terms[((symbol, 1),)] < 0.0 else 1.0
            return Polynomial.from_expression(Call("sin" if operation == "sin" else "cos", symbol)).scale(sign)
        parts = [Polynomial({monomial: part}) for monomial, part in angle.terms.items()]
        if len(parts) > 1 and all(part.symbol is not None for part in parts):
            first, rest = parts[0], total(parts[1:])
            s, c = self._trigonometric_value("sin", first), self._trigonometric_value("cos", first)
            s_rest, c_rest = self._trigonometric_value("sin", rest), self._trigonometric_value("cos", rest)
            return s * c_rest + c * s_rest if operation == "sin" else c * c_rest - s * s_rest
        return Polynomial.from_expression(Call("sin" if operation == "sin" else "cos", angle.expression()))

    def _root(self, inside: Polynomial) -> Polynomial:
        """Return the square root of a polynomial."""
        plain = square_root(inside, self.book.values)
        if plain is not None:
            return plain
        root = Root(inside.expression())
        self._squares[root] = inside
        return Polynomial.from_expression(root)


def _by_itself(one: Polynomial, other: Polynomial) -> float:
    """Return the ratio of two polynomials if it is 1 or -1; 0 for other ratios and for single terms."""
    if len(one.terms) < 2 or len(one.terms) != len(other.terms):
        return 0.0
    return 1.0 if not (one - other) else -1.0 if not (one + other) else 0.0


def _joined(operation: str, first: Polynomial, second: Polynomial) -> Polynomial:
    """Return the result of an operation (+, -, * or /) on two polynomials."""
    if operation == "*":
        return first * second
    if operation == "+":
        return first + second
    if operation == "-":
        return first - second
    if second.number is not None:
        return first.scale(1.0 / second.number)
    if len(second.terms) == 1:
        (monomial, part), *_ = second.terms.items()
        return first * Polynomial({tuple((atom, -power) for atom, power in monomial): 1.0 / part})
    return Polynomial.from_expression(Quotient(first.expression(), second.expression())) if first else NIL

"""The equations of motion of any mechanism, in the symbols of its text.

They are those that the exact engine integrates, recorded once for the mechanism and once for its twin; a number that is
the same function of what the text says in both is written as that function, see `writing.lexicon`.
"""

import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product
from typing import Self

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import State
from sim2reason.dsl.triples import Number as Quantity
from sim2reason.lazy import cached_property
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.lengths import Phase, RowTerms
from sim2reason.simulation.engines.exact.tape import Symbol as Recorded
from sim2reason.simulation.engines.exact.tape import Tape
from sim2reason.solutions.algebra.expressions import Expression, Quotient, Symbol
from sim2reason.solutions.algebra.functions import Call, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.writing.lexicon import Both, Lexicon, UnreadError
from sim2reason.solutions.writing.steps import Book, UnsolvedError

SUMMANDS = 5  # of a length along a line, at most
FEW = 2  # terms of what is written out wherever it stands


@dataclass(frozen=True, slots=True)
class Names:
    """What coordinates, their rates and accelerations, and the time are called."""

    places: tuple[Symbol, ...]
    rates: tuple[Symbol, ...]
    accelerations: tuple[Symbol, ...]
    time: Symbol


class EquationsOfMotion:
    """Mass matrix, loads and constraints, as polynomials of names.

    A number that is no simple function of what the text says `stands` as itself.
    """

    def __init__(self, lexicon: Lexicon, book: Book, phase: Phase, names: Names, *, plain: bool = False) -> None:
        """UnsolvedError if the twin moves by other equations; if they are to be `plain`, all is in numbers."""
        self._lexicon, self.book, self.names, self._plain = lexicon, book, names, plain
        self.mechanism = lexicon.mechanism
        self._here, one = _assembled(lexicon.mechanism, phase)
        self._there, two = (self._here, one) if plain else _assembled(lexicon.twin, phase)
        self._tapes = one, two
        self._known: dict[int, Polynomial] = {}
        self._below: dict[Expression, Polynomial] = {}  # what one is divided by
        self.named: dict[Expression, Symbol] = {}  # lengths, and what stands in several places
        self._shared: frozenset[int] = frozenset()
        self.stands = False

    def written_in(self, book: Book) -> Self:
        """The same, after a draft in a copy of the book."""
        self.book = book
        book.reserve(*(name.name for name in self.named.values()))
        return self

    def shorten(self) -> None:
        """Name what is long and stands in several places; before anything else is asked."""
        used = Counter(operand for _, *operands in self._tapes[0].nodes for operand in operands)
        self._shared = frozenset(node for node, times in used.items() if times > 1)

    def inertia(self, k: int) -> Polynomial:
        """What stands before the accelerations, with them."""
        here, there = self._here.full_mass()[k], self._there.full_mass()[k]
        pairs = zip(here, there, self.names.accelerations, strict=True)
        return total(self._read(a, b) * Polynomial.of(name) for a, b, name in pairs)

    def load(self, k: int) -> Polynomial:
        """What is given to act along a coordinate."""
        return self._read(self._here.force[k], self._there.force[k])

    def pull(self, row: int, k: int) -> Polynomial:
        """How a constraint's length grows with a coordinate."""
        here, there = (rows[row].along.get(k, 0.0) for rows in self._rows)
        return self._read(here, there)

    def held(self, row: int) -> tuple[Polynomial, Polynomial]:
        """What the accelerations must add up to: both sides of the second derivative of a constraint."""
        size = range(len(self.mechanism.coordinates))
        left = total(self.pull(row, k) * Polynomial.of(self.names.accelerations[k]) for k in size)
        return left, self._read(*(rows[row].target for rows in self._rows))

    @cached_property
    def _rows(self) -> tuple[list[RowTerms], list[RowTerms]]:
        starts = {line.name: 0.0 for line in self.mechanism.lines}
        return self._here.rows(starts), self._there.rows(starts)

    def pressing(self, face: int) -> Polynomial:
        """The normal force of a face, but for what constraints add to it."""
        size = range(len(self.mechanism.coordinates))
        parts = [
            self._read(self._here.lifted[face][k], self._there.lifted[face][k])
            * Polynomial.of(self.names.accelerations[k])
            for k in size
        ]
        return total(parts) - self._read(self._here.press[face], self._there.press[face])

    def lifted(self, row: int, face: int) -> Polynomial:
        """How a constraint lifts what lies on a face."""
        return self._read(*(rows[row].lift.get(face, 0.0) for rows in self._rows))

    # ---- from tapes to names

    def _read(self, here: Quantity, there: Quantity) -> Polynomial:
        if isinstance(here, Recorded) and isinstance(there, Recorded):
            return self._node(here.id, there.id)
        if isinstance(here, Recorded) or isinstance(there, Recorded):
            raise UnsolvedError("the equations of motion are of another kind with other numbers")
        return self.number(Both(float(here), float(there)))  # type: ignore[arg-type]

    def number(self, both: Both) -> Polynomial:
        """In the symbols of the text, or as it is."""
        try:
            if not self._plain:
                return self._lexicon.read(both)
        except UnreadError:
            pass
        self.stands = True
        return Polynomial.of(both.here)

    def _node(self, here: int, there: int) -> Polynomial:
        if here not in self._known:
            made = self._made(here, there)
            self._known[here] = self._called(made, "Z") if here in self._shared and len(made.terms) > FEW else made
        return self._known[here]

    def _made(self, here: int, there: int) -> Polynomial:
        one, two = self._tapes
        (operation, a, b), (other, c, d) = one.nodes[here], two.nodes[there]
        if operation != other:
            raise UnsolvedError("the equations of motion are of another kind with other numbers")
        if operation == "input":
            names = (self.names.time, *self.names.places, *self.names.rates)
            return Polynomial.of(names[a])
        if operation == "constant":
            return self.number(Both(one.constants[a], two.constants[c]))
        first = self._node(a, c)
        if operation in ("sin", "cos"):
            return self._turned(operation, first)
        if operation == "sqrt":
            return self._root(first)
        if operation == "neg":
            return first.scaled(-1.0)
        return self._joined(operation, first, self._node(b, d))

    def _joined(self, operation: str, first: Polynomial, second: Polynomial) -> Polynomial:
        """Along a line, a direction is a length by itself: 1 or -1."""
        plain = first, second
        for one, other in (plain, plain[::-1]) if operation == "*" else ():
            (atom, part), *more = [*other.terms.items()] or [((), 0.0)]
            below = self._below.get(atom[0][0]) if len(atom) == 1 and atom[0][1] == 1 and not more else None
            if below is not None and (sign := _by_itself(one, below)):
                return Polynomial.of(sign * part)
        if operation == "/" and (sign := _by_itself(first, second)):
            return Polynomial.of(sign)
        found = _joined(operation, first, second)
        if operation == "/" and len(second.terms) > 1 and len(found.terms) == 1 and first.number is not None:
            self._below[next(iter(found.terms))[0][0]] = second.scaled(1.0 / first.number)
        return found

    def _turned(self, operation: str, angle: Polynomial) -> Polynomial:
        symbol = angle.symbol
        sign = 1.0
        if symbol is not None and angle.terms[((symbol, 1),)] < 0.0:
            sign = -1.0 if operation == "sin" else 1.0
        argument: Expression = symbol if symbol is not None else angle.expression()
        return Polynomial.of(Call("sin" if operation == "sin" else "cos", argument)).scaled(sign)

    def _root(self, inside: Polynomial) -> Polynomial:
        plain = square_root(inside, self.book.values)
        if plain is not None:
            return plain
        return self._called(Polynomial.of(Root(inside.expression())), r"\ell")

    def _called(self, held: Polynomial, base: str) -> Polynomial:
        """By a name."""
        formula = held.expression()
        if formula not in self.named:
            name = self.named[formula] = self.book.fresh(base)
            self.book.know(name.name, self.book.value(formula))
        return Polynomial.of(self.named[formula])


def square_root(inside: Polynomial, at: Mapping[str, float]) -> Polynomial | None:
    """What a polynomial is the square of, positive `at` known values; None if it is none."""
    plain = [(m, part) for m, part in inside.terms.items() if part > 0.0 and all(power % 2 == 0 for _, power in m)]
    if not 1 <= len(plain) <= SUMMANDS:
        return None
    roots = [Polynomial({tuple((atom, power // 2) for atom, power in m): math.sqrt(part)}) for m, part in plain]
    for signs in product((1.0, -1.0), repeat=len(roots) - 1):
        found = total(root.scaled(sign) for root, sign in zip(roots, (1.0, *signs), strict=True))
        if not (found * found - inside):
            return found if found.value(at) > 0.0 else found.scaled(-1.0)
    return None


def _by_itself(one: Polynomial, other: Polynomial) -> float:
    """1 or -1, where that is what one by the other comes to; else 0."""
    if len(one.terms) < 2 or len(one.terms) != len(other.terms):
        return 0.0
    return 1.0 if not (one - other) else -1.0 if not (one + other) else 0.0


def _joined(operation: str, first: Polynomial, second: Polynomial) -> Polynomial:
    if operation == "*":
        return first * second
    if operation == "+":
        return first + second
    if operation == "-":
        return first - second
    if second.number is not None:
        return first.scaled(1.0 / second.number)
    if len(second.terms) == 1:
        (monomial, part), *_ = second.terms.items()
        return first * Polynomial({tuple((atom, -power) for atom, power in monomial): 1.0 / part})
    return Polynomial.of(Quotient(first.expression(), second.expression())) if first else NIL


def _assembled(mechanism: Mechanism, phase: Phase) -> tuple[Assembly, Tape]:
    size = len(mechanism.coordinates)
    tape = Tape(["t", *(f"q{k}" for k in range(size)), *(f"v{k}" for k in range(size))])
    symbols = list(tape.inputs.values())
    return Assembly(mechanism, phase, (symbols[1 : size + 1], symbols[size + 1 :], symbols[0]), tape), tape


def phase_at(state: State) -> Phase:
    """What acts at an instant: fields, engines that burn, and springs that act one way; nothing sticks."""
    m, time = state.mechanism, float(state.times[0])
    inside: list[tuple[bool, ...]] = []
    for force in m.forces:
        place = state.vector(state.frames.center(force.body).place)[0]
        margins = force.region.margins((place[0], place[1], place[2]), math) if force.region is not None else ()
        inside.append((all(float(margin) >= 0.0 for margin in margins),))  # type: ignore[arg-type]
    lengths = {line.name: float(state.free_length(line)[0][0]) for line, _ in m.half_springs}
    return Phase(
        inside=tuple(inside),
        burning=tuple(time < burn.until for burn in m.burns),
        stuck=(False,) * len(m.meetings),
        strained=tuple(law.side * (lengths[line.name] - law.length) >= 0.0 for line, law in m.half_springs),
    )

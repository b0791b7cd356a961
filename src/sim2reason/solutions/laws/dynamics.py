"""Accelerations and forces in one segment of a motion, from Newton's laws of the relevant bodies."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isclose, pi

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.vectors import dot
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import Number, Product, Symbol
from sim2reason.solutions.algebra.functions import PI, Power
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.laws.newton import Newton, Row, symbol
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.writing.notation import ACCELERATION, NEWTONS, latex
from sim2reason.solutions.writing.steps import SolutionBuilder

RATE_RTOL = 1e-9  # relative: largest difference of coefficients that count as equal


@dataclass(slots=True)
class SharedRate:
    """The common rate of several coordinates: its symbol, and by coordinate the sign relative to the symbol."""

    symbol: Symbol
    sense: dict[int, int]


@dataclass(frozen=True, slots=True)
class LawQuantity:
    """The kind of quantity that laws relate: accelerations, or displacements in motions where no force matters.

    `values` has the engine's values by coordinate; `known` is a coordinate whose value has a symbol already.
    """

    base: str
    unit: str
    noun: str
    values: tuple[float, ...] = ()
    known: tuple[int, Symbol] | None = None


ACCELERATIONS = LawQuantity("a", ACCELERATION, "acceleration")


def equal_rates(row: Row) -> tuple[tuple[int, int], int] | None:
    """Return the two coordinates that a string keeps at equal speed, and 1 or −1 for their signs; else None."""
    if row.kind not in ("string", "grip") or len(row.inertia.terms) != 2:
        return None
    parts = [(int(m[0][0].latex()[1:]), part) for m, part in row.inertia.terms.items() if len(m) == 1 and m[0][1] == 1]
    if len(parts) != 2 or abs(abs(parts[0][1]) - abs(parts[1][1])) > RATE_RTOL:
        return None
    return (parts[0][0], parts[1][0]), -1 if parts[0][1] * parts[1][1] > 0.0 else 1


def gravitational_constant(book: SolutionBuilder, value: float) -> Symbol:
    """Return the symbol of the gravitational constant and state its value on first use."""
    if "G" not in book.values:
        book.reserve("G")
        book.set_value("G", value)
        mantissa, _, power = f"{value:.8g}".partition("e")
        decimal_text = rf"{mantissa} \times 10^{{{int(power)}}}" if power else mantissa
        plain = isclose(value, 4.0 * pi**2)
        unit = latex("au^3/(Msun yr^2)" if plain else "N m^2/kg^2")
        book.stated["G"] = (r"4 \pi^{2}" if plain else decimal_text) + unit
        book.constants["G"] = Product((Number(4.0), Power(PI, 2))) if plain else Number(value)
    return Symbol("G")


AXES = ("x", "y")  # names of axes that a text may use


class Dynamics:
    """Newton's laws of one segment of a motion, with the symbols of their unknowns."""

    def __init__(
        self, setting: ProblemContext, book: SolutionBuilder, segment: Segment, measure: LawQuantity = ACCELERATIONS
    ) -> None:
        """Take the problem, the solution in progress and the segment; UnreadError for other kinds of mechanisms."""
        self.setting, self.book, self.segment = setting, book, segment
        self.newton = Newton(setting.lexicon, segment)
        self.mechanism = setting.mechanism
        self.names: dict[str, Polynomial] = {}  # unknowns of Newton's laws in the symbols of the book
        self.bound: dict[str, Polynomial] = {}  # accelerations in terms of others bound by strings
        self.shared: list[SharedRate] = []
        self.groups: list[list[Row]] = []
        self.sense: dict[int, int] = {}
        self.measure = measure
        self._units: dict[str, str] = {}

    # ---- which laws

    @cached_property
    def frozen(self) -> set[int]:
        """Return the indices of the coordinates that friction or a string holds at rest."""
        at_rest = {
            k
            for face, side in self.newton.slip_directions.items()
            if side == 0 and (k := self.newton.single_slip_coordinate(face)) is not None
        }
        rows = [self.newton.string(index).inertia for index in self.taut]
        for _ in rows:  # bodies at rest can hold others
            left = [row.substitute({f"q{k}": NIL for k in at_rest}) for row in rows]
            at_rest |= {int(next(n for n in row.names() if n[0] == "q")[1:]) for row in left if len(row.terms) == 1}
        return at_rest

    @cached_property
    def unforced(self) -> set[int]:
        """Return the indices of coordinates along x or y along which no force acts on the coordinate's body."""
        if self.measure.values:
            return set()
        laws = {k: self.newton.newton(k) for k, c in enumerate(self.mechanism.coordinates) if c.label in AXES}
        every = {f"q{k}" for k in range(len(self.mechanism.coordinates))}
        return {k for k, row in laws.items() if not row.forces and row.inertia.names() & every <= {f"q{k}"}}

    @cached_property
    def carrier_coordinates(self) -> dict[int, tuple[int, float]]:
        """Return, for each coordinate parallel to its carrier's, the carrier's coordinate and the relative sign.

        For slabs on each other on a slope, texts give the acceleration of each slab, not the relative one.
        """
        carriers: dict[int, tuple[int, float]] = {}
        if self.measure.values:
            return carriers
        for k, coordinate in enumerate(self.mechanism.coordinates):
            if (
                k in self.frozen
                or coordinate.kind != "slide"
                or len(self.mechanism.body[coordinate.body].coordinates) > 1
            ):
                continue
            below = [j for j in self._below(coordinate.body) if j not in self.frozen]
            along = [dot(coordinate.axis, self.mechanism.coordinates[j].axis) for j in below]
            if below and all(abs(abs(part) - 1.0) < RATE_RTOL for part in along):
                sign = float(round(along[0]))
                if self._tied_outside(k, below[0], sign):
                    carriers[k] = below[0], sign
        return carriers

    def _tied_outside(self, k: int, j: int, sign: float) -> bool:
        """Return whether taut strings depend on a body's motion relative to the world, not to its carrier."""
        for index in self.taut:
            terms = self.newton.string(index).inertia
            own, other = terms.coefficient(f"q{k}"), terms.coefficient(f"q{j}")
            if own and own - other.scale(sign):
                return False
        return True

    def _below(self, body: str) -> list[int]:
        """Return the coordinates of the bodies that carry a body, the nearest first."""
        coordinates: list[int] = []
        step = self.mechanism.body[body].parent
        while step is not None:
            coordinates += [self.mechanism.number[c.name] for c in reversed(self.mechanism.body[step].coordinates)]
            step = self.mechanism.body[step].parent
        return coordinates

    @property
    def taut(self) -> list[int]:
        """Return the indices of the strings that are taut in this segment."""
        acting = self.segment.found.mode.acting
        return [index for index in range(len(self.newton.lines)) if acting[index]]

    def laws(self, goals: Sequence[str]) -> tuple[list[Row], list[str]]:
        """Return all laws of this segment, and their unknowns."""
        newton, size = self.newton, len(self.mechanism.coordinates)
        sticking = [face for face, side in newton.slip_directions.items() if side == 0]
        pressing = {face for face, side in newton.slip_directions.items() if side}
        pressing |= {int(goal[1:]) for goal in goals if goal[0] == "N"}
        rows = [newton.newton(k) for k in range(size)]
        rows += [newton.normal(face) for face in sorted(pressing)]
        rows += [newton.string(index) for index in self.taut]
        rows += [newton.rolling(face) for face in sticking if newton.single_slip_coordinate(face) is None]
        still = {f"q{k}": NIL for k in self.frozen}
        for k, (j, sign) in self.carrier_coordinates.items():  # converted to that relative to the ground
            still[f"q{k}"] = symbol("q", k) - symbol("q", j).scale(sign)
        rows = [Row(r.kind, r.number, r.forces.substitute(still), r.inertia.substitute(still)) for r in rows]
        unknowns = [f"q{k}" for k in range(size) if k not in self.frozen]
        if self.measure.values:
            rows = [row for row in rows if row.kind == "string" or (row.kind == "newton" and not row.forces)]
            return rows, [
                name for name in unknowns if self.measure.known is None or name != f"q{self.measure.known[0]}"
            ]
        unknowns += [f"T{index}" for index in self.taut] + [f"N{face}" for face in sorted(pressing)]
        return rows, unknowns + [f"f{face}" for face in sticking]

    @cached_property
    def values(self) -> dict[str, float]:
        """Return the values of the unknowns, in SI units, as the engine computed them."""
        pairs = zip(self.measure.values, self.newton.scale, strict=False)
        values_by_name = self.newton.values | {f"q{k}": value * scale.value for k, (value, scale) in enumerate(pairs)}
        for k, (j, sign) in self.carrier_coordinates.items():  # carriers come first
            values_by_name[f"q{k}"] += sign * values_by_name[f"q{j}"]
        return values_by_name

    def relative_to_ground(self, values: Sequence[float]) -> list[float]:
        """Convert rates relative to carriers to rates relative to the ground."""
        converted = list(values)
        for k, (j, sign) in self.carrier_coordinates.items():
            converted[k] += sign * converted[j]
        return converted

    def by_themselves(self, relative: Mapping[int, Polynomial]) -> Mapping[int, Polynomial]:
        """Convert symbolic velocities or displacements relative to carriers to those relative to the ground."""
        converted = dict(relative)
        for k, (j, sign) in self.carrier_coordinates.items():
            if k in converted or j in converted:
                converted[k] = converted.get(k, NIL) + converted.get(j, NIL).scale(sign)
        return converted

    # ---- names

    def name_shared_rates(self, rows: Sequence[Row], goals: Sequence[str], laws: Sequence[Row]) -> None:
        """Give coordinates that strings bind to equal rates one common symbol."""
        members: dict[int, dict[int, int]] = {}
        used = {name for row in rows for name in row.zero.names() if name[0] == "q" and name[1:].isdigit()}
        known = {f"q{self.measure.known[0]}"} if self.measure.known else set[str]()
        for k in sorted(int(name[1:]) for name in used | known | {goal for goal in goals if goal[0] == "q"}):
            members[k] = {k: 1}
        for row in laws:  # also strings that the answer does not need: equal rates share a symbol
            pair = equal_rates(row)
            if pair is None:
                continue
            (one, other), sign = pair
            if one not in members or other not in members or members[one] is members[other]:
                continue
            turned = sign * members[one][one] * members[other][other]
            members[one] |= {k: turned * s for k, s in members[other].items()}
            for k in members[one]:
                members[k] = members[one]
        classes = {id(group): group for group in members.values()}.values()
        for group in classes:
            self._called(group, alone=len(classes) == 1, goals=goals)

    def _called(self, held: dict[int, int], *, alone: bool, goals: Sequence[str]) -> None:
        """Give several coordinates with one common rate a symbol, named after one of their bodies."""
        bodies = [self.mechanism.coordinates[k].body for k in held]
        goal = next(
            (self.mechanism.coordinates[int(g[1:])].body for g in goals if g[0] == "q" and int(g[1:]) in held), ""
        )
        mentioned = [body for body in bodies if body in self.setting.words.mentions]
        name = goal if goal in mentioned else next(iter(mentioned), bodies[0])
        told_already = self.measure.known is not None and self.measure.known[0] in held
        if told_already and self.measure.known is not None:
            named = self.measure.known[1]
        else:
            named = self.book.fresh(self.measure.base, "" if alone else self.setting.subscript_of(name))
        turn = self._turn(held)
        self.shared.append(SharedRate(named, {k: turn * s for k, s in held.items()}))
        self.sense |= self.shared[-1].sense
        self._units[named.name] = self.measure.unit
        for k, sense in self.shared[-1].sense.items():
            self.names[f"q{k}"] = Polynomial.from_expression(named).scale(float(sense))

    def _turn(self, held: dict[int, int]) -> int:
        """Return the sign of the rate with which coordinates of one common rate move, or begin to."""
        for values in (
            self.relative_to_ground(self.segment.v),
            [self.values[f"q{k}"] for k in range(len(self.segment.v))],
        ):
            rate = next((s * values[k] for k, s in held.items() if abs(values[k]) > RATE_RTOL), 0.0)
            if rate:
                return 1 if rate > 0.0 else -1
        return 1

    def name(self, rows: Sequence[Row], goals: Sequence[str]) -> None:
        """Name the forces in the laws: tensions by numbers, other forces by their bodies."""
        self.groups = self._grouped([row for row in rows if row.kind == "newton"], goals)
        used = {name for group in self.groups for name in self.sum_laws(group).zero.names()} | set(goals)
        tensions = sorted((n for n in used if n[0] == "T" and n[1:].isdigit()), key=lambda n: int(n[1:]))
        marks = [""] if len(tensions) == 1 else [str(number) for number in range(1, len(tensions) + 1)]
        for name, mark in zip(tensions, marks, strict=True):
            self._force(name, "T", mark)
        for name in sorted({name for row in rows for name in row.zero.names()}):
            if name[0] in "Nf" and name[1:].isdigit():
                self._force(name, name[0], self.setting.subscript_of(self.mechanism.faces[int(name[1:])].subject))

    def sum_laws(self, group: Sequence[Row]) -> Row:
        """Return the sum of Newton's laws of a group of bodies."""
        forces, inertia = total(row.forces for row in group), total(row.inertia for row in group)
        return Row("newton", group[0].number, forces, inertia)

    def _grouped(self, rows: Sequence[Row], goals: Sequence[str]) -> list[list[Row]]:
        """Return Newton's laws in groups; tensions between blocks in a row on one string cancel within a group."""
        groups = [[row] for row in rows]
        for name in sorted({n for row in rows for n in row.zero.names() if n[0] == "T" and n[1:].isdigit()} - {*goals}):
            holding = [group for group in groups if name in self.sum_laws(group).zero.names()]
            if len(holding) != 2:
                continue
            a, b = holding
            if self._moves_alike(a[0].number, b[0].number) and name not in self.sum_laws([*a, *b]).zero.names():
                groups[groups.index(a)] = sorted(a + b, key=lambda row: row.number)
                groups.remove(b)
        return groups

    def _moves_alike(self, one: int, other: int) -> bool:
        """Return whether two coordinates move their bodies in the same direction along parallel lines at one rate."""
        a, b = self.mechanism.coordinates[one], self.mechanism.coordinates[other]
        parents = [self.mechanism.body[c.body].parent for c in (a, b)]
        straight = a.kind == b.kind == "slide" and parents[0] == parents[1] and _close(a.axis, b.axis)
        same = one in self.sense and other in self.sense and self.names[f"q{one}"] == self.names[f"q{other}"]
        return straight and same and all(self.mechanism.body[c.body].mass for c in (a, b))

    def _force(self, name: str, base: str, mark: str) -> None:
        """Give a force a new symbol."""
        named = self.book.fresh(base, mark)
        sense = -1.0 if base == "f" and self.values[name] < 0.0 else 1.0
        self.names[name] = Polynomial.from_expression(named).scale(sense)
        self._units[named.name] = NEWTONS

    @property
    def units(self) -> dict[str, str]:
        """Return the unit of each unknown, in LaTeX."""
        return self._units

    def moving(self, k: int, sense: int) -> str:
        """Return words for the direction of motion along a coordinate, such as *in the positive x direction*."""
        coordinate = self.mechanism.coordinates[k]
        x, y, z = coordinate.axis
        labels = [each.label for each in self.mechanism.body[coordinate.body].coordinates]
        if coordinate.label in AXES and {*AXES} <= {*labels}:
            return f"in the {'positive' if sense > 0 else 'negative'} {coordinate.label} direction"
        parent = self.mechanism.body[coordinate.body].parent if k not in self.carrier_coordinates else None
        return self.setting.direction_words((sense * x, sense * y, sense * z), on=parent)

    def sufficient_coordinates(self, coordinates: Sequence[int]) -> list[int]:
        """Return the coordinates without those of carriers whose motion another coordinate already includes."""
        carriers = [k for k in coordinates if k in self.carrier_coordinates]
        spared = {j for k in carriers for j in self._below(self.mechanism.coordinates[k].body)}
        return [k for k in coordinates if k not in spared]


def _close(one: Sequence[float], other: Sequence[float]) -> bool:
    """Return whether two vectors are equal up to rounding errors."""
    return all(abs(a - b) < RATE_RTOL for a, b in zip(one, other, strict=True))

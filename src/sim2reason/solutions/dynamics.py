"""Accelerations and forces of one segment of a motion, from Newton's laws of the bodies that matter."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.book import Book, UnsolvedError
from sim2reason.solutions.elimination import Elimination, Equation, solved
from sim2reason.solutions.expressions import Expression, Symbol, multiplied
from sim2reason.solutions.lexicon import UnreadError
from sim2reason.solutions.newton import Newton, Row
from sim2reason.solutions.polynomials import NIL, Polynomial, divided, total
from sim2reason.solutions.selection import needed
from sim2reason.solutions.setting import Setting, capital

NEWTONS, METRES = r"\ \text{N}", r"\ \text{m/s}^2"
STILL = 1e-9


@dataclass(slots=True)
class Shared:
    """Coordinates that change at one rate, up to a sign: `sense` of each, by its number."""

    symbol: Symbol
    sense: dict[int, int]


@dataclass(frozen=True, slots=True)
class Measure:
    """What of coordinates the laws are about: accelerations, or displacements where no force has a part.

    `values` are the engine's, by coordinate; `known` is a coordinate whose value has a name already.
    """

    base: str
    unit: str
    noun: str
    values: tuple[float, ...] = ()
    known: tuple[int, Symbol] | None = None


ACCELERATIONS = Measure("a", METRES, "acceleration")


class Dynamics:
    """Writes the steps from Newton's laws to what is wanted."""

    def __init__(self, setting: Setting, book: Book, segment: Segment, measure: Measure = ACCELERATIONS) -> None:
        """UnreadError if the mechanism is of another kind."""
        self.setting, self.book, self.segment = setting, book, segment
        self.newton = Newton(setting.lexicon, segment)
        self.mechanism = setting.mechanism
        self.names: dict[str, Polynomial] = {}  # of the unknowns of Newton's laws, in the symbols of the book
        self.shared: list[Shared] = []
        self.groups: list[list[Row]] = []
        self.sense: dict[int, int] = {}
        self.measure = measure
        self._units: dict[str, str] = {}

    # ---- which laws

    @cached_property
    def frozen(self) -> set[int]:
        """The coordinates that do not change, as friction or a string holds them."""
        held = {k for face, side in self.newton.rough.items() if side == 0 and (k := self.newton.alone(face)) is not None}
        rows = [self.newton.string(place).inertia for place in self._taut]
        for _ in rows:  # what is held can hold more
            left = [row.put({f"q{k}": NIL for k in held}) for row in rows]
            held |= {int(next(n for n in row.names() if n[0] == "q")[1:]) for row in left if len(row.terms) == 1}
        return held

    @property
    def _taut(self) -> list[int]:
        acting = self.segment.found.mode.acting
        return [place for place in range(len(self.newton.lines)) if acting[place]]

    def _laws(self, goals: Sequence[str]) -> tuple[list[Row], list[str]]:
        """All laws of this segment, and their unknowns."""
        newton, size = self.newton, len(self.mechanism.coordinates)
        sticking = [face for face, side in newton.rough.items() if side == 0]
        pressing = {face for face, side in newton.rough.items() if side}
        pressing |= {int(goal[1:]) for goal in goals if goal[0] == "N"}
        rows = [newton.newton(k) for k in range(size)]
        rows += [newton.normal(face) for face in sorted(pressing)]
        rows += [newton.string(place) for place in self._taut]
        rows += [newton.rolling(face) for face in sticking if newton.alone(face) is None]
        still = {f"q{k}": NIL for k in self.frozen}
        rows = [Row(r.kind, r.number, r.forces.put(still), r.inertia.put(still)) for r in rows]
        unknowns = [f"q{k}" for k in range(size) if k not in self.frozen]
        if self.measure.values:
            rows = [row for row in rows if row.kind == "string" or (row.kind == "newton" and not row.forces)]
            return rows, [name for name in unknowns if self.measure.known is None or name != f"q{self.measure.known[0]}"]
        unknowns += [f"T{place}" for place in self._taut] + [f"N{face}" for face in sorted(pressing)]
        return rows, unknowns + [f"f{face}" for face in sticking]

    def reach(self, goals: Sequence[str]) -> None:
        """Write the way to some unknowns, such as ``q3`` or ``T1``; their `names` are known then."""
        goals = [goal for goal in dict.fromkeys(goals) if not (goal[0] == "q" and int(goal[1:]) in self.frozen)]
        self.names |= {f"q{k}": NIL for k in self.frozen}
        if not goals:
            return
        rows, unknowns = self._laws(goals)
        givens = {g.symbol: g.value for g in self.setting.lexicon.givens.values()}
        chosen = needed(rows, unknowns, {**givens, **self.values}, [goal for goal in goals if goal in unknowns])
        self._share(chosen, goals)
        self._name(chosen, goals)
        _Telling(self, chosen, goals).write()
        for name, held in self.names.items():
            for monomial, part in held.terms.items():
                self.book.observed.setdefault(monomial[0][0].latex(), self.values[name] / part)

    @cached_property
    def values(self) -> dict[str, float]:
        """What the engine has for the unknowns."""
        pairs = zip(self.measure.values, self.newton.scale, strict=False)
        return self.newton.values | {f"q{k}": value * scale.here for k, (value, scale) in enumerate(pairs)}

    # ---- names

    def _share(self, rows: Sequence[Row], goals: Sequence[str]) -> None:
        """Coordinates that strings bind to each other at equal rates go by one name."""
        members: dict[int, dict[int, int]] = {}
        used = {name for row in rows for name in row.zero.names() if name[0] == "q" and name[1:].isdigit()}
        known = {f"q{self.measure.known[0]}"} if self.measure.known else set[str]()
        for k in sorted(int(name[1:]) for name in used | known | {goal for goal in goals if goal[0] == "q"}):
            members[k] = {k: 1}
        for row in rows:
            pair = _equal(row)
            if pair is None:
                continue
            (one, other), sign = pair
            if members[one] is members[other]:
                continue
            turned = sign * members[one][one] * members[other][other]
            members[one] |= {k: turned * s for k, s in members[other].items()}
            for k in members[one]:
                members[k] = members[one]
        classes = {id(held): held for held in members.values()}.values()
        for held in classes:
            self._called(held, alone=len(classes) == 1, goals=goals)

    def _called(self, held: dict[int, int], *, alone: bool, goals: Sequence[str]) -> None:
        bodies = [self.mechanism.coordinates[k].body for k in held]
        goal = next((self.mechanism.coordinates[int(g[1:])].body for g in goals if g[0] == "q" and int(g[1:]) in held), "")
        told = [body for body in bodies if body in self.setting.words.mentions]
        name = goal if goal in told else next(iter(told), bodies[0])
        told_already = self.measure.known is not None and self.measure.known[0] in held
        if told_already and self.measure.known is not None:
            symbol = self.measure.known[1]
        else:
            symbol = self.book.fresh(self.measure.base, "" if alone else self.setting.mark(name))
        turn = self._turn(held)
        self.shared.append(Shared(symbol, {k: turn * s for k, s in held.items()}))
        self.sense |= self.shared[-1].sense
        self._units[symbol.name] = self.measure.unit
        for k, sense in self.shared[-1].sense.items():
            self.names[f"q{k}"] = Polynomial.of(symbol).scaled(float(sense))

    def _turn(self, held: dict[int, int]) -> int:
        """The sense in which they move, or begin to."""
        for values in (self.segment.v, [self.values[f"q{k}"] for k in range(len(self.segment.v))]):
            found = next((s * values[k] for k, s in held.items() if abs(values[k]) > STILL), 0.0)
            if found:
                return 1 if found > 0.0 else -1
        return 1

    def _name(self, rows: Sequence[Row], goals: Sequence[str]) -> None:
        """Tensions that do not cancel at once are numbered; other forces are named after their bodies."""
        self.groups = self._grouped([row for row in rows if row.kind == "newton"], goals)
        used = {name for group in self.groups for name in self.added(group).zero.names()} | set(goals)
        tensions = sorted((n for n in used if n[0] == "T" and n[1:].isdigit()), key=lambda n: int(n[1:]))
        marks = [""] if len(tensions) == 1 else [str(number) for number in range(1, len(tensions) + 1)]
        for name, mark in zip(tensions, marks, strict=True):
            self._force(name, "T", mark)
        for name in sorted({name for row in rows for name in row.zero.names()}):
            if name[0] in "Nf" and name[1:].isdigit():
                self._force(name, name[0], self.setting.mark(self.mechanism.faces[int(name[1:])].subject))

    def added(self, group: Sequence[Row]) -> Row:
        """The sum of Newton's laws of a group."""
        forces, inertia = total(row.forces for row in group), total(row.inertia for row in group)
        return Row("newton", group[0].number, forces, inertia)

    def _grouped(self, rows: Sequence[Row], goals: Sequence[str]) -> list[list[Row]]:
        """Newton's laws, those of a row of blocks on one string together, so that its tension is gone."""
        groups = [[row] for row in rows]
        for name in sorted({n for row in rows for n in row.zero.names() if n[0] == "T" and n[1:].isdigit()} - {*goals}):
            holding = [group for group in groups if name in self.added(group).zero.names()]
            if len(holding) != 2:
                continue
            one, other = holding
            if self._alike(one[0].number, other[0].number) and name not in self.added([*one, *other]).zero.names():
                groups[groups.index(one)] = sorted(one + other, key=lambda row: row.number)
                groups.remove(other)
        return groups

    def _alike(self, one: int, other: int) -> bool:
        """Whether two coordinates move their bodies side by side along one line."""
        a, b = self.mechanism.coordinates[one], self.mechanism.coordinates[other]
        parents = [self.mechanism.body[c.body].parent for c in (a, b)]
        straight = a.kind == b.kind == "slide" and parents[0] == parents[1] and _close(a.axis, b.axis)
        same = one in self.sense and other in self.sense and self.names[f"q{one}"] == self.names[f"q{other}"]
        return straight and same and all(self.mechanism.body[c.body].mass for c in (a, b))

    def _force(self, name: str, base: str, mark: str) -> None:
        symbol = self.book.fresh(base, mark)
        sense = -1.0 if base == "f" and self.values[name] < 0.0 else 1.0
        self.names[name] = Polynomial.of(symbol).scaled(sense)
        self._units[symbol.name] = NEWTONS

    @property
    def units(self) -> dict[str, str]:
        """The unit of every unknown, in LaTeX."""
        return self._units

    def moving(self, k: int, sense: int) -> str:
        """The direction of a coordinate, in words."""
        coordinate = self.mechanism.coordinates[k]
        x, y, z = coordinate.axis
        parent = self.mechanism.body[coordinate.body].parent
        return self.setting.towards((sense * x, sense * y, sense * z), on=parent)


def _equal(row: Row) -> tuple[tuple[int, int], int] | None:
    """The two coordinates that a string binds at equal rates, and whether with equal signs; None if it does not."""
    if row.kind not in ("string", "grip") or len(row.inertia.terms) != 2:
        return None
    parts = [(int(m[0][0].latex()[1:]), part) for m, part in row.inertia.terms.items() if len(m) == 1 and m[0][1] == 1]
    if len(parts) != 2 or abs(abs(parts[0][1]) - abs(parts[1][1])) > STILL:
        return None
    return (parts[0][0], parts[1][0]), -1 if parts[0][1] * parts[1][1] > 0.0 else 1


class _Telling:
    """The sentences about chosen laws, and the equations that they say."""

    def __init__(self, dynamics: Dynamics, rows: Sequence[Row], goals: Sequence[str]) -> None:
        self.d, self.rows = dynamics, rows
        self.names = dynamics.names
        self.goals = [_name_of(dynamics.names[goal]) for goal in goals]
        self.inline: dict[str, Polynomial] = {}  # normal forces that weights alone give
        self.pressed: dict[str, Polynomial] = {}  # the others, in terms of accelerations
        self.bound: dict[str, Polynomial] = {}  # accelerations by others

    def write(self) -> None:
        """Write everything."""
        self._introduce()
        equations = [*self._strings(), *self._faces()]
        groups = self.d.groups
        known = self.bound | {name: pressed for name, pressed in self.pressed.items()}
        rows = [self._equation(group, number, len(groups)) for number, group in enumerate(groups, start=1)]
        self._tell(groups, rows)
        light = [e for group, e in zip(groups, rows, strict=True) if not self._mass(group)]
        known |= self._balanced(light, known)
        heavy = [e.put(known).put(known) for e in rows if e not in light]
        all_of_them = heavy + equations + [Equation(e.label, e.forces, e.inertia, NIL) for e in light]
        unknowns = sorted({n for e in all_of_them for n in e.zero.names()} & self.d.units.keys())
        Elimination(self.d.book, self.d.units).solve(all_of_them, unknowns, self.goals)

    # ---- what things are called

    def _introduce(self) -> None:
        step = self.d.book.open("names")
        said = [f"${shared.symbol.name}$ {self._whose(shared)}" for shared in self.d.shared]
        if len(said) == 1:
            step.say(f"Let {said[0].replace('$ of', '$ be the acceleration of', 1)}.")
        elif said:
            step.say(f"{capital(self.d.measure.noun)}s: {'; '.join(said)}.")
        tensions = [f"${_name_of(self.names[n])}$ in {self._line(n)}" for n in self.names if n[0] == "T"]
        if tensions:
            step.say(f"Tension{'s' if len(tensions) > 1 else ''}: {'; '.join(tensions)}.")
        step.close()

    def _line(self, name: str) -> str:
        return self.d.setting.lines[self.d.newton.lines[int(name[1:])].name]

    def _whose(self, shared: Shared) -> str:
        """Of block A downward and of block B up the slope."""
        ways: dict[str, list[str]] = {}
        for k, sense in shared.sense.items():
            coordinate = self.d.mechanism.coordinates[k]
            if coordinate.kind == "hinge":
                continue
            parent = self.d.mechanism.body[coordinate.body].parent
            way = self.d.moving(k, sense)
            if parent is not None and self._moves(parent):
                way += f" relative to {self.d.setting.called(parent)}"
            ways.setdefault(way, []).append(coordinate.body)
        return " and ".join(f"of {self.d.setting.listed(bodies)} {way}" for way, bodies in ways.items())

    def _moves(self, body: str) -> bool:
        return any(k not in self.d.frozen for k in self.d.newton.moved(body))

    # ---- constraints

    def _strings(self) -> list[Equation]:
        """Strings that bind accelerations at other ratios than one."""
        found: list[Equation] = []
        step = self.d.book.open("constraint")
        for row in self.rows:
            if row.kind not in ("string", "grip"):
                continue
            zero = row.inertia.put(self.names)
            if not zero:
                continue
            zero = zero.put(self.bound)
            name = self._dependent(zero)
            rest = solved(zero, name)
            before = zero.coefficient(name).number
            assert before is not None
            self.bound[name] = zero.without((name,)).scaled(-1.0 / before)
            self.bound = {n: p.put({name: self.bound[name]}) for n, p in self.bound.items()}
            what = f"{capital(self._line(f'T{row.number}'))} does not stretch"
            step.say(f"{what}: {step.law(Symbol(name), rest)}.")
            found.append(Equation("", NIL, zero, NIL))
        step.close()
        return found

    def _dependent(self, zero: Polynomial) -> str:
        """The acceleration that is best expressed by the others: none that is asked for, and simply."""
        names = [n for n in sorted(zero.names() & self.d.units.keys()) if zero.coefficient(n).number is not None]
        if not names:
            raise UnsolvedError("a string binds accelerations at a ratio that changes")
        return min(names, key=lambda n: (n in self.goals, abs(zero.coefficient(n).number or 0.0) != 1.0, n))

    # ---- faces

    def _faces(self) -> list[Equation]:
        """Normal forces that the weight alone gives are put in at once; others are told."""
        found: list[Equation] = []
        step = self.d.book.open("normal")
        for row in self.rows:
            if row.kind != "normal":
                continue
            name = f"N{row.number}"
            symbol = _name_of(self.names[name])
            pressed = (row.inertia - row.forces.without((name,))).put(self.names)
            if symbol not in self.goals and not pressed.names() & self.d.units.keys():
                self.inline[symbol] = pressed
                continue
            self.pressed[symbol] = pressed
            body = self.d.setting.called(self.d.mechanism.faces[row.number].subject)
            step.say(f"Perpendicular to its face, {body}: {step.law(Symbol(symbol), pressed.expression())}.")
            found.append(Equation("", Polynomial.of(Symbol(symbol)), pressed, NIL))
        step.close()
        return found

    # ---- rows

    def _row(self, group: Sequence[Row]) -> Row:
        """The sum of a group's laws, in the symbols of the book, along the sense in which it moves."""
        sense = float(self.d.sense.get(group[0].number, 1))
        row = self.d.added(group)
        forces, inertia = (part.put(self.names).put(self.inline).scaled(sense) for part in (row.forces, row.inertia))
        return Row("newton", group[0].number, forces, inertia)

    def _equation(self, group: Sequence[Row], number: int, count: int) -> Equation:
        row = self._row(group)
        k = group[0].number
        moves = self.names.get(f"q{k}", NIL).scaled(float(self.d.sense.get(k, 1)))
        return Equation(f"({number})" if count > 1 else "", row.forces, row.inertia, moves)

    def _tell(self, groups: Sequence[Sequence[Row]], equations: Sequence[Equation]) -> None:
        step = self.d.book.open("newton")
        for group, equation in zip(groups, equations, strict=True):
            if not equation.inertia and not self._mass(group):
                left, right = _balance(equation.forces)
                who = capital(self.d.setting.called(self._body(group[0].number)))
                step.say(f"{equation.label} {who} is light, so the forces on it balance: {step.law(left, right)}.".strip())
                continue
            inertia = self._inertia(group, equation)
            law = step.law(equation.forces.expression(), inertia)
            step.say(f"{equation.label} {self._why(group)}: {law}.".strip())
        step.close()

    def _why(self, group: Sequence[Row]) -> str:
        if self.d.measure.values:
            return f"Along this line no outer force acts on {self._who(group)}; their centre of mass stays where it is"
        return capital(self._who(group))

    def _inertia(self, group: Sequence[Row], equation: Equation) -> Expression:
        """Mass times acceleration, where all have the same."""
        own = [row.inertia.put(self.names).scaled(float(self.d.sense.get(row.number, 1))) for row in group]
        masses = [part.coefficient(n) for part in own for n in sorted(equation.moves.names()) if part]
        accelerations = sorted(equation.inertia.names() & self.d.units.keys())
        if masses and len(masses) == len(own) and len(masses[0].terms) == 1 and len(accelerations) > 1:
            (monomial, part), *_ = masses[0].terms.items()
            acceleration = divided(own[0], monomial, part)
            if acceleration is not None and not (total(masses) * acceleration - equation.inertia):
                return multiplied(total(masses).expression(), acceleration.expression())
        return equation.inertia.collected(accelerations)

    def _mass(self, group: Sequence[Row]) -> bool:
        """Whether anything moves with a group that has a mass, or a moment of inertia."""
        newton = self.d.newton
        heavy = {k for b in self.d.mechanism.bodies if b.mass for k in newton.moved(b.name)}
        return any(row.number in heavy or self.d.mechanism.coordinates[row.number].kind == "hinge" for row in group)

    def _body(self, k: int) -> str:
        return self.d.mechanism.coordinates[k].body

    def _who(self, group: Sequence[Row]) -> str:
        """Whose law it is, and along which direction."""
        k = group[0].number
        own = [self._body(row.number) for row in group]
        if self.d.mechanism.coordinates[k].kind == "hinge":
            return f"{self.d.setting.called(own[0])}, turning, at its rim"
        riders = [b.name for b in self.d.mechanism.bodies if b.mass and b.name not in own and self._carried(b.name, own)]
        who = self.d.setting.listed(own)
        if riders:
            who += f" with {self.d.setting.listed(riders)}"
        return f"{who}{' together' if len(own) > 1 or riders else ''}, {self.d.moving(k, self.d.sense.get(k, 1))}"

    def _carried(self, body: str, own: Iterable[str]) -> bool:
        step = self.d.mechanism.body[body].parent
        while step is not None:
            if step in own:
                return True
            step = self.d.mechanism.body[step].parent
        return False

    def _balanced(self, light: Sequence[Equation], known: dict[str, Polynomial]) -> dict[str, Polynomial]:
        """The tensions that balances at light pulleys give by others."""
        found: dict[str, Polynomial] = {}
        for equation in light:
            zero = equation.forces.put(found)
            names = [n for n in sorted(zero.names() & self.d.units.keys()) if n not in known]
            plain = [n for n in names if abs(zero.coefficient(n).number or 0.0) == 1.0] or names
            name = min(plain, key=lambda n: (n in self.goals, n))
            before = zero.coefficient(name).number
            if not before:
                raise UnsolvedError("a light pulley balances at a ratio that changes")
            found[name] = zero.without((name,)).scaled(-1.0 / before)
            found = {n: p.put({name: found[name]}) for n, p in found.items()}
        return found


def _balance(forces: Polynomial) -> tuple[Expression, Expression]:
    positive = Polynomial({m: part for m, part in forces.terms.items() if part > 0.0})
    negative = Polynomial({m: -part for m, part in forces.terms.items() if part < 0.0})
    return positive.expression(), negative.expression()


def _close(one: Sequence[float], other: Sequence[float]) -> bool:
    return all(abs(a - b) < STILL for a, b in zip(one, other, strict=True))


def _name_of(held: Polynomial) -> str:
    """The one symbol of a polynomial."""
    return next(iter(held.names()), "")


__all__ = ["Dynamics", "UnreadError"]

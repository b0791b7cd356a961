"""Sentences about the laws that give an acceleration or a force, with their equations."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from sim2reason.solutions.algebra.elimination import Elimination, Equation, solve_linear
from sim2reason.solutions.algebra.expressions import Expression, Symbol, multiply_factors
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, balance, divide_by_term, total
from sim2reason.solutions.laws.directions import directions_of_friction, verify_sliding
from sim2reason.solutions.laws.dynamics import Dynamics, SharedRate
from sim2reason.solutions.laws.newton import Row
from sim2reason.solutions.laws.rolling_words import (
    inertia_words,
    not_slipping,
    only_turning,
    rim_of,
    rolling_bodies,
    rolling_words,
    slipping_words,
    turning_noun,
)
from sim2reason.solutions.laws.sticking import verify_sticking
from sim2reason.solutions.laws.strings_and_pulleys import balanced_tensions, doubling_reason, needed_laws, verify_taut
from sim2reason.solutions.setting import capitalized
from sim2reason.solutions.writing.notation import NEWTONS
from sim2reason.solutions.writing.steps import StepBuilder, UnsolvedError


def write_unforced(dynamics: Dynamics, goals: Sequence[str]) -> None:
    """Write that no force acts along coordinates whose accelerations are among the goals."""
    step = dynamics.book.begin_step("unforced")
    for k in sorted(dynamics.unforced - dynamics.frozen):
        if f"q{k}" in goals:
            coordinate = dynamics.mechanism.coordinates[k]
            who, direction = dynamics.setting.display_name(coordinate.body), f"in the {coordinate.label} direction"
            step.add_text(f"No force acts on {who} {direction}, so its velocity in this direction is constant.")
    step.close()


class WrittenDynamics(Dynamics):
    """The laws of an instant, from which accelerations and forces are derived in writing."""

    def reach(self, goals: Sequence[str]) -> None:
        """Write the derivation of unknowns, such as ``q3`` or ``T1``; their symbols in `names` have values then."""
        still = self.frozen | self.unforced
        write_unforced(self, goals)
        goals = [goal for goal in dict.fromkeys(goals) if not (goal[0] == "q" and int(goal[1:]) in still)]
        self.names |= {f"q{k}": NIL for k in still}
        if not goals:
            return
        rows, unknowns = self.laws(goals)
        givens = {g.symbol: g.value for g in self.setting.lexicon.givens.values()}
        chosen = needed_laws(rows, unknowns, {**givens, **self.values}, [goal for goal in goals if goal in unknowns])
        self.name_shared_rates(chosen, goals, rows)
        self.name(chosen, goals)
        DynamicsWriter(self, chosen, goals).write()
        verify_sticking(self)
        verify_sliding(self)
        verify_taut(self, rows)
        for name, polynomial in self.names.items():
            for monomial, part in polynomial.terms.items():
                self.book.observed.setdefault(monomial[0][0].latex(), self.values[name] / part)


class DynamicsWriter:
    """A writer of the sentences and equations that derive unknowns from chosen laws."""

    def __init__(self, dynamics: Dynamics, rows: Sequence[Row], goals: Sequence[str]) -> None:
        """Take the chosen laws `rows` and the unknowns that they determine, `goals`."""
        self.d, self.rows = dynamics, rows
        self.names = dynamics.names
        self.goals = [_name_of(dynamics.names[goal]) for goal in goals]
        self._labels: list[str] = []
        self.inline: dict[str, Polynomial] = {}  # normal forces due to weights alone
        self.pressed: dict[str, Polynomial] = {}  # other normal forces in terms of accelerations
        dynamics.bound = {}

    def _open(self, kind: str) -> StepBuilder:
        """Begin a step that is kept only if another step depends on it."""
        step = self.d.book.begin_step(kind)
        self._labels.append(f"{kind} {len(self.d.book.steps)}")
        step.label(self._labels[-1])
        return step

    def write(self) -> None:
        """Write the names of the unknowns, then the laws, then their solution."""
        self._introduce()
        equations = [*self._strings(), *self._faces()]
        groups = self.d.groups
        known = self.d.bound | self.pressed
        rows = [self._equation(group, labelled=len(groups) > 1) for group in groups]
        self._write_laws(groups, rows)
        light = [e for group, e in zip(groups, rows, strict=True) if not self._mass(group)]
        balanced, labels = balanced_tensions(light, known, self.d.units.keys(), self.goals)
        known |= balanced
        heavy = [e.substitute(known).substitute(known).linked_to(labels) for e in rows if e not in light]
        all_of_them = heavy + equations + [replace(e, moves=NIL) for e in light]
        unknowns = sorted({n for e in all_of_them for n in e.zero.names()} & self.d.units.keys())
        Elimination(self.d.book, self.d.units, self._labels).solve(all_of_them, unknowns, self.goals)

    # ---- what things are called

    def _introduce(self) -> None:
        """Write the names of accelerations and tensions."""
        step, noun = self._open("names"), self.d.measure.noun
        phrases = [f"${shared.symbol.name}${self._what(shared)}" for shared in self.d.shared]
        if len(phrases) == 1:
            name, _, what = phrases[0].partition("$ of ")
            step.add_text(f"Let {name}$ be the {noun} of {what}." if what else f"Let {name.replace(',', ' be', 1)}.")
        elif phrases:
            step.add_text(f"{capitalized(noun)}s: {'; '.join(phrases)}.")
        tensions = [f"${_name_of(self.names[n])}$ in {self._line(n)}" for n in self.names if n[0] == "T"]
        if tensions:
            step.add_text(f"Tension{'s' if len(tensions) > 1 else ''}: {'; '.join(tensions)}.")
        step.add_text(*map(self._rolling, self.d.shared), *directions_of_friction(self.d, self.rows), *self._resting())
        step.close()

    def _resting(self) -> list[str]:
        """Return sentences that bodies stay at rest relative to the bodies that carry them."""
        riders_by_parent: dict[str, list[str]] = {}
        for k in sorted(self.d.frozen):
            body = self.d.mechanism.coordinates[k].body
            parent = self.d.mechanism.body[body].parent
            own = [self._body(row.number) for group in self.d.groups for row in group]
            if parent is not None and self._carried(body, own):
                riders_by_parent.setdefault(parent, []).append(body)
        return [
            f"{capitalized(self.d.setting.bodies_phrase(bodies))} stay{'' if bodies[1:] else 's'} at rest relative to "
            f"{self.d.setting.display_name(parent)}."
            for parent, bodies in riders_by_parent.items()
        ]

    def _line(self, name: str) -> str:
        """Return the name of the string of a tension."""
        return self.d.setting.string_phrases[self.d.newton.lines[int(name[1:])].name]

    def _what(self, shared: SharedRate) -> str:
        """Return the words after the symbol of a rate: bodies with their directions, or the rotation of one body."""
        alone = only_turning(self.d, shared)
        return f", {turning_noun(self.d, shared)}" if alone else f" {self._whose(shared)}"

    def _rolling(self, shared: SharedRate) -> str:
        """Return the sentences that bodies roll, as one text; empty if none of the bodies with the rate rolls."""
        bodies = rolling_bodies(self.d, shared) if not only_turning(self.d, shared) else []
        return " ".join(rolling_words(self.d, body, shared) for body in bodies)

    def _whose(self, shared: "SharedRate") -> str:
        """Return the bodies of a rate, such as *of block A downward and of block B up the slope*."""
        ways: dict[str, list[str]] = {}
        turning: list[str] = []
        for k, sense in shared.sense.items():
            coordinate = self.d.mechanism.coordinates[k]
            if coordinate.kind == "hinge":
                turning += [] if self.d.newton.moving_coordinates(coordinate.body) else [coordinate.body]
                continue
            parent = self.d.mechanism.body[coordinate.body].parent
            direction = self.d.moving(k, sense)
            if parent is not None and self._moves(parent) and k not in self.d.carrier_coordinates:
                direction += f" relative to {self.d.setting.display_name(parent)}"
            ways.setdefault(direction, []).append(coordinate.body)
        phrases = [f"of {self.d.setting.bodies_phrase(bodies)} {direction}" for direction, bodies in ways.items()]
        return " and ".join([*phrases, *(f"of {rim_of(self.d.setting, body)}" for body in turning)])

    def _moves(self, body: str) -> bool:
        """Return whether a body moves."""
        return any(k not in self.d.frozen for k in self.d.newton.moving_coordinates(body))

    # ---- constraints

    def _strings(self) -> list[Equation]:
        """Write the constraints of strings that bind accelerations at ratios other than one; return them."""
        equations: list[Equation] = []
        step = self._open("constraint")
        for row in self.rows:
            if row.kind not in ("string", "grip"):
                continue
            zero = row.inertia.substitute(self.names)
            if not zero:
                continue
            zero = zero.substitute(self.d.bound)
            name = self._dependent(zero)
            rest = solve_linear(zero, name)
            before = zero.coefficient(name).number
            assert before is not None
            self.d.bound[name] = zero.terms_without((name,)).scale(-1.0 / before)
            self.d.bound = {n: p.substitute({name: self.d.bound[name]}) for n, p in self.d.bound.items()}
            line, more = self._line(f"T{row.number}"), f"{not_slipping(self.d, row)}{doubling_reason(self.d, row)}"
            step.add_text(f"{capitalized(line)} does not stretch{more}: {step.law(Symbol(name), rest)}.")
            equations.append(Equation("", NIL, zero, NIL))
        step.close()
        return equations

    def _dependent(self, zero: Polynomial) -> str:
        """Return the acceleration to eliminate: preferably one not asked for, and with a coefficient of ±1."""
        names = [n for n in sorted(zero.names() & self.d.units.keys()) if zero.coefficient(n).number is not None]
        if not names:
            raise UnsolvedError("a string binds accelerations at a ratio that changes")
        return min(names, key=lambda n: (n in self.goals, abs(zero.coefficient(n).number or 0.0) != 1.0, n))

    # ---- faces

    def _faces(self) -> list[Equation]:
        """Substitute normal forces due to weights alone; write and return the equations of the others."""
        equations: list[Equation] = []
        step = self._open("normal")
        for row in self.rows:
            if row.kind != "normal":
                continue
            name = f"N{row.number}"
            symbol = _name_of(self.names[name])
            pressed = (row.inertia - row.forces.terms_without((name,))).substitute(self.names)
            round_one = (
                self.d.newton.slip_directions.get(row.number)
                and self.d.newton.single_slip_coordinate(row.number) is None
            )
            if symbol not in self.goals and not pressed.names() & self.d.units.keys():
                self.inline[symbol] = pressed
                if round_one:
                    step.add_text(slipping_words(self.d, row.number, pressed))
                continue
            self.pressed[symbol] = pressed
            alone = not pressed.names() & self.d.units.keys()
            body = self.d.setting.display_name(self.d.mechanism.faces[row.number].subject)
            name, formula = Symbol(symbol), pressed.expression()
            law_text = step.result(name, formula, NEWTONS, law=True) if alone else step.law(name, formula)
            step.add_text(f"Perpendicular to the surface, {body}: {law_text}.")
            equations += [] if alone else [Equation("", Polynomial.from_expression(name), pressed, NIL)]
        step.close()
        return equations

    # ---- rows

    def _row(self, group: Sequence[Row]) -> Row:
        """Return the sum of Newton's laws of a group of bodies, in the text's symbols, along its motion."""
        sense = float(self.d.sense.get(group[0].number, 1))
        row = self.d.sum_laws(group)
        forces, inertia = (
            part.substitute(self.names).substitute(self.inline).scale(sense) for part in (row.forces, row.inertia)
        )
        return Row("newton", group[0].number, forces, inertia)

    def _equation(self, group: Sequence[Row], *, labelled: bool) -> Equation:
        """Return the equation that is the sum of Newton's laws of a group of bodies."""
        row = self._row(group)
        k = group[0].number
        moves = self.names.get(f"q{k}", NIL)
        if k in self.d.carrier_coordinates:  # the common acceleration is in the law of its carrier
            j, sign = self.d.carrier_coordinates[k]
            moves = moves - self.names.get(f"q{j}", NIL).scale(sign)
        moves = moves.scale(float(self.d.sense.get(k, 1)))
        return Equation(self.d.book.labels.next() if labelled else "", row.forces, row.inertia, moves)

    def _write_laws(self, groups: Sequence[Sequence[Row]], equations: Sequence[Equation]) -> None:
        """Write Newton's laws of all groups of bodies."""
        step = self._open("newton")
        for group, equation in zip(groups, equations, strict=True):
            if not equation.inertia and not self._mass(group):
                left, right = balance(equation.forces)
                who = capitalized(self.d.setting.display_name(self._body(group[0].number)))
                step.add_text(f"{equation.label} {who}, which is light: {step.law(left, right)}.".strip())
                continue
            law = step.law(equation.forces.expression(), self._inertia(group, equation))
            step.add_text(f"{equation.label} {self._why(group)}: {law}.".strip())
        step.close()

    def _why(self, group: Sequence[Row]) -> str:
        """Return the first words of the sentence with Newton's law of a group of bodies."""
        if self.d.measure.values:
            who, _, direction = self._who(group).rpartition(", ")
            reason = f"No external force on {who} has a component {direction}, and they start from rest,"
            return f"{reason} so their centre of mass does not move in this direction"
        return capitalized(self._who(group))

    def _inertia(self, group: Sequence[Row], equation: Equation) -> Expression:
        """Return mass times acceleration, with the masses collected if all have the same acceleration."""
        own = [row.inertia.substitute(self.names).scale(float(self.d.sense.get(row.number, 1))) for row in group]
        masses = [part.coefficient(n) for part in own for n in sorted(equation.moves.names()) if part]
        accelerations = sorted(equation.inertia.names() & self.d.units.keys())
        if masses and len(masses) == len(own) and len(masses[0].terms) == 1 and len(accelerations) > 1:
            (monomial, part), *_ = masses[0].terms.items()
            acceleration = divide_by_term(own[0], monomial, part)
            if acceleration is not None and not (total(masses) * acceleration - equation.inertia):
                return multiply_factors(total(masses).expression(), acceleration.expression())
        return equation.inertia.collected(accelerations)

    def _mass(self, group: Sequence[Row]) -> bool:
        """Return whether a group of bodies has a mass or a moment of inertia."""
        heavy = {k for b in self.d.mechanism.bodies if b.mass for k in self.d.newton.moving_coordinates(b.name)}
        return any(row.number in heavy or self.d.mechanism.coordinates[row.number].kind == "hinge" for row in group)

    def _body(self, k: int) -> str:
        """Return the body of a coordinate."""
        return self.d.mechanism.coordinates[k].body

    def _who(self, group: Sequence[Row]) -> str:
        """Return words for the bodies and the direction of Newton's law of a group of bodies."""
        k = group[0].number
        own = [self._body(row.number) for row in group]
        if self.d.mechanism.coordinates[k].kind == "hinge":
            return f"torque on {self.d.setting.display_name(own[0])}{inertia_words(self.d, k)}"
        own_names = {self.d.setting.display_name(body) for body in own}  # a pulley and its carrier share a name
        heavy = [b.name for b in self.d.mechanism.bodies if b.mass and b.name not in own]
        riders = [
            body for body in heavy if self._carried(body, own) and self.d.setting.display_name(body) not in own_names
        ]
        who = self.d.setting.bodies_phrase(own)
        if riders:
            who += f" with {self.d.setting.bodies_phrase(riders)}"
        return f"{who}{' together' if len(own) > 1 or riders else ''}, {self.d.moving(k, self.d.sense.get(k, 1))}"

    def _carried(self, body: str, own: Iterable[str]) -> bool:
        """Return whether one of the bodies in `own` carries a body."""
        step = self.d.mechanism.body[body].parent
        while step is not None:
            if step in own:
                return True
            step = self.d.mechanism.body[step].parent
        return False


def _name_of(polynomial: Polynomial) -> str:
    """Return the only symbol of a polynomial."""
    return next(iter(polynomial.names()), "")

"""The builder of worked solutions: each name has one value, and steps are written one by one."""

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from math import degrees

from sim2reason.questions.difficulty import Need
from sim2reason.scenes.dsl.units import SI, UnitSystem
from sim2reason.solutions.algebra.evaluated import NumericFormula
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import need_of
from sim2reason.solutions.solution import CHECKS, Integration, Phase, Relation, Step, with_unit
from sim2reason.solutions.writing.notation import CANONICAL, DEGREES, Labels, NameAllocator, latex

STATE_DIGITS = 8  # digits of numbers from which an integration starts


class UnsolvedError(Exception):
    """An error that ends a strategy that finds no answer; the message states why."""


class SolutionBuilder(NameAllocator):
    """A builder of a solution: names with their values, and the steps written so far."""

    def __init__(
        self,
        units: UnitSystem = SI,
        *,
        asks: str = "",
        called: Mapping[str, str] | None = None,
        most: Need = Need.INTEGRATION,
    ) -> None:
        """Begin an empty solution with results in `units`; `asks` is the unit of a time, distance or angle asked for.

        With `called`, the solution is in symbols: no number is written, and given numbers have names from that mapping.
        The mathematics of a result may not exceed `most`.
        """
        super().__init__(called)
        self.most, self._units, self.asks = most, units, asks
        self.values: dict[str, float] = {}
        self.units: dict[str, str] = {}
        self.steps: list[Step] = []
        self.observed: dict[str, float] = {}  # what the engine has for names that cancel, to check relations by
        self.stated: dict[str, str] = {}  # numbers that the question says, as they are written
        self.constants: dict[str, Expression] = {}  # those among them that are of nature
        self.hidden: set[str] = set()  # names whose values hang on what is unknown
        self.formulas: dict[str, Expression] = {}  # of those, in order
        self.condition_number = 1.0  # relative: by how much what is given changes with what is unknown
        self.sign_chosen = 0  # 1 or −1, for the magnitude of what hangs on an unknown, see `goals.modulus`
        self.passage = 0  # 1 or 2: at which of the times a quantity passes a value that is asked for; 0 if that is open
        self.phase = 0  # the index of the phase of the motion to which the next steps belong
        self.phases: list[Phase] = []  # empty where the motion has a single phase
        self.afterwards: list[Callable[[], None]] = []  # write arguments that may rest on what was found in the end
        self.checks: dict[object, Callable[[], None]] = {}  # write, after those, verifications of what is shown alone
        self.earliest: dict[int, int] = {}  # of a step that belongs further up: the number of one that it stands after
        self.sought = ""  # the symbol of a moment's number that is asked for, where a result at that moment is given
        self.labels = Labels()
        self._source: dict[str, int] = {}

    def copy(self) -> "SolutionBuilder":
        """Return a builder with the same names and values but no steps, for a draft."""
        builder = SolutionBuilder(self._units, asks=self.asks, called=self._called, most=self.most)
        builder.hidden, builder.sought, builder.passage = {*self.hidden}, self.sought, self.passage
        builder.values, builder.units, builder.stated = {**self.values}, {**self.units}, {**self.stated}
        builder._taken, builder.labels = {*self._taken}, copy(self.labels)
        return builder

    def saved(self) -> dict[str, object]:
        """Return a copy of the state of the builder; `vars(book).update(…)` restores it."""
        return {name: copy(value) for name, value in vars(self).items()}

    @property
    def last(self) -> str:
        """Return the name that was given a value last."""
        return next(reversed(self.values))

    def set_value(self, name: str, value: float, unit: str = "") -> None:
        """Store the value of a name; raise ValueError if it has another value already."""
        if name in self.values and self.values[name] != value:
            raise ValueError(f"{name} has two values, {self.values[name]:g} and {value:g}")
        self.values[name], self.units[name] = value, unit

    def state_given(self, name: str, value: float, unit: str) -> None:
        """Record a number that the question itself states, or the symbol of the one that it asks for."""
        is_asked, unit = unit == self.asks, self.unit_in_text(unit)
        self.set_value(name, value, unit)
        if is_asked and self.asks and not self.sought:
            self.sought = name
            self.hidden.add(name)
        else:
            self.stated[name] = f"{degrees(value) if unit == DEGREES else value:g}{unit}"

    def make_given(self, name: str, value: float, spelled: str) -> None:
        """Turn a computed name into a given one, with its value as spelled in the question."""
        self.hidden.discard(name)
        self.values[name], self.stated[name] = value, spelled

    def refresh(self, name: str, value: float) -> None:
        """Store a better value of the unknown, and recompute all names that depend on it."""
        self.values[name] = value
        for other, formula in self.formulas.items():
            if other not in self.stated:
                self.values[other] = self.value(formula)

    def check_need(self, formula: Expression) -> None:
        """Raise UnsolvedError for a formula whose mathematics is too advanced for this solution."""
        if self.most < Need.INTEGRATION and (need := need_of(formula)) > self.most:
            raise UnsolvedError(f"it needs more: {need.label}")

    def value(self, held: Expression, at: Mapping[str, float] | None = None) -> float:
        """Return the value of a formula, with known values or those of `at`; raise UnsolvedError if it has none."""
        try:
            number = held.value(self.values if at is None else at)
        except (ValueError, ArithmeticError) as error:  # the root of what is negative, a division by zero
            raise UnsolvedError(f"{held.latex()} has no value") from error
        assert not isinstance(number, complex)
        return number

    def unit_in_text(self, unit: str) -> str:
        """Return an SI unit, in LaTeX, in the unit system of the text."""
        name = CANONICAL.get(unit)
        return unit if name is None or self._units == SI else latex(self._units.spell(name))

    @property
    def counts_in_si(self) -> bool:
        """Return whether results are in SI units without prefixes."""
        return self._units == SI

    @property
    def in_symbols(self) -> bool:
        """Return whether the solution is in symbols, without numbers."""
        return self._called is not None

    def is_hidden(self, held: Expression) -> bool:
        """Return whether the value of a formula may not be written: it is unknown, or the solution is in symbols."""
        return self.in_symbols or not self.hidden.isdisjoint(held.names)

    def magnitude(self, formula: Expression) -> Expression:
        """Return a formula if its value is positive, else its negative."""
        return formula if self.value(formula) > 0.0 else -formula

    def defer_to_number(self, formula: Expression) -> Expression:
        """Return a formula to be written as a number only, or unchanged if it depends on the unknown."""
        return formula if self.is_hidden(formula) else NumericFormula(formula, self.value(formula))

    def rewrite(self, begun: int, steps: Sequence[Step]) -> None:
        """Replace all steps from the number `begun` on by other steps with consecutive numbers."""
        self.steps[begun:] = steps
        self._source = {name: step.id for step in self.steps for name in step.gives}

    def begin_phase(self, begins: str, ends: str) -> None:
        """Assign the following steps to a new phase of the motion."""
        self.phases.append(Phase(begins, ends))
        self.phase = len(self.phases) - 1

    def begin_step(self, kind: str) -> "StepBuilder":
        """Begin a step of a kind."""
        return StepBuilder(self, kind)

    def add_step(
        self, kind: str, said: str, name: Symbol, formula: Expression, unit: str = "", *, rests: str = ""
    ) -> Symbol:
        """Write a one-sentence step, `said` and name = formula = value, and return the name; `rests`: label used."""
        step = self.begin_step(kind)
        step.rest_on(rests)
        step.add_text(f"{said} {step.result(name, formula, unit, law=True)}.")
        step.close()
        return name

    def close(
        self,
        kind: str,
        text: str,
        relations: list[Relation],
        gives: list[str],
        rests: list[str],
        integration: Integration | None = None,
    ) -> Step:
        """Append a step with its relations and results, and return it."""
        number = len(self.steps)
        self._source.update(dict.fromkeys(gives, number))
        worked = (relation for relation in relations if relation.role in ("result", *CHECKS))
        names = {name for relation in worked for name in relation.names} | {*rests}
        names |= {name for relation in relations if relation.role == "law" and gives for name in relation.names}
        needs = sorted({self._source[name] for name in names if name in self._source} - {number})
        step = Step(number, kind, text, tuple(relations), tuple(gives), tuple(needs), self.phase, integration)
        self.steps.append(step)
        return step


class StepBuilder:
    """A step under construction, to which sentences and relations are added."""

    def __init__(self, book: SolutionBuilder, kind: str) -> None:
        """Begin an empty step of a kind."""
        self._book, self._kind = book, kind
        self._sentences: list[str] = []
        self.relations: list[Relation] = []  # recorded so far
        self._gives: list[str] = []
        self._rests: list[str] = []
        self._integration: Integration | None = None

    def label(self, name: str) -> None:
        """Record the label of an equation in this step, so that later steps can depend on it."""
        self._gives.append(name)

    def rest_on(self, label: str) -> None:
        """Record that this step uses the equation with a label."""
        if label:
            self._rests.append(label)

    def add_text(self, *sentences: str) -> None:
        """Append sentences to the text of the step."""
        self._sentences.extend(sentence for sentence in sentences if sentence)

    def law(self, left: Expression, right: Expression) -> str:
        """Record a law and return it in LaTeX with dollars."""
        return self._noted(Relation(left, right, "law"))

    def derived(self, left: Expression, right: Expression) -> str:
        """Record an equation that follows from earlier ones, and return it in LaTeX with dollars."""
        return self._noted(Relation(left, right, "derived"))

    def result(self, name: Symbol, formula: Expression, unit: str, *, law: bool = False) -> str:
        """Record a result and return it in LaTeX; with `law`, the formula is itself a law, such as v = a t."""
        self._book.check_need(formula)
        unit = self._book.unit_in_text(unit)
        relation = Relation(name, formula, "law" if law else "result", unit)
        self.relations.append(relation)
        self._book.set_value(name.name, value := self._book.value(formula), unit)
        self._gives.append(name.name)
        if not self._book.hidden.isdisjoint(formula.names):
            self._book.hidden.add(name.name)
            self._book.formulas[name.name] = formula
        return relation.latex(None if self._book.is_hidden(formula) else value)

    def verified(self, what: Expression, formula: Expression, unit: str) -> str:
        """Record and return the value of a formula that only checks an assumption, in LaTeX."""
        relation = Relation(what, formula, "verified", self._book.unit_in_text(unit))
        value = self._book.value(formula, {**self._book.observed, **self._book.values})
        self.relations.append(relation)
        if isinstance(what, Symbol) and what.name not in self._book.values:
            self._book.observed[what.name] = value
        return relation.latex(None if self._book.is_hidden(formula) else value)

    def integrate(self, integration: Integration) -> None:
        """Record an initial-value problem whose final values the builder knows already."""
        self._integration = integration
        self._gives += [name for _, name in integration.ends]

    def stated(self, formula: Expression, unit: str) -> str:
        """Return a formula of given numbers with its value, in LaTeX with dollars; without value if that is unknown."""
        value = self._book.value(formula)
        if self._book.is_hidden(formula):
            return f"${formula.latex()}$"
        if isinstance(formula, Number):
            return f"${with_unit(value, unit)}$"
        self._noted(Relation(formula, Number(value), "derived", unit))
        return f"${formula.latex()} = {with_unit(value, unit)}$"

    def defined(self, name: Symbol, formula: Expression) -> str:
        """Record and return a law that defines a name whose value is known already, in LaTeX."""
        relation = Relation(name, formula, "law", self._book.units[name.name])
        self.relations.append(relation)
        self._gives.append(name.name)
        return relation.latex(self._book.values[name.name])

    def trial(self, name: Symbol) -> str:
        """Record and return the value of an unknown found by trial, in LaTeX; the given result determines it."""
        value, unit = self._book.values[name.name], self._book.units[name.name]
        self.relations.append(Relation(name, Number(value), "trial", unit))
        self._gives.append(name.name)
        return f"${name.latex()} = {with_unit(value, unit, STATE_DIGITS)}$"

    def given_result(self, name: Symbol, value: float) -> str:
        """Record and return the equation by which a given result determines the unknown, in LaTeX."""
        relation = Relation(name, Number(value), "condition", self._book.units[name.name])
        self.relations.append(relation)
        return f"${name.latex()} = {with_unit(value, relation.unit)}$"

    def closed(self, name: Symbol, formula: Expression) -> str:
        """Record and return the value of a symbol that was unknown until now, in LaTeX with dollars."""
        self._book.check_need(formula)
        unit = self._book.units[name.name]
        relation = Relation(name, formula, "result", unit)
        self.relations.append(relation)
        self._book.hidden.discard(name.name)
        self._gives.append(name.name)
        return relation.latex(None if self._book.in_symbols else self._book.value(formula))

    def _noted(self, relation: Relation) -> str:
        self.relations.append(relation)
        return relation.latex()

    def close(self) -> None:
        """Append the step to the builder, unless it is empty."""
        if self._sentences or self.relations or self._integration:
            text = " ".join(self._sentences)
            self._book.close(self._kind, text, self.relations, self._gives, self._rests, self._integration)


def record_inequality(book: SolutionBuilder, step: StepBuilder, left: Expression, right: Expression) -> None:
    """Record in a step that one formula is larger than another; raise UnsolvedError if it is not."""
    if not book.value(left) > book.value(right):
        raise UnsolvedError(f"{left.latex()} does not exceed {right.latex()}")
    step.relations.append(Relation(left, right, "exceeds"))


def verify_assumed(book: SolutionBuilder, greater: Expression, less: Expression, relation: str) -> None:
    """Write that one formula is larger than another, as was assumed; `relation` is this inequality in LaTeX."""
    step = book.begin_step("verify")
    record_inequality(book, step, greater, less)
    step.add_text(f"Indeed ${relation}$, as was assumed.")
    step.close()


def why_this_time(book: SolutionBuilder, step: StepBuilder, chosen: Symbol, other: Expression) -> str:
    """Return a clause that the `other` root for a time is negative or later; empty for a solution in symbols."""
    if book.in_symbols:
        return ""
    if book.value(other) < 0.0:
        record_inequality(book, step, ZERO, other)
        return "; the other root is negative"
    if book.value(other) > book.value(chosen):
        record_inequality(book, step, other, chosen)
        return "; the other root is later"
    return ""

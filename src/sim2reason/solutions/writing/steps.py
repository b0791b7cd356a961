"""A book in which each name has one value, and into which a worked solution is written step by step."""

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from math import degrees

from sim2reason.questions.need import Need
from sim2reason.scenes.dsl.units import SI, UnitSystem
from sim2reason.solutions.algebra.evaluated import Worked
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.algebra.needs import need_of
from sim2reason.solutions.solution import CHECKS, Integration, Phase, Relation, Step, with_unit
from sim2reason.solutions.writing.subscripts import FreshNames, Labels
from sim2reason.solutions.writing.unit_latex import CANONICAL, DEGREES, latex

STATE_DIGITS = 8  # of numbers on which an integration rests


class UnsolvedError(Exception):
    """A strategy found that it cannot answer after all; the message says why."""


class Book(FreshNames):
    """Names with their values, and steps as they are written."""

    def __init__(
        self,
        units: UnitSystem = SI,
        *,
        asks: str = "",
        called: Mapping[str, str] | None = None,
        most: Need = Need.INTEGRATION,
    ) -> None:
        """Make an empty book with results in `units`; `asks` is the unit of the number of a moment that is asked for.

        With `called`, it is in symbols: no number is written, and given numbers have the names that it maps theirs to.
        No result may need more than `most`.
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
        self.keen = 1.0  # relative: by how much what is given changes with what is unknown
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

    def copy(self) -> "Book":
        """Another with the same names known, and no steps, for a draft."""
        found = Book(self._units, asks=self.asks, called=self._called, most=self.most)
        found.hidden, found.sought, found.passage = {*self.hidden}, self.sought, self.passage
        found.values, found.units, found.stated = {**self.values}, {**self.units}, {**self.stated}
        found._taken, found.labels = {*self._taken}, copy(self.labels)
        return found

    def saved(self) -> dict[str, object]:
        """Return all that is known and written: with `vars(book).update(…)` it is so again."""
        return {name: copy(value) for name, value in vars(self).items()}

    @property
    def last(self) -> str:
        """The name that was given a value last."""
        return next(reversed(self.values))

    def know(self, name: str, value: float, unit: str = "") -> None:
        """Give a name its value; a second one is a programmer's error."""
        if name in self.values and self.values[name] != value:
            raise ValueError(f"{name} has two values, {self.values[name]:g} and {value:g}")
        self.values[name], self.units[name] = value, unit

    def say_given(self, name: str, value: float, unit: str) -> None:
        """A number that the question itself says."""
        is_asked, unit = unit == self.asks, self.unit_in_text(unit)
        self.know(name, value, unit)
        if is_asked and self.asks and not self.sought:
            self.sought = name
            self.hidden.add(name)
        else:
            self.stated[name] = f"{degrees(value) if unit == DEGREES else value:g}{unit}"

    def state(self, name: str, value: float, spelled: str) -> None:
        """Make a name that was written one that is given, in the words of the question."""
        self.hidden.discard(name)
        self.values[name], self.stated[name] = value, spelled

    def refresh(self, name: str, value: float) -> None:
        """Give the unknown a better value, and all that hangs on it."""
        self.values[name] = value
        for other, formula in self.formulas.items():
            if other not in self.stated:
                self.values[other] = self.value(formula)

    def check_need(self, formula: Expression) -> None:
        """Raise UnsolvedError for a formula that needs more than this solution may."""
        if self.most < Need.INTEGRATION and (need := need_of(formula)) > self.most:
            raise UnsolvedError(f"it needs more: {need.label}")

    def value(self, held: Expression, at: Mapping[str, float] | None = None) -> float:
        """Return the value of a formula, with known values or those of `at`; UnsolvedError if it has none."""
        try:
            found = held.value(self.values if at is None else at)
        except (ValueError, ArithmeticError) as error:  # the root of what is negative, a division by zero
            raise UnsolvedError(f"{held.latex()} has no value") from error
        assert not isinstance(found, complex)
        return found

    def unit_in_text(self, unit: str) -> str:
        """Return a unit of the SI, in LaTeX, as the text of this scene has it."""
        name = CANONICAL.get(unit)
        return unit if name is None or self._units == SI else latex(self._units.spell(name))

    @property
    def counts_in_si(self) -> bool:
        """Return whether results are in units of the SI, without prefixes."""
        return self._units == SI

    @property
    def in_symbols(self) -> bool:
        """Return whether no number may be written."""
        return self._called is not None

    def is_hidden(self, held: Expression) -> bool:
        """Return whether the value of a formula may not be written, as it is unknown, or all is in symbols."""
        return self.in_symbols or not self.hidden.isdisjoint(held.symbols())

    def magnitude(self, formula: Expression) -> Expression:
        """Return a formula if its value is positive, else its negative."""
        return formula if self.value(formula) > 0.0 else -formula

    def worked(self, formula: Expression) -> Expression:
        """Return a formula of which the number alone is written, unless that hangs on what is unknown."""
        return formula if self.is_hidden(formula) else Worked(formula, self.value(formula))

    def rewrite(self, begun: int, steps: Sequence[Step]) -> None:
        """Put other steps in place of those from a number on, which have the numbers that follow."""
        self.steps[begun:] = steps
        self._source = {name: step.id for step in self.steps for name in step.gives}

    def begin_phase(self, begins: str, ends: str) -> None:
        """Let the steps from now on belong to another phase of the motion."""
        self.phases.append(Phase(begins, ends))
        self.phase = len(self.phases) - 1

    def open(self, kind: str) -> "Writing":
        """Begin a step."""
        return Writing(self, kind)

    def told(
        self, kind: str, said: str, name: Symbol, formula: Expression, unit: str = "", *, rests: str = ""
    ) -> Symbol:
        """Return a step of one sentence that ends with a law by itself and `rests` on a label; gives back the name."""
        step = self.open(kind)
        step.rest_on(rests)
        step.say(f"{said} {step.result(name, formula, unit, law=True)}.")
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
        """Keep a step."""
        number = len(self.steps)
        self._source.update(dict.fromkeys(gives, number))
        worked = (relation for relation in relations if relation.role in ("result", *CHECKS))
        names = {name for relation in worked for name in relation.symbols()} | {*rests}
        names |= {name for relation in relations if relation.role == "law" and gives for name in relation.symbols()}
        needs = sorted({self._source[name] for name in names if name in self._source} - {number})
        step = Step(number, kind, text, tuple(relations), tuple(gives), tuple(needs), self.phase, integration)
        self.steps.append(step)
        return step


class Writing:
    """A step in the making: sentences are said, and equations in them noted."""

    def __init__(self, book: Book, kind: str) -> None:
        """Nothing is said yet."""
        self._book, self._kind = book, kind
        self._said: list[str] = []
        self.relations: list[Relation] = []  # those that were noted so far
        self._gives: list[str] = []
        self._rests: list[str] = []
        self._integration: Integration | None = None

    def label(self, name: str) -> None:
        """Name an equation of this step, so that others can rest on it."""
        self._gives.append(name)

    def rest_on(self, label: str) -> None:
        """Use an equation by its label."""
        if label:
            self._rests.append(label)

    def say(self, *sentences: str) -> None:
        """Add sentences."""
        self._said.extend(sentence for sentence in sentences if sentence)

    def law(self, left: Expression, right: Expression) -> str:
        """Return a law that is told, in LaTeX with dollars."""
        return self._noted(Relation(left, right, "law"))

    def derived(self, left: Expression, right: Expression) -> str:
        """Return an equation that follows from what was told, in LaTeX with dollars."""
        return self._noted(Relation(left, right, "derived"))

    def result(self, name: Symbol, formula: Expression, unit: str, *, law: bool = False) -> str:
        """Return a name and what it comes to; with `law`, the formula is a law by itself, as v = a t is."""
        self._book.check_need(formula)
        unit = self._book.unit_in_text(unit)
        relation = Relation(name, formula, "law" if law else "result", unit)
        self.relations.append(relation)
        self._book.know(name.name, value := self._book.value(formula), unit)
        self._gives.append(name.name)
        if not self._book.hidden.isdisjoint(formula.symbols()):
            self._book.hidden.add(name.name)
            self._book.formulas[name.name] = formula
        return relation.latex(None if self._book.is_hidden(formula) else value)

    def verified(self, what: Expression, formula: Expression, unit: str) -> str:
        """State the value of a formula that only checks an assumption; the book keeps that of a new name for others."""
        relation = Relation(what, formula, "verified", self._book.unit_in_text(unit))
        value = self._book.value(formula, {**self._book.observed, **self._book.values})
        self.relations.append(relation)
        if isinstance(what, Symbol) and what.name not in self._book.values:
            self._book.observed[what.name] = value
        return relation.latex(None if self._book.is_hidden(formula) else value)

    def integrate(self, integration: Integration) -> None:
        """State an initial-value problem; the values at its end are known to the book already."""
        self._integration = integration
        self._gives += [name for _, name in integration.ends]

    def stated(self, formula: Expression, unit: str) -> str:
        """Return the value of a formula of given numbers, or a name, in LaTeX with dollars."""
        value = self._book.value(formula)
        if self._book.is_hidden(formula):
            return f"${formula.latex()}$"
        if isinstance(formula, Number):
            return f"${with_unit(value, unit)}$"
        self._noted(Relation(formula, Number(value), "derived", unit))
        return f"${formula.latex()} = {with_unit(value, unit)}$"

    def defined(self, name: Symbol, formula: Expression) -> str:
        """Return a law that gives a name, whose value the book knows already, as a formula."""
        relation = Relation(name, formula, "law", self._book.units[name.name])
        self.relations.append(relation)
        self._gives.append(name.name)
        return relation.latex(self._book.values[name.name])

    def trial(self, name: Symbol) -> str:
        """Return the value of an unknown that is found by trial: the result that is given determines it."""
        value, unit = self._book.values[name.name], self._book.units[name.name]
        self.relations.append(Relation(name, Number(value), "trial", unit))
        self._gives.append(name.name)
        return f"${name.latex()} = {with_unit(value, unit, STATE_DIGITS)}$"

    def given_result(self, name: Symbol, value: float) -> str:
        """Return the equation by which a result that the question gives determines the unknown."""
        relation = Relation(name, Number(value), "condition", self._book.units[name.name])
        self.relations.append(relation)
        return f"${name.latex()} = {with_unit(value, relation.unit)}$"

    def closed(self, name: Symbol, formula: Expression) -> str:
        """Return the value of a symbol that was unknown till now, in LaTeX with dollars."""
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
        """Keep it, if it says anything."""
        if self._said or self.relations or self._integration:
            text = " ".join(self._said)
            self._book.close(self._kind, text, self.relations, self._gives, self._rests, self._integration)

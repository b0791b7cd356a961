"""The parts of a worked solution: steps with their relations, phases and the answer; solutions of several parts."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from math import degrees
from typing import Literal

from sim2reason.base.records import abridge, cached_property, format_count
from sim2reason.grading.parts import PART_LABELS
from sim2reason.questions.difficulty import Need, most_advanced
from sim2reason.questions.spoken_units import SpokenUnits
from sim2reason.solutions.algebra.evaluated import NumericRoot, SpecialFunction
from sim2reason.solutions.algebra.expressions import Expression, Number
from sim2reason.solutions.algebra.functions import need_of
from sim2reason.solutions.algebra.plain_latex import plain_latex
from sim2reason.solutions.algebra.rounded_numbers import DIGITS, rounded_latex
from sim2reason.solutions.writing.notation import DEGREES, latex

Role = Literal["given", "law", "derived", "result", "verified", "exceeds", "trial", "condition"]
CHECKS = frozenset({"verified", "exceeds"})  # roles of relations on which no other relation depends
RELATION_RTOL = 1e-9  # relative tolerance within which every relation holds
ANSWER_RTOL = 1e-6  # relative tolerance of the answer of a solution to the engine's


@dataclass(frozen=True, slots=True)
class Relation:
    """An equation or comparison of two formulas, with its role in the solution.

    A `given`, `law` or `derived` equation, or a `result`: name = formula. An assumption is `verified` by a number
    on which nothing depends, or by a comparison: the left side `exceeds` the right one. An unknown found by `trial` has
    the value with which the `condition`, a result that the question gives, holds at the end.

    `unit` is the unit of a result, in LaTeX.
    """

    left: Expression
    right: Expression
    role: Role
    unit: str = ""

    def latex(self, value: float | None = None) -> str:
        """Return the relation as in the text, between dollar signs; a result is followed by its `value`."""
        formula, sign = plain_latex(self.right), ">" if self.role == "exceeds" else "="
        text = f"{plain_latex(self.left)} {sign} {formula}"
        if value is not None and (self.unit or not isinstance(self.right, Number)):
            number = with_unit(value, self.unit)
            bare = formula == rounded_latex(value) and self.unit != DEGREES
            plain = bare or isinstance(self.right, NumericRoot | SpecialFunction)
            text = f"{self.left.latex()} = {number}" if plain else f"{text} = {number}"
        return f"${text}$"

    @property
    def names(self) -> frozenset[str]:
        """Return the names in both sides of the relation."""
        return self.left.names | self.right.names

    def symbols(self) -> Iterator[str]:
        """Yield each name in both sides of the relation, some names more than once."""
        yield from self.left.symbols()
        yield from self.right.symbols()


@dataclass(frozen=True, slots=True)
class Coordinate:
    """A coordinate of an integrated phase: the symbols of its value and derivatives, and its initial values."""

    place: str
    rate: str
    acceleration: str
    initial_place: Expression
    initial_rate: Expression


@dataclass(frozen=True, slots=True)
class Accumulated:
    """A quantity that is integrated over a phase, such as work, impulse or path length: rate and initial value."""

    name: str
    rate: Expression
    initial: Expression


@dataclass(frozen=True, slots=True)
class Condition:
    """The end of an integrated phase: the `occurrence`-th zero of an expression after the phase begins.

    `direction` is 1 if only zeros count where the expression increases, -1 where it decreases, 0 if all count.
    """

    expression: Expression
    direction: int = 0
    occurrence: int = 1


@dataclass(frozen=True, slots=True)
class Integration:
    """The stated initial-value problem of one phase, complete enough to be integrated from this data alone.

    Attributes:
        time: symbol of the time, s, which counts from the start of the motion.
        begin: value of the time at which the phase begins.
        coordinates: the generalised coordinates with their initial values.
        unknowns: symbols of forces that the equations determine at each instant together with the accelerations.
        equations: equations of motion and constraints, linear in the accelerations and unknowns.
        until: the condition that ends the phase.
        ends: pairs of a symbol of the phase and the name that its value at the end of the phase gets.
        accumulated: quantities that are added up over the phase.
    """

    time: str
    begin: Expression
    coordinates: tuple[Coordinate, ...]
    unknowns: tuple[str, ...]
    equations: tuple[Relation, ...]
    until: Condition
    ends: tuple[tuple[str, str], ...]
    accumulated: tuple[Accumulated, ...] = ()

    def symbols(self) -> Iterator[str]:
        """Yield each name that the initial-value problem takes from other steps, some names more than once."""
        own = {self.time, *self.unknowns, *(integral.name for integral in self.accumulated)}
        own |= {name for c in self.coordinates for name in (c.place, c.rate, c.acceleration)}
        formulas = [self.begin, self.until.expression]
        formulas += [formula for c in self.coordinates for formula in (c.initial_place, c.initial_rate)]
        formulas += [formula for integral in self.accumulated for formula in (integral.rate, integral.initial)]
        formulas += [side for law in self.equations for side in (law.left, law.right)]
        return (name for formula in formulas for name in formula.symbols() if name not in own)


@dataclass(frozen=True, slots=True)
class Phase:
    """A part of the motion between two events, during which the same forces and constraints act."""

    begins: str
    ends: str


@dataclass(frozen=True, slots=True)
class Step:
    """One step of a solution: its text, its relations, the names that it gives a value, and the steps it needs.

    `phase` is the index of the phase of the motion to which it belongs. An `integration` is the initial-value problem
    that the step states; the names of its `ends` are among those that the step gives.
    """

    id: int
    kind: str
    text: str
    relations: tuple[Relation, ...]
    gives: tuple[str, ...]
    needs: tuple[int, ...]
    phase: int = 0
    integration: Integration | None = None

    def symbols(self) -> Iterator[str]:
        """Yield each name in the step's relations and initial-value problem, some names more than once."""
        for relation in self.relations:
            yield from relation.symbols()
        if self.integration is not None:
            yield from self.integration.symbols()

    @property
    def need(self) -> Need:
        """Return the level of mathematics of the step; checks do not count."""
        if self.integration is not None:
            return Need.INTEGRATION
        relations = (relation for relation in self.relations if relation.role not in CHECKS)
        return most_advanced(need_of(side) for relation in relations for side in (relation.left, relation.right))


@dataclass(frozen=True)
class Solution:
    """A worked solution; if it has no `answer`, `reason` states why."""

    strategy: str
    steps: tuple[Step, ...] = ()
    values: Mapping[str, float] = field(default_factory=dict[str, float])
    goal: str = ""
    answer: float | None = None
    unit: str = ""
    reason: str = ""
    stated: tuple[str, ...] = ()  # names of the numbers that the question itself states
    constants: Mapping[str, Expression] = field(default_factory=dict[str, Expression])  # constants of nature
    formula: str = ""  # the answer to a problem in symbols
    is_modulus: bool = False  # the formula is the absolute value of the goal, which may be negative
    scale: float = 1.0  # factor from `unit` to the unit of the answer, except for degrees
    condition_number: float = (
        1.0  # condition number: relative change of the given result per relative change of the unknown
    )
    phases: tuple[Phase, ...] = ()  # empty if the motion has a single phase
    asked_unit: tuple[str, float] | None = (
        None  # the unit that the text asks for, and the factor to it from the unit of the answer
    )
    whole: bool = False  # the answer is a count
    applies: bool = True  # whether the strategy is applicable to the question

    def __repr__(self) -> str:
        """Return the strategy, the number of steps and the answer, or the reason why there is none."""
        if self.answer is None:
            return f"<Solution: none, {abridge(self.reason, 120)}>"
        return f"<Solution by {self.strategy}: {format_count(len(self.steps), 'step')}, answer {self.answer:.6g}>"

    def __str__(self) -> str:
        """Return the text of the solution, or the reason why there is none."""
        return self.text if self.answer is not None else f"No worked solution: {self.reason}"

    @cached_property
    def needs(self) -> Need:
        """Return the most advanced mathematics in any step; INTEGRATION if the solution has no answer."""
        return most_advanced(step.need for step in self.steps) if self.answer is not None else Need.INTEGRATION

    @property
    def derived(self) -> bool:
        """Return whether no phase of the motion is integrated numerically."""
        return self.answer is not None and all(step.integration is None for step in self.steps)

    @property
    def text(self) -> str:
        """Return all steps, a paragraph each, and the answer in a box: to three digits, or a formula."""
        paragraphs = [step.text for step in self.steps if step.text]
        if self.answer is not None:
            goal = rf"\left|{self.goal}\right|" if self.is_modulus else self.goal
            paragraphs.append(f"Answer: ${goal}{self._boxed(self.answer)}$.")
        return "\n\n".join(paragraphs)

    def _boxed(self, answer: float) -> str:
        if self.formula:
            return rf" = \boxed{{{self.formula}}}"
        if self.whole:
            return rf" = \boxed{{{round(answer)}}}{self.unit}"
        if self.asked_unit is None:
            return rf" \approx \boxed{{{rounded_latex(answer, 3)}}}{self.unit}"
        unit, factor = self.asked_unit
        number = with_unit(self.values[self.goal], self.unit)
        return rf" = {number} \approx \boxed{{{rounded_latex(answer * factor, 3)}}}{unit}"

    def in_answer_unit(self, value: float) -> float:
        """Convert a value of the goal, in SI units, to the unit of the answer."""
        return degrees(value) if self.unit == DEGREES else value * self.scale

    @property
    def relations(self) -> list[Relation]:
        """Return all relations in the order of the steps."""
        return [relation for step in self.steps for relation in step.relations]


def with_unit(value: float, unit: str, digits: int = DIGITS) -> str:
    """Return a number with its unit, in LaTeX; angles in degrees are passed in radians."""
    return f"{rounded_latex(degrees(value) if unit == DEGREES else value, digits)}{unit}"


_BOX = re.compile(r"\\boxed\{([^{}]*(?:\{[^{}]*\}[^{}]*)*)\}")


@dataclass(frozen=True, slots=True)
class PartsSolution(Solution):
    """The combined solution of all parts; its goal and answer are those of the last part."""

    parts: tuple[Solution, ...] = ()

    @property
    def derived(self) -> bool:
        """Return whether the answers to all parts are derived in closed form."""
        return bool(self.parts) and all(part.derived for part in self.parts)

    @property
    def text(self) -> str:
        """Return the solutions of all parts with their labels, and all answers in one box."""
        texts = [f"({label}) {_unboxed_text(part)}" for label, part in zip(PART_LABELS, self.parts, strict=False)]
        if self.answer is not None:
            boxes = (_BOX.search(part.text) for part in self.parts)
            answers = "; ".join(
                f"({label}) {box[1] if box else ''}" for label, box in zip(PART_LABELS, boxes, strict=False)
            )
            texts.append(rf"Answers: $\boxed{{{answers}}}$.")
        return "\n\n".join(texts)


@dataclass(frozen=True, slots=True)
class ChosenSolution(Solution):
    """A solution of a multiple-choice question, whose answer is the letter of an option."""

    letter: str = ""

    @property
    def text(self) -> str:
        """Return the solution of the question without options, followed by the letter in a box."""
        text = _BOX.sub(r"\1", super(ChosenSolution, self).text)
        return f"{text}\n\n" + rf"That is option $\boxed{{\text{{{self.letter}}}}}$."


def choice_solution(solution: Solution, letter: str) -> Solution:
    """Return the solution of a multiple-choice question from the solution of the plain question."""
    field_values = {each.name: getattr(solution, each.name) for each in fields(Solution)}
    return ChosenSolution(**field_values, letter=letter)


def combine_parts(parts: Sequence[Solution]) -> Solution:
    """Return one solution of all parts; if a part has no answer, one without an answer whose reason names this part."""
    for label, part in zip(PART_LABELS, parts, strict=False):
        if part.answer is None:
            return Solution("", reason=f"part ({label}): {part.reason}")
    names = dict.fromkeys(part.strategy for part in parts)
    last = parts[-1]
    return PartsSolution(
        "; ".join(names),
        tuple(_in_one_row(parts)),
        last.values,
        last.goal,
        answer=last.answer,
        unit=last.unit,
        parts=tuple(parts),
    )


def _unboxed_text(part: Solution) -> str:
    """Return the text of one part without the box around its answer."""
    return _BOX.sub(r"\1", part.text)


def _in_one_row(parts: Sequence[Solution]) -> Iterator[Step]:
    """Yield the steps of all parts with consecutive numbers from zero."""
    count = 0
    for part in parts:
        for step in part.steps:
            yield replace(step, id=step.id + count, needs=tuple(need + count for need in step.needs))
        count += len(part.steps)


GIVEN = "Given: "


def convert_answer(system: SpokenUnits, solution: Solution, unit: str) -> Solution:
    """Return a solution in SI units that ends with a conversion to the unit in which the prompt asks for the answer."""
    other, factor = system.spelled(unit)
    if solution.answer is None or solution.formula or not system.says_otherwise:
        return solution
    steps = tuple(
        replace(step, text=step.text.replace(GIVEN, "Given, in SI units: ", 1)) if step.kind == "givens" else step
        for step in solution.steps
    )
    return replace(
        solution, steps=steps, asked_unit=(latex(other), float(factor)) if other != unit else solution.asked_unit
    )

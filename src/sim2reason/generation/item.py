"""Items: one problem with its answer, the data to verify or regenerate it, and the grading of responses to it."""

import json
from collections.abc import Iterator, Sequence
from textwrap import fill
from typing import Annotated, Self, cast

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    FiniteFloat,
    JsonValue,
    field_validator,
    model_validator,
)
from pydantic_core import from_json

from sim2reason.base.records import abridge
from sim2reason.grading import Score, choice, formula, number, parts
from sim2reason.grading.parts import PART_LABELS, Grader
from sim2reason.questions.prompt_formats import LETTERS
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.text.prose.description import formula_unit, stated_value

PROMPT_WIDTH = 88  # characters in a line of a printed prompt


class Record(BaseModel):
    """The base of all records on disk: frozen, without unknown fields, and with a short repr."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    def __repr__(self) -> str:
        """Return the class and the fields that differ from their defaults, with long values shortened."""
        shown = (f"{name}={abridge(repr(value), 40)}" for name, value in self._given())
        return f"{type(self).__name__}({', '.join(shown)})"

    def __str__(self) -> str:
        """Return the same text as `repr`."""
        return repr(self)

    def _given(self) -> Iterator[tuple[str, object]]:
        for name, field in type(self).model_fields.items():
            value = getattr(self, name)
            if field.is_required() or value != field.get_default(call_default_factory=True):
                yield name, value


def unfolded(value: object) -> object:
    """Return the value of a JSON text, which shards store for nested fields; other values unchanged.

    Raises:
        ValueError: a text that is no JSON.
    """
    return from_json(value) if isinstance(value, str) else value


FOLDED = BeforeValidator(unfolded)


class Binding(Record):
    """Values of all symbols of a problem in order, and the engine's answer with them."""

    numbers: tuple[FiniteFloat, ...]
    answer: FiniteFloat


class FormulaRecord(Record):
    """An answer as a formula with values of its symbols, in coherent units: rad, m/s, kg, C, or au, yr."""

    latex: str
    symbols: tuple[str, ...]
    """All that the prompt has, in LaTeX without dollars; the formula may do without some."""
    units: tuple[str, ...]
    """Those of the symbols' numbers in `bindings`: with them the formula needs no factor of conversion."""
    unit: str
    """That of the answers in `bindings`: ``rad`` where the item's own answer is in degrees."""
    bindings: tuple[Binding, ...]
    """The first has the scene's own numbers."""

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if any(
            len(entries) != len(self.symbols) for entries in (self.units, *(each.numbers for each in self.bindings))
        ):
            raise ValueError("each symbol has a unit, and a number in each binding")
        for unit in (self.unit, *self.units):
            if formula_unit(unit) != unit:
                raise ValueError(f"numbers of formulas are not in {unit}; give them in {formula_unit(unit)}")
        return self

    @property
    def points(self) -> list[dict[str, float]]:
        """Return the bindings as mappings by symbol."""
        return [dict(zip(self.symbols, each.numbers, strict=True)) for each in self.bindings]

    def given(self, binding: int = 0) -> dict[str, str]:
        """Return the values of one binding with their units, as in a text, by symbol."""
        numbers = self.bindings[binding].numbers
        pairs = zip(self.symbols, self.units, numbers, strict=True)
        return {symbol: stated_value(number, unit) for symbol, unit, number in pairs}


def _keyed(value: object) -> dict[str, object]:
    return cast("dict[str, object]", value) if isinstance(value, dict) else {}


class Answer(Record):
    """The answer to a problem: a number with its unit and tolerance, and a formula in symbolic problems.

    Attributes:
        value: The right number, in `unit`; of a symbolic problem, the value of the formula in the scene.
        unit: Canonical unit, such as ``m/s`` or ``kg m/s``; empty for a pure number.
        sign: Axis or direction that counts as positive, in words; empty for a magnitude.
        tolerance: Relative error within which a number is right.
        formula: The answer as a formula, with numbers for its symbols; None if a number is asked for.
        parts: Answers to all parts of a problem with several; the answer itself is then that to the last part.
        letter: Letter of the right option in multiple choice; empty otherwise.
        options: Number in each option, from A on, in `unit`; negative if the option names the second of two bodies.
        texts: Text of each option, from A on, if options have words besides numbers; empty otherwise.
        told: The number with its unit, or the formula, or the answer to each part, as text for people.
        shown: The same text with the direction that counts as positive.
    """

    value: FiniteFloat
    unit: str
    sign: str = ""
    tolerance: float = 0.05
    formula: FormulaRecord | None = None
    parts: "tuple[Answer, ...]" = ()
    letter: str = ""
    options: tuple[FiniteFloat, ...] = ()
    texts: tuple[str, ...] = ()

    @model_validator(mode="before")
    @classmethod
    def _of_earlier_versions(cls, value: object) -> object:
        """Return the answer of an older record with the units of its formula, which such records omit."""
        answer = _keyed(value)
        formula = _keyed(answer.get("formula"))
        if not formula or "unit" in formula:
            return value
        units = [formula_unit(str(unit)) for unit in cast("Sequence[object]", formula.get("units", ()))]
        return answer | {"formula": formula | {"units": units, "unit": formula_unit(str(answer.get("unit", "")))}}

    def __str__(self) -> str:
        """Return the answer as readable text, with the direction that counts as positive."""
        return self.shown

    @property
    def told(self) -> str:
        """Return the number with its unit, the formula with its value, or the answer to each part, as text."""
        if self.parts:
            return "; ".join(f"({label}) {part.told}" for label, part in zip(PART_LABELS, self.parts, strict=False))
        number = join_unit(f"{self.value:.6g}", self.unit)
        number = self.texts[LETTERS.index(self.letter)] if self.texts else number
        number = f"{self.letter}. {number}" if self.letter else number
        return number if self.formula is None else f"${self.formula.latex}$, which here is {number}"

    @property
    def shown(self) -> str:
        """Return the answer as text, with the direction that counts as positive."""
        if self.parts:
            return "; ".join(f"({label}) {part.shown}" for label, part in zip(PART_LABELS, self.parts, strict=False))
        return f"{self.told}  (positive: {self.sign})" if self.sign else self.told


class SolutionStep(Record):
    """One step of a worked solution."""

    kind: str
    text: str
    relations: tuple[str, ...]
    """Its equations, in LaTeX with dollars."""
    needs: tuple[int, ...]
    """The steps on which it rests, counted from zero."""


class SolutionRecord(Record):
    """A worked solution, with its answer in a box as the prompt requests."""

    strategy: str
    derived: bool
    """Whether the answer follows from the laws that are told, not from a numerical integration."""
    text: str
    steps: tuple[SolutionStep, ...]

    def __str__(self) -> str:
        """Return the text of the solution."""
        return self.text


class Distractor(Record):
    """An incorrect answer that follows from a misconception, in the unit of the correct one."""

    value: FiniteFloat
    simplification: str
    """The slip that leads to it, by its registered name."""
    reason: str
    """What is wrong about it."""


class QueryRecord(Record):
    """The queried value of a question: a quantity of a subject, at a time (s) or event."""

    subject: str
    """The address of a body, string or contact in the scene."""
    quantity: str
    time: FiniteFloat | None = None
    event: str | None = None
    unknown: str | None = None
    """The address of the number that the text leaves open, if it does."""
    limit_of: str | None = None
    """The address of the number whose limit is asked for, or given, if one is; the text leaves it open, too."""
    given: FiniteFloat | None = None
    """What the prompt says that the quantity is, where the answer is the unknown, or the time (in `given_unit`)."""
    given_unit: str | None = None


class MeasuredDifficulty(Record):
    """The measured difficulty of a problem: laws, phases and unknowns of its worked solution, and the score."""

    laws: int
    """How many laws of physics it uses."""
    phases: int
    """Of the motion, each between two events."""
    unknowns: int
    """The most that have to be found together."""
    score: int
    """All of it, and what the solution needs, in one number."""


class QuestionPart(Record):
    """One part of a problem; its answer is in the item's answer."""

    text: str
    """The question, as the prompt has it behind the label."""
    kind: str
    asked: QueryRecord
    uses: tuple[int, ...] = ()
    """The earlier parts whose answers lead to this one, counted from zero."""
    distractors: tuple[Distractor, ...] = ()
    solution: SolutionRecord | None = None
    """Where solutions were asked for; it starts from the answers to the parts that it uses."""
    unsolved: str = ""
    certificate: Annotated[dict[str, JsonValue], FOLDED]
    """How well the engines agree about this part."""


class Provenance(Record):
    """The origin of an item; with the same versions, the same request gives identical bytes."""

    recipe: str
    difficulty: str
    mode: str
    seed: int
    index: int
    versions: Annotated[dict[str, str], FOLDED]
    settings: str
    """A hash of the maker's settings: how many draws it tries, how long it simulates."""
    weights: Annotated[dict[str, float], FOLDED] = Field(default_factory=dict[str, float])
    """Of kinds of question, by name, where they are not those that the library declares."""
    units: str = "SI"
    """The system of units of the text and the answer; the scene is always in the SI."""
    needs: tuple[str, ...] = ()
    """What solutions might need by the order; none: the default, by which few need more than elementary means."""


class Item(Record):
    """A problem with its answer, and the data to check it or to make it again.

    The same request gives the same item in any process, in any order. Items are immutable.

    Attributes:
        id: Name of the problem, from which `solve` can make it again.
        prompt: Text of the problem, with the form of the answer in its last sentence.
        shape: Order in which the prompt gives the scene, the question and the form of the answer.
        answer: The answer with its unit and tolerance.
        mode: Mode of the question, such as ``numeric`` or ``symbolic``.
        kind: Kind of the question, such as ``start``, ``event`` or ``period``.
        recipe: Recipe of the scene; empty if the scene was given.
        difficulty: ``easy``, ``medium`` or ``hard``; empty if the scene was given.
        entities: Types of the entities, in the order of the scene.
        asked: The question as a quantity of a subject at a moment.
        needs: Most advanced mathematics of the shortest solution, ``arithmetic`` to ``integration``; empty if unknown.
        measured: Difficulty of the shortest solution, or of those of all parts together; None if one is missing.
        parts: The parts of a problem that has several, in order.
        distractors: Wrong answers with their reasons, each beyond the tolerance; with several parts, each has its own.
        idle: Bodies and other things in the prompt without bearing on the answer, by their names there.
        idle_numbers: Addresses of the stated numbers without bearing on the answer.
        solution: The worked solution; None if none was requested or found.
        unsolved: Why there is no worked solution although it was requested; empty otherwise.
        scene: The scene as YAML, which `load` reads.
        certificate: Agreement of the two engines, as plain JSON values.
        provenance: Coordinates, versions and settings from which the item was made.
        kinds: Kinds of question of all parts; the kind of the question if there are no parts.

    Examples:
        >>> import sim2reason
        >>> problem = sim2reason.item("pulley", "easy")
        >>> problem.id, problem.kind, problem.answer.unit
        ('pulley-easy-numeric-0-0', ..., ...)
        >>> sim2reason.Item.model_validate_json(problem.model_dump_json()) == problem
        True
    """

    id: str
    prompt: str
    shape: str
    answer: Answer
    mode: str
    kind: str
    recipe: str
    difficulty: str
    entities: tuple[str, ...]
    asked: QueryRecord
    needs: str = ""
    measured: MeasuredDifficulty | None = None
    parts: tuple[QuestionPart, ...] = ()
    distractors: tuple[Distractor, ...] = ()
    idle: tuple[str, ...] = ()
    idle_numbers: tuple[str, ...] = ()
    solution: SolutionRecord | None = None
    unsolved: str = ""
    scene: str
    certificate: Annotated[dict[str, JsonValue], FOLDED]
    provenance: Provenance

    def __repr__(self) -> str:
        """Return the id, the mode and the answer on one line."""
        return f"<Item {self.id!r}: {self.mode}, answer {abridge(self.answer.shown)}>"

    def __str__(self) -> str:
        """Return the id and coordinates, the prompt in lines of at most 88 characters, and the answer."""
        about = ", ".join(filter(None, (self.recipe, self.difficulty, self.mode)))
        lines = (_wrapped(line) for line in self.prompt.splitlines())
        return "\n".join((f"{self.id} ({about})", "", *lines, "", f"Answer: {self.answer.shown}"))

    @property
    def kinds(self) -> tuple[str, ...]:
        """Return the kinds of question of all parts, or the kind of the question if there are no parts."""
        return tuple(dict.fromkeys(part.kind for part in self.parts)) or (self.kind,)

    @field_validator("certificate")
    @classmethod
    def _finite(cls, value: dict[str, JsonValue]) -> dict[str, JsonValue]:
        """Reject infinities, which JSON cannot represent, when the item is created."""
        json.dumps(value, allow_nan=False)
        return value


def _wrapped(line: str) -> str:
    """Return a line of a prompt broken into lines of at most `PROMPT_WIDTH` characters; rows of tables stay whole."""
    return line if line.startswith("|") else fill(line, PROMPT_WIDTH, break_long_words=False, break_on_hyphens=False)


def grade_answer(answer: Answer, response: object, *, lenient: bool = False, partial: bool = False) -> Score:
    """Grade a response against an answer, such as one in a row of an export, without the rest of its item."""
    if answer.parts:
        return parts(response, [_grader(part) for part in answer.parts], partial=partial)
    if answer.letter:
        letters = LETTERS[: len(answer.options)]
        if answer.texts:
            return choice(response, answer.letter, letters, texts=answer.texts)
        return choice(response, answer.letter, letters, answer.options, answer.unit)
    if answer.formula is not None:
        reference = answer.formula
        return formula(response, reference.latex, reference.points, symbols=reference.symbols, positive=answer.sign)
    return number(
        response, answer.value, answer.unit, tolerance=answer.tolerance, positive=answer.sign, lenient=lenient
    )


def _grader(answer: Answer) -> Grader:
    return lambda response: grade_answer(answer, response)

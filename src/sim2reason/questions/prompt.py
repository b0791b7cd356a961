"""Prompts of a scene and a question in one of several shapes, and their parsing."""

import re
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from sim2reason.errors import SimulationError, TextError
from sim2reason.questions import KINDS, MODES, Formula, ParsedQuestion, Query, Question, SimulatedScene, Words
from sim2reason.questions.following import FollowedMotion, simulate_scene, simulate_until_answer
from sim2reason.questions.sentences import depends_on_start
from sim2reason.questions.shapes import SHAPES, Draft, shapes_to_try
from sim2reason.questions.spoken_units import in_si
from sim2reason.questions.words import spoken_of
from sim2reason.scenes.dsl.measures import show_unit
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.text.parsing import NONE_GIVEN, ParsedScene, parse_scene
from sim2reason.text.parsing.parse_state import unstated_error
from sim2reason.text.prose.description import Description, without_names
from sim2reason.text.prose.phrases import join, symbols

FORMATS = (
    "Give your answer in {unit}, to three significant figures, inside \\boxed{{}}.",
    "State the answer in {unit} to three significant figures, inside \\boxed{{}}.",
    "Write the answer in {unit}, to three significant figures, in \\boxed{{}}.",
)
WHOLE_NUMBER_FORMATS = (
    "Give your answer as a whole number, inside \\boxed{}.",
    "State the answer as a whole number inside \\boxed{}.",
    "Write the final answer, a whole number, in \\boxed{}.",
)
"""For what is counted."""


PLAIN_FORMATS = (
    "Give your answer to three significant figures, inside \\boxed{}.",
    "State the answer to three significant figures, inside \\boxed{}.",
    "Write the final answer, to three significant figures, in \\boxed{}.",
)
"""Of a pure number."""

SYMBOLIC = (
    "Give your answer in terms of {symbols}, inside \\boxed{{}}.",
    "Express the answer in terms of {symbols}, inside \\boxed{{}}.",
    "Write the final answer as a formula in terms of {symbols}, in \\boxed{{}}.",
    "The answer is a formula in {symbols}; put it in \\boxed{{}}.",
)
"""Where the numbers are symbols."""
ANGLES, IN_RADIANS = ("deg", "rad"), "in radians"
_TRIGONOMETRIC = re.compile(
    r"\\(?:sin|cos|tan)(?:\^\{?\d\}?)?(?:\\left\(.*?\\right\)| ?\\?[A-Za-z]+(?:_\{.*?\}|_\\?[A-Za-z0-9]+)?)"
)
"""A trigonometric function with its argument."""


@dataclass(frozen=True)
class Prompt:
    """The text of a problem and the name of its shape."""

    text: str
    shape: str


def words_of(description: Description) -> Words:
    """Return the names, symbols and numbers of a description in the form that questions use."""
    scene = description.scene
    stated_parameters = [(p.path, p) for p in scene.parameters if p.path in description.symbols]
    mentions = {address: description.mention(address) for address in scene.bodies}
    alone = {path: symbols([parameter], scene.bodies, description.names) for path, parameter in stated_parameters}
    unknowns = {path: symbol_by_path[path] for path, symbol_by_path in alone.items()}
    together = {path: description.symbols[path] for path in description.told if path in description.symbols}
    return Words.of(scene, mentions, unknowns, together)


def prompt(description: Description, question: Question, rng: np.random.Generator) -> str:
    """Return the text of the scene, the question, and how to give the answer."""
    return shaped(description, question, rng).text


def shaped(description: Description, question: Question, rng: np.random.Generator) -> Prompt:
    """Return the prompt in a random shape that suits the text and the question."""
    form = _last_line(question, rng)
    body = composed(description, question.text, rng)
    after = "\n\n" if body.text.endswith("|") else " "
    return Prompt(f"{body.text}{after}{form}", body.shape)


def composed(
    description: Description, question: str, rng: np.random.Generator, *, question_last: bool = False
) -> Prompt:
    """Return scene and question in a random suitable shape, or in one that ends with the unchanged question."""
    names, shares = list(SHAPES), np.array([member.share for member in SHAPES.values()])
    order: list[int] = rng.choice(len(names), len(names), replace=False, p=shares / shares.sum()).tolist()
    for number in order:
        text = SHAPES[names[number]].compose(description, question, rng)
        if text is not None and (text.endswith(question) or not question_last):
            return Prompt(text, names[number])
    raise LookupError("no shape of prompts takes every text; one must")


def _last_line(question: Question, rng: np.random.Generator) -> str:
    """Return the last line, on how to give the answer."""
    if question.formula is not None:
        form = SYMBOLIC[int(rng.random() * len(SYMBOLIC))]
        own = f", {IN_RADIANS}" if question.unit in ANGLES else ""
        return form.format(symbols=f"{join(list(_named(question.formula)))}{own}")
    is_integer = KINDS[question.query.kind].measured(question.query).whole
    forms = WHOLE_NUMBER_FORMATS if is_integer else FORMATS if question.unit else PLAIN_FORMATS
    form = forms[int(rng.random() * len(forms))]
    return form.format(unit=unit_in_words(question.unit)) if forms is FORMATS else form


def _named(formula: Formula) -> Iterator[str]:
    """Yield the symbols of a formula, with *in radians* for angles outside trigonometric functions."""
    plain = _TRIGONOMETRIC.sub("", formula.latex)
    for symbol, unit in zip(formula.symbols, formula.units, strict=True):
        yield f"${symbol}$ ({IN_RADIANS})" if unit in ANGLES and symbol in plain else f"${symbol}$"


def unit_in_words(unit: str) -> str:
    """Return a unit as it is written in a sentence: degrees as a word, all others as symbols."""
    return "degrees" if unit == "deg" else show_unit(unit)


SAMPLES = 101
HORIZON_FRACTIONS = 1.0, 0.3, 0.1, 0.03  # of the horizon: durations to try

_UNIT = r"(\S{1,12})"
_SYMBOL = rf"\$[^$]+\$(?: \({IN_RADIANS}\))?"
_SYMBOLS = rf"{_SYMBOL}(?:(?:, | and ){_SYMBOL})*(?:, {IN_RADIANS})?"
_FORMS = [
    *(re.compile(r"\s+" + re.escape(form.format(unit="UNIT")).replace("UNIT", _UNIT) + "$") for form in FORMATS),
    *(re.compile(rf"\s+{re.escape(form)}()$") for form in (*WHOLE_NUMBER_FORMATS, *PLAIN_FORMATS)),  # in no unit
    *(re.compile(rf"\s+{re.escape(form.format(symbols='LIST')).replace('LIST', _SYMBOLS)}()$") for form in SYMBOLIC),
]


@dataclass(frozen=True)
class ParsedPrompt:
    """The meaning of a prompt: its scene, its question, and the simulated motion.

    Attributes:
        reading: The scene with the names in the text.
        study: The motion with the data derived from it.
        asked: The question with its mode.
        unit: Unit of the answer; empty for a pure number.
        shape: Order in which the prompt gives the scene, the question and the form of the answer.
        work: Why the event asked about never occurs, or not within a limit of work; empty if it occurs.
        scene: The scene, with hidden numbers of its own.
        query: The query that is asked, or stated as a condition.
        words: Names and symbols of the text.
        answer: The answer that follows from the text alone, in `unit`; None if there is none.
        counted: The answer in the unit of the scene.
        reason: Why there is no answer; empty if there is one.
    """

    reading: ParsedScene
    study: SimulatedScene
    asked: ParsedQuestion
    unit: str
    shape: str
    work: str = ""

    def __repr__(self) -> str:
        """Return the mode, the quantity or the kind of question, its subjects and the unit of the answer."""
        query = self.query
        name = query.kind if query.target is None else query.target.quantity
        of = f" of {subjects}" if (subjects := ", ".join(filter(None, query.subjects))) else ""
        return f"<ParsedPrompt: {self.asked.mode}, {name}{of}{f' in {self.unit}' if self.unit else ''}>"

    def __str__(self) -> str:
        """Return the mode, quantity, subjects and unit of the question, followed by the lines of the scene."""
        return f"{repr(self)[1:-1]}\n{self.reading}"

    @property
    def scene(self) -> Scene:
        """Return the scene, with values of its own for numbers that the text does not state."""
        return self.reading.scene

    @property
    def query(self) -> Query:
        """Return the query of the question or, if a number is unknown, the query that has the stated result."""
        return self.asked.query

    @property
    def words(self) -> Words:
        """Return the names and symbols of the text."""
        return _words(self.reading)

    @property
    def answer(self) -> float | None:
        """Return the answer that follows from the text alone, in its unit; None if there is none."""
        count = self.is_count
        return count * self._factor(_words(self.reading)) if count is not None else None

    @property
    def is_count(self) -> float | None:
        """Return the answer in the scene's own unit; None if there is none."""
        return MODES[self.asked.mode].solution(self.asked, self.study, _words(self.reading))

    @property
    def reason(self) -> str:
        """Return why there is no answer, as a clause; empty if there is an answer."""
        if self.is_count is not None:
            return ""
        return self.work or MODES[self.asked.mode].lacking(self.asked, self.study, _words(self.reading))

    def _factor(self, words: Words) -> float:
        """Return the factor from the unit of the scene and its motion to the unit that the text asks for."""
        unknown = next((candidate for candidate in words.unknowns if candidate.path != self.query.hides), None)
        if self.asked.given is not None and unknown is not None:
            unit = unknown.unit
        else:
            unit = words.units.spell(KINDS[self.query.kind].measured(self.query).unit)
        return parse_unit(unit).factor_to(parse_unit(self.unit)) or 1.0


def parse_prompt(
    text: str, rng: np.random.Generator | None = None, given: Mapping[str, str] = NONE_GIVEN
) -> ParsedPrompt:
    """Read a prompt, rebuild its scene from the words alone, and simulate it.

    Args:
        text: The prompt, whose last sentence says how to give the answer.
        rng: Generator from which numbers are drawn that texts never state; by default one with the seed 0.
        given: Number with its unit for each symbol, in LaTeX without dollars, of a prompt with symbols.

    Returns:
        The scene, the question, and the answer that follows from the text.

    Raises:
        TextError: The text describes no scene, or several, or asks no question that the library knows.

    Examples:
        >>> import sim2reason
        >>> problem = sim2reason.item("pulley", "easy")
        >>> parsed = sim2reason.parse_prompt(problem.prompt)
        >>> abs(parsed.answer / problem.answer.value - 1.0) < 1e-6
        True
    """
    body, unit = without_form(text)
    refused: list[TextError] = []
    for read in (_understood, _in_ordinary_english):
        for variant in in_si(body):
            for shape, draft in _drafts(variant):
                try:
                    return read(_stated(draft, given), unit, shape, rng, given)
                except TextError as error:
                    refused.append(error)
    if not refused:
        raise TextError("prompt", "there is no question after the scene", "ask one in a sentence of its own")
    raise min(refused, key=lambda error: ("prompt", "text", error.place).index(error.place))  # what was read farthest


def without_form(text: str) -> tuple[str, str]:
    """Return a prompt without its last sentence, and the unit in that sentence; TextError if it is unknown."""
    form = next((match for pattern in _FORMS if (match := pattern.search(text))), None)
    if form is None:
        raise TextError("prompt", "its last sentence does not say how to answer", "end it with one of the known forms")
    return text[: form.start()], form[1]


def _drafts(text: str) -> Iterator[tuple[str, Draft]]:
    """Yield all possible partitions of a prompt into story and question, each with the name of its prompt shape."""
    for shape in shapes_to_try():
        for draft in shape.drafts(text):
            yield shape.name, draft


def _stated(draft: Draft, given: Mapping[str, str]) -> Draft:
    """Return a draft whose story has numbers in place of symbols."""
    stated = {symbol: number for symbol, number in given.items() if f"${symbol}$" in draft.story}
    return replace(draft, story=without_names(draft.story), given={**draft.given, **stated})


def _understood(
    draft: Draft, unit: str, shape: str, rng: np.random.Generator | None, given: Mapping[str, str]
) -> ParsedPrompt:
    """Return the meaning of a draft; TextError if it has none."""
    reading = parse_scene(draft.story, rng, draft.given, startless=True)
    motion = _begun(reading)
    study = motion.study
    words = _in_symbols(_words(reading), draft, given) if given else _words(reading)
    parsed_questions = (mode.parsed(draft.question, study, words) for mode in MODES.values())
    parsed_question = next((each for each in parsed_questions if each is not None), None)
    if parsed_question is None and len(reading.unknown) > 1:
        raise unstated_error(reading.unknown.values())
    if parsed_question is None:
        raise TextError("prompt", f"no question is asked by {draft.question!r}", "ask in the words of the library")
    if "start" in reading.without and depends_on_start(parsed_question.query, study):
        raise TextError("prompt", "it does not say how the motion begins", "say where everything is at first")
    if reading.unknown or KINDS[parsed_question.query.kind].time(parsed_question.query, study) is not None:
        return ParsedPrompt(reading, study, parsed_question, unit, shape)
    followed = simulate_until_answer(parsed_question.query, motion)
    return ParsedPrompt(reading, followed.study, parsed_question, unit, shape, followed.reason)


def _in_ordinary_english(
    draft: Draft, unit: str, shape: str, rng: np.random.Generator | None, given: Mapping[str, str]
) -> ParsedPrompt:
    """Return the meaning of a draft with a question in ordinary English; TextError if a part has no meaning."""
    from sim2reason.questions.ordinary.understanding import (  # noqa: PLC0415 - it compiles hundreds of patterns
        suggest_rewording,
        understand_sentence,
    )

    reading = _told(draft, rng)
    if len(reading.unknown) > 1:
        raise unstated_error(reading.unknown.values())
    if given or reading.unknown or "start" in reading.without:
        raise TextError("prompt", f"no question is asked by {draft.question!r}", "ask in the words of the library")
    motion, words = simulate_scene(reading.scene), _words(reading)
    meaning = understand_sentence(draft.question, motion, words)
    if meaning is None or meaning.posed_question.unknown is not None:
        near = suggest_rewording(draft.question, motion, words)
        raise TextError("prompt", f"no question is asked by {draft.question!r}", near)
    parsed_question = ParsedQuestion("numeric", meaning.posed_question.query)
    return ParsedPrompt(
        reading, meaning.simulated_answer.study, parsed_question, unit, shape, meaning.simulated_answer.reason
    )


def _told(draft: Draft, rng: np.random.Generator | None) -> ParsedScene:
    """Return the scene of a draft, whose story may also be in ordinary English."""
    try:
        return parse_scene(draft.story, rng, draft.given, startless=True)
    except TextError:
        if draft.given:
            raise
        return parse_scene(draft.story, rng)


def _begun(reading: ParsedScene) -> FollowedMotion:
    """Return a first motion of a scene, with an unknown number at its drawn value."""
    scene = reading.scene
    for share in HORIZON_FRACTIONS if reading.unknown else ():
        with suppress(SimulationError):
            return FollowedMotion(SimulatedScene.of(scene, np.linspace(0.0, share * scene.horizon, SAMPLES)))
    return simulate_scene(scene)


def _in_symbols(words: Words, draft: Draft, given: Mapping[str, str]) -> Words:
    """Return the words of a text that refers to numbers by symbols, with the values of the question's own symbols."""
    own = [spoken_of(symbol, number, words.units) for symbol, number in given.items() if symbol not in draft.given]
    return replace(words, symbolic=True, own=dict(filter(None, own)))


def _words(reading: ParsedScene) -> Words:
    return Words.of(reading.scene, reading.mentions, reading.unknown)

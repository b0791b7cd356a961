"""The context of one problem, as strategies use it: a scene with the names of its text, its motion and a query."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Self

from sim2reason.base.records import cached_property
from sim2reason.questions import KINDS, Formula, Query, Question, SimulatedScene, StatedResult, Target, Words
from sim2reason.questions.difficulty import Need
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.regimes import Regime
from sim2reason.scenes.dsl.mechanism import ConstantTension, Mechanism
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.simulation.engines.exact.engine import motion
from sim2reason.simulation.engines.exact.motion import Motion
from sim2reason.simulation.quantities.subjects.interactions import line_phrases, pulleys, springs
from sim2reason.simulation.trace import events_before
from sim2reason.solutions.writing.lexicon import Lexicon, StatedNumber
from sim2reason.solutions.writing.notation import latex
from sim2reason.text.prose.description import Description
from sim2reason.text.prose.voices import numeric

DIRECTION_TOLERANCE = 1e-9  # tolerance of the components of a unit vector
FOLLOWED_TIME_FACTOR = 1.001  # factor by which the motion is followed beyond the moment of the question
MIN_FOLLOWED_TIME = 1e-6  # s, minimum duration of the motion that is followed


@dataclass(frozen=True)
class ProblemContext:
    """A problem context: a scene, its names in the text, a query, and the `symbols` of the text by address."""

    scene: Scene
    words: Words
    symbols: Mapping[str, str]
    study: SimulatedScene
    query: Query
    unknown: str = ""  # the address of the number that the text leaves open, and asks for
    stated: StatedResult | None = None  # what the query's answer is said to be, where that is not asked for
    sought: float | None = None  # the moment's number that is asked for, such as a time, where a result then is given
    passage: int = 0  # 1 or 2: at which of the times a quantity passes the result, where those are told apart
    extreme: StretchQuery | None = None  # the extreme value that is asked for, where the query asks for it at an end
    formula: Formula | None = None  # the answer, where the numbers of the text are symbols
    assumed: tuple[Regime, ...] = ()  # what the text says of the motion where its numbers are symbols
    most: Need = Need.INTEGRATION  # what a solution may need; one that needs more is none

    @classmethod
    def from_query(cls, question: Question, study: SimulatedScene, words: Words, description: Description) -> Self:
        """Build the problem context of a question with an answer; an unknown parameter has its symbol in the text.

        A text in symbols has no symbol for a number that it does not state, such as a strain of zero.
        """
        symbols = {**description.voiced(numeric).symbols, **description.symbols}
        if question.formula is not None:
            symbols = {path: symbol for path, symbol in symbols.items() if path in description.told}
        arguments = question.query, question.unknown, question.given
        return cls(study.scene, words, symbols, study, *arguments, formula=question.formula, assumed=question.assumed)

    @property
    def mechanism(self) -> Mechanism:
        """Return the mechanism of the scene."""
        return self.scene.mechanism

    @property
    def target(self) -> Target | None:
        """Return the subject with the quantity, or the functional, that is asked for; None for other questions."""
        if isinstance(self.query, StretchQuery):
            return Target(self.query.functional, self.query.name)
        target = self.query.target
        if target is None or target.sense is None:
            return target
        return replace(target, sense=replace(target.sense, vector=target.direction(self.mechanism)))

    @cached_property
    def lexicon(self) -> Lexicon:
        """Return the lexicon: the symbols of the given numbers, which all questions about one motion share."""
        if self.scene is not self.study.scene:
            return Lexicon(self.scene, self.symbols)
        key = "lexicon", tuple(self.symbols.items())
        return self.study.memoize(key, lambda: Lexicon(self.scene, self.symbols))

    @cached_property
    def time(self) -> float:
        """Return the time, s, until which the motion affects the answer."""
        end_time = KINDS[self.query.kind].time(self.query, self.study)
        return 0.0 if end_time is None else end_time

    @cached_property
    def motion(self) -> Motion:
        """Return the motion, in segments, until the time that decides the answer; a recorded motion is reused."""
        until, trace = max(self.time * FOLLOWED_TIME_FACTOR, MIN_FOLLOWED_TIME), self.study.trace
        known, record = float(trace.state.times[-1]), trace.record
        if self.mechanism is not self.study.mechanism or until > known:
            return motion(self.mechanism, until)
        if isinstance(record, Motion) and not trace.tolerance:
            return record.through(until)
        return self.study.memoize("motion", lambda: motion(self.mechanism, known)).through(until)

    @cached_property
    def earlier_event_kinds(self) -> frozenset[str]:
        """Return the kinds of the events before the time that decides the answer."""
        return frozenset(event.kind for event in events_before(self.motion.events, self.time))

    @cached_property
    def answer(self) -> float | None:
        """Return the engine's answer: to the query, or for the unknown parameter or moment if the result is given.

        A greatest value at an end of its interval counts, although generated questions never ask for one.
        """
        if self.sought is not None:
            return self.sought
        if self.unknown and self.stated is not None:
            return float(self.study.scene.value(self.unknown))
        kind = KINDS[self.query.kind]
        value = kind.answer(self.query, self.study)
        return kind.loose_answer(self.query, self.study) if value is None else value

    @property
    def unit(self) -> str:
        """Return the unit of the answer to the query, in LaTeX."""
        return latex(KINDS[self.query.kind].measured(self.query).unit)

    # ---- names

    @cached_property
    def pulleys(self) -> Mapping[str, str]:
        """Return the addresses of pulleys, by the name of the massless body that only carries the pulley."""
        return pulleys(self.mechanism, self.words.mentions)

    def display_name(self, body: str) -> str:
        """Return the noun phrase of a body; of a massless body that only carries a pulley, that of the pulley."""
        address = body if body in self.words.mentions else self.pulleys.get(body, "")
        return self.words.mentions.get(address, "the carrier of the pulley")

    def subscript_of(self, body: str) -> str:
        """Return the subscript for a body: its letter, else its noun; empty if it is the only moving body."""
        name = self.display_name(body)
        if not name.startswith("the "):
            return name.rpartition(" ")[2]
        moving = {c.body for c in self.mechanism.coordinates}
        mass = self.symbols.get(f"{body}.mass", "")
        if len(moving) > 1 and len(mass) == 1 and mass.isupper():
            return mass  # a_M of the prism of mass M
        return "" if len(moving) == 1 else rf"\text{{{name.removeprefix('the ').rpartition(' ')[2]}}}"

    def bodies_phrase(self, bodies: list[str]) -> str:
        """Return several bodies as one phrase, such as *block A, crates B and C*."""
        nouns: dict[str, list[str]] = {}
        for name in map(self.display_name, bodies):
            noun, _, letter = name.rpartition(" ") if not name.startswith("the ") else (name, "", "")
            nouns.setdefault(noun, []).append(letter)
        phrases = [
            noun if letters == [""] else f"{noun}{'s' if len(letters) > 1 else ''} {join_words(letters)}"
            for noun, letters in nouns.items()
        ]
        return join_words(phrases)

    @cached_property
    def string_phrases(self) -> Mapping[str, str]:
        """Return phrases for strings, by name, including pulled strings, which have no length constraint."""
        phrases = line_phrases(self.mechanism, self.words.mentions, self.mechanism.strings, "string", alone=False)
        drawn = {
            line.name: "the string that is pulled"
            for line in self.mechanism.lines
            if isinstance(line.law, ConstantTension)
        }
        return {**drawn, **phrases, **self._by_one_end(phrases)}

    @cached_property
    def spring_phrases(self) -> Mapping[str, str]:
        """Return phrases for springs, by name."""
        return springs(self.mechanism, self.words.mentions)

    def _on_a_rim(self, site: str) -> bool:
        """Return whether a string leaves the rim of a pulley at a site."""
        attachment = self.mechanism.site[site]
        return attachment.body in self.pulleys and any(attachment.at)

    def _by_one_end(self, found: Mapping[str, str]) -> dict[str, str]:
        """Return phrases, by string name, for the strings not in `found`, such as *the string tied to block A*."""
        named: dict[str, str] = {}
        for line in self.mechanism.strings:
            if line.name in found:
                continue
            bodies = [self.mechanism.site[site].body for site in (line.through[0], line.through[-1])]
            ends = [self.display_name(body) for body in bodies if body is not None]
            where = " and ".join(ends) if ends else "its two fixed ends"
            named[line.name] = f"the string between {where}" if len(ends) > 1 else f"the string tied to {where}"
            if len(ends) == 1 and any(self._on_a_rim(site) for site in (line.through[0], line.through[-1])):
                named[line.name] = f"the part of the string between {where} and its fixed end"
            if not ends:
                around = [self.mechanism.site[site].body for site in line.through]
                named[line.name] = f"the string round {next(self.display_name(b) for b in around if b is not None)}"
        return named

    @cached_property
    def _given_names(self) -> frozenset[str]:
        return frozenset(given.symbol for given in self.lexicon.givens.values())

    def is_given(self, name: str) -> bool:
        """Return whether the text states the value of a symbol."""
        return name in self._given_names

    def given(self, path: str) -> StatedNumber | None:
        """Return the number that the text states for the parameter at an address; None if it states none."""
        return self.lexicon.givens.get(path)

    def direction_words(self, way: Vector, *, on: str | None = None) -> str:
        """Return a direction in words; `on` is the body on whose face the direction lies, if that can move."""
        x, y, z = way
        if abs(z) > 1.0 - DIRECTION_TOLERANCE:
            return "upward" if z > 0.0 else "downward"
        if abs(x) > 1.0 - DIRECTION_TOLERANCE:
            return "to the right" if x > 0.0 else "to the left"
        if abs(y) > 1.0 - DIRECTION_TOLERANCE:
            return "away from you" if y > 0.0 else "towards you"
        surface = "slope" if on is None or self._slides_along(on, way) else "face"
        return f"{'up' if z > 0.0 else 'down'} the {surface}"

    def _slides_along(self, body: str, way: Vector) -> bool:
        """Return whether a body, or its carrier, slides along a direction, as a plank on a slope does."""
        axes = [coordinate.axis for coordinate in self.mechanism.body[body].coordinates]
        parent = self.mechanism.body[body].parent
        along = any(
            abs(abs(sum(a * b for a, b in zip(axis, way, strict=True))) - 1.0) < DIRECTION_TOLERANCE for axis in axes
        )
        return along or (parent is not None and self._slides_along(parent, way))


def capitalized(text: str) -> str:
    """Return a text with its first letter capitalised."""
    return text[:1].upper() + text[1:]


def join_words(names: list[str]) -> str:
    """Return names as a list in words: A, B and C."""
    return names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]

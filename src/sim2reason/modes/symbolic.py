"""The symbolic mode: every number of the text is a symbol, and a formula is asked for."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.modes.parts.variations import ProblemSymbol, Variation, Variations
from sim2reason.prose.formula_numbers import factor
from sim2reason.prose.symbol_names import with_names
from sim2reason.prose.voices import symbolic_but_zero
from sim2reason.prose.writer import Description
from sim2reason.questions import KINDS, MODES, Formula, Query, Question, QuestionMode, Reading, Study, Words, mode
from sim2reason.questions.kinds import by_share
from sim2reason.questions.parse_question import parse_question
from sim2reason.questions.phrasing import chosen, sentence
from sim2reason.questions.regimes import FEW, Regime, possible, regimes
from sim2reason.questions.spoken import OwnSymbol, symbol_for
from sim2reason.questions.targets import targets
from sim2reason.solutions import STRATEGIES, Setting, solve
from sim2reason.solutions.closed_forms import ClosedForm, ClosedFormError, closed_form
from sim2reason.solutions.strategies import Strategy

POINTS = 8  # beside the scene's own
NEAR = (0.25, 0.08)  # relative: how far around the scene's numbers they lie, as far as its regime goes
WIDE = 1.1  # up to three times or a third of each: where the formula must hold, too, unless a regime is assumed
TRIES, WIDELY = 16, 24
SAME = 1e-6  # relative: how well the formula agrees with the engine
ASSUME = "Assume that "


@mode
class Symbolic(QuestionMode):
    """What is this as a formula?"""

    name = "symbolic"

    @property
    def kinds(self) -> frozenset[str]:
        """Those that some strategy of worked solutions has a way to, if their answers are functions of the symbols."""
        derived = (strategy.kinds for strategy in STRATEGIES.values() if not strategy.integrates)
        return frozenset(name for name in frozenset[str]().union(*derived) if KINDS[name].of_symbols)

    def ask(self, study: Study, words: Words, kind: str, rng: np.random.Generator) -> Question | None:
        """Whatever some strategy of worked solutions may lead to, still in numbers.

        None about a mechanism that is not its scene's, whose numbers no symbols stand for.
        """
        if study.mechanism is not study.scene.mechanism:
            return None
        names = [kind] if kind else [found.name for found in by_share(rng)]
        fitting = _fitting(study.mechanism)
        kinds = [name for name in names if name in self.kinds and any(name in strategy.kinds for strategy in fitting)]
        found = (MODES["numeric"].ask(study, words, name, rng) for name in kinds)
        asked = (question for question in found if question and _solvable(question.query, study, words, fitting))
        return next((replace(question, mode=self.name) for question in asked), None)

    def completed(self, question: Question, study: Study, words: Words, rng: np.random.Generator) -> Question | None:
        """In symbols, with a formula; None if none is found that agrees with the engine wherever it should."""
        query, spoken = question.query, _spoken(words, question.query)
        if spoken is None:
            return None
        symbols = _symbols(study, spoken)
        solution = solve(Setting(study.scene, words, words.symbols, study, query))
        if not solution.derived:
            return None
        try:
            found = closed_form(solution, [held.symbol for held in symbols if not held.path])
        except ClosedFormError:
            return None
        varied = _Varied(Variations(study, query, symbols), found, factor(question.unit))
        near = varied.near(rng)
        assumed = varied.assumed(rng, words) if near else None
        if assumed is None:
            return None
        noun = targets(words)[query.target] if query.target is not None else None
        asked = sentence(chosen(KINDS[query.kind].shapes(query, spoken, noun), rng))
        text = f"{_assuming(assumed, words)} {asked}" if assumed else asked
        return replace(question, text=text, formula=varied.formula(near, symbols))

    def described(self, question: Question, description: Description) -> Description:
        """Every number but zero as a symbol, each with its name."""
        del question
        return with_names(description.voiced(symbolic_but_zero))

    def parsed(self, text: str, study: Study, words: Words) -> Reading | None:
        """A query in the words of its kind, behind what is assumed."""
        if not words.symbolic:
            return None
        assumed, asked = _parted(text)
        query = parse_question(asked, study, words)
        if query is None:
            return None
        if not assumed:
            return Reading(self.name, query)
        some = (held for held in _some(possible(study, words)) if _assuming(held, words) == assumed)
        return next((Reading(self.name, query, assumed=held) for held in some), None)

    def solution(self, reading: Reading, study: Study, words: Words) -> float | None:
        """The answer with the numbers that the symbols have; None with those for which what is assumed is not so."""
        until = KINDS[reading.query.kind].time(reading.query, study) or 0.0
        if not all(held.holds(study, until) for held in reading.assumed):
            return None
        return super().solution(reading, study, words)


def _fitting(mechanism: Mechanism) -> tuple[Strategy, ...]:
    """The strategies that derive formulas and may apply to questions about a mechanism."""
    derives = (strategy for strategy in STRATEGIES.values() if not strategy.integrates)
    return tuple(strategy for strategy in derives if not strategy.unfit(mechanism))


def _solvable(query: Query, study: Study, words: Words, fitting: Sequence[Strategy]) -> bool:
    """Whether some of the strategies does not refuse it at once."""
    setting = Setting(study.scene, words, words.symbols, study, query)
    return any(query.kind in strategy.kinds and not strategy.refusal(setting) for strategy in fitting)


class _Varied:
    """A formula and the scenes in which it must hold."""

    def __init__(self, variations: Variations, formula: ClosedForm, factor: float) -> None:
        """`factor` makes the engine's answers those of formulas: radians of degrees."""
        self._variations, self._formula, self._factor = variations, formula, factor
        self._near: list[Variation] = []

    def near(self, rng: np.random.Generator) -> list[Variation]:
        """The scene's own numbers and as many fresh ones as are needed, of one regime; none if the formula fails."""
        own = self._variations.own()
        if own is None or not self._holds(own):
            return []
        for width in NEAR:
            found = [own]
            for other in self._variations.drawn(rng, width, TRIES):
                if other.story == own.story and self._holds(other):
                    found.append(other)
                if len(found) > POINTS:
                    self._near = found
                    return found
        return []

    def formula(self, near: Sequence[Variation], symbols: Sequence[ProblemSymbol]) -> Formula:
        """As a question has it."""
        return Formula(
            self._formula.latex,
            tuple(held.symbol for held in symbols),
            tuple(held.unit for held in symbols),
            tuple(tuple(each.values[held.symbol] for held in symbols) for each in near),
            tuple(each.answer * self._factor for each in near),
        )

    def assumed(self, rng: np.random.Generator, words: Words) -> tuple[Regime, ...] | None:
        """The fewest regimes that leave no scene in which the formula does not hold; None if no few do."""
        failing = [other for other in self._variations.drawn(rng, WIDE, WIDELY) if not self._holds(other)]
        if not failing:
            return ()
        own, *others = self._near
        found = regimes(own.study, words, own.until)
        kept = [held for held in found if all(held.holds(other.study, other.until) for other in others)]
        excluded = {
            held: {n for n, other in enumerate(failing) if not held.holds(other.study, other.until)} for held in kept
        }
        options = (
            some for some in _some(kept) if len(set[int]().union(*(excluded[held] for held in some))) == len(failing)
        )
        return next(options, None)

    def _holds(self, other: Variation) -> bool:
        try:
            found = self._formula.value(other.values)
        except (ValueError, ZeroDivisionError, OverflowError):
            return False
        return abs(found - other.answer * self._factor) <= SAME * abs(other.answer * self._factor)


def _some(found: Sequence[Regime]) -> Iterator[tuple[Regime, ...]]:
    """One of them, or a few."""
    for count in range(1, FEW + 1):
        yield from combinations(found, count)


def _assuming(assumed: Sequence[Regime], words: Words) -> str:
    """As in: assume that block A moves down the slope and that the string stays taut."""
    return f"{ASSUME}{' and that '.join(sorted(held.clause(words) for held in assumed))}."


def _parted(text: str) -> tuple[str, str]:
    """What a question assumes, if it does, and what it asks."""
    if not text.startswith(ASSUME):
        return "", text
    assumed, stop, asked = text.partition(". ")
    return f"{assumed}.", asked if stop else ""


def _spoken(words: Words, query: Query) -> Words | None:
    """Words with symbols for the question's own numbers; None if it has one for which there is none."""
    clock = set[str]() if words.released else {"t"}  # of a text that speaks of t = 0
    own, taken = dict[str, OwnSymbol](), clock.union(words.symbols.values())
    for value, unit in query.moment.stated if query.moment is not None else ():
        found = symbol_for(value, unit, taken)
        if found is None or unit in own:
            return None
        own[unit] = found
    return replace(words, symbolic=True, own=own)


def _symbols(study: Study, words: Words) -> list[ProblemSymbol]:
    """All symbols of a problem in the order in which it tells them."""
    parameters = {p.path: p for p in study.scene.parameters}
    found = [(symbol, parameters[path]) for path, symbol in words.symbols.items() if path in parameters]
    said = [ProblemSymbol(symbol, p.measure.unit, p.value, p.path) for symbol, p in found if p.value]
    return [*said, *(ProblemSymbol(own.symbol, words.units.spell(unit), own.value) for unit, own in words.own.items())]

"""The symbolic mode: every number of the text is a symbol, and a formula is asked for."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain, combinations

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.modes.parts.variations import ProblemSymbol, Variation, Variations
from sim2reason.prose.description import Description
from sim2reason.prose.formula_numbers import factor
from sim2reason.prose.symbol_names import with_names
from sim2reason.prose.voices import symbolic_but_zero
from sim2reason.questions import KINDS, MODES, Formula, Query, Question, QuestionMode, Reading, Study, Words, mode
from sim2reason.questions.kinds import by_share
from sim2reason.questions.parse_question import parse_question
from sim2reason.questions.phrasing import chosen, sentence
from sim2reason.questions.regimes import FEW, Regime, possible, regimes
from sim2reason.questions.spoken import OwnSymbol, symbol_for
from sim2reason.questions.targets import targets
from sim2reason.solutions import STRATEGIES, Setting
from sim2reason.solutions.closed_forms import LONGEST, ClosedForm, ClosedFormError, put_together, shortened
from sim2reason.solutions.derivation import derivation
from sim2reason.solutions.expressions import Expression
from sim2reason.solutions.strategies import Strategy

POINTS = 8  # beside the scene's own
NEAR = (0.25, 0.08)  # relative: how far around the scene's numbers they lie, as far as its regime goes
WIDE = 1.1  # up to three times or a third of each: where the formula must hold, too, unless a regime is assumed
TRIES, WIDELY, ACROSS = 16, 24, 4
DRAWS = 3  # of questions of one kind
BARREN = 8  # questions in a row to which no formula leads, after which none is expected to about a scene
SAME = 1e-6  # relative: how well the formula agrees with the engine
ASSUME, JOINT = "Assume that ", " and that "


@mode
class Symbolic(QuestionMode):
    """What is this as a formula?"""

    name = "symbolic"

    @property
    def kinds(self) -> frozenset[str]:
        """Those that some strategy of worked solutions has a way to, if their answers are functions of the symbols."""
        derived = (strategy.kinds for strategy in STRATEGIES.values() if not strategy.integrates)
        return frozenset(name for name in frozenset[str]().union(*derived) if KINDS[name].of_symbols)

    def offers(self, mechanism: Mechanism) -> bool:
        """Whether some strategy of worked solutions may lead to a formula."""
        return not self.kinds.isdisjoint(_formulas(mechanism))

    def ask(self, study: Study, words: Words, kind: str, rng: np.random.Generator) -> Question | None:
        """Whatever some strategy of worked solutions leads to by formulas, still in numbers.

        None about a mechanism that is not its scene's, whose numbers no symbols stand for.
        """
        if study.mechanism is not study.scene.mechanism:
            return None
        names = [kind] if kind else [found.name for found in by_share(rng)]
        formulas = study.once("formulas", lambda: self.kinds & _formulas(study.mechanism))
        kinds = [name for name in names if name in formulas]
        refused = study.once("refused", set[Query])
        for name in (name for name in kinds for _ in range(DRAWS)):
            question = MODES["numeric"].ask(study, words, name, rng) if len(refused) < BARREN else None
            if question is not None and _derived(question.query, study, words) is not None:
                refused.clear()
                return replace(question, mode=self.name)
            refused |= {question.query} if question is not None else set()
        return None

    def completed(self, question: Question, study: Study, words: Words, rng: np.random.Generator) -> Question | None:
        """In symbols, with a formula; None if none is found that agrees with the engine wherever it should."""
        query, spoken = question.query, _spoken(words, question.query)
        whole = _derived(query, study, words)
        if spoken is None or whole is None:
            return None
        symbols = _symbols(study, spoken)
        if not {held.symbol for held in symbols}.issuperset(whole.symbols()):
            return None  # it goes by where the motion starts, which the text does not tell
        varied = _Varied(Variations(study, query, symbols), factor(question.unit))
        if not varied.of_scene(whole):
            return None
        try:
            found = shortened(whole)
        except ClosedFormError:
            return None
        assumed = varied.assumed(found, rng, spoken) if varied.near(found, rng) else None
        if assumed is None and varied.beyond and not question.sign:
            found = found.of_sizes(varied.beyond)
            assumed = varied.assumed(found, rng, spoken)
        if assumed is None or len(found.latex) > LONGEST:
            return None
        noun = targets(words)[query.target] if query.target is not None else None
        asked = sentence(chosen(KINDS[query.kind].shapes(query, spoken, noun), rng))
        text = f"{asked} {_assuming(assumed, spoken)}" if assumed else asked
        return replace(question, text=text, formula=varied.formula(found, symbols), assumed=assumed)

    def described(self, question: Question, description: Description) -> Description:
        """Every number but zero as a symbol, each with its name."""
        del question
        return with_names(description.voiced(symbolic_but_zero))

    def parsed(self, text: str, study: Study, words: Words) -> Reading | None:
        """A query in the words of its kind, before what is assumed."""
        if not words.symbolic:
            return None
        assumed, asked = _parted(text)
        query = parse_question(asked, study, words)
        if query is None:
            return None
        if not assumed:
            return Reading(self.name, query)
        clauses = {held.clause(words): held for held in possible(study, words)}
        said = assumed.removeprefix(ASSUME).removesuffix(".").split(JOINT)
        held = tuple(clauses[clause] for clause in said if clause in clauses)
        whole = len(held) == len(said) and _assuming(held, words) == assumed
        return Reading(self.name, query, assumed=held) if whole else None

    def solution(self, reading: Reading, study: Study, words: Words) -> float | None:
        """The answer with the numbers that the symbols have; None with those for which what is assumed is not so."""
        until = KINDS[reading.query.kind].time(reading.query, study) or 0.0
        if not all(held.holds(study, until) for held in reading.assumed):
            return None
        return super().solution(reading, study, words)


def _formulas(mechanism: Mechanism) -> frozenset[str]:
    """The kinds of question about a mechanism to which strategies of worked solutions may lead by formulas."""
    fitting = (strategy for strategy in STRATEGIES.values() if not strategy.unfit(mechanism))
    return frozenset[str]().union(*(strategy.formulas(mechanism) for strategy in fitting))


def _fitting(study: Study) -> tuple[Strategy, ...]:
    """The strategies that may apply to questions about a mechanism."""
    mechanism, offered = study.mechanism, STRATEGIES.values()
    return study.once("fitting", lambda: tuple(held for held in offered if not held.unfit(mechanism)))


def _derived(query: Query, study: Study, words: Words) -> Expression | None:
    """The formulas of a worked solution put into each other; None if there is none in symbols."""
    return study.once(("formula", query), lambda: _worked_out(query, study, words))


def _worked_out(query: Query, study: Study, words: Words) -> Expression | None:
    spoken = _spoken(words, query)
    if spoken is None:
        return None
    setting = Setting(study.scene, words, words.symbols, study, query)
    tried = [held for held in _fitting(study) if query.kind in held.formulas(study.mechanism)]
    if all(strategy.refusal(setting) for strategy in tried):
        return None
    solution = derivation(query, study, words)
    try:
        return put_together(solution, [own.symbol for own in spoken.own.values()]) if solution.derived else None
    except ClosedFormError:
        return None


class _Varied:
    """The scenes in which a formula must hold; each is simulated when it is first needed."""

    def __init__(self, variations: Variations, factor: float) -> None:
        """`factor` makes the engine's answers those of formulas: radians of degrees."""
        self._variations, self._factor = variations, factor
        self._near: list[Variation] = []
        self._wide: list[Variation] = []
        self._more: Iterator[Variation] | None = None
        self._barren: list[Study] = []  # motions far from the scene's own in which there is no answer

    def of_scene(self, whole: Expression) -> bool:
        """Whether a formula holds with the scene's own numbers, which are those that cost least."""
        own = self._variations.own()
        self._near = [own] if own is not None and self._agrees(whole, own) else []
        return bool(self._near)

    def near(self, formula: ClosedForm, rng: np.random.Generator) -> bool:
        """Whether as many fresh numbers as are needed are found, of one regime with the scene's own."""
        own = self._near[0]
        for width in NEAR:
            found = [own]
            for other in self._variations.drawn(rng, width, TRIES):
                if other.story == own.story and self._agrees(formula.expression, other):
                    found.append(other)
                if len(found) > POINTS:
                    self._near = found
                    return True
        return False

    def formula(self, found: ClosedForm, symbols: Sequence[ProblemSymbol]) -> Formula:
        """As a question has it."""
        own = [held.symbol for held in symbols if not held.of_world]
        return Formula(
            found.latex,
            tuple(held.symbol for held in symbols),
            tuple(held.unit for held in symbols),
            tuple(tuple(each.values[held.symbol] for held in symbols) for each in self._near),
            tuple(each.answer * self._factor for each in self._near),
            tuple(symbol for symbol in own if symbol in found.symbols),
            tuple(symbol for symbol in own if symbol not in found.symbols),
        )

    def assumed(self, formula: ClosedForm, rng: np.random.Generator, words: Words) -> tuple[Regime, ...] | None:
        """The fewest regimes that leave no scene in which the formula does not hold; None if no few do.

        And those that are told always, first of all. Where some few do, they also leave none that begins in another way
        or loses one, and then has no answer: a text that does not exclude that seems to ask for it, too.
        """
        kept = self._shared(words)
        told = {held for held in kept if held.always_told(self._near[0].study)}
        excluding: list[set[Regime]] = []
        for other in self._widely(rng):
            if self._agrees(formula.expression, other):
                continue
            excluding.append({held for held in kept if not held.holds(other.study, other.until)})
            if not excluding[-1]:
                return None
        begun = [*excluding, *self._begun_otherwise(kept)]
        fitting = [some for some in _some(kept) if told.issubset(some)]
        for left in (begun, excluding):
            if not left and not told:
                return ()
            chosen = next((some for some in fitting if all(not held.isdisjoint(some) for held in left)), None)
            if chosen is not None:
                return chosen
        return None

    @property
    def beyond(self) -> list[Mapping[str, float]]:
        """Numbers far from the scene's own for which something may be as it is not there."""
        return [other.values for other in self._wide]

    def _widely(self, rng: np.random.Generator) -> Iterator[Variation]:
        """With numbers far from the scene's own."""
        yield from self._wide
        self._more = self._more or chain(
            self._variations.across(rng, NEAR[-1], ACROSS),
            self._variations.drawn(rng, WIDE, WIDELY, self._barren),
        )
        for other in self._more:
            self._wide.append(other)
            yield other

    def _shared(self, words: Words) -> list[Regime]:
        """The regimes of all scenes that are near."""
        own, *others = self._near
        found = regimes(own.study, words, own.until)
        return [held for held in found if all(held.holds(other.study, other.until) for other in others)]

    def _begun_otherwise(self, kept: Sequence[Regime]) -> Iterator[set[Regime]]:
        """For each scene without an answer, the regimes that it is not in from the very start on, or loses, if any."""
        own = self._near[0].study
        first = [held for held in kept if held.holds(own, 0.0)]
        found = ({h for h in first if not h.holds(other, 0.0) or h.is_lost(other)} for other in self._barren)
        yield from filter(None, found)

    def _agrees(self, formula: Expression, other: Variation) -> bool:
        try:
            found = formula.value(other.values)
        except (ValueError, ZeroDivisionError, OverflowError):
            return False
        return abs(found - other.answer * self._factor) <= SAME * abs(other.answer * self._factor)


def _some(found: Sequence[Regime]) -> Iterator[tuple[Regime, ...]]:
    """One of them, or a few."""
    for count in range(1, FEW + 1):
        yield from combinations(found, count)


def _assuming(assumed: Sequence[Regime], words: Words) -> str:
    """As in: assume that block A moves down the slope and that the string stays taut."""
    return f"{ASSUME}{JOINT.join(sorted(held.clause(words) for held in assumed))}."


def _parted(text: str) -> tuple[str, str]:
    """What a question assumes, if it does, and what it asks."""
    asked, stop, assumed = text.partition(f" {ASSUME}")
    return f"{ASSUME}{assumed}" if stop else "", asked


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

"""The symbolic mode: stated numbers are symbols, and the answer is a formula under stated assumptions."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from sim2reason.generation.modes.formula_validity import FormulaValidity
from sim2reason.generation.modes.problem_formula import ProblemSymbol
from sim2reason.generation.modes.variations import Variations
from sim2reason.questions import (
    KINDS,
    MODES,
    ParsedQuestion,
    Query,
    Question,
    QuestionMode,
    SimulatedScene,
    Suits,
    Words,
    accepts_any_query,
    mode,
)
from sim2reason.questions.kinds import kinds_by_share
from sim2reason.questions.kinds.nested import NestedQuery
from sim2reason.questions.phrasing import draw_sentence, sentence
from sim2reason.questions.query import targets
from sim2reason.questions.regimes import Regime, possible
from sim2reason.questions.sentences import parse_question
from sim2reason.questions.words import OwnSymbol, symbol_for
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions import STRATEGIES, ProblemContext
from sim2reason.solutions.algebra.expressions import Expression
from sim2reason.solutions.closed_forms import ClosedFormError, combined_formula
from sim2reason.solutions.derivation import derivation
from sim2reason.solutions.reverse import forward
from sim2reason.solutions.strategies import applicable_strategies
from sim2reason.text.prose.description import Description, formula_unit_factor, with_names
from sim2reason.text.prose.voices import symbolic_but_zero

ASSUME = "Assume that "
_JOINTS = re.compile(r", and that |, that | and that ")
MAX_PARSES = 1000  # parses of one sentence that are tried


def assuming(assumed: Sequence[Regime], words: Words) -> str:
    """Return the sentence that states some assumptions.

    For example: *assume that block A moves down the slope and that the string stays taut*. Assumptions are in the order
    of time: the start, the whole motion, the moment. If two consecutive clauses concern one body, the second one calls
    it *it*.
    """
    ordered = sorted(assumed, key=lambda regime: (regime.stage, regime.clause(words)))
    clauses = [_clause(regime, ordered[:number], assumed, words) for number, regime in enumerate(ordered)]
    if len(clauses) < 3:
        return f"{ASSUME}{' and that '.join(clauses)}."
    return f"{ASSUME}{', that '.join(clauses[:-1])}, and that {clauses[-1]}."


def parse_assumptions(sentence: str, study: SimulatedScene, words: Words) -> tuple[Regime, ...] | None:
    """Return the assumptions that a sentence states about a scene; None if it is not such a sentence."""
    clauses = _JOINTS.split(sentence.removeprefix(ASSUME).removesuffix("."))
    regimes = possible(study, words)
    candidates = [[regime for regime in regimes if clause in _forms(regime, words)] for clause in clauses]
    readings = product(*candidates)
    for _, reading in zip(range(MAX_PARSES), readings, strict=False):
        if assuming(reading, words) == sentence:
            return reading
    return None


def split_assumptions(text: str) -> tuple[str, str]:
    """Split a question into its assumptions (may be empty) and the rest."""
    question, stop, assumed = text.partition(f" {ASSUME}")
    return f"{ASSUME}{assumed}" if stop else "", question


def _clause(regime: Regime, before: Sequence[Regime], beside: Sequence[Regime], words: Words) -> str:
    clause, subject = regime.clause_beside(words, beside), _subject(regime, words)
    same = bool(before) and subject and subject == _subject(before[-1], words)
    return _replace_subject(clause, subject) if same else clause


def _forms(regime: Regime, words: Words) -> Iterator[str]:
    for clause in (regime.clause(words), regime.short_clause(words)):
        yield clause
        yield _replace_subject(clause, _subject(regime, words))


def _subject(regime: Regime, words: Words) -> str:
    """Return the name of the body with which a clause begins; empty without a single body."""
    called = words.subject_phrases(regime.of).get(regime.name, "")
    return called if called and regime.clause(words).startswith(f"{called} ") else ""


def _replace_subject(clause: str, subject: str) -> str:
    return f"it{clause.removeprefix(subject)}" if subject else clause


MAX_DRAWS = 3  # questions of one kind
MAX_UNDERIVED = 8  # consecutive questions without a formula after which a scene is abandoned


@mode
class Symbolic(QuestionMode):
    """Question for a formula in the symbols of the stated numbers."""

    name = "symbolic"

    @property
    def kinds(self) -> frozenset[str]:
        """Return the kinds with a strategy of worked solutions whose answers are functions of the symbols."""
        derived = (strategy.kinds for strategy in STRATEGIES.values() if not strategy.integrates)
        return frozenset(name for name in frozenset[str]().union(*derived) if KINDS[name].of_symbols)

    def offers(self, mechanism: Mechanism) -> bool:
        """Return whether some strategy of worked solutions may lead to a formula."""
        return not self.kinds.isdisjoint(_formulas(mechanism))

    def ask(
        self, study: SimulatedScene, words: Words, kind: str, rng: np.random.Generator, suits: Suits = accepts_any_query
    ) -> Question | None:
        """Return a question, still in numbers, for which some strategy derives a formula; else None.

        None also for a mechanism that differs from its scene's, because no symbols stand for its numbers.
        """
        if study.mechanism is not study.scene.mechanism:
            return None
        names = [kind] if kind else [question_kind.name for question_kind in kinds_by_share(rng)]
        formulas = study.memoize("formulas", lambda: self.kinds & _formulas(study.mechanism))
        kinds = [name for name in names if name in formulas]
        refused = study.memoize("refused", set[Query])
        for name in (name for name in kinds for _ in range(MAX_DRAWS)):
            question = MODES["numeric"].ask(study, words, name, rng) if len(refused) < MAX_UNDERIVED else None
            if question is not None and not suits(question.query, "", None):
                continue
            if question is not None and _derived(question.query, study, words) is not None:
                refused.clear()
                return replace(question, mode=self.name)
            if question is not None and not isinstance(question.query, NestedQuery):  # which needs two formulas
                refused.add(question.query)
        return None

    def completed(
        self, question: Question, study: SimulatedScene, words: Words, rng: np.random.Generator
    ) -> Question | None:
        """Return the question with its formula and assumptions; None if no formula agrees with the engine."""
        moment = question.query.moment
        query = replace(question.query, moment=moment.in_symbols(study.trace) if moment is not None else None)
        symbolic_words = _symbolic_words(words, query)
        expression = _derived(query, study, words)
        if symbolic_words is None or expression is None:
            return None
        symbols = _symbols(study, symbolic_words, query.hides)
        if not {stated.symbol for stated in symbols}.issuperset(expression.symbols()):
            return None  # it goes by where the motion starts, which the text does not tell
        times = formula_unit_factor(question.unit)
        varied = FormulaValidity(Variations(study, query, symbols, expression, times), times)
        if not varied.of_scene(expression):
            return None
        stated = varied.stated_formula(expression, rng, symbolic_words, signed=bool(question.sign))
        if stated is None:
            return None
        closed_form, assumed = stated
        noun = targets(words)[query.target] if query.target is not None else None
        question_text = sentence(draw_sentence(KINDS[query.kind].shapes(query, symbolic_words, noun), rng))
        text = f"{question_text} {assuming(assumed, symbolic_words)}" if assumed else question_text
        return replace(question, query=query, text=text, formula=varied.formula(closed_form, symbols), assumed=assumed)

    def described(self, question: Question, description: Description) -> Description:
        """Return the description with a named symbol for every number but zero."""
        del question
        return with_names(description.voiced(symbolic_but_zero))

    def parsed(self, text: str, study: SimulatedScene, words: Words) -> ParsedQuestion | None:
        """Parse a query in the words of its kind, after removal of its assumptions."""
        if not words.symbolic:
            return None
        assumed, question = split_assumptions(text)
        query = parse_question(question, study, words)
        if query is None:
            return None
        if not assumed:
            return ParsedQuestion(self.name, query)
        assumptions = parse_assumptions(assumed, study, words)
        return ParsedQuestion(self.name, query, assumed=assumptions) if assumptions is not None else None

    def solution(self, asked: ParsedQuestion, study: SimulatedScene, words: Words) -> float | None:
        """Return the numeric answer for the values of the symbols; None if they violate a stated assumption."""
        until = KINDS[asked.query.kind].time(asked.query, study) or 0.0
        if not all(regime.holds(study, until) for regime in asked.assumed):
            return None
        return super().solution(asked, study, words)


def _formulas(mechanism: Mechanism) -> frozenset[str]:
    """Return the question kinds for which some strategy of worked solutions may derive a formula."""
    return frozenset[str]().union(*(strategy.formulas(mechanism) for strategy in applicable_strategies(mechanism)))


def _derived(query: Query, study: SimulatedScene, words: Words) -> Expression | None:
    """Return the formula of a worked solution after substitution; None if there is no symbolic one."""
    return study.memoize(("formula", query), lambda: _worked_out(query, study, words))


def _worked_out(query: Query, study: SimulatedScene, words: Words) -> Expression | None:
    symbolic_words = _symbolic_words(words, query)
    if symbolic_words is None:
        return None
    setting = forward(ProblemContext(study.scene, words, words.symbols, study, query))
    strategies = [
        candidate
        for candidate in applicable_strategies(study.mechanism)
        if query.kind in candidate.formulas(study.mechanism)
    ]
    if all(strategy.why_not_applicable(setting) for strategy in strategies):
        return None
    solution = derivation(query, study, words)
    try:
        return (
            combined_formula(solution, [own.symbol for own in symbolic_words.own.values()])
            if solution.derived
            else None
        )
    except ClosedFormError:
        return None


def _symbolic_words(words: Words, query: Query) -> Words | None:
    """Return the words of a text with symbols for the numbers in the question; None if one has no symbol."""
    clock = set[str]() if words.released else {"t"}  # of a text that speaks of t = 0
    own, taken = dict[str, OwnSymbol](), clock.union(words.symbols.values())
    for value, unit in query.moment.stated if query.moment is not None else ():
        symbol = symbol_for(value, unit, taken)
        if symbol is None or unit in own:
            return None
        own[unit] = symbol
    return words.in_symbols(own)


def _symbols(study: SimulatedScene, words: Words, hidden: str) -> list[ProblemSymbol]:
    """Return all symbols of a problem in the order of its text, except the unknown."""
    parameters = {p.path: p for p in study.scene.parameters if p.path != hidden}
    pairs = [(symbol, parameters[path]) for path, symbol in words.symbols.items() if path in parameters]
    stated = [ProblemSymbol(symbol, p.measure.unit, p.value, p.path, p.signed) for symbol, p in pairs if p.value]
    return [
        *stated,
        *(ProblemSymbol(own.symbol, words.units.spell(unit), own.value) for unit, own in words.own.items()),
    ]

"""Questions for the value of a number at which an outcome changes."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import product

import numpy as np

from sim2reason.errors import TextError
from sim2reason.questions.accuracy import CLEAR_ERROR_FACTOR, TOLERANCE
from sim2reason.questions.inversion import ThresholdSearch
from sim2reason.questions.kinds import Kind, Measured, kind
from sim2reason.questions.outcomes import OUTCOMES, PossibleOutcome
from sim2reason.questions.query import Noun, Query, Targets
from sim2reason.questions.structured import StructuredQuestion, resolve_name
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.unknown import draw_unknowns, is_usual
from sim2reason.questions.words import Words
from sim2reason.simulation.certify import WITNESS, Certificate
from sim2reason.simulation.trace import DEFAULT_STEP_RTOL, Channel

SEARCH_RTOL = (
    CLEAR_ERROR_FACTOR * TOLERANCE
)  # relative: search distance from the known threshold in a changed mechanism
WRONG_ANSWER_FACTOR = 4.0  # factor: search distance for an incorrect answer
PUNCTUATION_BY_VERB = {"what is": "?", "find": ".", "determine": ".", "calculate": "."}
WITNESS_RELATIVE_DISTANCE = 5e-3  # relative: distance on either side at which the second engine is compared


@dataclass(frozen=True, slots=True)
class ThresholdQuery(Query):
    """A query for the least or greatest value of a number for which an outcome is absent, or beyond which it occurs.

    At the limit itself nothing happens.
    """

    outcome: PossibleOutcome | None = None
    parameter: str = ""
    unit: str = ""
    greatest: bool = False
    happens: bool = True
    about: float = field(default=0.0, compare=False)  # where it is, if that is known of a scene like this one

    @property
    def hides(self) -> str:
        """Return the address of the number, which the text leaves open."""
        return self.parameter

    @property
    def subject(self) -> str:
        """Return the subject of the outcome."""
        return self.outcome.name if self.outcome is not None else ""

    def trial(self, study: SimulatedScene) -> ThresholdSearch:
        """Return the threshold search for the outcome in a scene."""
        assert self.outcome is not None
        return _shared_trial(study, self.outcome, self.parameter)


@kind
class ThresholdKind(Kind):
    """The kind that asks for the threshold value of a number at which an outcome changes."""

    name = "threshold"
    share = 0.25
    costly = True
    hides = True

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for an outcome that changes exactly once in a wide range of a number; None without one."""
        del targets
        outcomes = [outcome for cls in OUTCOMES.values() for outcome in cls.found(words)]
        if not outcomes:
            return None
        outcome = outcomes[int(rng.integers(len(outcomes)))]
        for unknown in draw_unknowns(words.unknowns, study.scene, rng):
            path = unknown.path
            change = study.memoize(("usual change", outcome, path), partial(_usual_change, study, outcome, path))
            if change is not None:
                critical, beyond = change
                happens = bool(rng.random() < 0.5)
                return ThresholdQuery(
                    self.name, None, None, outcome, path, unknown.unit, beyond is not happens, happens, critical
                )
        return None

    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the threshold, searched near a known one or else everywhere; None if there is none.

        Of a changed mechanism only where it is close to that: there other values are tried with the same change. None
        for another one that is not its scene's.
        """
        assert isinstance(query, ThresholdQuery)
        trial = query.trial(study)
        if study.mechanism is not study.scene.mechanism:
            return trial.close_to(query.about, SEARCH_RTOL) if study.change is not None and query.about else None
        return trial.find_change_near(query.about) if query.about else trial.change()

    def loose_answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the known threshold or one on a coarse grid, if the outcome changes as the query says; else None."""
        assert isinstance(query, ThresholdQuery)
        trial, above = query.trial(study), query.greatest is not query.happens
        error = study.trace.tolerance or DEFAULT_STEP_RTOL
        if query.about and trial.changes_at(query.about, above=above, error=error):
            return query.about
        return trial.rough_change(above=above, error=error)

    def with_likely_answer(self, query: Query, answer: float) -> Query:
        """Return a query that contains the likely threshold."""
        assert isinstance(query, ThresholdQuery)
        return replace(query, about=answer)

    def far_answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the threshold in a misread scene, searched for over a wide range."""
        assert isinstance(query, ThresholdQuery)
        return (
            query.trial(study).within(query.about, WRONG_ANSWER_FACTOR)
            if study.change is not None and query.about
            else None
        )

    def time(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the start, t = 0, as the recorded motion does not determine the answer."""
        del query, study
        return 0.0

    def indifferent(self, query: Query, study: SimulatedScene, other: SimulatedScene) -> bool:
        """Return whether the scenes differ only in gravity, which an outcome needs but which may cancel out."""
        del query
        return replace(other.mechanism, gravity=study.mechanism.gravity) == study.mechanism

    def measured(self, query: Query) -> Measured:
        """Return the unit of the number whose threshold is asked for, with zero as its least value."""
        assert isinstance(query, ThresholdQuery)
        return Measured("threshold", query.unit, least=0.0)

    def channels(self, query: Query) -> tuple[Channel, ...]:
        """Return no channels, as only the outcome on either side of the threshold matters."""
        del query
        return ()

    def doubt(self, query: Query, study: SimulatedScene, certificate: Certificate | None) -> str:
        """Return why the threshold is not unique, or not confirmed by the second engine; empty if it is."""
        del certificate
        assert isinstance(query, ThresholdQuery)
        assert query.outcome is not None
        first, second = query.trial(study), ThresholdSearch(study, query.outcome, query.parameter, WITNESS)
        if not first.changes_only_at(query.about):
            return "the outcome changes at other values too"
        sides = (query.about * (1.0 - WITNESS_RELATIVE_DISTANCE), query.about * (1.0 + WITNESS_RELATIVE_DISTANCE))
        agreed = all(first(side) is not None and first(side) == second(side) for side in sides)
        return "" if agreed else "the engines disagree on what happens next to the threshold"

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return sentences such as *what is the mass of B above which A begins to slip?*."""
        return tuple(shape for called in self.noun_phrases(query, words, noun) for shape in _asking(called))

    def noun_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return noun phrases such as *the mass of B above which A begins to slip*."""
        del noun
        assert isinstance(query, ThresholdQuery)
        assert query.outcome is not None
        phrases = next((item.phrases for item in words.unknowns if item.path == query.parameter), ())
        if query.happens:
            side = "below which" if query.greatest else "above which"
            limits = tuple(f"{_value(phrase)} {side}" for phrase in phrases)
        else:
            extremes = ("greatest", "largest") if query.greatest else ("least", "smallest")
            limits = tuple(f"{_extreme(*item)} for which" for item in product(extremes, phrases))
        clauses = query.outcome.does(words) if query.happens else query.outcome.does_not(words)
        return tuple(f"{limit} {clause}" for limit, clause in product(limits, clauses))

    def finds(self, words: Words) -> tuple[str, ...]:
        """Return the addresses of the scene's numbers; none if no outcome in the scene can depend on a number."""
        possible = any(outcome.candidates(words) for outcome in OUTCOMES.values())
        return tuple(unknown.path for unknown in words.unknowns) if possible else ()

    def posed(self, asked: StructuredQuestion, study: SimulatedScene, words: Words) -> Query | None:
        """Return the query for the critical value of a number, such as *ramp.plane.angle* for the outcome *slides*."""
        text = asked.when.replace("_", " ")
        spelled = {name.replace("_", " "): cls for name, cls in OUTCOMES.items()}
        does = max((name for name in spelled if text.endswith(name)), key=len, default="")
        if not does:
            remedy = f"there are: {', '.join(spelled)}; or give what it makes so, such as --given 'velocity = 2 m/s'"
            raise TextError("when", f"{asked.when!r} is nothing that may happen or not", remedy)
        cls, subject = spelled[does], text.removesuffix(does).strip()
        outcome = cls(resolve_name("when", subject or asked.of, cls.candidates(words)))
        unit = next(unknown.unit for unknown in words.unknowns if unknown.path == asked.find)
        trial = _shared_trial(study, outcome, asked.find)
        critical = trial.change() or 0.0
        below = trial(critical * (1.0 - WITNESS_RELATIVE_DISTANCE)) is True
        return ThresholdQuery(self.name, None, None, outcome, asked.find, unit, greatest=below, about=critical)

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for every outcome of a subject that a sentence names, with every unknown number."""
        del study, targets
        outcomes = [outcome for cls in OUTCOMES.values() for outcome in cls.parsed(text, words)]
        for outcome, unknown in product(outcomes, words.unknowns):
            for greatest, happens in product((False, True), repeat=2):
                yield ThresholdQuery(self.name, None, None, outcome, unknown.path, unknown.unit, greatest, happens)


def _shared_trial(study: SimulatedScene, outcome: PossibleOutcome, path: str) -> ThresholdSearch:
    """Return the threshold search of an outcome and a number, which all questions about a study share."""
    return study.memoize(("trial", outcome, path), partial(ThresholdSearch, study, outcome, path))


def _usual_change(study: SimulatedScene, outcome: PossibleOutcome, path: str) -> tuple[float, bool | None] | None:
    """Return the threshold in the usual range, and whether the outcome occurs above it; None without a threshold."""
    trial = ThresholdSearch(study, outcome, path)
    critical = trial.usual_change()
    if critical is None or not is_usual(study.scene, path, critical):
        return None
    return critical, trial(critical * (1.0 + WITNESS_RELATIVE_DISTANCE))


def _extreme(extreme: str, phrase: str) -> str:
    """Return the noun phrase for an extreme: *the least mass of block A*, *the least value of m*."""
    if phrase.startswith("the "):
        return f"the {extreme} {phrase.removeprefix('the ')}"
    return f"the {extreme} value of {phrase}"


def _value(phrase: str) -> str:
    """Return the noun phrase for a value: *the mass of block A*, *the value of m*."""
    return phrase if phrase.startswith("the ") else f"the value of {phrase}"


def _asking(limit: str) -> tuple[str, ...]:
    return tuple(f"{verb} {limit}{end}" for verb, end in PUNCTUATION_BY_VERB.items())

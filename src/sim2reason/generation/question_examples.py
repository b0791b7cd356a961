"""Examples of all kinds of questions, in words and as structured parts, from scenes of the recipes."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cache
from typing import NamedTuple

import numpy as np

from sim2reason.errors import TextError
from sim2reason.generation.asked_scenes import ASKED
from sim2reason.generation.example_scenes import OWN
from sim2reason.generation.item_search import sample
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import KINDS, MOMENTS, Query, Words
from sim2reason.questions.following import FollowedMotion, simulate_scene
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.kinds import moments_by_cause
from sim2reason.questions.kinds.comparison import ComparisonQuery
from sim2reason.questions.kinds.limit import LimitQuery
from sim2reason.questions.kinds.nested import OR, NestedQuery, WhichQuery
from sim2reason.questions.kinds.optimum import OptimumQuery
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.moments import Happening, Moment
from sim2reason.questions.ordinary.understanding import understand_sentence
from sim2reason.questions.outcomes import OUTCOMES
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import targets
from sim2reason.questions.structured import StructuredQuestion, moment_told
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import loads
from sim2reason.text.prose.description import describe

LEVELS = "medium", "easy", "hard"
SEED_COUNT = 12  # scenes of each recipe


class AskedExample(NamedTuple):
    """A question in words, and its parts as options of *solve*."""

    sentence: str
    parts: str


@dataclass
class Examples:
    """The first example question for each registered quantity, functional, moment, outcome and kind, by name."""

    quantities: dict[str, AskedExample] = field(default_factory=dict[str, AskedExample])
    functionals: dict[str, AskedExample] = field(default_factory=dict[str, AskedExample])
    moments: dict[str, AskedExample] = field(default_factory=dict[str, AskedExample])
    outcomes: dict[str, AskedExample] = field(default_factory=dict[str, AskedExample])
    kinds: dict[str, AskedExample] = field(default_factory=dict[str, AskedExample])


def examples() -> Examples:
    """Return the first example question for each registered member; every call returns the same examples."""
    collected = Examples()
    for number, scene in enumerate(scenes()):
        motion, words = simulate_scene(scene), words_of(describe(scene, number))
        for query in _queries(motion, words, np.random.default_rng(number), collected):
            _enter(query, motion, words, collected)
    for own in (*OWN, *ASKED):
        scene = loads(own.text)
        motion, words = simulate_scene(scene), words_of(describe(scene))
        for sentence in own.asked:
            interpretation = understand_sentence(sentence, motion, words)
            if interpretation is not None:
                _enter(interpretation.posed_question.query, motion, words, collected, sentence)
    return collected


@cache
def scenes() -> tuple[Scene, ...]:
    """Return the scenes searched for examples: those with rare features first, then some of every recipe."""
    drawn = (sample(recipe, LEVELS[seed % len(LEVELS)], seed=seed) for seed in range(SEED_COUNT) for recipe in RECIPES)
    return (*(loads(own.text) for own in (*OWN, *ASKED)), *drawn)


def _queries(motion: FollowedMotion, words: Words, rng: np.random.Generator, collected: Examples) -> Iterator[Query]:
    """Yield queries about a scene: every quantity, every moment, and a draw of each kind without an example."""
    study, offered = motion.study, targets(words)
    moments = [moment for cls in moments_by_cause() for moment in list(cls.found(study, words, rng))[:1]]
    for moment in moments:
        if isinstance(moment, Happening) and moment.clause(words) is not None:
            yield Query("time_to_event", None, moment)
        if moment.kind in ("state", "event"):
            queries = (Query(moment.kind, target, moment) for target in offered)
            yield from (query for query in queries if _is_something(query, motion))
    yield from _stretches(moments, motion, words, collected)
    for cls in OUTCOMES.values():
        for outcome in cls.found(words):
            yield from (
                ThresholdQuery("threshold", None, None, outcome, unknown.path, unknown.unit)
                for unknown in words.unknowns
            )
    for name, kind in KINDS.items():
        query = kind.draw(study, words, offered, rng) if name == "start" or name not in collected.kinds else None
        if query is not None:
            yield query


def _is_something(query: Query, motion: FollowedMotion) -> bool:
    """Return whether a query has an answer that differs noticeably from zero."""
    answer = KINDS[query.kind].answer(query, motion.study)
    return answer is not None and abs(answer) > KINDS[query.kind].measured(query).least


def _stretches(moments: list[Moment], motion: FollowedMotion, words: Words, collected: Examples) -> Iterator[Query]:
    """Yield questions for each functional without an example, over the motion up to each suitable moment."""
    for functional in FUNCTIONALS.values():
        named = words.subject_phrases(functional.of) if functional.name not in collected.functionals else ()
        for name in named:
            if not functional.present(words, name):
                continue
            for moment in moments:
                query = StretchQuery(functional.kind, None, moment, functional.name, name)
                if functional.when(moment, words, name) and KINDS[query.kind].answer(query, motion.study):
                    yield query


def _enter(query: Query, motion: FollowedMotion, words: Words, collected: Examples, given_sentence: str = "") -> None:
    """Add a query as the example of each name without one, if its parts parse back to an equal query.

    The example's sentence is `given_sentence`, or else the library's own.
    """
    entries = _names(query)
    table = vars(collected)
    new = [(registry, name) for registry, name in entries if name not in table[registry]]
    structured = _structured_parts(query, motion, words) if new else None
    if structured is None:
        return
    try:
        question = pose_question(structured, motion, words)
    except TextError:
        return
    sentence = given_sentence or question.sentence(words)
    alike = question.query == query or isinstance(query, ThresholdQuery)
    if not sentence or not alike:
        return
    for registry, name in new:
        table[registry][name] = AskedExample(sentence, _options(structured))


def _names(query: Query) -> list[tuple[str, str]]:
    """Return pairs of a registry and a name for all registered components in a query: its kind, quantity and moment."""
    names = [("kinds", query.kind)]
    if isinstance(query, WhichQuery):
        return names
    if isinstance(query, StretchQuery):
        names.append(("functionals", query.functional))
    elif query.target is not None and not isinstance(query, NestedQuery):
        names.append(("quantities", query.target.quantity))
    if isinstance(query, ThresholdQuery) and query.outcome is not None:
        names.append(("outcomes", next(name for name, cls in OUTCOMES.items() if cls is type(query.outcome))))
    if query.moment is not None:
        names += [("moments", name) for name, cls in MOMENTS.items() if cls is type(query.moment)]
    return names


def _structured_parts(query: Query, motion: FollowedMotion, words: Words) -> StructuredQuestion | None:
    """Return a query as structured parts (find, of, when); None if its kind has no such form here."""
    if isinstance(query, NestedQuery | WhichQuery):
        return _of_others(query, motion, words)
    when = _when(query.moment, words)
    if isinstance(query, ThresholdQuery):
        outcome = query.outcome
        name = next((name for name, cls in OUTCOMES.items() if cls is type(outcome)), "").replace("_", " ")
        return StructuredQuestion(query.parameter, when=f"{outcome.name if outcome else ''} {name}")
    if isinstance(query, PeriodQuery):
        of = query.of[0] if len(query.of) == 1 else ""
        return StructuredQuestion(query.measure, of, "equilibrium" if query.small else "")
    if isinstance(query, StretchQuery):
        return StructuredQuestion(query.functional, query.name, "" if when == "whole motion" else when)
    target = query.target
    if target is None:
        return StructuredQuestion("time", when=when) if query.kind == "time_to_event" else None
    along = target.sense.axis or target.sense.positive if target.sense is not None else ""
    return StructuredQuestion(target.quantity, target.subject, when or "equilibrium", along)


def _of_others(query: NestedQuery | WhichQuery, motion: FollowedMotion, words: Words) -> StructuredQuestion | None:
    """Return the structured question for a query that contains one other query, as a limit does, or two."""
    if isinstance(query, NestedQuery):
        return _nested(query, motion, words)
    return _of_two(*(_structured_parts(each, motion, words) for each in query.both))


def _of_two(first: StructuredQuestion | None, second: StructuredQuestion | None) -> StructuredQuestion | None:
    """Return the structured parts of a comparison of two queries that differ in subject or moment."""
    if first is None or second is None:
        return None
    of, when = (OR.join(dict.fromkeys(pair)) for pair in ((first.of, second.of), (first.when, second.when)))
    return replace(first, of=of, when=when)


def _when(moment: Moment | None, words: Words) -> str:
    return moment_told(moment, words) if moment is not None else ""


def _nested(query: NestedQuery, motion: FollowedMotion, words: Words) -> StructuredQuestion | None:
    """Return the parts of a nested query: the inner query's parts with the outer query's change or condition."""
    inner = _structured_parts(query.inner, motion, words)
    if inner is None:
        return None
    parts = {"of": inner.of, "when": inner.when, "along": inner.along}
    if isinstance(query, OptimumQuery):
        extreme = "greatest" if query.greatest else "least"
        if query.asks_place:
            return StructuredQuestion(query.path, **parts, given=f"{inner.find} = {extreme}")
        return StructuredQuestion(inner.find, **parts, change=f"{query.path} = {extreme}")
    if isinstance(query, LimitQuery):
        return StructuredQuestion(inner.find, **parts, change=f"{query.path} = {'infinity' if query.large else 0}")
    if isinstance(query, ComparisonQuery):
        compare = "ratio" if query.ratio else "difference"
        return StructuredQuestion(inner.find, **parts, change=f"{query.path} × {query.factor:g}", compare=compare)
    return None


def _options(question: StructuredQuestion) -> str:
    """Return the parts of a question as options on a command line."""
    parts = {
        "find": question.find,
        "of": question.of,
        "when": question.when,
        "along": question.along,
        "given": question.given,
    }
    parts |= {"change": question.change, "compare": question.compare if question.compare != "ratio" else ""}
    return " ".join(f"--{name} {_quoted(part)}" for name, part in parts.items() if part)


def _quoted(part: str) -> str:
    return f'"{part}"' if set(part) & set(" &=×*;()") else part

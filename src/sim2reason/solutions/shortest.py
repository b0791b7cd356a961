"""The worked solution of a question with the simplest mathematics, found before the prompt is written.

Numerical integration is not used: if only that would lead to the answer, the solution has none.
"""

from collections.abc import Hashable

from sim2reason.questions import Query, SimulatedScene, StatedResult, Words
from sim2reason.questions.difficulty import Need
from sim2reason.solutions.reverse import forward
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.solve import solve
from sim2reason.solutions.strategies import closed_form_strategies
from sim2reason.solutions.verification import verify_solution

FOUND, SHORTEST = "shortest solution", "shortest"


def shortest_solution(
    query: Query,
    study: SimulatedScene,
    words: Words,
    unknown: str = "",
    stated: StatedResult | None = None,
    most: Need = Need.SPECIAL_FUNCTION,
) -> Solution:
    """Return the simplest solution of a query, or of the reverse question for `unknown` given the `stated` result.

    The mathematics of a solution may not exceed `most`. `unknown` is the address of a parameter of the scene. The data
    of the solution are only recomputed by `shortest_verified_solution`, since filters reject most questions before.
    """
    setting = _setting(query, study, words, unknown, stated, most)
    found = study.memoize(_key(query, unknown, stated, setting.most), lambda: solve(setting, checked=False))
    if found.answer is not None and not unknown and stated is None:
        study.memoize((FOUND, query), lambda: found)
    return found


def shortest_verified_solution(
    query: Query, study: SimulatedScene, words: Words, unknown: str, stated: StatedResult | None, most: Need
) -> Solution:
    """Return the simplest solution of a query, without an answer if recomputation from its data gives another."""
    found = shortest_solution(query, study, words, unknown, stated, most)
    setting = _setting(query, study, words, unknown, stated, most)
    if found.answer is None or verify_solution(found, forward(setting)).answer is not None:
        return found
    return study.keep(_key(query, unknown, stated, setting.most), solve(setting))


def _setting(
    query: Query, study: SimulatedScene, words: Words, unknown: str, stated: StatedResult | None, most: Need
) -> ProblemContext:
    most = min(most, Need.SPECIAL_FUNCTION)
    return ProblemContext(study.scene, words, words.symbols, study, query, unknown, stated, most=most)


def is_solved(query: Query, study: SimulatedScene, unknown: str, stated: StatedResult | None, most: Need) -> bool:
    """Return whether `shortest_solution` has a cached solution for these arguments."""
    return study.is_cached(_key(query, unknown, stated, min(most, Need.SPECIAL_FUNCTION)))


def _key(query: Query, unknown: str, stated: StatedResult | None, most: Need) -> Hashable:
    return SHORTEST, query, unknown, stated, most


def cached_shortest_solution(query: Query, study: SimulatedScene) -> Solution | None:
    """Return the cached solution of a query; None if there is none."""
    return study.memoize((FOUND, query), lambda: Solution("")) if study.is_cached((FOUND, query)) else None


def may_have_solution(kind: str, study: SimulatedScene, most: Need) -> bool:
    """Return whether some strategy may answer generated questions of a kind with mathematics of level `most`."""
    found = study.memoize(
        ("needed least", kind),
        lambda: [each.least_need for each in closed_form_strategies(kind, study.mechanism) if each.drawn],
    )
    return min(found, default=Need.INTEGRATION) <= most

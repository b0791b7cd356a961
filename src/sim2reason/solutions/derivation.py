"""The simplest worked solution of a question and the derivation of its formula, cached per simulated scene.

Numerical integration is not used for the simplest solution: if only that would lead to the answer, it has none.
"""

from collections.abc import Hashable
from dataclasses import replace

from sim2reason.questions import Query, SimulatedScene, StatedResult, Words
from sim2reason.questions.difficulty import Need
from sim2reason.solutions.reverse import forward
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.solve import solve
from sim2reason.solutions.strategies import STRATEGIES, closed_form_strategies
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
    solution = study.memoize(_key(query, unknown, stated, setting.most), lambda: solve(setting, checked=False))
    if solution.answer is not None and not unknown and stated is None:
        study.memoize((FOUND, query), lambda: solution)
    return solution


def shortest_verified_solution(
    query: Query, study: SimulatedScene, words: Words, unknown: str, stated: StatedResult | None, most: Need
) -> Solution:
    """Return the simplest solution of a query, without an answer if recomputation from its data gives another."""
    solution = shortest_solution(query, study, words, unknown, stated, most)
    setting = _setting(query, study, words, unknown, stated, most)
    if solution.answer is None or verify_solution(solution, forward(setting)).answer is not None:
        return solution
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
    needs = study.memoize(
        ("needed least", kind),
        lambda: [each.least_need for each in closed_form_strategies(kind, study.mechanism) if each.drawn],
    )
    return min(needs, default=Need.INTEGRATION) <= most


DERIVATION = "derivation"


def derivation(query: Query, study: SimulatedScene, words: Words) -> Solution:
    """Return the closed-form worked solution of a query with the simplest mathematics, cached; it may have no answer.

    The query itself is answered even where the text states its answer and asks for a parameter. For *when is the speed
    2.1 m/s?* the derivation gives the speed at that time.
    """
    return study.memoize((DERIVATION, query), lambda: _derived(query, study, words))


def is_derived(query: Query, study: SimulatedScene) -> bool:
    """Return whether the derivation of a query is cached already."""
    return study.is_cached((DERIVATION, query)) or cached_shortest_solution(query, study) is not None


def _derived(query: Query, study: SimulatedScene, words: Words) -> Solution:
    solution = cached_shortest_solution(query, study)
    if solution is not None and query.kind in STRATEGIES[solution.strategy].formulas(study.mechanism):
        return solution
    setting = forward(ProblemContext(study.scene, words, words.symbols, study, query))
    if query.hides:  # the number that it asks for is the unknown of its laws
        return solve(setting, derived=True)
    return solve(replace(setting, unknown="", stated=None, sought=None), derived=True)

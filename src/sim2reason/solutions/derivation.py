"""The derivation of the formula that answers a query, cached per simulated scene."""

from dataclasses import replace

from sim2reason.questions import Query, SimulatedScene, Words
from sim2reason.solutions.reverse import forward
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.shortest import cached_shortest_solution
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.solve import solve
from sim2reason.solutions.strategies import STRATEGIES

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
    found = cached_shortest_solution(query, study)
    if found is not None and query.kind in STRATEGIES[found.strategy].formulas(study.mechanism):
        return found
    setting = forward(ProblemContext(study.scene, words, words.symbols, study, query))
    if query.hides:  # the number that it asks for is the unknown of its laws
        return solve(setting, derived=True)
    return solve(replace(setting, unknown="", stated=None, sought=None), derived=True)

"""The values of a number of the scene for which a query has a given answer."""

from collections.abc import Sequence

from sim2reason.questions.dependence import AnswerFunction, find_roots, with_long_strings
from sim2reason.questions.query import Query
from sim2reason.questions.study import COARSE_STEP_ERROR, EXACT_STEP_ERROR, SimulatedScene
from sim2reason.questions.unknown import Unknown, beyond_range, range_of
from sim2reason.scenes.dsl.constancy import changing
from sim2reason.scenes.dsl.scene import Scene

PATIENCE = {False: tuple(4.0**n for n in range(2, 12)), True: (16.0, 64.0)}
"""Times the horizon, till when results are waited for with no value found; fewer where motions are integrated."""
DIPS = 4  # greatest number of extrema of the answer that are examined
GOLDEN = (5.0**0.5 - 1.0) / 2.0
ROUNDS = 60  # of golden-section search
TOUCHED, ZERO = 1e-9, 1e-7  # relative: how closely an extremum is found, and what is no distance from it
SPARSE = 4  # only every fourth point of a range is tried with simulations of long duration


def values_giving(query: Query, given: float, unknown: Unknown, study: SimulatedScene) -> list[float]:
    """Return the values of an unknown number that give a query's answer, from the usual range or else from beyond."""

    def looked_for() -> list[float]:
        scene, path = study.scene, unknown.path
        dependence = AnswerFunction(query, study, path, EXACT_STEP_ERROR, with_long_strings(scene))
        found = find_roots(dependence, range_of(scene, path), given)
        patient = AnswerFunction(
            query,
            study,
            path,
            EXACT_STEP_ERROR,
            with_long_strings(scene),
            None,
            PATIENCE[bool(changing(study.mechanism))],
        )
        for values in () if found else (range_of(scene, path)[::SPARSE], *beyond_range(scene, path)):
            found += find_roots(patient, values, given)
        return found or _approached(dependence, range_of(scene, path), beyond_range(scene, path), given)

    return study.memoize(("values giving", query, given, unknown.path), looked_for)


def _approached(
    dependence: AnswerFunction, usual: Sequence[float], beyond: Sequence[Sequence[float]], given: float
) -> list[float]:
    """Return the numbers for which an answer touches `given`, or just passes it and returns, near one of its extremes.

    An answer that is a magnitude does not change sign where it is zero: on both sides it is greater.
    """
    coarse = dependence.coarser(COARSE_STEP_ERROR)
    tried = sorted({*usual, *(value for values in beyond for value in values)})
    apart = [(at, abs(found - given)) for at in tried if (found := coarse(at)) is not None]
    triples = zip(apart, apart[1:], apart[2:], strict=False)
    dips = [(one[0], other[0]) for one, middle, other in triples if middle[1] < min(one[1], other[1])]
    return [root for low, high in dips[:DIPS] for root in _in_dip(dependence, low, high, given)]


def _in_dip(dependence: AnswerFunction, low: float, high: float, given: float) -> list[float]:
    """Return the numbers between `low` and `high` with answer `given`, near an extreme of the answer between them.

    The golden-section search ends where the answer is as given or beyond; there it passes twice.
    """
    start = dependence(low)
    if start is None:
        return []
    side, size = start > given, abs(start - given)
    points = [low, high - GOLDEN * (high - low), low + GOLDEN * (high - low), high]
    for _ in range(ROUNDS):
        found = [dependence(at) for at in points[1:3]]
        if found[0] is None or found[1] is None:
            return []
        for at, answer in zip(points[1:3], found, strict=True):
            if answer is not None and (answer > given) is not side and answer != given:
                ends = dependence.between(given, low, at), dependence.between(given, at, high)
                return [end for end in ends if end is not None]
        nearer = abs(found[0] - given) < abs(found[1] - given)
        one, other = (points[0], points[2]) if nearer else (points[1], points[3])
        points = [one, other - GOLDEN * (other - one), one + GOLDEN * (other - one), other]
        if other - one <= TOUCHED * abs(other):
            break
    middle = 0.5 * (points[0] + points[3])
    least = dependence(middle)
    return [middle] if least is not None and abs(least - given) <= ZERO * size else []


def why_not_one(unknown: Unknown, found: Sequence[float], scene: Scene) -> str:
    """Return a clause explaining why an unknown number has no single value; empty if there is exactly one."""
    if len(found) == 1:
        return ""
    if found:
        return f"several values of {unknown.symbol} do: {', '.join(f'{value:.6g} {unknown.unit}' for value in found)}"
    ends = [end for values in (range_of(scene, unknown.path), *beyond_range(scene, unknown.path)) for end in values]
    return f"no value of {unknown.symbol} from {min(ends):.3g} to {max(ends):.3g} {unknown.unit} does"

"""The values of a number of the scene for which a query has a given answer."""

from collections.abc import Sequence

from sim2reason.questions.dependence import Dependence, roomy, roots
from sim2reason.questions.query import Query
from sim2reason.questions.study import ENOUGH, Study
from sim2reason.questions.unknown import Unknown, beyond_range, range_of
from sim2reason.scenes.dsl.constancy import changing
from sim2reason.scenes.dsl.scene import Scene

PATIENCE = {False: tuple(4.0**n for n in range(2, 12)), True: (16.0, 64.0)}
"""Times the horizon, till when results are waited for with no value found; fewer where motions are integrated."""
SPARSE = 4  # every so many points of a range are tried with that patience


def values_giving(query: Query, given: float, unknown: Unknown, study: Study) -> list[float]:
    """Return the values of an unknown number that give a query's answer, from the usual range or else from beyond."""

    def looked_for() -> list[float]:
        scene, path = study.scene, unknown.path
        dependence = Dependence(query, study, path, ENOUGH, roomy(scene))
        found = roots(dependence, range_of(scene, path), given)
        patient = Dependence(query, study, path, ENOUGH, roomy(scene), None, PATIENCE[bool(changing(study.mechanism))])
        for values in () if found else (range_of(scene, path)[::SPARSE], *beyond_range(scene, path)):
            found += roots(patient, values, given)
        return found

    return study.once(("values giving", query, given, unknown.path), looked_for)


def why_not_one(unknown: Unknown, found: Sequence[float], scene: Scene) -> str:
    """Return a clause explaining why an unknown number has no single value; empty if there is exactly one."""
    if len(found) == 1:
        return ""
    if found:
        return f"several values of {unknown.symbol} do: {', '.join(f'{value:.6g} {unknown.unit}' for value in found)}"
    ends = [end for values in (range_of(scene, unknown.path), *beyond_range(scene, unknown.path)) for end in values]
    return f"no value of {unknown.symbol} from {min(ends):.3g} to {max(ends):.3g} {unknown.unit} does"

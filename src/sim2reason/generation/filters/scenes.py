"""Filters that reject a scene before any question about it."""

from collections.abc import Iterator

from sim2reason.generation.filters import FILTERS, Candidate, SceneFilter
from sim2reason.questions import SimulatedScene
from sim2reason.scenes.dsl.magnitudes import implausible_numbers
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.scenes.dsl.mechanism import Inextensible
from sim2reason.scenes.dsl.structure import changing
from sim2reason.simulation.quantities.kinematics import Acceleration


class Magnitudes(SceneFilter):
    """Filter for implausible numbers: stated values, densities, mass ratios or initial lengths of springs."""

    def scene_reason(self, study: SimulatedScene) -> str:
        """Return a reason if a number of the scene, such as a density or a spring's initial length, is implausible."""
        return study.memoize("implausible numbers", lambda: next(implausible_numbers(study.scene), ""))

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: all implausible values."""
        return implausible_numbers(candidate.study.scene)


FILTERS.add("magnitudes", Magnitudes())


ACCELERATION_FLOOR = 1e-6  # m/s²
SEVERAL = 2  # parts of a scene from which on the filter applies


class Opposed(SceneFilter):
    """Filter for scenes in which all weights of several entities descend, so that none opposes another.

    A row of blocks on one slope belongs to one entity. Springs and swinging bodies are ignored.
    """

    def scene_reason(self, study: SimulatedScene) -> str:
        """Return a reason if bodies of several entities accelerate downwards just after the start and none upwards."""
        if not study.mechanism.strings or changing(study.mechanism):
            return ""
        up = _accelerations(study)
        down = {name.partition(".")[0] for name, upwards in up.items() if upwards < -ACCELERATION_FLOOR}
        rises = any(upwards > ACCELERATION_FLOOR for upwards in up.values())
        return "all that has a weight runs down together" if len(down) >= SEVERAL and not rises else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: whether each accelerated body first accelerates upwards or downwards."""
        moving = {name: up for name, up in _accelerations(candidate.study).items() if abs(up) > ACCELERATION_FLOOR}
        yield from (f"{name} is accelerated {'up' if up > 0.0 else 'down'}" for name, up in moving.items())


def _accelerations(study: SimulatedScene) -> dict[str, float]:
    """Return the vertical accelerations of all bodies with mass just after the start, m/s², positive upwards."""
    state = study.trace.at(0.0)
    heavy = [body.name for body in state.mechanism.bodies if body.mass > 0.0]
    return {name: float(Acceleration.evaluate(state, name)[0, 2]) for name in heavy}


FILTERS.add("opposed", Opposed())


TENSION_FLOOR = 1e-9  # N


class Taut(SceneFilter):
    """Filter for scenes with a string called taut whose tension is zero just after the start."""

    def scene_reason(self, study: SimulatedScene) -> str:
        """Return the first string whose tension is zero just after the start."""
        return next(
            (f"{name} is slack from the start on" for name, t in _tensions(study).items() if t <= TENSION_FLOOR), ""
        )

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield a report line with the smallest string tension just after the start."""
        tensions = _tensions(candidate.study)
        if tensions:
            name = min(tensions, key=lambda each: tensions[each])
            unit = candidate.study.mechanism.units.spell("N")
            yield f"the least tension just after the start is {join_unit(f'{tensions[name]:.4g}', unit)}, in {name}"


def _tensions(study: SimulatedScene) -> dict[str, float]:
    """Return the tensions of all strings just after the start, N."""
    law, tension = Inextensible(), study.trace.at(0.0).tension
    return {line.name: float(tension[line.name][0]) for line in study.mechanism.strings if line.law == law}


FILTERS.add("taut", Taut())

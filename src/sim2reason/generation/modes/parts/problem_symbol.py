"""Symbols for the numbers of a problem, and variations of the problem with other numbers."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite

from sim2reason.errors import SimulationError
from sim2reason.questions import KINDS, Query, SimulatedScene
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import ENGINES
from sim2reason.text.prose.description import factor


@dataclass(frozen=True, slots=True)
class ProblemSymbol:
    """A symbol of a problem, with its unit and value as stated, and the address of its number.

    Numbers of the question itself have no address. A `signed` symbol may stand for a negative number.
    """

    symbol: str
    unit: str
    value: float
    path: str = ""
    signed: bool = False

    @property
    def of_world(self) -> bool:
        """Return whether the symbol belongs to the world, as g does, not to an object in it."""
        return self.path.startswith("world.")

    def counted(self, value: float) -> float:
        """Return a value in the units of formulas: radians for degrees, metres for kilometres."""
        return value * factor(self.unit)


@dataclass(frozen=True)
class Variation:
    """A scene with other numbers: the values in formula units, the motion and the answer."""

    values: Mapping[str, float]
    study: SimulatedScene
    query: Query
    answer: float

    @property
    def until(self) -> float:
        """Return the latest time on which the answer depends, s."""
        return KINDS[self.query.kind].time(self.query, self.study) or 0.0

    @property
    def story(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """Return the events up to the latest time on which the answer depends, in order, without turning points."""
        return self.study.trace.story(self.until)

    @property
    def finer(self) -> "Variation | None":
        """Return the variation simulated with the smallest steps; None without an answer, or if it already is."""
        scene, trace = self.study.scene, self.study.trace
        if not trace.tolerance:
            return None
        try:
            found = answered(self.query, SimulatedScene(scene, ENGINES[RECORDED](scene.mechanism, trace.state.times)))
        except SimulationError:
            return None
        return None if found is None else Variation(self.values, *found)


def answered(query: Query, study: SimulatedScene) -> tuple[SimulatedScene, Query, float] | None:
    """Return the motion, query and answer, simulated as long as needed; None if there is no answer."""
    answer = KINDS[query.kind].loose_answer(query, study)
    time = KINDS[query.kind].time(query, study)
    if answer is None or not isfinite(answer) or time is None or time > study.trace.stable_until:
        return None
    return study, query, answer

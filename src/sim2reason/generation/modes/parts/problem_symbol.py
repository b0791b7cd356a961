"""Symbols of the numbers of a problem, and the problem with other numbers."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite

from sim2reason.errors import SimulationError
from sim2reason.questions import KINDS, Query, Study
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import ENGINES
from sim2reason.text.prose.symbol_names import factor


@dataclass(frozen=True, slots=True)
class ProblemSymbol:
    """A symbol of a problem: its unit and value as the text says them, and the address of its number.

    What the question itself says has no address. A `signed` one may stand for a negative number, too.
    """

    symbol: str
    unit: str
    value: float
    path: str = ""
    signed: bool = False

    @property
    def of_world(self) -> bool:
        """Return whether it is a number of the world, as g is, and of nothing in it."""
        return self.path.startswith("world.")

    def counted(self, value: float) -> float:
        """Return a value of it as formulas count: in radians and metres, where it is said in degrees or kilometres."""
        return value * factor(self.unit)


@dataclass(frozen=True)
class Variation:
    """A scene with other numbers: their values as formulas count them, its motion, and the answer in it."""

    values: Mapping[str, float]
    study: Study
    query: Query
    answer: float

    @property
    def until(self) -> float:
        """Return when all that the answer depends on has happened, s."""
        return KINDS[self.query.kind].time(self.query, self.study) or 0.0

    @property
    def story(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """Return what happens before that, in order; turns change nothing."""
        return self.study.trace.story(self.until)

    @property
    def finer(self) -> "Variation | None":
        """The same followed by the finest steps; None if it is by then, or has no answer any more."""
        scene, trace = self.study.scene, self.study.trace
        if not trace.tolerance:
            return None
        try:
            found = answered(self.query, Study(scene, ENGINES[RECORDED](scene.mechanism, trace.state.times)))
        except SimulationError:
            return None
        return None if found is None else Variation(self.values, *found)


def answered(query: Query, study: Study) -> tuple[Study, Query, float] | None:
    """Return a motion with the answer in it; None if it has none as far as it is followed."""
    answer = KINDS[query.kind].loose_answer(query, study)
    time = KINDS[query.kind].time(query, study)
    if answer is None or not isfinite(answer) or time is None or time > study.trace.stable_until:
        return None
    return study, query, answer

"""Checks of mirror symmetry and of scaling."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.questions import SimulatedScene
from sim2reason.scenes.dsl.units import Dimension, parse_unit
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import ENGINES, Trace
from sim2reason.testing.answers import differences
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens, changed, stated_numbers, studied
from sim2reason.testing.transformations import mirrored

MIRROR_RTOL = 1e-9  # of the largest value, or of 1 in SI units


@check
class MirrorImageCheck(Check):
    """Check that the mirror image of a scene moves as the mirror image of its motion."""

    name = "mirror image"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Compare coordinates and their rates up to the end of both motions."""
        for found in specimens.moving:
            what = self._parted(found)
            if what:
                remedy = "let laws of force depend on their arguments alone"
                yield found.finding(self.name, "the mirror image moves as the mirror image", what, remedy)

    def _parted(self, found: Specimen) -> str:
        """Return in words where a motion and its mirror image differ; empty if they agree."""
        trace = found.study.trace
        try:
            image = ENGINES[RECORDED](mirrored(trace.mechanism), trace.state.times)
        except (SimulationError, UnsupportedError) as error:
            return f"it is refused: {error}"
        end = min(found.end, image.stable_until)
        if found.end - end > MIRROR_RTOL * found.end:
            return f"it ends at {end:.6g} s ({image.cut}), not at {found.end:.6g} s"
        return _difference(trace, image, end)


def _difference(trace: Trace, image: Trace, end: float) -> str:
    times = trace.state.times
    clear = [abs(times - event.time) > 1e-6 * end for event in trace.events]
    within = np.logical_and.reduce([times <= end, *clear])
    for what, mine, its in (("q", trace.state.q, image.state.q), ("its rate", trace.state.v, image.state.v)):
        for number, coordinate in enumerate(trace.mechanism.coordinates):
            one, other = mine[within, number], its[within, number]
            gap = np.abs(one - other)
            if gap.max(initial=0.0) > MIRROR_RTOL * max(1.0, float(np.abs(one).max(initial=0.0))):
                worst = int(gap.argmax())
                where = f"{what} of {coordinate.name} at {times[within][worst]:.4g} s"
                return f"{where}: {other[worst]:.9g} in place of {one[worst]:.9g}"
    return ""


@dataclass(frozen=True)
class Units:
    """A change to units that are smaller by powers of two, which cause no rounding; the numbers become larger."""

    length: float = 1.0
    mass: float = 1.0
    time: float = 1.0

    def factor(self, dimension: Dimension) -> float:
        """Return the factor on values of a dimension; 1 for angles and cycles."""
        return self.length**dimension.length * self.mass**dimension.mass * self.time**dimension.time

    @property
    def text(self) -> str:
        """Return the change of units in words."""
        grown = {"lengths": self.length, "masses": self.mass, "times": self.time}
        return ", ".join(f"all {name} × {factor:g}" for name, factor in grown.items() if factor != 1.0)


INDEPENDENT_UNITS = (Units(length=2.0), Units(mass=2.0), Units(time=2.0))
KEPLER = (Units(length=4.0, time=8.0), Units(mass=4.0, time=0.5))  # the constant of gravitation, λ³/(µτ²), stays


@check
class ScalingCheck(Check):
    """Check that the text's numbers in other units give the same answers in those units."""

    name = "scaling"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Double all stated lengths, then all masses, then all times."""
        for found in specimens.moving:
            for units in KEPLER if found.study.mechanism.attractions else INDEPENDENT_UNITS:
                yield from self._scaled(found, units)

    def _scaled(self, found: Specimen, units: Units) -> Iterator[Finding]:
        other = scaled(found, units)
        difference = next(differences(found, other, _factor(units)), None) if other is not None else None
        if difference is not None:
            yield found.finding(
                self.name,
                f"with {units.text} in the text, answers grow as their units do",
                f"in the old units, {difference.text}",
                "an answer depends on a number with a unit that is not in the text: declare it and say it",
            )


def scaled(found: Specimen, units: Units) -> SimulatedScene | None:
    """Return the scene with its stated numbers multiplied as in smaller units, simulated; None if invalid."""
    numbers = {
        path: parameter.value * units.factor(parse_unit(parameter.measure.unit).dimension)
        for path, parameter in stated_numbers(found.scene, found.seed).items()
        if parameter.value
    }
    return studied(changed(found.scene, numbers), found.scene.horizon * units.time)


def _factor(units: Units) -> Callable[[Dimension], float]:
    return units.factor

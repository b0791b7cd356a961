"""Checks of variants of a scene: mirrored, scaled, with parts removed, or with bodies held fixed."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from pydantic import ValidationError

from sim2reason.errors import SceneError, Sim2ReasonError, SimulationError, UnsupportedError
from sim2reason.questions import SimulatedScene
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.units import Dimension, parse_unit
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.scenes import simulate
from sim2reason.simulation.trace import ENGINES, Trace
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import (
    ENTITY_NAME,
    Specimen,
    Specimens,
    change_numbers,
    differences,
    stated_numbers,
    studied,
)
from sim2reason.testing.transformations import mirrored
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose.description import describe

MIRROR_RTOL = 1e-9  # of the largest value, or of 1 in SI units


@check
class MirrorImageCheck(Check):
    """Check that the mirror image of a scene moves as the mirror image of its motion."""

    name = "mirror image"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Compare coordinates and their rates up to the end of both motions."""
        for specimen in specimens.moving:
            what = self._parted(specimen)
            if what:
                remedy = "let laws of force depend on their arguments alone"
                yield specimen.finding(self.name, "the mirror image moves as the mirror image", what, remedy)

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
        for specimen in specimens.moving:
            for units in KEPLER if specimen.study.mechanism.attractions else INDEPENDENT_UNITS:
                yield from self._scaled(specimen, units)

    def _scaled(self, found: Specimen, units: Units) -> Iterator[Finding]:
        other = scale_numbers(found, units)
        difference = next(differences(found, other, _factor(units)), None) if other is not None else None
        if difference is not None:
            yield found.finding(
                self.name,
                f"with {units.text} in the text, answers grow as their units do",
                f"in the old units, {difference.text}",
                "an answer depends on a number with a unit that is not in the text: declare it and say it",
            )


def scale_numbers(specimen: Specimen, units: Units) -> SimulatedScene | None:
    """Return the scene with its stated numbers multiplied as in smaller units, simulated; None if invalid."""
    numbers = {
        path: parameter.value * units.factor(parse_unit(parameter.measure.unit).dimension)
        for path, parameter in stated_numbers(specimen.scene, specimen.seed).items()
        if parameter.value
    }
    return studied(change_numbers(specimen.scene, numbers), specimen.scene.horizon * units.time)


def _factor(units: Units) -> Callable[[Dimension], float]:
    return units.factor


SCENE_COUNT = 4


@check
class AblationsCheck(Check):
    """Check that scenes stay valid, or are refused with a reason, if a part is removed or a body is held fixed."""

    name = "ablations"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Remove every optional part, and fix every movable body."""
        for specimen in specimens.some(SCENE_COUNT):
            for address in removable(specimen.scene):
                yield from self._without(specimen, address)
            for body in specimen.scene.mechanism.bodies:
                if body.coordinates and body.name.startswith(f"{ENTITY_NAME}."):
                    yield from self._glued(specimen, body.name)

    def _without(self, found: Specimen, address: str) -> Iterator[Finding]:
        """Yield a finding unless the rest of the scene is described and simulated, or refused with an error."""
        remedy = "let a validator refuse what can not be without it, and build what is there"
        try:
            scene = _made(lambda: found.scene.without(address))
            if scene is not None:
                describe(scene, found.seed)
                simulate(scene)
        except Sim2ReasonError:
            return
        except Exception as error:  # noqa: BLE001 - whatever a stranger's class raises is a finding
            what = f"{type(error).__name__}: {error}"
            yield found.finding(self.name, f"without {address} it is a scene, or refused in words", what, remedy)
            return
        if scene is None:
            return
        text = describe(scene, found.seed).text
        try:
            parse_scene(text)
        except SceneError as error:
            expected = f"without {address} its text is read back"
            yield found.finding(self.name, expected, f"{error}\n  text: {text}", remedy)

    def _glued(self, found: Specimen, body: str) -> Iterator[Finding]:
        """Yield a finding if a body that is held fixed can still move, or the rest of the scene cannot be simulated."""
        expected, remedy = f"{body} can be glued to what carries it", "let build say all of a body through the frame"
        try:
            scene = _made(lambda: found.scene.gluing(body))
            if scene is not None and scene.mechanism.body[body].coordinates:
                yield found.finding(self.name, expected, "it still moves", remedy)
            if scene is not None:
                simulate(scene)
        except Sim2ReasonError:
            return
        except Exception as error:  # noqa: BLE001 - the same
            yield found.finding(self.name, expected, f"{type(error).__name__}: {error}", remedy)


def _made(make: Callable[[], Scene]) -> Scene | None:
    """Return a changed scene if it is valid; None if it is refused."""
    try:
        scene = make()
        scene.check()
    except (SceneError, ValidationError):
        return None
    return scene


def removable(scene: Scene) -> Iterator[str]:
    """Yield the addresses of removable parts: optional fields with a value, and members of lists."""
    yield from _removable(scene.entity(ENTITY_NAME), ENTITY_NAME)


def _removable(value: Model, address: str) -> Iterator[str]:
    for name, kind in field_types(type(value)).items():
        field_value, where = getattr(value, name), f"{address}.{name}"
        if kind.optional and field_value is not None:
            yield where
        if isinstance(field_value, tuple):
            for index, member in enumerate(field_value):  # type: ignore[reportUnknownVariableType]
                yield f"{where}.{index}"
                if isinstance(member, Model):
                    yield from _removable(member, f"{where}.{index}")
        elif isinstance(field_value, Model):
            yield from _removable(field_value, where)

"""Checks of drawings and plots."""

from collections.abc import Iterator
from math import hypot
from pathlib import Path
from tempfile import TemporaryDirectory
from warnings import catch_warnings, simplefilter

import numpy as np

from sim2reason.errors import FigureWarning, MissingExtraError, UnsupportedError
from sim2reason.figures import canvas
from sim2reason.figures.curves import motion_curves
from sim2reason.figures.drawing import drawing
from sim2reason.figures.plot import plot
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism, RigidBody
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import REST_TOLERANCE, Specimen, Specimens

MAX_FILES = 1  # scenes written as files, whose cost is mostly matplotlib's


@check
class DrawnCheck(Check):
    """Check that the initial state can be drawn, with the name of every body that has a letter."""

    name = "drawing"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Draw all scenes as shapes, the first one also as a file."""
        for specimen in specimens.members:
            yield from self._drawn(specimen)
        for specimen in specimens.some(MAX_FILES):
            self._written(specimen)

    def _drawn(self, found: Specimen) -> Iterator[Finding]:
        expected = "every body has its place in the line drawing"
        with catch_warnings(record=True) as caught:
            simplefilter("always", FigureWarning)
            try:
                shown = drawing(found.scene, found.description)
            except UnsupportedError as error:
                yield found.finding(self.name, expected, str(error), "build it so that what is tied stands apart")
                return
        for message in dict.fromkeys(str(warning.message) for warning in caught):
            yield found.finding(self.name, expected, message, "give the body's class a look in sim2reason.figures")
        named = {label.subject for label in shown.labels if label.name}
        missing = [address for address in found.description.names.letters if address not in named]
        if missing or not shown.shapes:
            what = f"without a name in it: {', '.join(missing)}" if missing else "it is empty"
            yield found.finding(self.name, expected, what, "let its piece want a label")

    def _written(self, found: Specimen) -> None:
        try:
            with catch_warnings(), TemporaryDirectory() as folder:
                simplefilter("ignore", FigureWarning)  # told above
                canvas.draw(drawing(found.scene, found.description), Path(folder) / "scene.svg")
        except (MissingExtraError, UnsupportedError):
            return  # without matplotlib shapes are all that can be had; what can't be drawn is told above


@check
class PlottedCheck(Check):
    """Check that every moving object in the text has a curve in the plots."""

    name = "plots"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Plot all motions as curves, the first one also as a file."""
        expected, remedy = "a plot shows all that moves", "name bodies in build as their fields are"
        panels = 0
        for specimen in specimens.moving:
            panels += len(motion_curves(specimen.study.trace, specimen.description).panels)
            missing = [name for name in moving(specimen) if name not in plotted(specimen)]
            if missing:
                yield specimen.finding(self.name, expected, f"no curve is of {', '.join(missing)}", remedy)
        if not panels:
            yield Finding(self.name, expected, f"{len(specimens.moving)} scenes that move have no panel", remedy)
        for specimen in specimens.moving[:MAX_FILES]:
            self._written(specimen)

    def _written(self, found: Specimen) -> None:
        try:
            with TemporaryDirectory() as folder:
                plot(found.study.trace, found.description, Path(folder) / "motion.svg")
        except MissingExtraError:
            return


def moving(specimen: Specimen) -> list[str]:
    """Return the bodies of the text that move by themselves, not only with a carrying body."""
    state, mentions = specimen.study.trace.state, specimen.words.mentions
    shift = QUANTITIES["displacement"].evaluate
    within = state.times <= specimen.end
    names = [
        body.name for body in state.mechanism.bodies if body.name in mentions and _moves_itself(state.mechanism, body)
    ]
    return [name for name in names if np.abs(shift(state, name)[within]).max(initial=0.0) > REST_TOLERANCE]


def _moves_itself(mechanism: Mechanism, body: RigidBody) -> bool:
    """Return whether a coordinate of the body itself moves its centre of mass; a wheel's rotation does not."""
    gradient = initial_frames(mechanism).center(body.name).gradient
    ways = (gradient.get(mechanism.number[own.name], ZERO) for own in body.coordinates)
    return any(hypot(*direction) > REST_TOLERANCE for direction in ways)


def plotted(specimen: Specimen) -> set[str]:
    """Return the names of the objects with a curve in some panel."""
    mechanism, mentions = specimen.study.mechanism, specimen.words.mentions
    shown = [quantity for quantity in QUANTITIES.values() if quantity.panel]
    return {name for quantity in shown for name in quantity.of.phrases(mechanism, mentions)}

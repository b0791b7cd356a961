"""A scene in, a file out: the drawing of its initial state, or the plot of its motion."""

from pathlib import Path

from sim2reason.dsl.scene import Scene
from sim2reason.figures.canvas import check, draw, matplotlib
from sim2reason.figures.drawing import drawing
from sim2reason.figures.plot import plot as plotted
from sim2reason.prose.description import describe
from sim2reason.simulation.scenes import BOTH, simulate


def figure(scene: Scene, out: Path | str, *, numbers: bool = False, seed: int = 0) -> None:
    """Draw the initial state of a scene into a .svg, .png or .pdf file, labelled as its text of that seed names things.

    `numbers` writes masses, too. A FigureWarning says what can only be hinted at.

    Raises:
        MissingExtraError: matplotlib is not installed.
        UnsupportedError: `out` ends otherwise.
    """
    check(Path(out))
    draw(drawing(scene, describe(scene, seed), numbers=numbers), Path(out))


def plot(scene: Scene, out: Path | str, *, duration: float | None = None, engine: str = BOTH, seed: int = 0) -> None:
    """Plot the motion of a scene into a .svg, .png or .pdf file; `both` engines: the exact one's, cut where they part.

    Raises:
        MissingExtraError: matplotlib is not installed.
        UnsupportedError: `out` ends otherwise.
        SceneError, SimulationError, UnknownNameError: as `simulate`.
    """
    check(Path(out))
    matplotlib()
    plotted(simulate(scene, duration, engine), describe(scene, seed), Path(out))

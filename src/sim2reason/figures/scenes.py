"""A scene in, a file out: the drawing of its initial state, or the plot of its motion."""

from pathlib import Path

from sim2reason.dsl.scene import Scene
from sim2reason.figures.canvas import check, draw, matplotlib
from sim2reason.figures.drawing import drawing
from sim2reason.figures.plot import plot as plotted
from sim2reason.prose.description import Description, describe
from sim2reason.scene_files import SceneLike, Wording, given_scene, wording_of
from sim2reason.simulation.scenes import BOTH, whole


def figure(
    scene: SceneLike,
    out: Path | str,
    *,
    numbers: bool = False,
    seed: int | None = None,
    wording: Wording | None = None,
) -> None:
    """Draw the initial state of a scene into a .svg, .png or .pdf file, with labels from its text.

    The text has the given `seed`; by default the seed of `wording`, or 0. `wording` is by default the wording in the
    scene's file, which `wording_of` reads where a file, its text or an item is given. Numbers that the wording replaces
    by symbols are shown as symbols. `numbers` writes masses, too. A FigureWarning names features that the figure can
    only hint at.

    Raises:
        TypeError: neither a scene nor the path of its file, its text or an item.
        MissingExtraError: matplotlib is not installed.
        UnsupportedError: `out` ends otherwise.
    """
    check(Path(out))
    scene, wording = _given(scene, wording, "figure")
    draw(drawing(scene, _described(scene, seed, wording), numbers=numbers), Path(out))


def plot(
    scene: SceneLike,
    out: Path | str,
    *,
    duration: float | None = None,
    engine: str = BOTH,
    seed: int | None = None,
    wording: Wording | None = None,
) -> None:
    """Plot the motion of a scene into a .svg, .png or .pdf file; `both` engines: the exact one's, cut where they part.

    Names are those of the text, as in `figure`.

    Raises:
        MissingExtraError: matplotlib is not installed.
        UnsupportedError: `out` ends otherwise.
        SceneError, SimulationError, UnknownNameError: as `simulate`.
    """
    check(Path(out))
    scene, wording = _given(scene, wording, "plot")
    matplotlib()
    plotted(whole(scene, duration, engine), _described(scene, seed, wording), Path(out))


def _given(scene: SceneLike, wording: Wording | None, function: str) -> tuple[Scene, Wording | None]:
    """Return the scene with its wording; by default the wording in the scene's file, None without a file."""
    held, text = given_scene(scene, function)
    return held, wording or (wording_of(text) if text else None)


def _described(scene: Scene, seed: int | None, wording: Wording | None) -> Description:
    wording = wording or Wording()
    wanted = wording.seed if seed is None else seed
    return describe(scene, wanted, without=wording.without, hide=wording.symbols)

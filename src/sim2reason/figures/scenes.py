"""Figures of scenes: the drawing of the initial state, and the plot of the motion."""

from pathlib import Path

from sim2reason.figures.canvas import check, draw, matplotlib
from sim2reason.figures.drawing import drawing
from sim2reason.figures.plot import plot as plotted
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import SceneLike, Wording, given_scene, wording_of
from sim2reason.simulation.scenes import BOTH, simulate_full_duration
from sim2reason.text.prose.description import Description, describe


def figure(
    scene: SceneLike,
    out: Path | str,
    *,
    numbers: bool = False,
    seed: int | None = None,
    wording: Wording | None = None,
) -> None:
    """Draw the initial state of a scene into a file, with the names of its text.

    Numbers that the wording replaces by symbols are shown as symbols. A FigureWarning names features that the figure
    can only suggest.

    Args:
        scene: A scene, the path of its file, its YAML text, an item about it, or the result of `parse_scene`.
        out: File with the ending .svg, .png or .pdf.
        numbers: Whether to write the masses, too.
        seed: Seed of the text, on which names depend; by default that of `wording`, or 0.
        wording: Wording of the text; by default that in the scene's file, if there is one.

    Raises:
        TypeError: `scene` is of another type.
        MissingExtraError: matplotlib is not installed.
        UnsupportedError: `out` has another ending.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> sim2reason.figure(scene, "scene.svg")
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
    """Plot displacement, velocity, acceleration and tension over time into a file.

    Args:
        scene: A scene, the path of its file, its YAML text, an item about it, or the result of `parse_scene`.
        out: File with the ending .svg, .png or .pdf.
        duration: Duration in the scene's unit of time (s unless its text uses another); by default its horizon.
        engine: ``exact``, ``mujoco``, or ``both``: the motion of the exact engine, cut where the engines part.
        seed: Seed of the text, on which names depend; by default that of `wording`, or 0.
        wording: Wording of the text; by default that in the scene's file, if there is one.

    Raises:
        TypeError: `scene` is of another type.
        MissingExtraError: matplotlib is not installed.
        UnsupportedError: `out` has another ending.
        SceneError, SimulationError, UnknownNameError: The scene cannot be simulated, as in `simulate`.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> sim2reason.plot(scene, "motion.svg", duration=1.0)
    """
    check(Path(out))
    scene, wording = _given(scene, wording, "plot")
    matplotlib()
    plotted(simulate_full_duration(scene, duration, engine), _described(scene, seed, wording), Path(out))


def _given(scene: SceneLike, wording: Wording | None, function: str) -> tuple[Scene, Wording | None]:
    """Return the scene with its wording; the default is the wording in the scene's file, else None."""
    held, text = given_scene(scene, function)
    return held, wording or (wording_of(text) if text else None)


def _described(scene: Scene, seed: int | None, wording: Wording | None) -> Description:
    wording = wording or Wording()
    wanted = wording.seed if seed is None else seed
    return describe(scene, wanted, without=wording.without, hide=wording.symbols)

"""Plot the motion of a scene: displacement, velocity, acceleration and tension over time."""

from pathlib import Path

import click

from sim2reason.cli import console, options, results, source

EXAMPLE = """\b
Example:
    sim2reason plot scene.yaml -o traces.png
    sim2reason plot scene.yaml -o traces.svg --duration 1 --engine exact

Events are marked, and what is cut off is shaded. Needs: pip install matplotlib
"""


@click.command("plot", epilog=EXAMPLE)
@options.scene()
@options.out("Where to: a .svg, .png or .pdf file.", required=True, printing=False)
@click.option(
    "--duration",
    type=console.Seconds(0.0, 60.0, min_open=True),
    default=None,
    help="How long; as long as the scene is worth by default.",
)
@click.option("--engine", default="both", show_default=True, help="exact, mujoco, or both: exact, cut where they part.")
@options.wording()
def command(scene: Path, out: Path, duration: float | None, engine: str, seed: int | None) -> None:
    """Plot the motion of the scene in the file SCENE (- is standard input)."""
    from sim2reason.figures.canvas import check
    from sim2reason.figures.drawing import plot
    from sim2reason.scenes.files import wording_of

    check(out)
    content = source.text(scene)
    loaded, wording = source.scene(scene, content), wording_of(content)
    with results.written(out) as path:
        plot(loaded, path, duration=duration, engine=engine, seed=seed, wording=wording)

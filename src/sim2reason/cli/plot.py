"""Plot the motion of a scene: displacement, velocity, acceleration and tension over time."""

from pathlib import Path

import click

from sim2reason.cli import console, source

EXAMPLE = """\b
Example:
    sim2reason plot scene.yaml -o traces.png
    sim2reason plot scene.yaml -o traces.svg --duration 1 --engine exact

Events are marked, and what is cut off is shaded. Needs: pip install 'sim2reason[figures]'
"""


@click.command("plot", epilog=EXAMPLE)
@click.argument("scene", type=click.Path(path_type=Path))
@click.option("-o", "out", type=console.RESULT, required=True, help="Where to: a .svg, .png or .pdf file.")
@click.option(
    "--duration",
    type=console.Seconds(0.0, 60.0, min_open=True),
    default=None,
    help="How long; as long as the scene is worth by default.",
)
@click.option("--engine", default="both", show_default=True, help="exact, mujoco, or both: exact, cut where they part.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Of the wording, as in describe.")
def command(scene: Path, out: Path, duration: float | None, engine: str, seed: int) -> None:
    """Plot the motion of the scene in the file SCENE (- is standard input)."""
    from sim2reason.figures.canvas import check, matplotlib
    from sim2reason.figures.plot import plot
    from sim2reason.prose.writer import describe
    from sim2reason.simulation.scenes import certify, simulate

    check(out)
    matplotlib()
    loaded = source.scene(scene)
    trace = certify(loaded, duration)[0] if engine == "both" else simulate(loaded, duration, engine)
    plot(trace, describe(loaded, seed), out)

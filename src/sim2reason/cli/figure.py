"""Draw the initial state of a scene, labelled as its text names things."""

import warnings
from pathlib import Path

import click

from sim2reason.cli import console, source

EXAMPLE = """\b
Example:
    sim2reason figure scene.yaml -o scene.svg
    sim2reason figure scene.yaml -o scene.png --numbers

Angles are right; of machines of strings and planes lengths are not. Needs: pip install 'sim2reason[figures]'
"""


@click.command("figure", epilog=EXAMPLE)
@click.argument("scene", type=click.Path(path_type=Path))
@click.option("-o", "out", type=console.RESULT, required=True, help="Where to: a .svg, .png or .pdf file.")
@click.option("--numbers", is_flag=True, help="Write masses too.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Of the wording, as in describe.")
def command(scene: Path, out: Path, numbers: bool, seed: int) -> None:
    """Draw the initial state of the scene in the file SCENE (- is standard input) as a line drawing."""
    from sim2reason.errors import FigureWarning
    from sim2reason.figures import canvas
    from sim2reason.figures.drawing import drawing
    from sim2reason.prose.writer import describe

    canvas.check(out)
    loaded = source.scene(scene)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", FigureWarning)
        drawn = drawing(loaded, describe(loaded, seed), numbers=numbers)
    for warning in caught:
        console.explain(f"sim2reason: warning: {warning.message}")
    canvas.draw(drawn, out)

"""Draw the initial state of a scene, labelled as its text names things."""

from pathlib import Path

import click

from sim2reason.cli import options, results, source

EXAMPLE = """\b
Example:
    sim2reason figure scene.yaml -o scene.svg
    sim2reason figure scene.yaml -o scene.png --numbers

Angles are right; of machines of strings and planes lengths are not. Lengths and angles for which the text has symbols
are drawn with other values. Needs: pip install matplotlib
"""


@click.command("figure", epilog=EXAMPLE)
@options.scene()
@options.out("Where to: a .svg, .png or .pdf file.", required=True, printing=False)
@click.option("--numbers", is_flag=True, help="Write masses too.")
@options.wording()
def command(scene: Path, out: Path, numbers: bool, seed: int | None) -> None:
    """Draw the initial state of the scene in the file SCENE (- is standard input) as a line drawing."""
    from sim2reason.figures.canvas import check
    from sim2reason.figures.drawing import figure
    from sim2reason.scenes.files import wording_of

    check(out)
    content = source.text(scene)
    loaded, wording = source.scene(scene, content), wording_of(content)
    with results.warnings_told(), results.written(out) as path:
        figure(loaded, path, numbers=numbers, seed=seed, wording=wording)

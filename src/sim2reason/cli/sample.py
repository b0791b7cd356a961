"""Draw a random scene and write it as a file."""

from pathlib import Path

import click

from sim2reason.cli import console
from sim2reason.datasets.random_scenes import sample
from sim2reason.scene_files import dump

EXAMPLE = """\b
Example:
    sim2reason sample --recipe pulley --difficulty medium --seed 7 --index 0 -o scene.yaml
"""


@click.command("sample", epilog=EXAMPLE)
@click.option("--recipe", required=True, help="Which kind of scene; see: sim2reason list recipes.")
@click.option("--difficulty", default="medium", show_default=True, help="easy, medium or hard.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Which series of scenes.")
@click.option("--index", type=click.IntRange(0), default=0, show_default=True, help="Which scene of the series.")
@click.option("-o", "out", type=console.RESULT, help="Where to write it; standard output if left out.")
def command(recipe: str, difficulty: str, seed: int, index: int, out: Path | None) -> None:
    """Draw a random scene: the same one for the same recipe, difficulty, seed and index."""
    text = dump(sample(recipe, difficulty, seed=seed, index=index))
    if out is None:
        click.echo(text, nl=False)
    else:
        out.write_text(text, encoding="utf-8")

"""Draw a random scene and write it as a file."""

from pathlib import Path

import click

from sim2reason.cli import options, results
from sim2reason.cli.options import Names

EXAMPLE = """\b
Example:
    sim2reason sample --recipe pulley --difficulty medium --seed 7 --index 0 -o scene.yaml

It is the scene of: sim2reason item --recipe pulley --difficulty medium --seed 7 --index 0
"""


@click.command("sample", epilog=EXAMPLE)
@options.one_recipe()
@options.one_difficulty()
@options.one_mode()
@options.seed("Which series of scenes.")
@options.index("Which scene of the series.")
@options.weights()
@options.tolerance()
@options.needs()
@options.out("Where to write it; standard output if left out.")
def command(
    recipe: str,
    difficulty: str,
    mode: str,
    seed: int,
    index: int,
    weights: dict[str, float],
    tolerance: float,
    needs: Names,
    out: Path | None,
) -> None:
    """Draw a random scene: that of the problem of the same recipe, difficulty, mode, seed and index."""
    from sim2reason.datasets.items import sample
    from sim2reason.scenes.files import dump

    scene = sample(recipe, difficulty, mode, seed=seed, index=index, weights=weights, tolerance=tolerance, needs=needs)
    results.tell(dump(scene), out)

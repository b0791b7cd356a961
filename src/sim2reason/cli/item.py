"""Make one problem by its coordinates, with its answer."""

from pathlib import Path

import click

from sim2reason.cli import console, options, problems, results
from sim2reason.cli.options import Names

EXAMPLE = """\b
Example:
    sim2reason item --recipe pulley --difficulty medium --mode reverse --seed 7 --index 3
    sim2reason item --recipe springs --difficulty hard --index 12 --solutions --figure scene.svg
    sim2reason item --recipe pulley --json
"""


@click.command("item", epilog=EXAMPLE)
@options.one_recipe()
@options.one_difficulty()
@options.one_mode()
@options.seed("Which series of problems.")
@options.index("Which problem of the series.")
@options.weights()
@options.units()
@options.tolerance()
@options.needs()
@click.option("--solutions", is_flag=True, help="With its worked solution, where there is one.")
@options.figure(printing=True)
@click.option("--scene", "with_scene", is_flag=True, cls=options.Printing, help="Print the scene too.")
@options.to_json("For a program to read: one item, as the lists of show and ask have it.")
def command(
    recipe: str,
    difficulty: str,
    mode: str,
    seed: int,
    index: int,
    weights: dict[str, float],
    units: str,
    tolerance: float,
    needs: Names,
    solutions: bool,
    figure: Path | None,
    with_scene: bool,
    to_json: bool,
) -> None:
    """Make one problem of a recipe, difficulty and mode: the same one that a dataset has."""
    from sim2reason.datasets.items import made, requested
    from sim2reason.figures import canvas
    from sim2reason.figures.drawing import drawing

    if figure is not None:
        canvas.check(figure)
    how = weights, units
    request = requested(
        recipe, difficulty, mode, seed, index, *how, tolerance=tolerance, needs=needs, solutions=solutions
    )
    item, found = made(request)
    if figure is not None:
        with results.warnings_told(), results.written(figure) as path:
            canvas.draw(drawing(found.description.scene, found.description), path)
    if to_json:
        console.as_json(item.model_dump(mode="json"))
    else:
        problems.tell(item, scene=with_scene, solution=solutions)

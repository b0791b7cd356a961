"""Show problems of a dataset with their answers."""

from pathlib import Path

import click

from sim2reason.cli import console, options, problems
from sim2reason.cli.options import Names

EXAMPLE = """\b
Example:
    sim2reason show problems -n 3
    sim2reason show problems --recipe springs,rolling --kind period --split test --solutions
    sim2reason show problems --id pulley-easy-numeric-0-4 --scene
"""


@click.command("show", epilog=EXAMPLE)
@options.dataset()
@options.items(3, 1, None)
@options.identity("Only the problem of this id.")
@options.recipe()
@options.difficulty()
@options.mode("all")
@options.several("--kind", "Kinds of question, separated by commas, or all.")
@options.several("--quantity", "Quantities, as in speed,tension; or all.")
@options.several("--needs", "What solutions need, as in arithmetic,quadratic; or all.")
@options.split()
@click.option("--scene", "with_scene", is_flag=True, cls=options.Printing, help="Print the scene too.")
@click.option("--solutions", is_flag=True, cls=options.Printing, help="Print the worked solutions too.")
@options.to_json("For a program to read: a list of whole items.")
def command(
    dataset: Path,
    items: int,
    id: str | None,  # noqa: A002 - the option's name
    recipe: Names,
    difficulty: Names,
    mode: Names,
    kind: Names,
    quantity: Names,
    needs: Names,
    split: Names,
    with_scene: bool,
    solutions: bool,
    to_json: bool,
) -> None:
    """Show problems of the DATASET, spread over all that fit, with their answers."""
    from sim2reason.datasets.inspection import show

    chosen = {"recipe": recipe, "difficulty": difficulty, "mode": mode, "kind": kind, "quantity": quantity}
    chosen["needs"] = needs
    found = show(dataset, items=items, id=id, split=split, **chosen)
    if to_json:
        console.as_json_list(item.model_dump(mode="json") for item in found)
        return
    for item in found:
        problems.tell(item, scene=with_scene, solution=solutions)

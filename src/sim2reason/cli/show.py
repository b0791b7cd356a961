"""Show problems of a dataset with their answers."""

from pathlib import Path
from textwrap import fill, indent

import click

from sim2reason.cli import console
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.item import Item

EXAMPLE = """\b
Example:
    sim2reason show problems -n 3
    sim2reason show problems --id pulley-easy-numeric-0-4 --scene
"""
WIDTH = 88


@click.command("show", epilog=EXAMPLE)
@click.argument("out", type=click.Path(path_type=Path))
@click.option("-n", "count", type=click.IntRange(1), default=3, show_default=True, help="How many problems.")
@click.option("--id", "name", help="Only the problem of this id.")
@click.option("--scene", "with_scene", is_flag=True, help="Print the scene too.")
@click.option("--solution", "with_solution", is_flag=True, help="Print the worked solution too.")
@click.option("--json", "to_json", is_flag=True, help="For a program to read: a list of whole items.")
def command(out: Path, count: int, name: str | None, with_scene: bool, to_json: bool, *, with_solution: bool) -> None:
    """Show problems of the dataset in OUT, spread over it, with their answers."""
    data = Dataset(out)
    items = [data.item(name)] if name else list(data.some(count))
    if to_json:
        console.as_json([item.model_dump(mode="json") for item in items])
    for item in [] if to_json else items:
        _tell(item, with_scene=with_scene, with_solution=with_solution)


def _tell(item: Item, *, with_scene: bool, with_solution: bool) -> None:
    click.secho(item.id, bold=True)
    for line in item.prompt.splitlines():
        click.echo(fill(line, WIDTH, break_long_words=False, break_on_hyphens=False))
    sign = f"  (positive: {item.answer.sign})" if item.answer.sign else ""
    click.echo(f"\nAnswer: {item.answer.told}{sign}\n")
    if with_solution:
        told = item.solution.text if item.solution is not None else item.unsolved
        click.echo(f"{told or 'No solution was asked for: sim2reason generate OUT --solutions'}\n")
    if with_scene:
        click.echo(indent(item.scene, "    "))

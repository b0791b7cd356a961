"""Show problems of a dataset with their answers."""

from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from textwrap import fill, indent

import click

from sim2reason.cli import console
from sim2reason.datasets.item import Item
from sim2reason.datasets.manifest import load
from sim2reason.datasets.store import read_items

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
def command(out: Path, count: int, name: str | None, with_scene: bool, to_json: bool, *, with_solution: bool) -> int:
    """Show problems of the dataset in OUT, spread over it, with their answers."""
    items = list(_named(out, name) if name else _spread(out, count))
    if not items:
        console.explain(f"sim2reason: {out}: holds no such problem; see: sim2reason show {out}")
        return 1
    if to_json:
        console.as_json([item.model_dump(mode="json") for item in items])
    for item in [] if to_json else items:
        _tell(item, with_scene=with_scene, with_solution=with_solution)
    return 0


def _named(out: Path, name: str) -> Iterator[Item]:
    return islice((item for item in read_items(out) if item.id == name), 1)


def _spread(out: Path, count: int) -> Iterator[Item]:
    """Problems from all over the dataset; never in step with the round robin of its plan."""
    rows = load(out).rows
    places = {i * rows // count + i for i in range(count)} if rows > 2 * count else set(range(count))
    return (item for place, item in enumerate(read_items(out)) if place in places)


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

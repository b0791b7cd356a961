"""Printing of problems as readable text."""

from textwrap import fill, indent
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from sim2reason.generation.item import Item

WIDTH = 88


def tell(item: "Item", *, scene: bool = False, solution: bool = False) -> None:
    """Print a problem and its answer, optionally with its scene and solution."""
    click.secho(item.id, bold=True)
    for line in item.prompt.splitlines():
        click.echo(fill(line, WIDTH, break_long_words=False, break_on_hyphens=False))
    click.echo(f"\nAnswer: {item.answer.shown}")
    click.echo(f"Needs: {item.needs}\n")
    if solution:
        told = item.solution.text if item.solution is not None else item.unsolved
        click.echo(f"{told or 'No solution was asked for: sim2reason generate OUT --solutions'}\n")
    if scene:
        click.echo(indent(item.scene, "    "))

"""Tell all about one problem: where it comes from, what vouches for it, and why it was kept."""

from contextlib import ExitStack
from pathlib import Path

import click

from sim2reason.cli import console, options, results

EXAMPLE = """\b
Example:
    sim2reason explain problems --id pulley-easy-numeric-0-4

The problem is made again from its coordinates, so that nothing in the file is taken on trust.
"""


@click.command("explain", epilog=EXAMPLE)
@options.dataset()
@options.identity("Of the problem; see: sim2reason show DATASET.", required=True)
@options.figure()
@click.option("--trace", type=console.RESULT, help="Write the motion, too: a .parquet file.")
@options.to_json("For a program to read: {title: [line]}.")
def command(dataset: Path, id: str, figure: Path | None, trace: Path | None, to_json: bool) -> None:  # noqa: A002
    """Tell all about one problem of the DATASET: its scene, certificate, and every filter's verdict."""
    from sim2reason.datasets.explain import check, explain, told

    check(figure, trace)
    with ExitStack() as files:
        drawn, moved = (files.enter_context(results.written(out)) if out else None for out in (figure, trace))
        found = explain(dataset, id, figure=drawn, trace=moved)
    if to_json:
        console.as_json(found)
        return
    for title, lines in found.items():
        click.secho(title, bold=True)
        click.echo(f"{told(lines)}\n")

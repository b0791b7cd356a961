"""Tell all about one problem: where it comes from, what vouches for it, and why it was kept."""

from contextlib import ExitStack
from pathlib import Path

import click

from sim2reason.cli import console, options, results

EXAMPLE = """\b
Example:
    sim2reason explain problems --id pulley-easy-numeric-0-4
    sim2reason explain --id pulley-easy-numeric-0-4 --refused

The problem is made again from its coordinates, so that nothing in the file is taken on trust. Without a DATASET the
problem need not be in one.
"""


@click.command("explain", epilog=EXAMPLE)
@click.argument("dataset", metavar="[DATASET]", required=False, type=click.Path(path_type=Path))
@options.identity("Of the problem; see: sim2reason show DATASET.", required=True)
@click.option("--refused", is_flag=True, help="Show each refused question, with the numbers that its filter compared.")
@options.figure()
@click.option("--trace", type=console.RESULT, help="Write the motion, too: a .parquet file.")
@options.to_json("For a program to read: {title: [line]}.")
def command(
    dataset: Path | None,
    id: str,  # noqa: A002
    refused: bool,
    figure: Path | None,
    trace: Path | None,
    to_json: bool,
) -> None:
    """Explain one problem: its scene, certificate, every filter's verdict, and the questions refused before it."""
    from sim2reason.datasets.inspection import check, explain, section_text

    check(figure, trace)
    with ExitStack() as files:
        drawn, moved = (files.enter_context(results.written(out)) if out else None for out in (figure, trace))
        found = explain(dataset, id, refused=refused, figure=drawn, trace=moved)
    if to_json:
        console.as_json(found)
        return
    for title, lines in found.items():
        click.secho(title, bold=True)
        click.echo(f"{section_text(lines)}\n")

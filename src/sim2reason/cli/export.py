"""Export a dataset for a library that trains or evaluates models."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sim2reason.cli import console, options

if TYPE_CHECKING:
    from sim2reason.datasets.exports.export import Parts

EXAMPLE = """\b
Example:
    sim2reason export problems --to hf --out problems-hf
    sim2reason export problems --to verl --out problems-verl --split train,test
    sim2reason list exports

The folder holds all that the library needs besides itself and sim2reason; its README.md says how to use it.
Exit code 0: written; 2: wrong input, or a folder that is not empty.
"""


@click.command("export", epilog=EXAMPLE)
@options.dataset()
@click.option("--to", required=True, help="The library or form; see: sim2reason list exports")
@click.option(
    "-o",
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    required=True,
    help="The folder to be written, a new one.",
)
@options.split()
@click.option(
    "--parts",
    type=click.Choice(["together", "separate"]),
    default="together",
    show_default=True,
    help="Of a problem with several parts: one row, or a row for each part with the answers to those before it.",
)
@options.verbose()
@options.to_json("For a program to read: {folder, rows, left_out}.")
def command(dataset: Path, to: str, out: Path, split: options.Names, parts: "Parts", to_json: bool) -> None:
    """Write the DATASET as another library reads it, into a folder of its own."""
    from sim2reason.datasets.dataset import Dataset
    from sim2reason.datasets.exports import EXPORTS
    from sim2reason.datasets.exports.export import export

    lacks, counts = EXPORTS[to].lacks, Dataset(dataset).manifest.counts.get("split", {})
    chosen = counts if split == options.ALL else split
    with console.progress("problems", sum(counts.get(name, 0) for name in chosen)) as advance:
        done = export(dataset, out, to=to, split=split, parts=parts, advance=advance)
    if to_json:
        console.as_json({"folder": str(done.folder), "rows": done.rows, "left_out": done.left_out})
        return
    console.table(["split", "problems"], list(done.rows.items()))
    if done.left_out:
        click.echo(f"{done.left_out} left out: {lacks}")
    click.echo(f"{sum(done.rows.values())} problems in {out}; how to use them: {out / 'README.md'}")

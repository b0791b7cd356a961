"""Verify a dataset on disk against its manifest."""

from pathlib import Path

import click

from sim2reason.cli import console
from sim2reason.datasets import verify

EXAMPLE = """\b
Example:
    sim2reason verify problems

Exit code 0: whole; 1: damaged, with a line for each finding; 2: no finished dataset.
"""


@click.command("verify", epilog=EXAMPLE)
@click.argument("out", type=click.Path(path_type=Path))
@click.option("--json", "to_json", is_flag=True, help="For a program to read: {ok, rows, shards, faults}.")
def command(out: Path, to_json: bool) -> int:
    """Check every file of the dataset in OUT: checksums, missing and extra shards, counts of rows."""
    report = verify.examine(out)
    if to_json:
        console.as_json({"ok": not report.faults} | report.model_dump(mode="json"))
    else:
        for line in report.faults:
            click.echo(line)
        verdict = f"damaged: {len(report.faults)} findings" if report.faults else "whole"
        shards = f"{report.shards} shard{'s' * (report.shards != 1)}"
        click.echo(f"{out}: {verdict}; {report.rows} problems in {shards} by the manifest")
    return 1 if report.faults else 0

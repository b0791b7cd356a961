"""Verify a dataset on disk against its manifest."""

from pathlib import Path

import click

from sim2reason.cli import console, options

EXAMPLE = """\b
Example:
    sim2reason verify problems

Exit code 0: whole; 1: damaged, with a line for each finding; 2: no finished dataset.
"""


@click.command("verify", epilog=EXAMPLE)
@options.dataset()
@options.to_json("For a program to read: {ok, rows, shards, faults}.")
def command(dataset: Path, to_json: bool) -> int:
    """Check every file of the DATASET: checksums, missing and extra shards, counts of rows."""
    from sim2reason.datasets.dataset import verify

    report = verify(dataset)
    if to_json:
        console.as_json({"ok": not report.faults} | report.model_dump(mode="json"))
    else:
        for line in report.faults:
            click.echo(line)
        count = len(report.faults)
        verdict = f"damaged: {count} finding{'s' * (count != 1)}" if count else "whole"
        shards = f"{report.shards} shard{'s' * (report.shards != 1)}"
        click.echo(f"{dataset}: {verdict}; {report.rows} problems in {shards} by the manifest")
    return 1 if report.faults else 0

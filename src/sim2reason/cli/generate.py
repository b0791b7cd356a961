"""Generate a dataset: problems with certified answers, in a folder."""

from pathlib import Path
from typing import Unpack, cast

import click
from click.core import ParameterSource

from sim2reason.cli import console, options
from sim2reason.datasets.build import Work, build, build_part
from sim2reason.datasets.contamination import Benchmarks
from sim2reason.datasets.generate import DEFAULT_ITEMS, Order, build_config, files_to_avoid, read_order
from sim2reason.datasets.manifest import Manifest
from sim2reason.datasets.places import DEFAULT_TIMEOUT, HERE
from sim2reason.datasets.plan import DEFAULT_DISTANCE, DEFAULT_SHARD_ROWS, LICENSE, MAKER, MAX_SHARD_ROWS
from sim2reason.datasets.worker import Attempt
from sim2reason.generation.request import MAX_SEED

EXAMPLE = """\b
Example:
    sim2reason generate problems --items 1000 --recipe pulley,incline --seed 7
    sim2reason generate problems --items 1000 --split train=0.9,validation=0.05,test=0.05
    sim2reason generate problems --items 100000 --shard 3/8
    sim2reason generate problems --config problems.yaml --items 50

An interrupted run goes on when the same command is given again, and ends in the same bytes; with more --items it grows.
Processes with --shard 1/8 to 8/8, at once or not, on any machines that share the folder, make its parts; the command
without --shard then ends the work.

It makes as many as are asked for: what no draw fills, or repeats a problem, is made up for by others.

Exit code 0: done; 1: done, but a mode, kind and recipe is empty that should not be; 2: wrong input, or fewer problems
are to be had than are asked for.
"""


@click.command("generate", epilog=EXAMPLE)
@click.argument("out", type=click.Path(file_okay=False, path_type=Path))
@options.items(DEFAULT_ITEMS, 0, MAX_SEED)
@options.recipe()
@options.difficulty()
@options.mode()
@options.seed("Another seed, other problems.")
@options.weights()
@options.units()
@options.tolerance()
@options.needs()
@click.option(
    "--config",
    type=click.Path(dir_okay=False, path_type=Path),
    help="A YAML file of options by their names in Python, as in recipe: [pulley]; options given here come first.",
)
@click.option("--solutions", is_flag=True, help="With a worked solution of each problem, where there is one.")
@click.option("--unfiltered", is_flag=True, help="A control: keep any question that has an answer.")
@click.option(
    "--workers",
    type=click.IntRange(1),
    help="Processes, which never change the result; 1 is this one. [default: one per core]",
)
@click.option(
    "--on",
    default=HERE,
    show_default=True,
    help="Where to work: here, or on a cluster of Ray by ray or ray://HOST:PORT. It never changes the result.",
)
@click.option(
    "--split",
    callback=options.pairs,
    help="Shares of splits, as in train=0.9,test=0.1; variants of a problem keep together.",
)
@click.option(
    "--distance",
    type=click.FloatRange(0.0, 1.0),
    default=DEFAULT_DISTANCE,
    show_default=True,
    help="Variants of a problem differ in some number by this much, relatively; 0 keeps all that differ.",
)
@click.option(
    "--decontaminate",
    multiple=True,
    type=click.Path(path_type=Path),
    help="Leave out what shares ten words in a row with this benchmark: .json, .jsonl, .parquet, .txt. Repeatable.",
)
@click.option("--license", default=LICENSE, show_default=True, help="Of the data, as the Hugging Face hub calls it.")
@click.option(
    "--shard", "part", default=None, help="Make one part of several, as in 3/8, and leave the end to another run."
)
@click.option(
    "--shard-size",
    "shard",
    type=click.IntRange(1, MAX_SHARD_ROWS),
    default=DEFAULT_SHARD_ROWS,
    show_default=True,
    help="Problems in one file.",
)
@options.verbose()
@options.to_json("Print the manifest for a program to read.")
@click.option("--patience", type=console.Seconds(0.1, console.LONGEST_TIMER), default=DEFAULT_TIMEOUT, hidden=True)
@click.option("--maker", default=MAKER, hidden=True)
def generate_command(
    out: Path,
    part: str | None,
    workers: int | None,
    on: str,
    to_json: bool,
    patience: float,
    config: Path | None,
    **order: Unpack[Order],
) -> int:
    """Generate problems into the folder OUT: Parquet shards, manifest.json and a dataset card."""
    if config is not None:
        order = read_order(config) | _given(order)
    planned, benchmarks = build_config(**order), Benchmarks(files_to_avoid(order))
    remedy = f"what is finished stays in {out}; give the same command again to go on"
    with console.resumable(remedy), console.progress("problems", planned.items) as advance:
        work = Work(workers=workers, on=on, patience=patience, advance=advance, benchmarks=benchmarks)
        if console.verbose():
            work["watch"] = _tell_attempt
        if part is not None:
            number, parts = _part(part)
            made = build_part(out, planned, (number, parts), **work)
            shards = planned.shards(planned.items)
            mine = f"{len(range(number, shards, parts))} of {shards} shards"
            remedy = f"when all {parts} parts are made, the same command without --shard ends the work"
            click.echo(f"part {part}: {mine}, {made} problems in {out}; {remedy}", err=to_json)
            return 0
        manifest = build(out, planned, **work)
    if to_json:
        console.as_json(manifest.model_dump(mode="json"))
    else:
        _tell(out, manifest)
    for line in (lines := list(manifest.empty_cells())):
        console.explain(f"an empty cell: {line}")
    return 1 if lines else 0


def _tell_attempt(attempt: Attempt) -> None:
    """Print the outcome of an attempt at a position to stderr."""
    draws = sum(attempt.rejected.values())
    outcome = attempt.item.id if attempt.item is not None else f"no problem: {attempt.failure or 'no draw passed'}"
    console.explain(f"position {attempt.position}: {outcome} ({attempt.seconds:.1f} s, {draws} draws refused)")


def _given(order: Order) -> Order:
    """Return only those options that the user set on the command line, not those with default values."""
    context = click.get_current_context()
    given = {n: value for n, value in order.items() if context.get_parameter_source(n) is not ParameterSource.DEFAULT}
    return cast("Order", given)


def _part(text: str) -> tuple[int, int]:
    """Return the K of a --shard option K/N, counted from zero, and the N."""
    number, _, parts = text.partition("/")
    if not (number.isdecimal() and parts.isdecimal()):
        raise click.UsageError(f"--shard: {text!r} is no part; write K/N, as in 3/8.")
    return int(number) - 1, int(parts)


def _tell(out: Path, manifest: Manifest) -> None:
    counts = manifest.counts.get("recipe", {})
    refused = {recipe: sum(by_filter.values()) for recipe, by_filter in manifest.rejected.items()}
    names = sorted(counts.keys() | refused.keys())
    console.table(["recipe", "problems", "refused draws"], [(n, counts.get(n, 0), refused.get(n, 0)) for n in names])
    click.echo(f"{manifest.rows} problems in {out} (counts by filter: {out}/README.md)")
    if more := manifest.positions - manifest.config.items:
        console.explain(f"positions without a problem, made up for by later ones: {more}")
    for kind in ("quarantined", "unfilled", "contaminated", "variants"):
        refused = manifest.refused[kind]
        for first in refused.first[:1]:
            where = f"{first.recipe} {first.difficulty} {first.mode}, seed {first.seed}, index {first.index}"
            console.explain(f"{refused.total} {kind}, the first at position {first.position} ({where}): {first.reason}")

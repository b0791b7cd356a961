"""Commands on a finished dataset: show its problems, explain one, count, verify, and export."""

from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sim2reason.cli import console, files, options
from sim2reason.cli.options import Names

if TYPE_CHECKING:
    from sim2reason.datasets.inspection import Spread
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sim2reason.datasets.exports.export import Parts


SHOW_EXAMPLE = """\b
Example:
    sim2reason show problems -n 3
    sim2reason show problems --recipe springs,rolling --kind period --split test --solutions
    sim2reason show problems --id pulley-easy-numeric-0-4 --scene
"""


@click.command("show", epilog=SHOW_EXAMPLE)
@options.dataset()
@options.items(3, 1, None)
@options.identity("Only the problem of this id.")
@options.recipe()
@options.difficulty()
@options.mode("all")
@options.several("--kind", "Kinds of question, separated by commas, or all.")
@options.several("--quantity", "Quantities, as in velocity,tension; or all.")
@options.several("--needs", "What solutions need, as in arithmetic,quadratic; or all.")
@options.split()
@click.option("--scene", "with_scene", is_flag=True, cls=options.Printing, help="Print the scene too.")
@click.option("--solutions", is_flag=True, cls=options.Printing, help="Print the worked solutions too.")
@options.to_json("For a program to read: a list of whole items.")
def show_command(
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
        console.tell_problem(item, scene=with_scene, solution=solutions)


EXPLAIN_EXAMPLE = """\b
Example:
    sim2reason explain problems --id pulley-easy-numeric-0-4
    sim2reason explain --id pulley-easy-numeric-0-4 --refused

The problem is made again from its coordinates, so that nothing in the file is taken on trust. Without a DATASET the
problem need not be in one.
"""


@click.command("explain", epilog=EXPLAIN_EXAMPLE)
@click.argument("dataset", metavar="[DATASET]", required=False, type=click.Path(path_type=Path))
@options.identity("Of the problem; see: sim2reason show DATASET.", required=True)
@click.option("--refused", is_flag=True, help="Show each refused question, with the numbers that its filter compared.")
@options.figure()
@click.option("--trace", type=console.RESULT, help="Write the motion, too: a .parquet file.")
@options.to_json("For a program to read: {title: [line]}.")
def explain_command(
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
    with ExitStack() as stack:
        drawn, moved = (stack.enter_context(files.written(out)) if out else None for out in (figure, trace))
        found = explain(dataset, id, refused=refused, figure=drawn, trace=moved)
    if to_json:
        console.as_json(found)
        return
    for title, lines in found.items():
        click.secho(title, bold=True)
        click.echo(f"{section_text(lines)}\n")


STATS_EXAMPLE = """\b
Example:
    sim2reason stats problems
    sim2reason stats problems --json
"""


@click.command("stats", epilog=STATS_EXAMPLE)
@options.dataset()
@options.to_json("For a program to read: {items, counts, refused, words, answers}.")
def stats_command(dataset: Path, to_json: bool) -> None:
    """Count what the DATASET holds: its problems, the draws refused for them, lengths of prompts, answers by unit."""
    from sim2reason.datasets.inspection import stats
    from sim2reason.scenes.dsl.measures import show_unit

    found = stats(dataset)
    if to_json:
        console.as_json(found.model_dump(mode="json"))
        return
    for name, counts in found.counts.items():
        rows = [(held, count, f"{100.0 * count / max(found.items, 1):.1f} %") for held, count in counts.items()]
        console.table([name, "problems", "share"], rows)
        click.echo()
    console.table(["filter", "refused draws"], list(found.refused.items()))
    click.echo()
    console.table(["prompts", "problems", *SPREAD], [("words", *_spread(found.words))])
    click.echo()
    answers = [(show_unit(unit) or "none", *_spread(held)) for unit, held in found.answers.items()]
    console.table(["unit of answer", "problems", *SPREAD], answers)
    click.echo(f"\n{found.items} problems in {dataset}")


SPREAD = "least", "median", "greatest"


def _spread(spread: "Spread") -> tuple[object, ...]:
    return spread.items, f"{spread.least:.4g}", f"{spread.median:.4g}", f"{spread.greatest:.4g}"


VERIFY_EXAMPLE = """\b
Example:
    sim2reason verify problems

Exit code 0: whole; 1: damaged, with a line for each finding; 2: no finished dataset.
"""


@click.command("verify", epilog=VERIFY_EXAMPLE)
@options.dataset()
@options.to_json("For a program to read: {ok, rows, shards, faults}.")
def verify_command(dataset: Path, to_json: bool) -> int:
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


EXPORT_EXAMPLE = """\b
Example:
    sim2reason export problems --to hf --out problems-hf
    sim2reason export problems --to verl --out problems-verl --split train,test
    sim2reason list exports

The folder holds all that the library needs besides itself and sim2reason; its README.md says how to use it.
Exit code 0: written; 2: wrong input, or a folder that is not empty.
"""


@click.command("export", epilog=EXPORT_EXAMPLE)
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
def export_command(dataset: Path, to: str, out: Path, split: options.Names, parts: "Parts", to_json: bool) -> None:
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

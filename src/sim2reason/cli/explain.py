"""Tell all about one problem: where it comes from, what vouches for it, and why it was kept."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from textwrap import indent
from typing import TYPE_CHECKING

import click

from sim2reason.cli import console
from sim2reason.errors import DatasetError

if TYPE_CHECKING:
    from sim2reason.datasets.plan import Request
    from sim2reason.datasets.question_search import CertifiedQuestion

EXAMPLE = """\b
Example:
    sim2reason explain problems --id pulley-easy-numeric-0-4

The problem is made again from its coordinates, so that nothing in the file is taken on trust.
"""


@click.command("explain", epilog=EXAMPLE)
@click.argument("out", type=click.Path(path_type=Path))
@click.option("--id", "name", required=True, help="Of the problem; see: sim2reason show OUT.")
@click.option("--figure", type=console.RESULT, help="Draw the scene, too: a .svg, .png or .pdf file.")
@click.option("--trace", type=console.RESULT, help="Write the motion, too: a .parquet file.")
def command(out: Path, name: str, figure: Path | None, trace: Path | None) -> int:
    """Tell all about one problem of the dataset in OUT: its scene, certificate, and every filter's verdict."""
    from sim2reason.datasets.dataset import Dataset
    from sim2reason.datasets.item_search import ItemSearch
    from sim2reason.datasets.make import item_of
    from sim2reason.datasets.plan import Request

    item = Dataset(out).item(name)
    made = item.provenance
    weights = tuple(sorted(made.weights.items()))
    solved = item.solution is not None or bool(item.unsolved)
    request = Request(made.recipe, made.difficulty, made.mode, made.seed, made.index, weights, made.units, solved)
    search = ItemSearch(request)
    found, refused = search.found(), search.rejected
    if found is None or item_of(request, found) != item:
        remedy = "install the versions that it names, or make the dataset anew"
        raise DatasetError(f"{name}: this version of sim2reason makes another problem of these coordinates; {remedy}")
    for title, lines in (
        ("Problem", [*item.prompt.splitlines(), "", f"Answer: {item.answer.told}"]),
        ("Scene", item.scene.splitlines()),
        ("Certificate", [f"{key}: {value}" for key, value in item.certificate.items()]),
        ("Refused before it", [f"{count} × {reason}" for reason, count in sorted(refused.items())] or ["nothing"]),
        ("Solution", _solution(request, found).splitlines()),
        ("Filters", list(_filters(found))),
        ("Wrong answers", [f"{d.value:.4g}: {d.reason}" for d in item.distractors] or ["none"]),
        ("Without bearing", list(item.idle) or ["nothing"]),
    ):
        click.secho(title, bold=True)
        click.echo(indent("\n".join(lines), "  ") + "\n")
    if figure is not None:
        _draw(found, figure)
    if trace is not None:
        from sim2reason.simulation.trace_files import write_trace

        write_trace(found.study.trace, trace)
    return 0


def _solution(request: "Request", found: "CertifiedQuestion") -> str:
    """The worked solution, or why there is none."""
    from sim2reason.datasets.worked_solutions import worked

    solution = worked(request, found)
    return f"by {solution.strategy}\n\n{solution.text}" if solution.answer is not None else f"none: {solution.reason}"


def _filters(found: "CertifiedQuestion") -> Iterator[str]:
    """Every filter with its verdict and what it found."""
    from sim2reason.filters import in_order

    candidate = replace(found.candidate, certificate=found.certificate)
    for name, each in in_order():
        yield f"{name}: {each.reason(candidate) or 'keeps it'}"
        yield from (f"  {line}" for line in each.findings(candidate))


def _draw(found: "CertifiedQuestion", path: Path) -> None:
    """The scene as `sim2reason figure` draws it, called as the problem calls things."""
    from sim2reason.figures import canvas
    from sim2reason.figures.drawing import drawing

    canvas.check(path)
    canvas.draw(drawing(found.description.scene, found.description), path)

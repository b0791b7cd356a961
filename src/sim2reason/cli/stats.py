"""Count what a dataset holds: recipes, modes, kinds, quantities, refused draws, lengths and answers."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sim2reason.cli import console, options

if TYPE_CHECKING:
    from sim2reason.datasets.inspection import Spread

EXAMPLE = """\b
Example:
    sim2reason stats problems
    sim2reason stats problems --json
"""


@click.command("stats", epilog=EXAMPLE)
@options.dataset()
@options.to_json("For a program to read: {items, counts, refused, words, answers}.")
def command(dataset: Path, to_json: bool) -> None:
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


def _spread(found: "Spread") -> tuple[object, ...]:
    return found.items, f"{found.least:.4g}", f"{found.median:.4g}", f"{found.greatest:.4g}"

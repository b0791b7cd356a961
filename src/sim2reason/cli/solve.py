"""Solve a problem in steps, as a teacher would write them."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sim2reason.cli import console, options, source

if TYPE_CHECKING:
    from sim2reason.solutions import Solution

EXAMPLE = """\b
Example:
    sim2reason solve --id pulley-easy-numeric-0-4
    sim2reason solve scene.yaml --seed 3
    sim2reason solve scene.yaml --question "What is the tension in the string just after release?"
"""


@click.command("solve", epilog=EXAMPLE)
@click.argument("scene", metavar="[SCENE]", required=False, type=click.Path(path_type=Path, allow_dash=True))
@options.identity("The problem of this id, made again from its name.")
@click.option("--question", help="A question about the scene, in the words of the library; else one is drawn.")
@options.seed("Another seed, other words.")
@options.to_json("For a program to read: steps with their relations.")
def command(scene: Path | None, id: str | None, question: str | None, seed: int, to_json: bool) -> int:  # noqa: A002
    """Solve a question about the scene in the file SCENE (- is standard input), or the problem of an id.

    Exit code 1 if no strategy applies; standard error then says why.
    """
    from sim2reason.datasets.solve import solve

    if (scene is None) == (id is None):
        raise click.UsageError("give a scene or an --id, one of the two.")
    told, found = solve(source.scene(scene) if scene else None, id=id, question=question, seed=seed)
    if to_json:
        console.as_json(_document(told, found))
    else:
        click.echo(told)
        click.echo(f"\n{found.text}\n\nNeeds: {found.needs.label}" if found.answer is not None else "")
    if found.answer is None:
        console.explain(f"sim2reason: {found.reason}")
    return 0 if found.answer is not None else 1


def _document(told: str, found: "Solution") -> dict[str, object]:
    return {
        "problem": told,
        "strategy": found.strategy,
        "answer": found.answer,
        "needs": found.needs.label,
        "reason": found.reason,
        "text": found.text,
        "steps": [
            {
                "id": step.id,
                "kind": step.kind,
                "text": step.text,
                "relations": [relation.latex() for relation in step.relations],
                "gives": list(step.gives),
                "needs": list(step.needs),
            }
            for step in found.steps
        ],
    }

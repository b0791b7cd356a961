"""Solve a problem in steps, as a teacher would write them."""

from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sim2reason.cli import console, source
from sim2reason.errors import DrawError, SceneError, TextError

if TYPE_CHECKING:
    from sim2reason.solutions import Solution

EXAMPLE = """\b
Example:
    sim2reason solve --id pulley-easy-numeric-0-4
    sim2reason solve scene.yaml --seed 3
    sim2reason solve scene.yaml --question "What is the tension in the string just after release?"
"""
TRIES = 20


@click.command("solve", epilog=EXAMPLE)
@click.argument("path", metavar="[SCENE]", required=False, type=click.Path(path_type=Path, allow_dash=True))
@click.option("--id", "name", help="The problem of this id, made again from its name.")
@click.option("--question", help="A question about the scene, in the words of the library; else one is drawn.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Another seed, other words.")
@click.option("--json", "to_json", is_flag=True, help="For a program to read: steps with their relations.")
def command(path: Path | None, name: str | None, question: str | None, seed: int, *, to_json: bool) -> int:
    """Solve a question about the scene in the file SCENE (- is standard input), or the problem of an id.

    Exit code 1 if no strategy applies; standard error then says why.
    """
    if (path is None) == (name is None):
        raise click.UsageError("give a scene or an --id, one of the two.")
    told, found = _of_item(name) if name else _of_scene(path or Path("-"), question, seed)
    if to_json:
        console.as_json(_document(told, found))
    else:
        click.echo(told)
        click.echo(f"\n{found.text}" if found.answer is not None else "")
    if found.answer is None:
        console.explain(f"sim2reason: {found.reason}")
    return 0 if found.answer is not None else 1


def _of_item(name: str) -> "tuple[str, Solution]":
    from sim2reason.datasets.item_search import ItemSearch
    from sim2reason.datasets.make import item_of
    from sim2reason.datasets.plan import Request
    from sim2reason.datasets.worked_solutions import worked
    from sim2reason.questions.spoken_units import system_named

    request = Request.named(name)
    system_named(request.units)
    found = ItemSearch(request).found()
    if found is None:
        raise DrawError(f"{name}: no draw passed the filters, so that there is no such problem; take another index")
    return item_of(request, found).prompt, worked(request, found)


def _of_scene(path: Path, question: str | None, seed: int) -> "tuple[str, Solution]":
    from sim2reason.datasets.question_search import QuestionSearch
    from sim2reason.datasets.random_scenes import generator
    from sim2reason.questions import MODES
    from sim2reason.questions.parse_question import parse_question
    from sim2reason.solutions import Setting, solve

    search = QuestionSearch(source.scene(path), seed)
    if question is None:
        draws = (search.ask(MODES["numeric"], generator("solve", seed, n), Counter[str]()) for n in range(TRIES))
        drawn = next((held for held in draws if held is not None), None)
        if drawn is None:
            raise SceneError(str(path), "no question about it passes the filters", "give one, by --question")
        query, question = drawn.question.query, drawn.question.text
    else:
        query = parse_question(question, search.study, search.words)
        if query is None:
            raise TextError("--question", "it asks nothing that this library asks", "see: sim2reason ask SCENE")
    setting = Setting(search.study.scene, search.words, search.description.symbols, search.study, query)
    return f"{search.description.text} {question}", solve(setting)


def _document(told: str, found: "Solution") -> dict[str, object]:
    return {
        "problem": told,
        "strategy": found.strategy,
        "answer": found.answer,
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

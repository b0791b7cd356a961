"""Ask questions about a scene, with their answers."""

from collections import Counter
from pathlib import Path

import click

from sim2reason.cli import console
from sim2reason.datasets.draws import generator
from sim2reason.datasets.make import Asking, ask
from sim2reason.dsl.files import load
from sim2reason.questions import MODES

EXAMPLE = """\b
Example:
    sim2reason ask scene.yaml -n 5 --seed 0
"""
TRIES = 10  # for each question that is wanted


@click.command("ask", epilog=EXAMPLE)
@click.argument("scene", type=click.Path(path_type=Path))
@click.option("--mode", default="numeric", show_default=True, help="What is unknown; see: sim2reason list modes.")
@click.option("-n", "count", type=click.IntRange(1, 1000), default=5, show_default=True, help="How many questions.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Another seed, other questions.")
@click.option("--json", "to_json", is_flag=True, help="For a program to read.")
def command(scene: Path, mode: str, count: int, seed: int, *, to_json: bool) -> int:
    """Ask questions about the scene in the file SCENE; only those that pass every filter."""
    loaded, asked = load(scene), MODES[mode]
    refused: Counter[str] = Counter()
    found: dict[str, Asking] = {}
    for attempt in range(TRIES * count):
        asking = ask(loaded, asked, generator("ask", mode, seed, attempt), refused)
        if asking is not None:
            found.setdefault(asking.question.text, asking)
        if len(found) == count:
            break
    if to_json:
        console.as_json([_document(asking) for asking in found.values()])
    for asking in () if to_json else found.values():
        click.echo(f"{asking.prompt}\n\nAnswer: {asking.question.answer:.6g} {asking.question.unit}\n")
    if len(found) < count:
        said = ", ".join(f"{number} {name}" for name, number in sorted(refused.items()))
        console.explain(f"sim2reason: {len(found)} of {count} questions; refused: {said or 'none'}")
    return 0 if found else 1


def _document(asking: Asking) -> dict[str, object]:
    question = asking.question
    return {
        "prompt": asking.prompt,
        "answer": question.answer,
        "unit": question.unit,
        "sign": question.sign,
        "mode": question.mode,
        "kind": question.ask.kind,
        "time": question.ask.time(asking.trace),
    }

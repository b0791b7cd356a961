"""Ask questions about a scene, with their answers."""

from collections import Counter
from pathlib import Path
from textwrap import fill

import click

from sim2reason.cli import console, source
from sim2reason.datasets.make import answer_of
from sim2reason.datasets.question_search import CertifiedQuestion, QuestionSearch
from sim2reason.datasets.random_scenes import generator
from sim2reason.questions import KINDS, MODES

EXAMPLE = """\b
Example:
    sim2reason ask scene.yaml -n 5 --seed 0
"""
TRIES = 10  # for each question that is wanted
WIDTH = 100


@click.command("ask", epilog=EXAMPLE)
@click.argument("path", metavar="SCENE", type=click.Path(path_type=Path, allow_dash=True))
@click.option("--mode", default="numeric", show_default=True, help="What is unknown; see: sim2reason list modes.")
@click.option("-n", "count", type=click.IntRange(1, 1000), default=5, show_default=True, help="How many questions.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Another seed, other questions.")
@click.option("--json", "to_json", is_flag=True, help="For a program to read: whole prompts.")
def command(path: Path, mode: str, count: int, seed: int, *, to_json: bool) -> int:
    """Ask questions about the scene in the file SCENE (- is standard input); only those that pass every filter."""
    asked, search = MODES[mode], QuestionSearch(source.scene(path), seed)
    refused: Counter[str] = Counter()
    found: dict[str, CertifiedQuestion] = {}
    for attempt in range(TRIES * count):
        certified = search.ask(asked, generator("ask", mode, seed, attempt), refused)
        if certified is not None:
            found.setdefault(certified.question.text, certified)
        if len(found) == count:
            break
    if to_json:
        console.as_json([_document(certified) for certified in found.values()])
    else:
        _tell(search.description.text, list(found.values()))
    if len(found) < count:
        said = ", ".join(f"{number} {name}" for name, number in sorted(refused.items()))
        console.explain(f"sim2reason: {len(found)} of {count} questions; refused: {said or 'none'}")
    return 0 if found else 1


def _tell(text: str, found: list[CertifiedQuestion]) -> None:
    """The text of the scene, once, and its questions with their answers."""
    for line in text.splitlines():
        click.echo(line if line.startswith("|") else fill(line, WIDTH, break_on_hyphens=False))
    for number, certified in enumerate(found, start=1):
        question = certified.question
        sign = f"  (positive: {question.sign})" if question.sign else ""
        click.echo(f"\n{number}. {question.text}\n   Answer: {answer_of(certified).told}{sign}")


def _document(certified: CertifiedQuestion) -> dict[str, object]:
    question, query = certified.question, certified.question.query
    return {
        "prompt": certified.prompt,
        "question": question.text,
        "answer": question.answer,
        "formula": question.formula.latex if question.formula is not None else None,
        "unit": question.unit,
        "sign": question.sign,
        "mode": question.mode,
        "kind": query.kind,
        "time": KINDS[query.kind].time(query, certified.study),
    }

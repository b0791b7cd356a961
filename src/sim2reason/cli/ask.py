"""Ask questions about a scene, with their answers."""

from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING

import click

from sim2reason.cli import console, options, source

if TYPE_CHECKING:
    from sim2reason.datasets.scene_questions import AskedScene

EXAMPLE = """\b
Example:
    sim2reason ask scene.yaml -n 5 --seed 0
"""
WIDTH = 100


@click.command("ask", epilog=EXAMPLE)
@options.scene()
@options.mode()
@options.items(5, 1, 1000, "How many questions.")
@options.seed("Another seed, other questions.")
@click.option("--all", is_flag=True, help="Those that filters refuse, too: easy, odd or uncertain ones.")
@options.to_json("For a program to read: a list of whole items, as show gives them.")
def command(scene: Path, mode: str | tuple[str, ...], items: int, seed: int, all: bool, to_json: bool) -> int:  # noqa: A002
    """Ask questions with different answers about the scene in the file SCENE (- is standard input).

    Every question passes every filter, unless --all is given. Exit code 1 if there are none; standard error says why.
    """
    from sim2reason.datasets.scene_questions import asked

    result = asked(source.scene(scene), mode, items, seed, unfiltered=all)
    if to_json:
        console.as_json_list(item.model_dump(mode="json") for _, item in result.found.values())
    else:
        _tell(result)
    if len(result.found) < items:
        _explain(result, items, all=all)
    return 0 if result.found else 1


def _explain(result: "AskedScene", items: int, *, all: bool) -> None:  # noqa: A002
    """Print the number of questions found, and a table of the reasons that rejected others."""
    from sim2reason.base.registry import members

    if result.reason:
        console.explain(f"sim2reason: there is nothing to ask: {result.reason}")
        return
    hint = "" if all else " (--all asks those, too)"
    found = f"sim2reason: {len(result.found)} of {items} questions"
    if not result.refused:
        console.explain(found)
        return
    console.explain(f"{found}; others were refused{hint}:")
    meanings = {filter.name: filter.summary for filter in members("filters")["filters"]}
    rows = [[number, name, meanings.get(name.partition(":")[0], "")] for name, number in result.refused.most_common()]
    console.table(["number", "reason", "meaning"], rows, err=True)


def _tell(result: "AskedScene") -> None:
    """Print the scene's text once and the questions; whole prompts if the text reveals an answer."""
    found = list(result.found.values())
    whole = any(certified.question.unknown or certified.question.formula for certified, _ in found)
    _print("" if whole else result.text)
    for number, (certified, item) in enumerate(found, start=1):
        said = item.prompt if whole else certified.question.text
        _print(f"\n{number}. {said}")
        click.echo(f"   Answer: {item.answer.shown}")


def _print(text: str) -> None:
    for line in text.splitlines():
        click.echo(line if line.startswith("|") else fill(line, WIDTH, break_on_hyphens=False))

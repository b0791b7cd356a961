"""Commands for questions about a scene: draw some with their answers, or solve one in steps.

Shells complete the options of a structured question with names from the scene file.
"""

from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sim2reason.cli import files
from sim2reason.errors import Sim2ReasonError

if TYPE_CHECKING:
    from sim2reason.questions import Words
from textwrap import fill
from typing import TYPE_CHECKING

from sim2reason.cli import console, options

if TYPE_CHECKING:
    from sim2reason.datasets.scene_questions import AskedScene
from typing import TYPE_CHECKING, Any

from sim2reason.scenes.dsl.measures import join_unit, show_unit
from sim2reason.scenes.files import read_question

if TYPE_CHECKING:
    from sim2reason.datasets.scene_questions import SolvedProblem
    from sim2reason.solutions import Solution


def findable(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[str]:
    """Return the names of quantities and numbers of the scene that begin with `incomplete`."""
    from sim2reason.questions.posing import findable_names as names

    del param
    words = _words(ctx)
    return _beginning(incomplete, names(words) if words is not None else ())


def subjects(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[str]:
    """Return the addresses of bodies of the scene that begin with `incomplete`."""
    del param
    words = _words(ctx)
    return _beginning(incomplete, words.mentions if words is not None else ())


def moments(ctx: click.Context, param: click.Parameter, incomplete: str) -> list[str]:
    """Return the names of moments and outcomes that begin with `incomplete`."""
    from sim2reason.questions import MOMENTS
    from sim2reason.questions.outcomes import OUTCOMES

    del ctx, param
    return _beginning(incomplete, (name.replace("_", " ") for name in (*MOMENTS, *OUTCOMES, "equilibrium")))


def _words(ctx: click.Context) -> "Words | None":
    from sim2reason.questions.prompt import words_of
    from sim2reason.text.prose.description import describe

    path = ctx.params.get("scene") or next(iter(ctx.args), None)  # click leaves it there while an option has no value
    with suppress(Sim2ReasonError, OSError):
        return words_of(describe(files.scene(Path(path)))) if path is not None else None
    return None


def _beginning(incomplete: str, names: Iterable[str]) -> list[str]:
    return [name for name in names if name.startswith(incomplete)]


ASK_EXAMPLE = """\b
Example:
    sim2reason ask scene.yaml -n 5 --seed 0
"""
LINE_WIDTH = 100


@click.command("ask", epilog=ASK_EXAMPLE)
@options.scene()
@options.mode()
@options.items(5, 1, 1000, "How many questions.")
@options.seed("Another seed, other questions.")
@click.option("--all", is_flag=True, help="Those that filters refuse, too: easy, odd or uncertain ones.")
@options.to_json("For a program to read: a list of whole items, as show gives them.")
def ask_command(scene: Path, mode: str | tuple[str, ...], items: int, seed: int, all: bool, to_json: bool) -> int:  # noqa: A002
    """Ask questions with different answers about the scene in the file SCENE (- is standard input).

    Every question passes every filter, unless --all is given. Exit code 1 if there are none; standard error says why.
    """
    from sim2reason.datasets.scene_questions import ask_scene

    result = ask_scene(files.scene(scene), mode, items, seed, unfiltered=all)
    if to_json:
        console.as_json_list(item.model_dump(mode="json") for _, item in result.found.values())
    else:
        _tell_questions(result)
    if len(result.found) < items:
        _explain_refusals(result, items, all=all)
    return 0 if result.found else 1


def _explain_refusals(result: "AskedScene", items: int, *, all: bool) -> None:  # noqa: A002
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


def _tell_questions(result: "AskedScene") -> None:
    """Print the scene's text once and the questions; whole prompts if the text reveals an answer."""
    found = list(result.found.values())
    whole = any(certified.question.unknown or certified.question.formula for certified, _ in found)
    _print_wrapped("" if whole else result.text)
    for number, (certified, item) in enumerate(found, start=1):
        said = item.prompt if whole else certified.question.text
        _print_wrapped(f"\n{number}. {said}")
        click.echo(f"   Answer: {item.answer.shown}")


def _print_wrapped(text: str) -> None:
    for line in text.splitlines():
        click.echo(line if line.startswith("|") else fill(line, LINE_WIDTH, break_on_hyphens=False))


PARTS = ("find", "of", "when", "along", "given", "change")
MIN_TABLE_ROWS = 3  # reasons, from which on they are printed as a table
SOLVE_EXAMPLE = """\b
Example:
    sim2reason solve --id pulley-easy-numeric-0-4
    sim2reason solve scene.yaml --seed 3
    sim2reason solve scene.yaml --question "What is the tension in the string just after release?"
    sim2reason solve scene.yaml --question "How fast is the block after 2 s?"
    sim2reason solve scene.yaml --find velocity --of ramp.block --when "moved 0.5 m"
    sim2reason solve scene.yaml --find ramp.speed --given "displacement = 25 m" --when stopped
"""


@click.command("solve", epilog=SOLVE_EXAMPLE)
@click.argument("scene", metavar="[SCENE]", required=False, type=click.Path(path_type=Path, allow_dash=True))
@options.identity("The problem of this id, made again from its name.")
@click.option("--question", help="A question about the scene, in English; else one is drawn.")
@click.option(
    "--find",
    help="What to find: a quantity, as list quantities has them, a functional, time, or an address.",
    metavar="NAME",
    default="",
    shell_complete=findable,
)
@click.option(
    "--of",
    help="Of what: as the text calls it, or by its address.",
    metavar="SUBJECT",
    default="",
    shell_complete=subjects,
)
@click.option(
    "--when",
    help="When: a time, a moment, or QUANTITY = VALUE.",
    metavar="MOMENT",
    default="",
    shell_complete=moments,
)
@click.option("--along", help="Which component: an axis, or what is positive.", metavar="AXIS", default="")
@click.option("--given", help="Find a number of the scene that makes QUANTITY = VALUE.", metavar="EQUATION", default="")
@click.option(
    "--change",
    help="Find how it changes: ADDRESS = VALUE, ADDRESS × 2, BODY fixed; or what follows: STRING removed at 1.5 s.",
    metavar="CHANGE",
    default="",
)
@click.option(
    "--compare",
    help="Tell a changed answer, or a number that is found, as its ratio to that of the scene, as the difference"
    " or as its value. By default a ratio with --change, a value otherwise.",
    metavar="[ratio|difference|value]",
    default="",
)
@options.seed("Another seed, other words.")
@options.to_json("For a program to read: steps with their relations.")
def solve_command(scene: Path | None, id: str | None, to_json: bool, **asked: Any) -> int:  # noqa: A002, ANN401 - click's own
    """Solve a question about the scene in the file SCENE (- is standard input), or the problem of an id.

    A question about a scene is answered from the motion, which is followed until the answer is known, and by a worked
    solution where a strategy finds one. Exit code 1 if there is no answer; standard error says why.
    """
    from sim2reason.datasets.scene_questions import solve

    if (scene is None) == (id is None):
        raise click.UsageError("give a scene or an --id, one of the two.")
    if scene is None:
        solved = solve(None, id=id, **asked)
    else:
        content = _text(scene)
        read = files.scene(scene, content)
        if asked["question"] is None and not any(asked[name] for name in PARTS):
            asked["question"] = read_question(content)
        solved = solve(read, **asked)
    if to_json:
        console.as_json(_document(solved))
    else:
        _tell_solution(solved, of_scene=scene is not None)
    failed = solved.solution.answer is None and (scene is None or solved.answer is None)
    if failed:
        console.explain(f"sim2reason: no answer: {solved.reason}")
    elif solved.solution.answer is None:
        _explain_strategies(solved.solution)
    return 1 if failed else 0


def _text(path: Path) -> str:
    """Return the text of a scene file; FileNotFoundError names `--id`, in case the user means the id of a problem."""
    try:
        return files.text(path)
    except FileNotFoundError as error:
        error.add_note(f"if this is the id of a problem: sim2reason solve --id {path.name}")
        raise


def _tell_solution(solved: "SolvedProblem", *, of_scene: bool) -> None:
    """Print a problem, its worked solution and, for a scene, the answer from the motion to twelve digits."""
    found = solved.solution
    click.echo(solved.problem)
    if solved.read_as:
        click.echo(f"\nRead as: {solved.read_as}")
    if found.answer is not None:
        click.echo(f"\n{found.text}\n\nNeeds: {found.needs.label}")
    if of_scene and solved.answer is not None:
        over = f", {solved.over}" if solved.over else ""
        click.echo(f"\nFrom the motion: {join_unit(f'{solved.answer:.12g}', show_unit(solved.unit))}{over}")


def _explain_strategies(found: "Solution") -> None:
    """Print why there is no worked solution, as a table for three or more strategies."""
    tried = [row.partition(": ")[::2] for row in found.reason.split("; ")]
    if len(tried) < MIN_TABLE_ROWS:
        console.explain(f"sim2reason: no worked solution: {found.reason}")
        return
    console.explain("sim2reason: no worked solution:")
    console.table(["strategy", "why not"], tried, err=True)


def _document(solved: "SolvedProblem") -> dict[str, object]:
    solution = solved.solution
    return {
        "problem": solved.problem,
        "read_as": solved.read_as,
        "strategy": solution.strategy,
        "answer": solution.answer if solution.answer is not None else solved.answer,
        "unit": solved.unit,
        "from_motion": solved.answer,
        "over": solved.over,
        "needs": solution.needs.label,
        "reason": solved.reason,
        "text": solution.text,
        "steps": [
            {
                "id": step.id,
                "kind": step.kind,
                "text": step.text,
                "relations": [relation.latex() for relation in step.relations],
                "gives": list(step.gives),
                "needs": list(step.needs),
            }
            for step in solution.steps
        ],
    }

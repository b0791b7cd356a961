"""Solve a problem in steps, as a teacher would write them."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sim2reason.cli import completion, console, options, source
from sim2reason.scenes.dsl.measures import join_unit, show_unit
from sim2reason.scenes.files import question_of

if TYPE_CHECKING:
    from sim2reason.datasets.scene_questions import SolvedProblem
    from sim2reason.solutions import Solution

PARTS = ("find", "of", "when", "along", "given", "change")
LONG = 3  # reasons, from which on they are printed as a table
EXAMPLE = """\b
Example:
    sim2reason solve --id pulley-easy-numeric-0-4
    sim2reason solve scene.yaml --seed 3
    sim2reason solve scene.yaml --question "What is the tension in the string just after release?"
    sim2reason solve scene.yaml --question "How fast is the block after 2 s?"
    sim2reason solve scene.yaml --find velocity --of ramp.block --when "moved 0.5 m"
    sim2reason solve scene.yaml --find ramp.speed --given "displacement = 25 m" --when stopped
"""


@click.command("solve", epilog=EXAMPLE)
@click.argument("scene", metavar="[SCENE]", required=False, type=click.Path(path_type=Path, allow_dash=True))
@options.identity("The problem of this id, made again from its name.")
@click.option("--question", help="A question about the scene, in English; else one is drawn.")
@click.option(
    "--find",
    help="What to find: a quantity, as list quantities has them, a functional, time, or an address.",
    metavar="NAME",
    default="",
    shell_complete=completion.findable,
)
@click.option(
    "--of",
    help="Of what: as the text calls it, or by its address.",
    metavar="SUBJECT",
    default="",
    shell_complete=completion.subjects,
)
@click.option(
    "--when",
    help="When: a time, a moment, or QUANTITY = VALUE.",
    metavar="MOMENT",
    default="",
    shell_complete=completion.moments,
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
def command(scene: Path | None, id: str | None, to_json: bool, **asked: Any) -> int:  # noqa: A002, ANN401 - click's own
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
        read = source.scene(scene, content)
        if asked["question"] is None and not any(asked[name] for name in PARTS):
            asked["question"] = question_of(content)
        solved = solve(read, **asked)
    if to_json:
        console.as_json(_document(solved))
    else:
        _tell(solved, of_scene=scene is not None)
    failed = solved.solution.answer is None and (scene is None or solved.answer is None)
    if failed:
        console.explain(f"sim2reason: no answer: {solved.reason}")
    elif solved.solution.answer is None:
        _explain(solved.solution)
    return 1 if failed else 0


def _text(path: Path) -> str:
    """Return the text of a scene file; FileNotFoundError names `--id`, in case the user means the id of a problem."""
    try:
        return source.text(path)
    except FileNotFoundError as error:
        error.add_note(f"if this is the id of a problem: sim2reason solve --id {path.name}")
        raise


def _tell(solved: "SolvedProblem", *, of_scene: bool) -> None:
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


def _explain(found: "Solution") -> None:
    """Print why there is no worked solution, as a table for three or more strategies."""
    tried = [row.partition(": ")[::2] for row in found.reason.split("; ")]
    if len(tried) < LONG:
        console.explain(f"sim2reason: no worked solution: {found.reason}")
        return
    console.explain("sim2reason: no worked solution:")
    console.table(["strategy", "why not"], tried, err=True)


def _document(solved: "SolvedProblem") -> dict[str, object]:
    found = solved.solution
    return {
        "problem": solved.problem,
        "read_as": solved.read_as,
        "strategy": found.strategy,
        "answer": found.answer if found.answer is not None else solved.answer,
        "unit": solved.unit,
        "from_motion": solved.answer,
        "over": solved.over,
        "needs": found.needs.label,
        "reason": solved.reason,
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

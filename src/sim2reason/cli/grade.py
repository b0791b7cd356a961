"""Grade responses to the problems of a dataset."""

from pathlib import Path

import click

from sim2reason.cli import console

EXAMPLE = """\b
Example:
    sim2reason grade problems --responses responses.jsonl -o scores.jsonl

A line of responses is {"id": …, "response": …}; an id may occur more than once. The answer is the content of the
last complete box after the thinking. Exit code 0: graded; 2: no finished dataset, or a line that fits no item.
"""


LONGEST_NAME = 80  # characters shown of an id that nobody knows


@click.command("grade", epilog=EXAMPLE)
@click.argument("out", type=click.Path(path_type=Path))
@click.option(
    "--responses", "source", type=click.Path(path_type=Path), required=True, help="JSON lines {id, response}."
)
@click.option("-o", "scores", type=console.RESULT, help="Write {id, reward, outcome, parsed, why} here.")
@click.option("--lenient", is_flag=True, help="Without a box, take the last number. For evaluation only.")
@click.option("--json", "to_json", is_flag=True, help="For a program to read: a list of groups with their outcomes.")
def command(out: Path, source: Path, scores: Path | None, lenient: bool, to_json: bool) -> int:
    """Grade responses to the dataset in OUT; sum up by recipe, kind and outcome."""
    from sim2reason.datasets import grade
    from sim2reason.datasets.dataset import Dataset
    from sim2reason.errors import DatasetError
    from sim2reason.grading import Outcome

    given = list(grade.responses(source))
    if not given:
        raise DatasetError(f"{source}: holds no response; give a line {{id, response}} for each")
    wanted = {response.id for response in given}
    items = {item.id: item for item in Dataset(out) if item.id in wanted}
    if wanted - items.keys():
        unknown = min(wanted - items.keys())[:LONGEST_NAME]
        raise DatasetError(f"{source}: {unknown!r} is no item of {out}; give the dataset it is from")
    graded = [(response, grade.grade(items[response.id], response.response, lenient=lenient)) for response in given]
    if scores is not None:
        scores.write_text("".join(f"{grade.line(*pair)}\n" for pair in graded), encoding="utf-8")
    tallies = grade.tallies((items[response.id], score) for response, score in graded)
    if to_json:
        console.as_json([tally._asdict() for tally in tallies])
    else:
        head = ["by", "name", "responses", "reward", *Outcome]
        console.table(head, [[*tally[:3], f"{tally.reward:.3f}", *tally.outcomes.values()] for tally in tallies])
    return 0

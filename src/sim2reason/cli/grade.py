"""Grade responses to the problems of a dataset."""

from pathlib import Path

import click

from sim2reason.cli import console, options, results

EXAMPLE = """\b
Example:
    sim2reason grade problems --responses responses.jsonl -o scores.jsonl

A line of responses is {"id": …, "response": …}; an id may occur more than once, and a list of texts is as many
responses. The answer is the content of the
last complete box after the thinking. Exit code 0: graded; 2: no finished dataset, or a line that fits no item.
"""


@click.command("grade", epilog=EXAMPLE)
@options.dataset()
@click.option(
    "--responses",
    type=click.Path(path_type=Path, allow_dash=True),
    required=True,
    help="JSON lines {id, response}; - is standard input.",
)
@options.out("Write {id, reward, outcome, parsed, why} here; to - they are printed, and the table goes to stderr.")
@options.split()
@click.option("--lenient", is_flag=True, help="Without a box, take the last number. For evaluation only.")
@click.option("--partial", is_flag=True, help="Pay the share of the parts that are right; else all must be.")
@click.option("--thinking-opened", is_flag=True, help="Prompts ended within the thinking, as by a chat template.")
@options.to_json("For a program to read: a list of groups with their outcomes.")
def command(
    dataset: Path,
    responses: Path,
    out: Path | None,
    split: options.Names,
    lenient: bool,
    partial: bool,
    thinking_opened: bool,
    to_json: bool,
) -> None:
    """Grade responses to the DATASET; sum up by recipe, kind and outcome."""
    from sim2reason.datasets import grade
    from sim2reason.datasets.dataset import Dataset
    from sim2reason.grading import Outcome

    if to_json and out == results.STDOUT:
        raise click.UsageError("--json and -o - both want standard output; give one of them a file.")
    name, tallies = "standard input" if responses == results.STDOUT else str(responses), grade.Tallies()
    with click.open_file(responses, "rb") as file, results.lines(out) as say:
        given = grade.responses(file, name)
        how = {"lenient": lenient, "partial": partial, "thinking_opened": thinking_opened}
        for found in grade.graded(Dataset(dataset), given, split=split, **how):
            tallies.add(found)
            say(grade.line(found.response, found.score))
    if to_json:
        console.as_json([tally._asdict() for tally in tallies])
        return
    head = ["by", "name", "responses", "reward", *Outcome]
    rows = [[*tally[:3], f"{tally.reward:.3f}", *tally.outcomes.values()] for tally in tallies]
    console.table(head, rows, err=out == results.STDOUT)

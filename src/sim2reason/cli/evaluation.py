"""Commands that evaluate models: grade responses, run benchmarks, and sample correct solutions."""

from pathlib import Path

import click

from sim2reason.cli import console, files, options

GRADE_EXAMPLE = """\b
Example:
    sim2reason grade problems --responses responses.jsonl -o scores.jsonl

A line of responses is {"id": …, "response": …}; an id may occur more than once, and a list of texts is as many
responses. The answer is the content of the
last complete box after the thinking. Exit code 0: graded; 2: no finished dataset, or a line that fits no item.
"""


@click.command("grade", epilog=GRADE_EXAMPLE)
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
def grade_command(
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

    if to_json and out == files.STDOUT:
        raise click.UsageError("--json and -o - both want standard output; give one of them a file.")
    name, tallies = "standard input" if responses == files.STDOUT else str(responses), grade.Tallies()
    with click.open_file(responses, "rb") as file, files.lines(out) as say:
        given = grade.responses(file, name)
        how = {"lenient": lenient, "partial": partial, "thinking_opened": thinking_opened}
        for found in grade.grade_all(Dataset(dataset), given, split=split, **how):
            tallies.add(found)
            say(grade.line(found.response, found.score))
    if to_json:
        console.as_json([tally._asdict() for tally in tallies])
        return
    head = ["by", "name", "responses", "reward", *Outcome]
    rows = [[*tally[:3], f"{tally.reward:.3f}", *tally.outcomes.values()] for tally in tallies]
    console.table(head, rows, err=out == files.STDOUT)


SAMPLE_SOLUTIONS_EXAMPLE = """\b
Example:
    sim2reason sample-solutions problems --policy policy.yaml --k 8 -o solutions

policy.yaml has the settings of one policy, as a configuration of sim2reason eval has them. The file
solutions/solutions.jsonl has the responses that earn the whole reward; a corpus {kind: sampled, folder: solutions} of
sim2reason train sft learns from them. The same command goes on where it was broken off, and asks nothing twice.
"""
FOLDER = click.Path(file_okay=False, path_type=Path)


@click.command("sample-solutions", epilog=SAMPLE_SOLUTIONS_EXAMPLE)
@options.dataset()
@click.option("--policy", type=click.Path(path_type=Path), required=True, help="A YAML file with its settings.")
@click.option("--k", type=click.IntRange(1, 4096), default=8, show_default=True, help="Tries at each problem.")
@click.option("--keep", type=click.IntRange(1, 4096), default=4, show_default=True, help="Solutions of one, at most.")
@options.split()
@options.seed("Of the tries: each has a seed of its own that follows from it.")
@click.option("-o", "--out", type=FOLDER, required=True, help="The folder of the result.")
@options.verbose()
@options.to_json("Print the result for a program to read.")
def sample_solutions_command(
    dataset: Path, policy: Path, k: int, keep: int, split: options.Names, seed: int, out: Path, to_json: bool
) -> None:
    """Ask a policy for solutions of the problems of DATASET, and keep those that the grader finds right."""
    from sim2reason.datasets.dataset import Dataset
    from sim2reason.training.corpora.solutions import sample_solutions

    counts = Dataset(dataset).manifest.counts.get("split", {})
    total = k * sum(counts.values() if split == options.ALL else (counts.get(name, 0) for name in split))
    remedy = f"what is finished stays in {out}; give the same command again to go on"
    with console.resumable(remedy), console.progress("answers", total) as advance:
        found = sample_solutions(dataset, out, policy, k=k, keep=keep, split=split, seed=seed, advance=advance)
    if to_json:
        console.as_json(found.model_dump(mode="json"))
    else:
        console.table(["answers", "number"], [["kept", found.kept], *map(list, found.left_out.items())])
        where = out / "solutions.jsonl"
        click.echo(f"{found.kept} solutions of {found.solved} of {found.items} problems: {where}")


EVAL_EXAMPLE = """\b
Example:
    sim2reason eval config.yaml
    sim2reason eval compare before after
    sim2reason eval correlate run-1 run-2 run-3 -o correlation
    sim2reason eval solvable problems --policy policy.yaml -o solvable

A configuration names policies, benchmarks, seed, samples and the folder of the run; docs/evaluation.md has one. Every
finished answer is on disk at once: the same command goes on where a run was broken off, and asks nothing twice.

Exit code 0: done; 1: done, but some samples got no answer; 2: wrong input, or a model that can't be asked.
"""
COMPARE_EXAMPLE = """\b
Example:
    sim2reason eval compare before after
    sim2reason eval compare run:base run:trained -o comparison
"""
CORRELATE_EXAMPLE = """\b
Example:
    sim2reason eval correlate run-1 run-2 run-3 -o correlation
    sim2reason eval correlate runs --across ours --up jeebench,olympiadbench
"""
SOLVABLE_EXAMPLE = """\b
Example:
    sim2reason eval solvable problems --policy policy.yaml --k 8 --between 0.1,0.9 -o solvable

policy.yaml has the settings of one policy, as a configuration has them. The folder solvable/problems is a dataset of
what was kept; the same command goes on where it was broken off, and with more tries or other bounds.
"""
RUN = "run"


class _DefaultRunGroup(click.Group):
    """A click group that treats an unknown command as the configuration of `run`."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the named command, or `run`."""
        if args and args[0] not in self.commands:
            return super().resolve_command(ctx, [RUN, *args])
        return super().resolve_command(ctx, args)


@click.group("eval", cls=_DefaultRunGroup, epilog=EVAL_EXAMPLE, subcommand_metavar="CONFIG | COMMAND [ARGS]...")
def eval_command() -> None:
    """Have policies answer benchmarks as the file CONFIG says, and report; or compare and correlate such runs."""


@eval_command.command(RUN, epilog=EVAL_EXAMPLE)
@click.argument("config", type=click.Path(path_type=Path))
@click.option("-o", "--out", type=FOLDER, default=None, help="The folder of the run. [default: as CONFIG says]")
@options.verbose()
@click.option("--json", "to_json", is_flag=True, help="Print the report for a program to read.")
def run(config: Path, out: Path | None, to_json: bool) -> int:
    """Run CONFIG; `eval CONFIG` is the same."""
    from sim2reason.evaluation.benchmarks.runs.config import build_evaluation
    from sim2reason.evaluation.reports.evaluation import EvaluationResult, evaluate

    evaluation = build_evaluation(config, out)
    remedy = f"what is finished stays in {evaluation.out}; give the same command again to go on"
    with console.resumable(remedy), console.Bar("answers") as bar:
        evaluated: EvaluationResult = evaluate(evaluation, begun=bar.begin, advance=bar.advance)
    if to_json:
        console.as_json(evaluated.report.model_dump(mode="json"))
    else:
        head = ["benchmark", "policy", "problems", "k", "mean@k (%)", "missing"]
        rows = [
            [r.benchmark, r.policy, r.items, r.samples, r.accuracy.shown, r.missing] for r in evaluated.report.results
        ]
        console.table(head, rows)
        click.echo(f"The whole report: {evaluated.folder.report}")
    if evaluated.open:
        console.explain(
            f"{len(evaluated.open)} samples got no answer; give the same command again. {evaluated.open[0]}"
        )
    return 1 if evaluated.open else 0


@eval_command.command("compare", epilog=COMPARE_EXAMPLE)
@click.argument("first")
@click.argument("second")
@click.option("-o", "--out", type=FOLDER, default=None, help="Write compare.json and compare.md into this folder.")
@click.option("--json", "to_json", is_flag=True, help="For a program to read.")
def compare_command(first: str, second: str, out: Path | None, to_json: bool) -> None:
    """Compare the policies of two runs, FIRST and SECOND, on the same problems; RUN:POLICY where a run has several."""
    from sim2reason.evaluation.reports.comparison import HEAD, compare, rows

    pairs = compare(first, second, out)
    if to_json:
        console.as_json([{**one._asdict(), "difference": one.difference._asdict()} for one in pairs])
    else:
        console.table(HEAD, rows(pairs))


@eval_command.command("correlate", epilog=CORRELATE_EXAMPLE)
@click.argument("runs", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--across", default=None, help="The benchmark that lies across. [default: the synthetic one]")
@click.option("--up", default="", help="Those that it is correlated with, separated by commas. [default: all others]")
@click.option(
    "-o",
    "--out",
    type=FOLDER,
    default=None,
    help="Write correlate.json, correlate.md and the scatter plots there; without it there are none.",
)
@click.option("--json", "to_json", is_flag=True, help="For a program to read.")
def correlate_command(runs: tuple[Path, ...], across: str | None, up: str, out: Path | None, to_json: bool) -> None:
    """Correlate, across the models of RUNS, accuracy on our problems with that on others: Spearman's ρ."""
    from sim2reason.evaluation.reports.comparison import correlate, correlation_text

    correlations = correlate(runs, across, console.comma_separated(up) if up else (), out)
    if to_json:
        console.as_json(
            [
                {"across": f.across, "up": f.up, "models": f.models, "rho": f.rho and f.rho._asdict()}
                for f in correlations
            ]
        )
    else:
        console.table(
            ["across", "up", "models", "ρ"],
            [[f.across, f.up, len(f.models), correlation_text(f)] for f in correlations],
        )


@eval_command.command("solvable", epilog=SOLVABLE_EXAMPLE)
@options.dataset()
@click.option("--policy", type=click.Path(path_type=Path), required=True, help="A YAML file with its settings.")
@click.option("--k", type=click.IntRange(1, 4096), default=8, show_default=True, help="Tries at each problem.")
@click.option("--between", default="0.1,0.9", show_default=True, help="The open interval of shares that are kept.")
@options.seed("Of the tries: each has a seed of its own that follows from it.")
@click.option("-o", "--out", type=FOLDER, required=True, help="The folder of the result.")
@options.verbose()
@click.option("--json", "to_json", is_flag=True, help="Print the result for a program to read.")
def solvable_command(dataset: Path, policy: Path, k: int, between: str, seed: int, out: Path, to_json: bool) -> None:
    """Keep the problems of DATASET that a policy solves sometimes, neither never nor always."""
    from sim2reason.datasets.dataset import Dataset
    from sim2reason.evaluation.policy_pass import solvable

    total, bounds = len(Dataset(dataset)) * k, _bounds(between)
    remedy = f"what is finished stays in {out}; give the same command again to go on"
    with console.resumable(remedy), console.progress("answers", total) as advance:
        result = solvable(dataset, out, policy, k=k, between=bounds, seed=seed, advance=advance)
    if to_json:
        console.as_json(result.model_dump(mode="json"))
    else:
        console.table(["right answers", "problems"], [[int(right), count] for right, count in result.rates.items()])
        click.echo(f"{result.kept} of {result.items} problems kept: {out / 'problems'}")


def _bounds(text: str) -> tuple[float, float]:
    """Return the two numbers of the option --between: the open interval of accepted pass rates."""
    try:
        low, high = map(float, text.split(","))
    except ValueError:
        raise click.UsageError(f"--between: {text!r} is no interval; write LOW,HIGH, as in 0.1,0.9.") from None
    return low, high

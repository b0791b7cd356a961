"""Evaluate policies on benchmarks: ours and those that others published."""

from pathlib import Path

import click

from sim2reason.cli import console, options

EXAMPLE = """\b
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
FOLDER = click.Path(file_okay=False, path_type=Path)


class _DefaultRunGroup(click.Group):
    """A click group that treats an unknown command as the configuration of `run`."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the named command, or `run`."""
        if args and args[0] not in self.commands:
            return super().resolve_command(ctx, [RUN, *args])
        return super().resolve_command(ctx, args)


@click.group("eval", cls=_DefaultRunGroup, epilog=EXAMPLE, subcommand_metavar="CONFIG | COMMAND [ARGS]...")
def command() -> None:
    """Have policies answer benchmarks as the file CONFIG says, and report; or compare and correlate such runs."""


@command.command(RUN, epilog=EXAMPLE)
@click.argument("config", type=click.Path(path_type=Path))
@click.option("-o", "--out", type=FOLDER, default=None, help="The folder of the run. [default: as CONFIG says]")
@options.verbose()
@click.option("--json", "to_json", is_flag=True, help="Print the report for a program to read.")
def run(config: Path, out: Path | None, to_json: bool) -> int:
    """Run CONFIG; `eval CONFIG` is the same."""
    from sim2reason.evaluation.benchmarks.runs.config import evaluation_from
    from sim2reason.evaluation.reports.evaluation import Evaluated, evaluate

    evaluation = evaluation_from(config, out)
    remedy = f"what is finished stays in {evaluation.out}; give the same command again to go on"
    with console.resumable(remedy), console.Bar("answers") as bar:
        found: Evaluated = evaluate(evaluation, begun=bar.begin, advance=bar.advance)
    if to_json:
        console.as_json(found.report.model_dump(mode="json"))
    else:
        head = ["benchmark", "policy", "problems", "k", "mean@k (%)", "missing"]
        rows = [[r.benchmark, r.policy, r.items, r.samples, r.accuracy.shown, r.missing] for r in found.report.results]
        console.table(head, rows)
        click.echo(f"The whole report: {found.folder.report}")
    if found.open:
        console.explain(f"{len(found.open)} samples got no answer; give the same command again. {found.open[0]}")
    return 1 if found.open else 0


@command.command("compare", epilog=COMPARE_EXAMPLE)
@click.argument("first")
@click.argument("second")
@click.option("-o", "--out", type=FOLDER, default=None, help="Write compare.json and compare.md into this folder.")
@click.option("--json", "to_json", is_flag=True, help="For a program to read.")
def compare_command(first: str, second: str, out: Path | None, to_json: bool) -> None:
    """Compare the policies of two runs, FIRST and SECOND, on the same problems; RUN:POLICY where a run has several."""
    from sim2reason.evaluation.reports.comparison import HEAD, compare, rows

    found = compare(first, second, out)
    if to_json:
        console.as_json([{**one._asdict(), "difference": one.difference._asdict()} for one in found])
    else:
        console.table(HEAD, rows(found))


@command.command("correlate", epilog=CORRELATE_EXAMPLE)
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

    found = correlate(runs, across, console.comma_separated(up) if up else (), out)
    if to_json:
        console.as_json(
            [{"across": f.across, "up": f.up, "models": f.models, "rho": f.rho and f.rho._asdict()} for f in found]
        )
    else:
        console.table(
            ["across", "up", "models", "ρ"], [[f.across, f.up, len(f.models), correlation_text(f)] for f in found]
        )


@command.command("solvable", epilog=SOLVABLE_EXAMPLE)
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
    from sim2reason.evaluation.solvable import solvable

    total, bounds = len(Dataset(dataset)) * k, _bounds(between)
    remedy = f"what is finished stays in {out}; give the same command again to go on"
    with console.resumable(remedy), console.progress("answers", total) as advance:
        found = solvable(dataset, out, policy, k=k, between=bounds, seed=seed, advance=advance)
    if to_json:
        console.as_json(found.model_dump(mode="json"))
    else:
        console.table(["right answers", "problems"], [[int(right), count] for right, count in found.rates.items()])
        click.echo(f"{found.kept} of {found.items} problems kept: {out / 'problems'}")


def _bounds(text: str) -> tuple[float, float]:
    """Return the two numbers of the option --between: the open interval of accepted pass rates."""
    try:
        low, high = map(float, text.split(","))
    except ValueError:
        raise click.UsageError(f"--between: {text!r} is no interval; write LOW,HIGH, as in 0.1,0.9.") from None
    return low, high

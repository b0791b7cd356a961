"""Train models: supervised fine-tuning, and reinforcement learning."""

import os
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sim2reason.cli import console, options

if TYPE_CHECKING:
    from sim2reason.training.rl.config import TrainingResult
    from sim2reason.training.rl.run import Stage

EXAMPLE = """\b
Example:
    sim2reason train sft config.yaml
    sim2reason train rl experiments/tiny.yaml
    accelerate launch --no-python sim2reason train sft config.yaml

A configuration names a model, its training data and the folder of the run. The same command resumes an interrupted run.
"""
SFT_EXAMPLE = """\b
Example:
    sim2reason train sft config.yaml
    sim2reason train sft config.yaml -o run

config.yaml, for a tiny model made here that learns from worked solutions:

\b
    out: run
    model: {kind: scratch, layers: 3, width: 96, heads: 3}
    corpora: [{kind: worked, dataset: problems}]
    steps: 1000
    optimizer: muon
    learning_rate: 3.0e-3

The trained model lies in run/model and loads like any checkpoint; the same command resumes an interrupted run.
"""
RL_EXAMPLE = """\b
Example:
    sim2reason train rl experiments/tiny.yaml
    accelerate launch --no-python sim2reason train rl experiments/paper/3b.yaml

The trained model is stored in OUT/model, the measured values of each step in OUT/train/log.jsonl, and accuracies on
held-out problems before and after in OUT/report. The same command resumes an interrupted run with the next prompt.
"""
STUDY_EXAMPLE = """\b
Example:
    sim2reason train study experiments/tiny-study.yaml

tiny-study.yaml names a configuration of train rl, what arms change in it, and seeds:

\b
    out: runs/tiny-study
    base: experiments/tiny.yaml
    seeds: [0, 1, 2]
    arms:
      ours: {}
      random: {reward: random}

Each run lies in OUT/runs/ARM-SEED, all of them together on a page in OUT/report. The same command goes on where a study
was broken off.
"""
FOLDER = click.Path(file_okay=False, path_type=Path)
UNTIL = "Only what comes before: data, which needs no GPU, or the warm start and its answers; the same command goes on."
UNTIL_DATA = "Only what comes before the first step and needs no GPU; the same command goes on."


@click.group("train", epilog=EXAMPLE)
def train_command() -> None:
    """Train a model as a configuration says."""


@train_command.command("sft", epilog=SFT_EXAMPLE)
@click.argument("config", type=click.Path(path_type=Path))
@click.option("-o", "--out", type=FOLDER, default=None, help="The folder of the run. [default: as CONFIG says]")
@click.option("--until", type=click.Choice(["data"]), default=None, help=UNTIL_DATA)
@options.verbose()
@click.option("--json", "to_json", is_flag=True, help="Print the result for a program to read.")
def sft_command(config: Path, out: Path | None, until: str | None, to_json: bool) -> None:
    """Fine-tune a model on prompts with completions, as the file CONFIG says; needs the extra [train]."""
    from sim2reason.training.sft.config import build_fine_tuning
    from sim2reason.training.sft.run import prepare_sft, train_sft

    settings = build_fine_tuning(config, out)
    remedy = f"what is finished stays in {settings.out}; give the same command again to go on"
    with console.resumable(remedy), console.Phases() as phases:
        if until is not None:
            prepare_sft(settings)
            result = None
        else:
            result = train_sft(settings, begun=phases.begin, advance=phases.advance)
    if int(os.environ.get("RANK", "0")):  # of several processes, the first speaks
        return
    if result is None:
        _print_prepared(settings.out, "data")
        return
    if to_json:
        console.as_json(result.model_dump(mode="json"))
    else:
        left_out = sum(result.left_out.values())
        head = ["steps", "rows", "too long", "parameters", "last loss"]
        console.table(head, [[result.steps, result.rows, left_out, result.parameters, round(result.loss, 4)]])
        click.echo(f"The model: {settings.out / result.model}")


@train_command.command("rl", epilog=RL_EXAMPLE)
@click.argument("config", type=click.Path(path_type=Path))
@click.option("-o", "--out", type=FOLDER, default=None, help="The folder of the run. [default: as CONFIG says]")
@click.option("--until", type=click.Choice(["data", "warm-start"]), default=None, help=UNTIL)
@options.verbose()
@click.option("--json", "to_json", is_flag=True, help="Print the result for a program to read.")
def rl_command(config: Path, out: Path | None, until: "Stage | None", to_json: bool) -> None:
    """Train a model on problems by GSPO with our grader as the reward, as the file CONFIG says; needs [train]."""
    from sim2reason.training.extras import is_main_process, silence_library
    from sim2reason.training.rl.config import build_reinforcement_learning
    from sim2reason.training.rl.report import answer_before, report_training
    from sim2reason.training.rl.run import prepare_rl, train_rl

    settings = build_reinforcement_learning(config, out)
    remedy = f"what is finished stays in {settings.out}; give the same command again to go on"
    with console.resumable(remedy), console.Phases() as phases, silence_library():
        if until is not None:
            prepare_rl(settings, until=until, begun=phases.begin, advance=phases.advance)
            if is_main_process():
                if until == "warm-start":
                    answer_before(settings, phases.begin, phases.advance)
                _print_prepared(settings.out, until)
            return
        result = train_rl(settings, begun=phases.begin, advance=phases.advance)
        main = is_main_process()
        report = report_training(settings, begun=phases.begin, advance=phases.advance) if main else None
    if report is None:
        return
    if to_json:
        console.as_json(result.model_dump(mode="json"))
        return
    console.table(["steps", "prompts", "seconds"], [[result.steps, result.prompts_consumed, round(result.seconds)]])
    rows = [
        [name, each.benchmark, f"{100 * each.first:.1f}", f"{100 * each.second:.1f}", each.difference.shown]
        for name, paired in report.differences.items()
        for each in paired
    ]
    if rows:
        console.table(["responses", "problems", "before (%)", "after (%)", "difference"], rows)
    click.echo(f"The report: {report.folder / 'report.md'}")
    click.echo(f"The model: {settings.out / result.model}")


@train_command.command("study", epilog=STUDY_EXAMPLE)
@click.argument("config", type=click.Path(path_type=Path))
@click.option("-o", "--out", type=FOLDER, default=None, help="The folder of the study. [default: as CONFIG says]")
@click.option("--until", type=click.Choice(["data", "warm-start"]), default=None, help=UNTIL)
@options.verbose()
@click.option("--json", "to_json", is_flag=True, help="Print what came of each run for a program to read.")
def study_command(config: Path, out: Path | None, until: "Stage | None", to_json: bool) -> None:
    """Train by `train rl` in several arms and with several seeds, as the file CONFIG says; needs [train]."""
    from sim2reason.training.study.config import build_study
    from sim2reason.training.study.report import report_study
    from sim2reason.training.study.run import prepare_study, train_study

    study = build_study(config, out)
    remedy = f"what is finished stays in {study.out}; give the same command again to go on"
    with console.resumable(remedy), console.Phases() as phases:
        if until is not None:
            prepare_study(study, until=until, begun=phases.begin, advance=phases.advance)
            _print_prepared(study.out, until)
            return
        results = train_study(study, begun=phases.begin, advance=phases.advance)
    report = report_study(study) if study.configs[study.runs[0]].held_out else None
    if to_json:
        console.as_json({name: each.model_dump(mode="json") for name, each in results.items()})
        return
    console.table(["run", "steps", "prompts", "seconds"], [_row(name, each) for name, each in results.items()])
    if report is not None:
        rows = [
            [*each[:3], f"{100 * each.before:.1f}", f"{100 * each.after:.1f}", each.gain.shown] for each in report.arms
        ]
        console.table(["problems", "responses", "arm", "before (%)", "after (%)", "gain"], rows)
        click.echo(f"The report: {report.folder / 'report.md'}")


def _print_prepared(out: Path, until: str) -> None:
    click.echo(f"Prepared until {until}: {out}; the same command without --until goes on")


def _row(name: str, result: "TrainingResult") -> list[object]:
    return [name, result.steps, result.prompts_consumed, round(result.seconds)]

"""Tests that commands can read every configuration under experiments, and of the commands on their page."""

import re
import shlex
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim2reason.base.settings import read_settings
from sim2reason.cli import main
from sim2reason.evaluation.benchmarks import BENCHMARKS
from sim2reason.evaluation.benchmarks.runs.config import build_evaluation
from sim2reason.evaluation.policies import build_policy
from sim2reason.training.rl.config import build_reinforcement_learning
from sim2reason.training.sft.config import build_fine_tuning
from sim2reason.training.study.config import build_study

ROOT = Path(__file__).parents[1]
EXPERIMENTS = ROOT / "experiments"
FILES = sorted(path for path in EXPERIMENTS.rglob("*.yaml") if "verl" not in path.parts)  # which has its own
PAGE = (EXPERIMENTS / "README.md").read_text("utf-8")
ABSENT = {"jsonl", "saved", "synthetic"}  # kinds of which no one else's benchmark is


def reader(file: Path) -> Callable[[Path], object]:
    """Return the function that reads a configuration file, by its folder and its name."""
    folder = file.parent.name
    if file.stem == "teacher":
        return lambda path: build_policy(read_settings(path))
    if file.stem.endswith("study"):
        return build_study
    return {"evaluation": build_evaluation, "sft": build_fine_tuning}.get(folder, build_reinforcement_learning)


@pytest.mark.parametrize("file", FILES, ids=lambda path: str(path.relative_to(EXPERIMENTS)))
def test_each_experiment_can_be_read_and_is_on_the_page(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    reader(file)(file)
    assert any(f"({name})" in PAGE for name in (file.relative_to(EXPERIMENTS), file.parent.relative_to(EXPERIMENTS)))


def test_every_benchmark_has_an_experiment() -> None:
    found = [build_evaluation(path) for path in (EXPERIMENTS / "evaluation").glob("*.yaml")]
    kinds = {BENCHMARKS.name_of(benchmark) for each in found for benchmark in each.benchmarks}
    assert kinds >= set(BENCHMARKS) - ABSENT
    assert len({each.out for each in found}) == len(found)


def test_the_commands_of_the_page_are_commands() -> None:
    """Each command accepts its options, and the files that it names are experiments or their results."""
    commands = [shlex.split(line) for line in re.findall(r"^    (sim2reason .*)$", PAGE, re.MULTILINE)]
    assert {tuple(words[1:3]) for words in commands} >= {("eval", "correlate"), ("eval", "compare"), ("train", "sft")}
    for words in commands:
        found = CliRunner().invoke(main, [*words[1:], "--help"])
        assert found.exit_code == 0, found.output
        assert all((ROOT / word).is_file() for word in words if word.endswith(".yaml"))


def test_what_is_correlated_is_in_the_run() -> None:
    (line,) = re.findall(r"^    sim2reason eval correlate (.*)$", PAGE, re.MULTILINE)
    words = shlex.split(line)
    run = next(
        each for each in map(build_evaluation, (EXPERIMENTS / "evaluation").glob("*.yaml")) if str(each.out) == words[0]
    )
    assert words[words.index("--across") + 1] in {benchmark.name for benchmark in run.benchmarks}
    assert len(run.policies) >= 3

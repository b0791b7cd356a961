"""Tests of problems with several parts in every export: as one prompt, or each with the earlier answers."""

import json
import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim2reason import rewards
from sim2reason.cli import main
from sim2reason.datasets.build import build
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.exports.export import export, split_parts
from sim2reason.datasets.plan import Config
from sim2reason.errors import DatasetError
from sim2reason.questions.prompt_formats import MINUS


@pytest.fixture(scope="module")
def parted(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build three problems: one with parts, one with options, and a plain one."""
    out = tmp_path_factory.mktemp("parted")
    modes = ("multipart", "choice", "numeric")
    build(out, Config(items=3, recipes=("pulley",), difficulties=("easy",), modes=modes, solutions=True), workers=1)
    return out


def rows(folder: Path) -> list[dict[str, str]]:
    return [json.loads(line) for path in folder.glob("data/*.jsonl") for line in path.read_text().splitlines()]


@pytest.mark.parametrize("to", ["inspect", "lm-eval", "reasoning-gym"])
def test_parts_are_one_row_or_several(parted: Path, tmp_path: Path, to: str) -> None:
    count = sum(max(1, len(item.parts)) for item in Dataset(parted))
    assert count > len(Dataset(parted))
    assert sum(export(parted, tmp_path / "one", to=to).rows.values()) == len(Dataset(parted))
    assert sum(export(parted, tmp_path / "each", to=to, parts="separate").rows.values()) == count


def test_the_reward_reads_the_rows_of_either_form(parted: Path, tmp_path: Path) -> None:
    (item,) = (item for item in Dataset(parted) if item.parts)
    export(parted, tmp_path / "one", to="lm-eval")
    export(parted, tmp_path / "each", to="lm-eval", parts="separate")
    (whole,) = (row for row in rows(tmp_path / "one") if row["id"] == item.id)
    assert whole["prompt"] == item.prompt
    assert rewards.score(whole["ground_truth"], whole["target"]).reward == 1.0
    half = whole["target"].replace("(b)", "(b) 7 ")
    given = {"ground_truth": [whole["ground_truth"], None]}
    assert rewards.accuracy([], [half, half], **given) == [0.0, None]
    assert rewards.partial_accuracy([], [half, half], **given) == [1.0 - 1.0 / len(item.parts), None]
    single = [row for row in rows(tmp_path / "each") if row["id"].startswith(f"{item.id}-")]
    assert len(single) == len(item.parts)
    for number, row in enumerate(single):
        assert rewards.score(row["ground_truth"], row["target"]).reward == 1.0
        assert row["prompt"].count("Answer: ") == number


def test_a_later_part_is_given_the_numbers_that_its_solution_starts_from(parted: Path) -> None:
    """The given numbers have five digits; with three, the later answer would differ in its third digit."""
    (item,) = (item for item in Dataset(parted) if item.parts)
    for number, part in enumerate(split_parts(item)):
        told = re.findall(r"Answer: (\S+)", part.prompt)
        assert [float(said.replace(MINUS, "-")) for said in told] == pytest.approx(
            [answer.value for answer in item.answer.parts[:number]], rel=5e-5
        )
        assert part.solution is not None
        recalled = re.findall(r"From part \([a-h]\), .*", part.solution.text)
        numbers = re.findall(r"= -?(\d+\.\d{2,})", " ".join(recalled))
        assert all(any(said in given for given in told) for said in numbers)
        assert bool(numbers) == bool(item.parts[number].uses)


def test_commands_know_parts_and_options(parted: Path, tmp_path: Path) -> None:
    run, responses = CliRunner().invoke, tmp_path / "responses.jsonl"
    items = list(Dataset(parted))
    told = [{"id": item.id, "response": rewards.boxed(rewards.answered(item))} for item in items]
    (several,) = (line for item, line in zip(items, told, strict=True) if item.parts)
    several["response"] = several["response"].replace("(b)", "(b) 7 ")
    responses.write_text("\n".join(map(json.dumps, told)))
    for options, reward in ([], 2 / 3), (["--partial"], (2 + 1 - 1 / 2) / 3):
        done = run(main, ["grade", str(parted), "--responses", str(responses), "--json", *options])
        assert done.exit_code == 0, done.output
        assert json.loads(done.output)[0]["reward"] == pytest.approx(reward)
    for item in items:
        shown = run(main, ["show", str(parted), "--id", item.id, "--solutions"])
        assert shown.exit_code == 0, shown.output
        assert item.solution is None or item.solution.text in shown.output
        solved = run(main, ["solve", "--id", item.id])
        assert item.solution is None or item.solution.text in solved.output
        explained = run(main, ["explain", str(parted), "--id", item.id])
        assert explained.exit_code == 0, explained.output
        assert explained.output.count("(b) engines") == bool(item.parts)
    assert run(main, ["verify", str(parted)]).exit_code == 0
    done = run(main, ["export", str(parted), "--to", "hf", "--out", str(tmp_path / "hf"), "--parts", "separate"])
    assert done.exit_code == 0, done.output


def test_another_word_for_the_parts_is_refused(parted: Path, tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match="parts: 'single' is none of together, separate"):
        export(parted, tmp_path / "out", to="hf", parts="single")  # type: ignore[arg-type]
    assert not list(tmp_path.iterdir())

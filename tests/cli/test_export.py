import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from sim2reason.cli import main


def call(*args: object) -> Result:
    return CliRunner().invoke(main, [str(arg) for arg in args])


@pytest.fixture
def data(tmp_path: Path) -> Path:
    usual = "--items", "40", "--recipe", "incline,pulley", "--difficulty", "easy", "--workers", "1"
    made = call(
        "generate", tmp_path / "data", *usual, "--maker", "fake_makers:with_answers", "--split", "train=0.5,test=0.5"
    )
    assert made.exit_code == 0, made.stderr
    return tmp_path / "data"


def test_export_says_what_it_wrote_and_where_to_read_on(data: Path, tmp_path: Path) -> None:
    result = call("export", data, "--to", "hf", "--out", tmp_path / "hf")
    assert result.exit_code == 0, result.stderr
    assert result.stdout.endswith(f"40 problems in {tmp_path}/hf; how to use them: {tmp_path}/hf/README.md\n")
    assert (tmp_path / "hf/README.md").is_file()


def test_it_says_what_it_left_out_and_why(data: Path, tmp_path: Path) -> None:
    result = call("export", data, "--to", "multiple-choice", "--out", tmp_path / "choice")
    assert "left out: it needs a number as its answer, and 3 wrong ones" in result.stdout


def test_json_is_for_programs(data: Path, tmp_path: Path) -> None:
    result = call("export", data, "--to", "verl", "--out", tmp_path / "verl", "--split", "test", "--json")
    told = json.loads(result.stdout)
    assert told["folder"] == str(tmp_path / "verl")
    assert list(told["rows"]) == ["test"]
    assert told["left_out"] == 0


@pytest.mark.parametrize(
    ("args", "word"),
    [
        (("--to", "hff"), "did you mean: hf"),
        (("--to", "hf", "--split", "dev"), "has no split 'dev'; there is test, train"),
        (("--to", "hf", "--split", ","), "names nothing"),
        ((), "Missing option '--to'"),
    ],
)
def test_wrong_input_is_one_line_and_exit_code_two(
    data: Path, tmp_path: Path, args: tuple[str, ...], word: str
) -> None:
    result = call("export", data, *args, "--out", tmp_path / "out")
    assert result.exit_code == 2
    assert word in result.stderr
    assert len(result.stderr.splitlines()) == 1
    assert not (tmp_path / "out").exists()


def test_a_folder_that_holds_anything_is_left_alone(data: Path) -> None:
    result = call("export", data, "--to", "hf", "--out", data)
    assert result.exit_code == 2
    assert "nothing is overwritten" in result.stderr
    assert call("verify", data).exit_code == 0

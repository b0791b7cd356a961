"""Tests of closed, full or unread standard streams, and of file names that are not valid text."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim2reason.cli import main
from sim2reason.datasets.build import build
from sim2reason.datasets.plan import Config

COMMAND = f"'{sys.executable}' -m sim2reason"


def shell(line: str, folder: Path) -> "subprocess.CompletedProcess[bytes]":
    return subprocess.run(["bash", "-c", line], cwd=folder, capture_output=True, check=False)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder with a dataset called *data*."""
    config = Config(items=4, recipes=("pulley",), difficulties=("easy",), maker="fake_makers:steady")
    build(tmp_path / "data", config, workers=1)
    return tmp_path


ALL_CLOSED = ">&- 2>&- <&-"


@pytest.mark.parametrize(
    "closed", [*(pytest.param(some, marks=pytest.mark.slow) for some in (">&-", ">&- 2>&-")), ALL_CLOSED, "<&-"]
)
def test_closed_streams_are_as_if_nobody_read(folder: Path, closed: str) -> None:
    result = shell(f"{COMMAND} show data -n 2 {closed}", folder)
    assert (result.returncode, result.stderr) == (0, b"")
    assert result.stdout.count(b"Answer: ") == (2 if closed == "<&-" else 0)


def test_nothing_is_read_from_a_closed_input(folder: Path) -> None:
    result = shell(f"{COMMAND} grade data --responses - <&-", folder)
    assert result.returncode == 2
    assert result.stderr == b"sim2reason: standard input: holds no response; give a line {id, response} for each\n"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="only Linux has a device that is always full")
def test_standard_output_that_is_full_is_named(folder: Path) -> None:
    result = shell(f"{COMMAND} schema > /dev/full", folder)
    assert result.returncode == 2
    assert result.stderr.startswith(b"sim2reason: standard output: No space left on device; check")
    assert result.stderr.count(b"\n") == 1


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="only Linux has a device that is always full")
def test_a_file_that_is_full_is_named() -> None:
    result = CliRunner().invoke(main, ["schema", "-o", "/dev/full"])
    assert result.exit_code == 2
    assert result.stderr.startswith("sim2reason: /dev/full: No space left on device; check")
    assert result.stderr.count("\n") == 1


def named(folder: Path, name: bytes) -> Path:
    """Rename the dataset to a name that is not valid text."""
    try:
        return (folder / "data").rename(folder / os.fsdecode(name))
    except OSError:
        pytest.skip("the file system takes no such names")


@pytest.mark.skipif(sys.platform == "darwin", reason="its file system takes no such names")
@pytest.mark.parametrize(
    "command", ["verify", *(pytest.param(name, marks=pytest.mark.slow) for name in ("show", "stats"))]
)
def test_names_that_are_no_text(folder: Path, command: str) -> None:
    named(folder, b"\xff\xfe")
    result = shell(f"{COMMAND} {command} $'\\xff\\xfe'", folder)
    assert (result.returncode, result.stderr) == (0, b"")
    assert (b"\xff\xfe" in result.stdout) == (command != "show")


@pytest.mark.skipif(sys.platform == "darwin", reason="its file system takes no such names")
def test_what_is_built_and_written_under_names_that_are_no_text(folder: Path) -> None:
    data = named(folder, b"\xff\xfe")
    assert CliRunner().invoke(main, ["show", str(data)]).exit_code == 0
    config = Config(items=4, recipes=("pulley",), difficulties=("easy",), maker="fake_makers:steady", seed=1)
    assert build(folder / f"{data.name}2", config, workers=1).rows == 4
    out = folder / os.fsdecode(b"\xfd.json")
    assert CliRunner().invoke(main, ["schema", "-o", str(out)]).exit_code == 0
    assert out.stat().st_size > 1000


@pytest.mark.skipif(sys.platform == "darwin", reason="its file system takes no such names")
@pytest.mark.parametrize("to", [pytest.param("hf", marks=pytest.mark.slow), "lm-eval"])
def test_what_is_written_may_have_such_a_name(folder: Path, to: str) -> None:
    """Both Parquet files and JSON Lines can be written under such a name."""
    result = shell(f"{COMMAND} export data --to {to} --out $'e\\xff'", folder)
    assert (result.returncode, result.stderr) == (0, b"")
    assert b"e\xff/README.md" in result.stdout
    assert sorted(os.fsencode(path.name) for path in folder.iterdir()) == [b"data", b"e\xff"]


@pytest.mark.skipif(sys.platform == "darwin", reason="its file system takes no such names")
def test_a_trace_in_such_a_folder(folder: Path) -> None:
    place = folder / os.fsdecode(b"t\xff")
    place.mkdir()
    sample = CliRunner().invoke(main, ["sample", "--recipe", "pulley", "--difficulty", "easy"]).stdout
    result = CliRunner().invoke(main, ["simulate", "-", "-o", str(place / "t.parquet")], input=sample)
    assert (result.exit_code, result.stderr) == (0, "")
    assert [path.name for path in place.iterdir()] == ["t.parquet"]


@pytest.mark.skipif(sys.platform == "darwin", reason="its file system takes no such names")
def test_a_benchmark_of_such_a_name_is_refused_before_anything_is_made(tmp_path: Path) -> None:
    benchmark, new = tmp_path / os.fsdecode(b"b\xff.txt"), tmp_path / "new"
    benchmark.write_text("A block slides.")
    order = ["--items", "1", "--recipe", "rocket", "--decontaminate", str(benchmark)]
    result = CliRunner().invoke(main, ["generate", str(new), *order])
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert "a manifest can't say this name" in result.stderr
    assert not new.exists()


def test_a_dash_is_standard_output(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert CliRunner().invoke(main, ["schema", "-o", "-"]).stdout == CliRunner().invoke(main, ["schema"]).stdout
    assert not list(tmp_path.iterdir())

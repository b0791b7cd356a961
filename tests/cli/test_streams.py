"""Standard streams that are closed, full or without a reader, and names that are no text."""

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
    """With a dataset, called *data*."""
    config = Config(items=4, recipes=("pulley",), difficulties=("easy",), maker="fake_makers:steady")
    build(tmp_path / "data", config, workers=1)
    return tmp_path


@pytest.mark.parametrize("closed", [">&-", ">&- 2>&-", ">&- 2>&- <&-", "<&-"])
def test_closed_streams_are_as_if_nobody_read(folder: Path, closed: str) -> None:
    result = shell(f"{COMMAND} show data -n 2 {closed}", folder)
    assert (result.returncode, result.stderr) == (0, b"")
    assert result.stdout.count(b"Answer: ") == (2 if closed == "<&-" else 0)


def test_nothing_is_read_from_a_closed_input(folder: Path) -> None:
    result = shell(f"{COMMAND} grade data --responses - <&-", folder)
    assert result.returncode == 2
    assert result.stderr == b"sim2reason: standard input: holds no response; give a line {id, response} for each\n"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="only Linux has a device that is always full")
@pytest.mark.parametrize(("option", "name"), [("> /dev/full", b"standard output"), ("-o /dev/full", b"/dev/full")])
def test_what_is_full_is_named(folder: Path, option: str, name: bytes) -> None:
    result = shell(f"{COMMAND} schema {option}", folder)
    assert result.returncode == 2
    assert result.stderr.startswith(b"sim2reason: " + name + b": No space left on device; check")
    assert result.stderr.count(b"\n") == 1


@pytest.mark.skipif(sys.platform == "darwin", reason="its file system takes no such names")
def test_names_that_are_no_text(folder: Path) -> None:
    name = os.fsdecode(b"\xff\xfe")
    try:
        (folder / "data").rename(folder / name)
    except OSError:
        pytest.skip("the file system takes no such names")
    for command in ("verify", "show", "stats"):
        result = shell(f"{COMMAND} {command} $'\\xff\\xfe'", folder)
        assert (result.returncode, result.stderr) == (0, b"")
        assert (b"\xff\xfe" in result.stdout) == (command != "show")
    config = Config(items=4, recipes=("pulley",), difficulties=("easy",), maker="fake_makers:steady", seed=1)
    assert build(folder / f"{name}2", config, workers=1).rows == 4
    result = shell(f"{COMMAND} schema -o $'\\xfd.json'", folder)
    assert (result.returncode, (folder / os.fsdecode(b"\xfd.json")).stat().st_size > 1000) == (0, True)


@pytest.mark.skipif(sys.platform == "darwin", reason="its file system takes no such names")
@pytest.mark.parametrize("to", ["hf", "lm-eval"])
def test_what_is_written_may_have_such_a_name(folder: Path, to: str) -> None:
    """Parquet and lines."""
    result = shell(f"{COMMAND} export data --to {to} --out $'e\\xff'", folder)
    assert (result.returncode, result.stderr) == (0, b"")
    assert b"e\xff/README.md" in result.stdout
    assert sorted(os.fsencode(path.name) for path in folder.iterdir()) == [b"data", b"e\xff"]


@pytest.mark.skipif(sys.platform == "darwin", reason="its file system takes no such names")
def test_a_trace_in_such_a_folder(folder: Path) -> None:
    place = folder / os.fsdecode(b"t\xff")
    place.mkdir()
    sample = f"{COMMAND} sample --recipe pulley --difficulty easy"
    result = shell(f"{sample} | {COMMAND} simulate - -o $'t\\xff/t.parquet'", folder)
    assert (result.returncode, result.stderr) == (0, b"")
    assert [path.name for path in place.iterdir()] == ["t.parquet"]


@pytest.mark.skipif(sys.platform == "darwin", reason="its file system takes no such names")
def test_a_benchmark_of_such_a_name_is_refused_before_anything_is_made(folder: Path) -> None:
    (folder / os.fsdecode(b"b\xff.txt")).write_text("A block slides.")
    result = shell(f"{COMMAND} generate new --items 1 --recipe rocket --decontaminate $'b\\xff.txt'", folder)
    assert result.returncode == 2
    assert result.stderr.count(b"\n") == 1
    assert b"a manifest can't say this name" in result.stderr
    assert not (folder / "new").exists()


def test_a_dash_is_standard_output(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert CliRunner().invoke(main, ["schema", "-o", "-"]).stdout == CliRunner().invoke(main, ["schema"]).stdout
    assert not list(tmp_path.iterdir())

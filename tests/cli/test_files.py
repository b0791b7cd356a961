"""Tests that commands write files whole or not at all, and overwrite no other file."""

import os
from pathlib import Path
from threading import Thread

import click
import pytest

from sim2reason.cli import files


def write(out: Path, text: str = "new") -> None:
    with files.written(out) as path:
        assert path.suffix == out.suffix
        path.write_text(text)


def test_a_file_is_written_and_nothing_else_stays(tmp_path: Path) -> None:
    write(tmp_path / "a.svg")
    write(tmp_path / "a.svg", "newer")
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {"a.svg": "newer"}


def test_what_fails_leaves_the_old_file(tmp_path: Path) -> None:
    out = tmp_path / "a.svg"
    out.write_text("old")
    with pytest.raises(KeyError), files.written(out) as path:
        {"half": path.write_text("half")}["whole"]
    assert [path.name for path in tmp_path.iterdir()] == ["a.svg"]
    assert out.read_text() == "old"


def test_files_beside_it_and_what_links_lead_to_are_left_alone(tmp_path: Path) -> None:
    """Names that the command might use for temporary files may exist already, also as symbolic links."""
    out, far = tmp_path / "x.parquet", tmp_path / "far"
    far.write_text("far")
    others = {f"x.parquet{end}": "mine" for end in (".part", ".tmp")} | {f".sim2reason-{os.getpid()}-0.parquet": "far"}
    for name, text in others.items():
        if text == "far":
            (tmp_path / name).symlink_to(far)
        else:
            (tmp_path / name).write_text(text)
    out.symlink_to(far)
    write(out)
    assert not out.is_symlink()
    assert out.read_text() == "new"
    assert far.read_text() == "far"
    assert {name: (tmp_path / name).read_text() for name in others} == others


def test_a_file_has_the_rights_that_any_new_file_has(tmp_path: Path) -> None:
    (tmp_path / "plain").touch()
    write(tmp_path / "a.svg")
    assert (tmp_path / "a.svg").stat().st_mode == (tmp_path / "plain").stat().st_mode


def test_what_is_no_file_is_written_to(tmp_path: Path) -> None:
    pipe, heard = tmp_path / "pipe", list[str]()
    os.mkfifo(pipe)
    reader = Thread(target=lambda: heard.append(pipe.read_text()))
    reader.start()
    write(pipe)
    reader.join()
    assert heard == ["new"]
    assert pipe.is_fifo()
    write(Path(os.devnull))
    assert not Path(os.devnull).is_file()


def test_an_error_names_the_file(tmp_path: Path) -> None:
    with pytest.raises(OSError, match=r"no/such\.svg"):
        write(tmp_path / "no" / "such.svg")
    with pytest.raises(OSError, match=r"full\.svg"), files.written(tmp_path / "full.svg"):
        raise OSError(28, "No space left on device")


def test_a_dash_takes_only_text(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(click.UsageError, match="no text"):
        write(Path("-"))
    files.tell("one\n", Path("-"))
    files.tell("two\n", None)
    assert capsys.readouterr().out == "one\ntwo\n"
    assert not list(tmp_path.iterdir())

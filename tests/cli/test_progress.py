"""Tests of the progress that long commands report, with or without a terminal, and of --verbose."""

import re
import time
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from sim2reason.cli import console, main

USUAL = "--items", "30", "--recipe", "incline,pulley", "--difficulty", "easy", "--workers", "1"


def generated(out: Path, *options: str) -> str:
    """Run `generate` and return what it writes to standard error."""
    command = ["generate", str(out), *USUAL, "--maker", "fake_makers:slow", *options]
    result = CliRunner().invoke(main, command)
    assert result.exit_code == 0, result.stderr
    return result.stderr


def test_lines_come_now_and_then_where_there_is_no_terminal(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(console, "SELDOM", 0.05)
    told = re.findall(r"^problems: (\d+) of 30, \d+ s$", generated(tmp_path / "out"), re.MULTILINE)
    assert len(told) >= 2
    assert int(told[0]) < int(told[-1]) <= 30


def test_a_short_command_says_nothing_of_it(tmp_path: Path) -> None:
    assert "problems: " not in generated(tmp_path / "out")
    assert console.SELDOM <= 30.0


def test_a_line_comes_though_no_step_ends(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(console, "SELDOM", 0.02)
    with console.progress("answers", 5) as advance:
        advance(2)
        time.sleep(0.3)
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) >= 2
    assert set(lines) == {"answers: 2 of 5, 0 s"}


def test_verbose_tells_of_each_problem_how_long_it_took(tmp_path: Path) -> None:
    told = generated(tmp_path / "out", "--verbose")
    lines = re.findall(r"^position (\d+): (\S.*) \(\d+\.\d s, \d+ draws refused\)$", told, re.MULTILINE)
    assert [int(number) for number, _ in lines][:30] == list(range(30))
    assert dict(lines)["6"] == "no problem: no draw passed"
    assert dict(lines)["1"] == "pulley-easy-numeric-0-0"


def test_all_long_commands_have_it() -> None:
    def found(group: click.Command, *names: str) -> click.Command:
        for name in names:
            assert isinstance(group, click.Group)
            group = group.commands[name] if names[0] != name else main.get_command(click.Context(main), name)
        return group

    long = [("generate",), ("export",), ("sample-solutions",), ("eval", "run"), ("eval", "solvable")]
    long += [("train", name) for name in ("sft", "rl", "study")]
    for names in long:
        assert any("--verbose" in param.opts for param in found(main, *names).params), names

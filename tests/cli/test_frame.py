"""Tests of behaviour common to all commands: help with an example, exit codes, one-line errors, quiet pipes."""

import ast
import subprocess
import sys
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from sim2reason import cli
from sim2reason.cli import Commands, main
from sim2reason.errors import SceneError

COMMANDS = main.list_commands(click.Context(main)) if isinstance(main, Commands) else []
CODE = "from sim2reason.cli import main; main()"


def run(*args: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run([sys.executable, "-c", CODE, *args], capture_output=True, text=True, check=False)


def test_every_command_is_in_the_table_with_its_module() -> None:
    defined = dict[str, str]()
    for path in Path(cli.__file__).parent.glob("[a-z]*.py"):
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            for decorator in node.decorator_list if isinstance(node, ast.FunctionDef) else ():
                if isinstance(decorator, ast.Call) and ast.unparse(decorator.func) in ("click.command", "click.group"):
                    name = ast.literal_eval(decorator.args[0])
                    defined[name] = f"sim2reason.cli.{path.stem}"
    assert {"generate", "list", "show", "verify"} <= defined.keys()
    assert {name: module for name, (module, _) in cli.COMMANDS.items()} == defined


@pytest.mark.parametrize("name", COMMANDS)
def test_help_shows_an_example(name: str) -> None:
    result = CliRunner().invoke(main, [name, "--help"])
    assert result.exit_code == 0
    assert "Example:" in result.stdout
    assert f"sim2reason {name}" in result.stdout.partition("Example:")[2]


@pytest.mark.parametrize("name", COMMANDS)
def test_lines_of_an_example_stay_lines(name: str) -> None:
    """Click joins lines to paragraphs, except after its mark against rewrapping."""
    shown = CliRunner().invoke(main, [name, "--help"]).stdout.splitlines()
    command = main.get_command(click.Context(main), name)
    assert command is not None
    lines = [line for line in (command.epilog or "").splitlines() if line.startswith("    ")]
    assert lines
    assert not [line for line in lines if f"  {line}" not in shown]


@pytest.mark.parametrize("name", COMMANDS)
def test_an_unknown_option_is_one_line_and_exit_code_two(name: str) -> None:
    result = CliRunner().invoke(main, [name, "--no-such-option"])
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert f"See: main {name} --help" in result.stderr


def test_help_lists_all_commands_and_loads_nothing_heavy() -> None:
    code = (
        "import sys\nfrom sim2reason.cli import main\n"
        "try: main(['--help'])\n"
        "except SystemExit as end: assert end.code == 0\n"
        "heavy = {'numpy', 'mujoco', 'pyarrow', 'pydantic', 'yaml', 'rich.progress', 'matplotlib', 'torch'}\n"
        "assert not heavy & sys.modules.keys(), heavy & sys.modules.keys()"
    )
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    assert all(name in result.stdout for name in COMMANDS)


@pytest.mark.parametrize("name", ["fly", "../errors", "console", "", ".", "Show", "SHOW", "list.py"])
def test_what_is_no_command_is_one_line(name: str) -> None:
    result = CliRunner().invoke(main, [name])
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1


def test_a_path_is_no_command(tmp_path: Path) -> None:
    """Even a path to a file that looks like a command is refused, and the file is not run."""
    for path in (tmp_path / "show.py", tmp_path / "scene.yaml"):
        path.write_text("def command(): ...\nraise SystemExit(7)\n")
        for name in (path, path.with_suffix("")):
            result = CliRunner().invoke(main, [str(name)])
            assert (result.exit_code, result.stderr.count("\n")) == (2, 1)


def test_without_a_command_the_help_is_shown() -> None:
    result = CliRunner().invoke(main, [])
    assert result.exit_code == 2
    assert [line.strip() for line in result.stderr.splitlines()] == [
        line.strip() for line in CliRunner().invoke(main, ["--help"]).stdout.splitlines()
    ]


def test_the_version_is_that_of_the_package() -> None:
    from importlib.metadata import version

    assert version("sim2reason") in run("--version").stdout


@pytest.fixture
def broken(monkeypatch: pytest.MonkeyPatch) -> "list[BaseException]":
    """Replace every command by one that raises the exception in the returned list."""
    errors: list[BaseException] = []

    @click.command()
    def command() -> None:
        raise errors[0]

    monkeypatch.setattr(Commands, "get_command", lambda *_: command)
    return errors


@pytest.mark.parametrize(
    ("error", "code", "line"),
    [
        (SceneError("scene.entities[0]", "no type", "say one"), 2, "sim2reason: scene.entities[0]: no type; say one\n"),
        (FileNotFoundError(2, "No such file or directory", "x.yaml"), 2, "sim2reason: x.yaml: No such file"),
        (OSError(28, "No space left on device"), 2, "sim2reason: standard output: No space left on device; check"),
        (OSError(28, "No space left on device", "x.yaml"), 2, "sim2reason: x.yaml: No space left on device; check"),
        (click.ClickException("bad"), 2, "sim2reason: bad\n"),
        (KeyboardInterrupt(), 130, "sim2reason: interrupted\n"),
    ],
)
def test_errors_are_one_line(broken: "list[BaseException]", error: BaseException, code: int, line: str) -> None:
    broken.append(error)
    result = CliRunner().invoke(main, ["anything"])
    assert result.exit_code == code
    assert result.stderr.lstrip("\n").startswith(line)
    assert result.stderr.strip().count("\n") == 0


def test_a_defect_keeps_its_traceback(broken: "list[BaseException]") -> None:
    broken.append(ZeroDivisionError("a defect"))
    assert isinstance(CliRunner().invoke(main, ["anything"]).exception, ZeroDivisionError)


def test_a_reader_that_goes_away_ends_it_quietly(tmp_path: Path) -> None:
    big = tmp_path / "cmd.py"
    big.write_text(
        "import click\nfrom sim2reason.cli import Commands, main\n"
        "@click.command()\ndef command():\n    for k in range(100_000): click.echo(f'line {k} of many')\n"
        "Commands.get_command = lambda *_: command\nmain(['anything'])\n"
    )
    line = f"'{sys.executable}' '{big}' | head -1; exit ${{PIPESTATUS[0]}}"
    result = subprocess.run(["bash", "-c", line], capture_output=True, text=True, check=False)
    assert (result.stdout, result.stderr, result.returncode) == ("line 0 of many\n", "", 141)

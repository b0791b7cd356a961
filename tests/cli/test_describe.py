"""Tests of `describe` on files of scenes; any error is one line with exit code 2."""

import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from scene_files import drawn
from sim2reason.cli import main
from sim2reason.scenes.files import dump, load
from sim2reason.text.prose.description import describe as describe_scene
from sim2reason.text.prose.voices import symbolic, symbolic_at

RAMP = """\
scene:
  entities:
  - name: ramp
    type: TwoSideMassPlane
    parameters:
      plane: {angle: 30.0, friction: 0.0}
      blocks: [{mass: 2.0}]
"""


@pytest.fixture
def ramp(tmp_path: Path) -> Path:
    path = tmp_path / "ramp.yaml"
    path.write_text(RAMP)
    return path


def described(*args: object, stdin: str | bytes | None = None) -> Result:
    return CliRunner().invoke(main, ["describe", *map(str, args)], input=stdin)


def test_it_prints_the_text(ramp: Path) -> None:
    scene = load(RAMP)
    assert described(ramp).stdout == f"{describe_scene(scene).text}\n"
    assert described(ramp, "--seed", 3).stdout == f"{describe_scene(scene, 3).text}\n"
    assert described(ramp, "--voice", "symbolic").stdout == f"{describe_scene(scene, 0, symbolic).text}\n"


def test_a_number_can_be_hidden(ramp: Path) -> None:
    result = described(ramp, "--hide", "ramp.blocks.0.mass")
    assert result.stdout == f"{describe_scene(load(RAMP), 0, symbolic_at('ramp.blocks.0.mass')).text}\n"
    assert "2.0 kg" not in result.stdout


def test_what_can_not_be_hidden_is_said_with_what_can(ramp: Path) -> None:
    result = described(ramp, "--hide", "ramp.mass")
    assert result.exit_code == 2
    assert "--hide ramp.mass: no such number is told; there are: ramp.plane.angle," in result.stderr


def test_a_dash_reads_standard_input() -> None:
    for scene in drawn(6, seed=9):
        result = described("-", stdin=dump(scene))
        assert (result.exit_code, result.stdout) == (0, f"{describe_scene(scene).text}\n")


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("mass: 2.0", "mass: -2", "scene.entities[0].parameters.blocks[0].mass (line 7): -2 is less than"),
        ("angle", "&a angle", "scene.entities[0].parameters.plane (line 6): a key is not a plain word"),
        ("TwoSideMassPlane", "Plain", "scene.entities[0].type (line 4): there is no type"),
    ],
)
def test_a_wrong_file_is_one_line_with_its_name(ramp: Path, old: str, new: str, said: str) -> None:
    ramp.write_text(RAMP.replace(old, new))
    result = described(ramp)
    assert result.exit_code == 2
    assert said in result.stderr
    assert result.stderr.startswith(f"sim2reason: {ramp}: ")
    assert result.stderr.count("\n") == 1


def test_junk_on_standard_input_is_one_line() -> None:
    for junk in (b"\xff\xfe\x00", b"\x00" * 100, b"", b"[" * 70_000):
        result = described("-", stdin=junk)
        assert result.exit_code == 2
        assert result.stderr.startswith("sim2reason: standard input: ")
        assert result.stderr.count("\n") == 1


def test_missing_files_and_folders_are_one_line(tmp_path: Path) -> None:
    assert described(tmp_path / "none.yaml").exit_code == 2
    assert described(tmp_path).exit_code == 2


def test_a_pipe_of_real_processes(ramp: Path) -> None:
    code = "from sim2reason.cli import main; main()"
    command = [sys.executable, "-c", code, "describe", "-"]
    with ramp.open() as file:
        result = subprocess.run(command, stdin=file, capture_output=True, text=True, check=True)
    assert "2.0 kg" in result.stdout


def test_the_schema_is_written(tmp_path: Path) -> None:
    import json

    from sim2reason.scenes.files.page import format_page
    from sim2reason.scenes.files.schema import schema

    printed = CliRunner().invoke(main, ["schema"]).stdout
    assert json.loads(printed) == schema()
    assert CliRunner().invoke(main, ["schema", "-o", str(tmp_path / "s.json")]).exit_code == 0
    assert (tmp_path / "s.json").read_text() == printed
    assert CliRunner().invoke(main, ["schema", "--page"]).stdout == format_page()

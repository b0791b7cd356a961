"""Tests of `simulate`, which runs foreign scenes in a process that can be killed, and summarises their motion."""

import json
import os
import time
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from sim2reason.cli import main
from sim2reason.cli.simulation import run_in_sandbox
from sim2reason.errors import SceneError, SimulationError
from sim2reason.scenes.files import load
from sim2reason.simulation import trace_files
from sim2reason.simulation.scenes import simulate

ATWOOD = """\
scene:
  entities:
  - name: a
    type: MassWithFixedPulley
    parameters: {system: {kind: hanging, blocks: [{mass: 1.0}]}, pulley: {}}
  - name: b
    type: MassWithFixedPulley
    parameters: {system: {kind: hanging, blocks: [{mass: 3.0}]}, pulley: {}}
  connections:
  - tendon: [{entity: a, direction: tail}, {entity: b, direction: tail}]
"""
UNHELD = """\
scene:
  entities:
  - {name: q, type: MassWithReverseMovablePulley, parameters: {pulley: {}}}
  - {name: h, type: FixedSupport}
  - {name: k, type: FixedSupport}
  connections:
  - tendon: [{entity: h, direction: end}, {entity: q, direction: left}]
  - tendon: [{entity: q, direction: right}, {entity: k, direction: end}]
"""
LIFTED = """\
scene:
  entities:
  - name: w
    type: MassWithFixedPulley
    parameters:
      system: {kind: on_wedge, wedge: {mass: 1.0, angle: 60.0}, blocks: [{mass: 0.01}]}
      pulley: {}
  - {name: hand, type: ConstantForcePuller, parameters: {force: 1000.0}}
  connections:
  - tendon: [{entity: w, direction: tail}, {entity: hand, direction: end}]
"""


@pytest.fixture
def atwood(tmp_path: Path) -> Path:
    path = tmp_path / "atwood.yaml"
    path.write_text(ATWOOD)
    return path


def run(*args: object, stdin: str | None = None) -> Result:
    return CliRunner().invoke(main, ["simulate", *map(str, args)], input=stdin)


def document(*args: object) -> dict[str, object]:
    result = run(*args, "--json")
    assert result.exit_code == 0, result.stderr
    return json.loads(result.stdout)


def test_it_gives_final_values_and_events(atwood: Path) -> None:
    found = document(atwood, "--duration", 0.5)
    values = {(row["subject"], row["quantity"]): row["value"] for row in found["final"]}  # type: ignore[index]
    assert found["stable_until"] == 0.5
    assert found["cut"] == ""
    assert values["b.system.blocks.0", "acceleration"][2] == pytest.approx(-4.9, rel=1e-12)
    assert values["b.system.blocks.0", "velocity"][2] == pytest.approx(-2.45, rel=1e-12)
    assert values["tendon_1", "tension"] == pytest.approx(14.7, rel=1e-12)


def test_people_get_a_table(atwood: Path) -> None:
    result = run(atwood, "--duration", 2)
    assert result.exit_code == 0
    assert ["tendon_1", "tension", "14.7", "N"] in [line.split() for line in result.stdout.splitlines()]
    assert "1.10657 s: reach of a.system.hook, a.pulley.left" in result.stdout
    assert "The motion is followed until 1.10657 s, not 2 s: two points of a string meet" in result.stdout


def test_both_engines_give_a_certificate(atwood: Path) -> None:
    found = document(atwood, "--engine", "both", "--duration", 0.5)
    certificate = found["certificate"]
    assert certificate["engines"] == ["exact", "mujoco"]  # type: ignore[index]
    assert max(row[2] for row in certificate["channels"]) < 1e-4  # type: ignore[index]
    assert (
        "exact and mujoco agree until 0.5 s; they differ by at most"
        in run(atwood, "--engine", "both", "--duration", 0.5).stdout
    )


def test_the_trace_is_written_whole_or_not_at_all(atwood: Path, tmp_path: Path) -> None:
    out = tmp_path / "trace.parquet"
    assert run(atwood, "--duration", 0.5, "--samples", 11, "-o", out).exit_code == 0
    assert len(trace_files.read_trace(out).times) == 11
    out.unlink()
    assert run(atwood, "--patience", 0.01, "-o", out).exit_code == 2
    assert [path.name for path in tmp_path.iterdir()] == ["atwood.yaml"]
    assert run(atwood, "-o", tmp_path / "no" / "trace.parquet").exit_code == 2


def test_a_dash_reads_standard_input(atwood: Path) -> None:
    assert run("-", stdin=ATWOOD).stdout == run(atwood).stdout


def test_what_takes_too_long_is_killed(atwood: Path) -> None:
    begun = time.perf_counter()
    result = run(atwood, "--patience", 0.01)
    assert result.exit_code == 2
    assert result.stderr == "sim2reason: the simulation takes longer than 0.01 s; simulate a shorter time\n"
    assert time.perf_counter() - begun < 5.0


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (UNHELD, "q.carrier.slide: there is no motion to follow: nothing holds a massless part at the start; give it"),
        (LIFTED, "there is no motion to follow: a body leaves its face at the start; pull on it with less force"),
        (ATWOOD.replace("3.0", "NaN"), 'blocks[0].mass (line 8): "NaN" is not a number; give a number in kg'),
        (ATWOOD.partition("  connections")[0], "scene.entities[0] (line 3): its port 'tail' is open; connect it"),
    ],
)
def test_what_can_not_be_simulated_is_one_line(text: str, said: str) -> None:
    result = run("-", stdin=text)
    assert result.exit_code == 2
    assert said in result.stderr
    assert result.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--engine", "newton"), "no such name among engines: 'newton'"),
        (("--duration", "0"), "--duration"),
        (("--duration", "nan"), "--duration"),
        (("--samples", "1"), "--samples"),
    ],
)
def test_wrong_options_are_one_line(atwood: Path, options: tuple[str, str], said: str) -> None:
    result = run(atwood, *options)
    assert result.exit_code == 2
    assert said in result.stderr
    assert result.stderr.count("\n") == 1


# ---- the worker


@pytest.mark.parametrize("patience", ["nan", "inf", "1e300"])
def test_patience_ends(atwood: Path, patience: str) -> None:
    """The hidden option --patience, for tests, refuses values that no timer accepts."""
    result = run(atwood, "--patience", patience)
    assert (result.exit_code, result.stderr.count("\n")) == (2, 1)
    assert "'--patience'" in result.stderr


def test_results_and_errors_come_back_from_the_worker() -> None:
    assert run_in_sandbox(20.0, json.loads, "[1]") == [1]
    with pytest.raises(SceneError, match="the file: it is empty"):
        run_in_sandbox(20.0, load, "")


def test_a_crash_is_an_error() -> None:
    with pytest.raises(SimulationError, match=r"crashed its process \(exit code -6\)"):
        run_in_sandbox(20.0, os.abort)


def test_the_library_gives_what_the_command_gives(atwood: Path) -> None:
    trace = simulate(load(ATWOOD))
    assert document(atwood)["stable_until"] == trace.stable_until


@pytest.mark.parametrize("out", ["missing/trace.parquet", "."])
def test_what_can_not_be_written_is_one_line(atwood: Path, tmp_path: Path, out: str) -> None:
    result = run(atwood, "-o", tmp_path / out)
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert str(tmp_path) in result.stderr


@pytest.mark.parametrize("name", ["trace.csv", "trace", "parquet"])
def test_another_format_is_refused_by_name(atwood: Path, tmp_path: Path, name: str) -> None:
    result = run(atwood, "-o", tmp_path / name)
    wanted = f"sim2reason: {tmp_path / name}: a trace is written as Parquet; end the name in .parquet\n"
    assert (result.exit_code, result.stderr) == (2, wanted)
    assert not list(tmp_path.glob("*trace*"))


def test_a_worker_hands_on_what_the_system_refuses(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        run_in_sandbox(20.0, os.listdir, tmp_path / "missing")

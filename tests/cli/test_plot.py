from pathlib import Path

import pytest
from click.testing import CliRunner

from sim2reason.cli import main
from sim2reason.generation.item_search import sample
from sim2reason.scenes.files import dump


def plotted(tmp_path: Path, out: Path, *options: object) -> str:
    scene = tmp_path / "scene.yaml"
    scene.write_text(dump(sample("collision", "medium", seed=3)), encoding="utf-8")
    result = CliRunner().invoke(main, ["plot", str(scene), "-o", str(out), *map(str, options)])
    assert result.exit_code == 0, result.stderr
    return out.read_text(encoding="utf-8") if out.suffix == ".svg" else ""


def test_panels_are_named(tmp_path: Path) -> None:
    text = plotted(tmp_path, tmp_path / "traces.svg")
    for word in ("x (m)", "y (m)", "speed", "(m/s)", "energy", "distance", "time (s)"):
        assert word in text


@pytest.mark.parametrize("engine", ["exact", "mujoco", "both"])
def test_engines_can_be_chosen(tmp_path: Path, engine: str) -> None:
    plotted(tmp_path, tmp_path / "traces.png", "--engine", engine, "--duration", 1)
    assert (tmp_path / "traces.png").stat().st_size > 1000


@pytest.mark.parametrize("duration", ["nan", "inf", "0", "-1", "soon"])
def test_a_duration_is_a_finite_stretch(tmp_path: Path, duration: str) -> None:
    scene = tmp_path / "scene.yaml"
    scene.write_text(dump(sample("incline", "easy")), encoding="utf-8")
    result = CliRunner().invoke(main, ["plot", str(scene), "-o", str(tmp_path / "t.png"), "--duration", duration])
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert "--duration" in result.stderr


def test_an_unknown_engine_is_an_error_of_one_line(tmp_path: Path) -> None:
    scene = tmp_path / "scene.yaml"
    scene.write_text(dump(sample("incline", "easy")), encoding="utf-8")
    result = CliRunner().invoke(main, ["plot", str(scene), "-o", str(tmp_path / "t.png"), "--engine", "guess"])
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1

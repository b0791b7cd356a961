import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim2reason.cli import main
from sim2reason.datasets.items import item
from sim2reason.generation.item_search import sample
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.bodies.oscillators import Ball, LightRod
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum
from sim2reason.scenes.files import dump
from sim2reason.text.prose.description import describe


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    path = tmp_path / "scene.yaml"
    path.write_text(dump(sample("pulley", "medium", seed=7)), encoding="utf-8")
    return path


def run(*args: object, text: str | None = None) -> tuple[int, str]:
    result = CliRunner().invoke(main, [str(arg) for arg in args], input=text)
    return result.exit_code, result.stderr


@pytest.mark.parametrize("ending", ["svg", "png", "pdf"])
def test_a_figure_is_drawn(scene: Path, tmp_path: Path, ending: str) -> None:
    out = tmp_path / f"scene.{ending}"
    assert run("figure", scene, "-o", out) == (0, "")
    assert out.stat().st_size > 1000


def test_names_follow_the_text_and_masses_are_written_on_demand(scene: Path, tmp_path: Path) -> None:
    out = tmp_path / "scene.svg"
    loaded = sample("pulley", "medium", seed=7)
    masses = [p.measure.say(p.value) for p in loaded.parameters if p.path.endswith("mass") and p.value]
    assert run("figure", scene, "-o", out)[0] == 0
    plain = out.read_text(encoding="utf-8")
    assert run("figure", scene, "-o", out, "--numbers", "--seed", 1)[0] == 0
    numbered = out.read_text(encoding="utf-8")
    for letter in describe(loaded).names.letters.values():
        assert f">{letter}</text>" in plain
    for mass in masses:
        assert mass not in plain
        assert mass in numbered


def test_standard_input_is_read(scene: Path, tmp_path: Path) -> None:
    out = tmp_path / "scene.svg"
    assert run("figure", "-", "-o", out, text=scene.read_text(encoding="utf-8")) == (0, "")
    assert out.exists()


def test_what_is_wrong_is_said_in_a_line(scene: Path, tmp_path: Path) -> None:
    code, said = run("figure", scene, "-o", tmp_path / "scene.gif")
    assert (code, said.count("\n")) == (2, 1)
    assert "end the name in .svg, .png or .pdf" in said
    code, said = run("figure", tmp_path / "none.yaml", "-o", tmp_path / "scene.svg")
    assert (code, said.count("\n")) == (2, 1)
    assert "none.yaml" in said


def test_a_missing_extra_is_said_with_the_remedy(scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "matplotlib", None)
    for name in ("figure", "plot"):
        code, said = run(name, scene, "-o", tmp_path / "scene.svg")
        assert code == 2
        assert said == (
            "sim2reason: matplotlib is not installed; "
            "install it with: pip install 'matplotlib>=3.9', or in a clone: pip install '.[figures]'\n"
        )


def test_a_body_without_a_look_is_warned_of(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Ball, "look", None)
    path, out = tmp_path / "scene.yaml", tmp_path / "scene.svg"
    pendulum = Pendulum(bob=Ball(mass=1.0), hanger=LightRod(length=1.0), angle=30.0)
    path.write_text(dump(Scene(entities=(Named(name="it", entity=pendulum),))), encoding="utf-8")
    code, said = run("figure", path, "-o", out)
    assert (code, said.count("\n")) == (0, 1)
    assert "warning: no figure shows a body of the type Ball, here it.bob; give its class a look" in said
    assert ">ball</text>" in out.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("recipe", "difficulty", "mode", "index"),
    [
        pytest.param("collision", "hard", "reverse", 0, marks=pytest.mark.slow),
        ("collision", "easy", "numeric", 0),
        pytest.param("hybrid", "hard", "reverse", 0, marks=pytest.mark.slow),
        ("pulley", "easy", "reverse", 1),
        ("incline", "easy", "symbolic", 0),
    ],
)
def test_the_figure_of_an_items_scene_is_that_of_the_item(
    tmp_path: Path, recipe: str, difficulty: Difficulty, mode: str, index: int
) -> None:
    """The figure names bodies as the text does, and does not show the unknown."""
    made = item(recipe, difficulty, mode, seed=31, index=index)
    file, alone, beside = tmp_path / "scene.yaml", tmp_path / "alone.svg", tmp_path / "beside.svg"
    file.write_text(made.scene, encoding="utf-8")
    assert run("figure", file, "-o", alone) == (0, "")
    where = ("--recipe", recipe, "--difficulty", difficulty, "--mode", mode, "--seed", 31, "--index", index)
    assert run("item", *where, "--figure", beside)[0] == 0
    labels = [
        set(re.findall(r"<!-- (.*?) -->|>([^<>\n]+)</text>", path.read_text(encoding="utf-8")))
        for path in (alone, beside)
    ]
    assert labels[0] == labels[1]
    assert labels[0]

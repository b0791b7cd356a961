"""Tests of one problem by its coordinates, of its scene, and of questions about a user's scene."""

import json
import re
from itertools import islice
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import sim2reason
from sim2reason.cli import main
from sim2reason.scenes.files import dump, read_wording


def call(*args: object) -> Result:
    return CliRunner().invoke(main, [str(arg) for arg in args])


def test_an_item_is_that_of_a_dataset_and_is_told_whole() -> None:
    problem = sim2reason.item("rocket", "easy", seed=3, index=1)
    told = call("item", "--recipe", "rocket", "--difficulty", "easy", "--seed", 3, "--index", 1)
    assert told.exit_code == 0, told.output
    assert (
        told.stdout.split()
        == f"{problem.id} {problem.prompt} Answer: {problem.answer.shown} Needs: {problem.needs}".split()
    )
    assert json.loads(
        call("item", "--recipe", "rocket", "--difficulty", "easy", "--seed", 3, "--index", 1, "--json").stdout
    ) == problem.model_dump(mode="json")


@pytest.mark.parametrize(("mode", "recipe"), [("numeric", "incline"), ("reverse", "projectile")])
def test_a_sample_is_the_scene_of_the_item_of_the_same_coordinates(mode: str, recipe: str, tmp_path: Path) -> None:
    """The item's file has the wording of its text in addition, which a scene alone lacks."""
    problem = sim2reason.item(recipe, "easy", mode, seed=2, index=5)
    scene = sim2reason.sample(recipe, "easy", mode, seed=2, index=5)
    assert dump(scene, read_wording(problem.scene)) == problem.scene
    where = "--recipe", recipe, "--difficulty", "easy", "--mode", mode, "--seed", 2, "--index", 5
    assert call("sample", *where).stdout == dump(scene)
    assert call("sample", *where, "-o", tmp_path / "scene.yaml").exit_code == 0
    assert (tmp_path / "scene.yaml").read_text(encoding="utf-8") == dump(scene)


def test_what_else_is_told(tmp_path: Path) -> None:
    figure = tmp_path / "scene.svg"
    told = call(
        "item",
        "--recipe",
        "incline",
        "--difficulty",
        "easy",
        "--units",
        "cgs",
        "--scene",
        "--solutions",
        "--figure",
        figure,
    )
    assert told.exit_code == 0, told.output
    assert told.stdout.startswith("incline-easy-numeric-0-0-cgs\n")
    assert "    scene:\n" in told.stdout
    assert r"\boxed{" in told.stdout.partition("Answer:")[2]
    assert figure.stat().st_size > 1000


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (("--recipe", "pully", "--difficulty", "easy"), "did you mean: pulley"),
        (("--recipe", "all", "--difficulty", "easy"), "no such name among recipes: 'all'"),
        (("--recipe", "pulley", "--difficulty", "brutal"), "easy, medium, hard"),
        (
            ("--recipe", "pulley", "--difficulty", "easy", "--mode", "all"),
            "there are: choice, multipart, numeric, reverse, symbolic",
        ),
        (("--recipe", "pulley", "--difficulty", "easy", "--units", "cgsx"), "there are: SI, cgs, mixed"),
        (("--recipe", "pulley", "--difficulty", "easy", "--weights", "periods=2"), "there is no kind 'periods'"),
        (("--recipe", "pulley", "--difficulty", "easy", "--figure", "scene.gif"), ".svg, .png or .pdf"),
        (("--recipe", "pulley", "--difficulty", "easy", "--index", "-1"), "--index"),
    ],
)
def test_wrong_coordinates_are_one_line(args: tuple[str, ...], said: str) -> None:
    told = call("item", *args)
    assert told.exit_code == 2
    assert said in told.stderr
    assert told.stderr.count("\n") == 1


def test_a_stream_deals_modes_too() -> None:
    first, second, third = islice(sim2reason.stream("rocket", "easy", ("numeric", "reverse"), seed=3), 3)
    assert [first.mode, second.mode, third.mode] == ["numeric", "reverse", "numeric"]
    assert first == sim2reason.item("rocket", "easy", seed=3)


def test_questions_about_a_scene_are_items_too(tmp_path: Path) -> None:
    problem = sim2reason.item("incline", "easy", seed=2)
    (tmp_path / "scene.yaml").write_text(problem.scene, encoding="utf-8")
    asked = sim2reason.ask(sim2reason.load(tmp_path / "scene.yaml"), items=3, seed=4, mode="reverse")
    assert len({item.id for item in asked}) == 3
    assert {item.mode for item in asked} == {"reverse"}
    assert all(sim2reason.grade(item, rf"\boxed{{{item.answer.value!r}}}").reward == 1.0 for item in asked)
    options = "--items", 3, "--seed", 4, "--mode", "reverse"
    listed = json.loads(call("ask", tmp_path / "scene.yaml", *options, "--json").stdout)
    assert listed == [item.model_dump(mode="json") for item in asked]
    told = call("ask", tmp_path / "scene.yaml", *options).stdout
    assert all(f"Answer: {item.answer.shown}\n" in told for item in asked)
    assert all("".join(item.prompt.split()) in "".join(told.split()) for item in asked), "its scene hides the unknown"
    assert listed[0].keys() == problem.model_dump(mode="json").keys()


def test_ask_says_in_words_why_questions_were_refused(tmp_path: Path) -> None:
    """Every question about a 10 m pendulum on the Moon is refused, since no textbook has one that long."""
    pendulum = "{bob: {mass: 1.0}, hanger: {kind: cord, length: 10.0}, angle: 10.0}"
    entity = f"{{name: pendulum, type: Pendulum, parameters: {pendulum}}}"
    text = f"scene: {{name: moon, entities: [{entity}], world: {{gravity: 1.62}}}}"
    (tmp_path / "scene.yaml").write_text(text, encoding="utf-8")
    told = call("ask", tmp_path / "scene.yaml", "--items", 1)
    assert told.exit_code == 1
    assert "sim2reason: 0 of 1 questions; others were refused (--all asks those, too):\nnumber  reason" in told.stderr
    (meaning,) = (member.summary for member in sim2reason.list("filters")["filters"] if member.name == "magnitudes")
    assert re.search(rf"\d+  magnitudes +{re.escape(meaning)}\n", told.stderr)

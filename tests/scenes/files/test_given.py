"""Tests that public functions accept a scene as an object, a file, a text or an item about it."""

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest

import sim2reason
from sim2reason.generation.item import Item
from sim2reason.generation.make import make
from sim2reason.generation.request import Request

FUNCTIONS: dict[str, Callable[[object], object]] = {
    "simulate": lambda scene: sim2reason.simulate(scene).stable_until,  # type: ignore[arg-type]
    "certify": lambda scene: sim2reason.certify(scene)[0].stable_until,  # type: ignore[arg-type]
    "describe": lambda scene: str(sim2reason.describe(scene)),  # type: ignore[arg-type]
    "ask": lambda scene: [item.prompt for item in sim2reason.ask(scene, items=1)],  # type: ignore[arg-type]
    "figure": lambda scene: sim2reason.figure(scene, "figure.svg"),  # type: ignore[arg-type]
    "plot": lambda scene: sim2reason.plot(scene, "plot.svg"),  # type: ignore[arg-type]
}


@pytest.fixture(scope="module")
def item() -> Item:
    found = make(Request("pulley", "easy", "numeric", 0, 4)).item
    assert found is not None
    return found


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_scene_may_be_given_as_its_file_its_text_or_an_item(
    item: Item, name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("scene.yaml").write_text(item.scene, encoding="utf-8")
    wanted = FUNCTIONS[name](sim2reason.load(item.scene))
    for given in ("scene.yaml", Path("scene.yaml"), item.scene, item):
        assert FUNCTIONS[name](given) == wanted


@pytest.mark.parametrize("name", [*FUNCTIONS, "solve"])
@pytest.mark.parametrize("given", [5, ["scene.yaml"], Item])
def test_anything_else_is_one_clear_type_error(name: str, given: object) -> None:
    function = FUNCTIONS.get(name, sim2reason.solve)  # type: ignore[arg-type]
    told = rf"^{name}\(\) takes a scene, the path of its file, its YAML text or an item; \w+ is none of them$"
    with pytest.raises(TypeError, match=told):
        function(given)


def test_a_figure_of_an_item_shows_no_more_than_its_text(item: Item, tmp_path: Path) -> None:
    scene = sim2reason.load(item.scene)
    address = next(each.path for each in scene.parameters if each.path.endswith("mass"))
    hidden = re.sub(r"^text: \{", f"text: {{symbols: [{address}], ", item.scene, flags=re.MULTILINE)
    assert hidden != item.scene
    sim2reason.figure(hidden, tmp_path / "hidden.svg", numbers=True)
    sim2reason.figure(scene, tmp_path / "shown.svg", numbers=True)
    assert (tmp_path / "hidden.svg").read_bytes() != (tmp_path / "shown.svg").read_bytes()


def test_an_item_is_solved_as_its_id_is(item: Item) -> None:
    found, wanted = sim2reason.solve(item), sim2reason.solve(id=item.id)
    assert (found.problem, found.solution.text, found.answer) == (wanted.problem, wanted.solution.text, wanted.answer)


def test_a_question_about_a_scene_of_ones_own_says_what_to_give(item: Item) -> None:
    (asked,) = sim2reason.ask(item, items=1)
    with pytest.raises(sim2reason.Sim2ReasonError, match="it is asked about a scene; give that with a question"):
        sim2reason.solve(asked)


def test_the_question_of_a_file_is_solved(item: Item) -> None:
    scene = sim2reason.load(item.scene)
    (asked,) = sim2reason.ask(scene, items=1)
    parts = {"find": asked.asked.quantity, "of": asked.asked.subject, "when": f"{asked.asked.time:.4g} s"}
    if asked.asked.time is None:
        pytest.skip("another question")
    text = f"{item.scene}question: {json.dumps(parts)}\n"
    found = sim2reason.solve(text)
    assert found.answer == pytest.approx(sim2reason.solve(scene, question=parts).answer)


def test_printing_a_description_prints_its_text(item: Item) -> None:
    described = sim2reason.describe(item)
    assert str(described) == described.text

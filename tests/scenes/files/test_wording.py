"""Tests that the wording of a problem is saved in the scene's file."""

import pytest

from sim2reason.errors import SceneError
from sim2reason.generation.item_search import sample
from sim2reason.scenes.files import Wording, dump, loads, read_wording

SCENE = sample("pulley", "easy", seed=7)


@pytest.mark.parametrize("wording", [Wording(), Wording(12, ("world.gravity",), ("start", "axes"))])
def test_it_is_read_back(wording: Wording) -> None:
    text = dump(SCENE, wording)
    assert read_wording(text) == wording
    assert loads(text) == SCENE


def test_a_file_need_not_have_any() -> None:
    assert read_wording(dump(SCENE)) is None


@pytest.mark.parametrize(
    ("said", "place"),
    [
        ("text: 5", "text"),
        ("text: {wordings: 5}", "text.wordings"),
        ("text: {wording: -1}", "text.wording"),
        ("text: {wording: 1.5}", "text.wording"),
        ("text: {symbols: world.gravity}", "text.symbols"),
        ("text: {symbols: [1]}", "text.symbols"),
        ("text: {without: [middle]}", "text.without"),
    ],
)
def test_what_is_wrong_with_it_is_said_with_its_place(said: str, place: str) -> None:
    text = f"{dump(SCENE)}{said}\n"
    with pytest.raises(SceneError) as error:
        loads(text)
    assert error.value.place.startswith(f"{place} (line ")
    with pytest.raises(SceneError):
        read_wording(text)

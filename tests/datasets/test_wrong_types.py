"""Tests that values of wrong types give the library's own errors, with their place and the expected type."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import sim2reason
from sim2reason.errors import Sim2ReasonError

ORDERS: list[tuple[dict[str, Any], str]] = [
    ({"recipe": None}, "recipe: None is no name; give one, several, or 'all'"),
    ({"mode": 5}, "mode: 5 is no name"),
    ({"difficulty": [None]}, "difficulty: None is no name"),
    ({"weights": "period"}, "weights: 'period' is no mapping; give numbers by name"),
    ({"weights": {"period": "2"}}, "weights: 'period': '2' is no number"),
    ({"split": "train"}, "split: 'train' is no mapping"),
    ({"license": ""}, "license: '' is no licence"),
    ({"decontaminate": None}, "decontaminate: None names no files; give a path, or several in a list"),
    ({"decontaminate": [5]}, r"decontaminate: \[5\] names no files"),
    ({"decontaminate": "none.jsonl"}, "none.jsonl"),
]


@pytest.mark.parametrize(("order", "told"), ORDERS)
def test_an_order(tmp_path: Path, order: dict[str, Any], told: str) -> None:
    with pytest.raises(Sim2ReasonError, match=f"^{told}"):
        sim2reason.generate(tmp_path / "new", items=1, **order)
    assert not (tmp_path / "new").exists()


COORDINATES: list[tuple[dict[str, Any], str]] = [
    ({"recipe": None}, "recipe: None is no name"),
    ({"recipe": ["pulley"]}, r"recipe: \['pulley'\] is no name"),
    ({"mode": None}, "mode: None is no name"),
    ({"weights": "x"}, "weights: 'x' is no mapping"),
    ({"weights": {"period": None}}, "weights: 'period': None is no number"),
    ({"weights": {3: 1.0}}, "weights: 3: 1.0 is no number of that name"),
    ({"units": ["SI"]}, "no such units: "),
]


def first(**given: Any) -> object:  # noqa: ANN401 - wrong ones
    return next(sim2reason.stream(**given))


@pytest.mark.parametrize(("coordinates", "told"), COORDINATES)
@pytest.mark.parametrize("asked", [sim2reason.item, first])
def test_a_problem(asked: Callable[..., object], coordinates: dict[str, Any], told: str) -> None:
    if asked is not sim2reason.item and coordinates.get("recipe") == ["pulley"]:
        pytest.skip("a stream takes several")
    with pytest.raises(Sim2ReasonError, match=f"^{told}"):
        asked(**coordinates)


READERS: list[tuple[Callable[[Any], object], str]] = [
    (lambda data: sim2reason.explain(data, id=None), "holds no problem None; see"),  # type: ignore[arg-type]
    (lambda data: list(sim2reason.show(data, id=5)), "holds no problem 5; see"),  # type: ignore[arg-type]
    (lambda data: list(sim2reason.show(data, recipe=None)), "recipe: None is no name"),  # type: ignore[arg-type]
    (lambda data: list(sim2reason.show(data, split=None)), "split: None is no name"),  # type: ignore[arg-type]
]


@pytest.mark.parametrize(("read", "told"), READERS)
def test_what_is_read(data: Path, read: Callable[[Any], object], told: str) -> None:
    with pytest.raises(Sim2ReasonError, match=told):
        read(data)


def test_a_name_of_a_registry() -> None:
    for name in (None, ["hf"]):
        with pytest.raises(Sim2ReasonError, match="no such name among exports: "):
            sim2reason.export("nowhere", "new", to=name)  # type: ignore[arg-type]

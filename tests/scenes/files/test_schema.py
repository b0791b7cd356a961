"""Tests that the JSON schema and the documentation of the format match the classes."""

import copy
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema
import pytest
import yaml
from numpy.random import default_rng

from scene_files import composed, drawn
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.dsl.entity import ENTITIES
from sim2reason.scenes.dsl.measures import Mass
from sim2reason.scenes.dsl.model import Model
from sim2reason.scenes.files import dump
from sim2reason.scenes.files.page import format_page
from sim2reason.scenes.files.schema import Json, fields, schema, snake, words

CHECK = jsonschema.Draft202012Validator(schema())


def test_it_is_a_schema() -> None:
    jsonschema.Draft202012Validator.check_schema(schema())


def test_every_dump_keeps_it() -> None:
    for scene in drawn(60, seed=2):
        CHECK.validate(yaml.safe_load(dump(scene)))
    for seed in range(20):
        CHECK.validate(composed(default_rng(seed)))


def _changed(data: Json, path: tuple[Any, ...], value: object) -> Json:
    changed = copy.deepcopy(data)
    held: Any = changed
    for step in path[:-1]:
        held = held[step]
    held[path[-1]] = value
    return changed


@pytest.mark.parametrize(
    ("path", "value"),
    [
        (("scene", "entities"), []),
        (("scene", "more"), 1),
        (("scene", "entities", 0, "type"), "Unknown"),
        (("scene", "entities", 0, "name"), "Not a name"),
        (("scene", "entities", 0, "parameters", "pulley", "mass"), -1.0),
        (("scene", "entities", 0, "parameters", "pulley", "mass"), "1.0"),
        (("scene", "entities", 0, "parameters", "system", "kind"), "floating"),
        (("scene", "entities", 0, "parameters", "system", "blocks"), []),
        (("scene", "connections", 0, "tendon"), []),
        (("scene", "connections", 0, "free"), -1),
        (("scene", "world", "gravity"), -1),
    ],
)
def test_it_refuses_what_load_refuses(path: tuple[Any, ...], value: object) -> None:
    good = {
        "scene": {
            "entities": [
                {
                    "name": "a",
                    "type": "mass_with_fixed_pulley",
                    "parameters": {"system": {"kind": "hanging", "blocks": [{"mass": 1}]}, "pulley": {}},
                },
                {"name": "b", "type": "FixedSupport"},
            ],
            "connections": [{"tendon": [{"entity": "a", "direction": "tail"}, {"entity": "b", "direction": "end"}]}],
            "world": {},
        }
    }
    CHECK.validate(good)
    assert not CHECK.is_valid(_changed(good, path, value))


def test_ranges_and_units_are_those_of_the_declaration() -> None:
    (mass,) = fields(Block)
    assert mass.schema == {"type": "number", "minimum": 1e-6, "maximum": 1e9, "description": "mass in kg"}
    assert words(mass.schema) == "a number in kg, at least 1e-06 and at most 1000000000"


def test_types_that_files_can_not_hold_are_a_programmers_error() -> None:
    class Odd(Model):
        when: complex
        mass: Mass

    with pytest.raises(TypeError, match="can't hold"):
        list(fields(Odd))


def test_tuples_of_fixed_length_and_whole_numbers_are_described() -> None:
    class Point(Model):
        at: tuple[float, float]
        count: int
        mode: bool

    at, count, mode = fields(Point)
    assert (at.schema["minItems"], count.schema["type"], mode.schema["type"]) == (2, "integer", "boolean")


def test_every_type_is_told_in_both_spellings() -> None:
    said = [
        entity["properties"]["type"]["enum"]
        for entity in schema()["properties"]["scene"]["properties"]["entities"]["items"]["oneOf"]
    ]
    assert said == [[name, snake(name)] for name in ENTITIES]


def test_the_committed_page_is_current() -> None:
    page = Path(__file__).parents[3] / "docs" / "scene-format.md"
    assert page.read_text(encoding="utf-8") == format_page(), "run: sim2reason schema --page -o docs/scene-format.md"


def test_no_choice_holds_a_comma() -> None:
    """Commas separate the documented choices and the entries of a flow mapping in YAML."""

    def choices(held: Any) -> Iterator[str]:  # noqa: ANN401 - JSON of any kind
        if isinstance(held, dict):
            yield from (str(value) for value in held.get("enum", ()))
        for value in held.values() if isinstance(held, dict) else held if isinstance(held, list) else ():
            yield from choices(value)

    found = set(choices(schema()))
    assert {"above", "on the same side as the first body"} <= found
    assert not [value for value in found if "," in value]

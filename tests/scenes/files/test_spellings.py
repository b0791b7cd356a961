"""Tests of the spellings in the paper's figure: positions, masses by type, directions along a string, titles."""

import jsonschema
import pytest
import yaml

from sim2reason.errors import SceneError
from sim2reason.scenes.files import dump, load
from sim2reason.scenes.files.schema import schema

FIGURE = """\
scene:
  name: "Pulley System"
  entities:
  - name: "entity1"
    type: "MassWithFixedPulley"
    position: [0, 2, 0]
    parameters:
      mass_type: "Mass"
      mass_values: [10]
  - name: "entity2"
    type: "MassWithMovablePulley"
    position: [0, 1, 0]
    parameters:
      mass_type: ["Mass", "OnPlane"]
      mass_values: [4, [1.5, 2]]
      plane: {angle: 30, friction: 0}
  connections:
  - tendon:
    - entity: "entity1"
      direction: "inner_to_outer"
    - entity: "entity2"
      direction: "outer_to_inner"
"""
SIMPLE = FIGURE.replace('["Mass", "OnPlane"]', '"Mass"').replace("      plane: {angle: 30, friction: 0}\n", "")
OWN = """\
scene:
  name: pulley_system
  entities:
  - name: entity1
    type: MassWithFixedPulley
    parameters: {system: {kind: hanging, blocks: [{mass: 10}]}, pulley: {}}
  - name: entity2
    type: MassWithMovablePulley
    parameters:
      left: {kind: hanging, blocks: [{mass: 4}]}
      right: {kind: hanging, blocks: [{mass: 1.5}, {mass: 2}]}
      pulley: {}
  connections:
  - tendon: [{entity: entity1, direction: tail}, {entity: entity2, direction: top}]
"""


def test_the_figure_means_what_our_own_spelling_means() -> None:
    assert load(SIMPLE) == load(OWN)
    assert load(dump(load(SIMPLE))) == load(OWN)
    jsonschema.Draft202012Validator(schema()).validate(yaml.safe_load(SIMPLE))


def test_where_an_entity_stands_is_for_looks_only() -> None:
    elsewhere = SIMPLE.replace("[0, 2, 0]", "[5, -1.5, 2]")
    assert load(elsewhere) == load(SIMPLE)
    assert "position" not in dump(load(elsewhere))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('mass_type: "Mass"', "mass_type: Hanging"),
        ('mass_type: "Mass"', "mass_type: hanging"),
        ('      mass_type: "Mass"\n', ""),
        ("mass_values: [10]", "mass_values: [10]\n      pulley: {mass: 0.0}"),
        ('direction: "inner_to_outer"', "direction: outer_to_inner"),
        ('direction: "outer_to_inner"', "direction: outer_to_inner\n      connecting_point: top"),
        ("Pulley System", "Pulley  system"),
    ],
)
def test_other_ways_to_say_the_same(old: str, new: str) -> None:
    assert old in SIMPLE
    assert load(SIMPLE.replace(old, new, 1)) == load(OWN)


def test_keys_of_the_kind_stand_beside_the_masses() -> None:
    text = SIMPLE.replace('mass_type: "Mass"', "mass_type: OnPlane\n      plane: {angle: 30, friction: 0.1}", 1)
    plane = "system: {kind: on_plane, plane: {angle: 30, friction: 0.1}, blocks: [{mass: 10}]}"
    assert load(text) == load(OWN.replace("system: {kind: hanging, blocks: [{mass: 10}]}", plane))


def test_systems_of_several_types_take_what_is_theirs() -> None:
    """The figure has one hanging block, and two on a plane."""
    left, right = (
        load(FIGURE).entities[1].entity.model_dump()["left"],
        load(FIGURE).entities[1].entity.model_dump()["right"],
    )
    assert (len(left["blocks"]), len(right["blocks"])) == (1, 2)
    assert right["plane"]["angle"] == 30.0


FIRST, SECOND = "scene.entities[0].parameters.", "scene.entities[1].parameters."


@pytest.mark.parametrize(
    ("old", "new", "place", "problem", "remedy"),
    [
        ("[0, 2, 0]", "[0, 2]", "scene.entities[0].position (line 6)", "not a place", "three numbers"),
        ("[0, 2, 0]", "[0, 2, up]", "scene.entities[0].position (line 6)", "not a place", "three numbers"),
        ("[10]", "[-10]", FIRST + "mass_values[0] (line 9)", "-10 is less than", "kg"),
        ("[10]", "[ten]", FIRST + "mass_values[0] (line 9)", '"ten" is not a number', "kg"),
        ("[10]", "[]", FIRST + "mass_values (line 9)", "at least 1", "a list"),
        ("[10]", "10", FIRST + "mass_values (line 9)", "not a list", "[10]"),
        ("      mass_values: [10]\n", "", FIRST + "mass_values (line 8)", "it is missing", "[10]"),
        ('"Mass"', '"Rocket"', FIRST + "mass_type (line 8)", 'no type "Rocket"', "Mass, hanging, on_plane"),
        ('"Mass"', "OnPlane", FIRST + "plane (line 8)", "it is missing", "a mapping, such as {"),
        ('"Mass"', "3", FIRST + "mass_type (line 8)", "3, not a word", "Mass"),
        ('"Mass"', "[Mass, Mass]", FIRST + "mass_type (line 8)", "2 members for 1", "one word"),
        ("[10]", "[10]\n      system: {}", FIRST + "system (line 10)", "says the same", "one of the two"),
        ("[10]", "[10]\n      height: 2", FIRST + "height (line 10)", "no such key", "length"),
        ("[4, [1.5, 2]]", "[4]", SECOND + "mass_values (line 15)", "1 members for 2", "[1.0, [2.0, 3.0]]"),
        ("[4, [1.5, 2]]", "[x]", SECOND + "mass_values (line 15)", "1 members for 2", "list"),
        ("[4, [1.5, 2]]", "[4, [1.5, x]]", SECOND + "mass_values[1][1] (line 15)", '"x" is not', "kg"),
        ("MassWithFixedPulley", "FixedSupport", FIRST + "mass_values (line 9)", "no masses of a type", "own"),
        ("outer_to_inner", "outer", "scene.connections[0].tendon[1].direction (line 21)", "no direction", "top"),
    ],
)
def test_mistakes_are_told_by_their_place_in_the_file(
    old: str, new: str, place: str, problem: str, remedy: str
) -> None:
    assert old in SIMPLE
    with pytest.raises(SceneError) as raised:
        load(SIMPLE.replace(old, new, 1))
    assert raised.value.place == place
    assert problem in raised.value.problem
    assert remedy in raised.value.remedy


def test_a_way_to_an_entity_with_several_ends_must_say_which() -> None:
    text = SIMPLE.replace("MassWithMovablePulley", "TwoSideMassPlane").replace(
        'mass_type: "Mass"\n      mass_values: [4, [1.5, 2]]',
        "plane: {angle: 0, friction: 0}\n      blocks: [{mass: 1.0}]",
    )
    with pytest.raises(SceneError, match="no direction"):
        load(text)
    chosen = text.replace('"outer_to_inner"', "outer_to_inner\n      connecting_point: left")
    assert load(chosen).connections[0].links[1].port == "left"

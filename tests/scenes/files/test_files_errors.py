"""Tests that a faulty file raises one error with its path, line, problem and remedy."""

import re
import time
from pathlib import Path
from textwrap import dedent

import pytest

from sim2reason.base.yaml_text import MAX_DEPTH, MAX_NODES, parse, write
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import load
from sim2reason.simulation.scenes import simulate

GOOD = """\
scene:
  entities:
  - name: ramp
    type: MassWithFixedPulley
    parameters:
      system:
        kind: on_plane
        plane: {angle: 30.0, friction: 0.0}
        blocks:
        - {mass: 2.0}
        - {mass: 3.0}
      pulley: {}
  - name: hand
    type: ConstantForcePuller
    parameters: {force: 5.0}
  connections:
  - tendon:
    - {entity: ramp, direction: tail}
    - {entity: hand, direction: end}
    free: 2.0
  world: {gravity: 9.8}
"""
SYSTEM = "scene.entities[0].parameters.system"
MASS = "scene.entities[0].parameters.system.blocks[0].mass (line 10)"
PUCKS = """\
scene:
  entities:
  - name: table
    type: TwoDCollisionPlane
    parameters:
      table: {}
      radius: 0.1
      restitution: 1.0
      pucks:
      - {mass: 1.0, x: 0.0, y: 0.0, vx: 1.0, vy: 0.0}
      - {mass: 1.0, x: 1.0, y: 0.0, vx: 0.0, vy: 0.0}
"""


def refused(text: str) -> SceneError:
    with pytest.raises(SceneError) as raised:
        load(text)
    assert raised.value.remedy
    assert "\n" not in str(raised.value)
    return raised.value


def test_the_files_that_are_spoiled_below_are_good() -> None:
    assert simulate(load(GOOD)).stable_until > 0.5
    assert simulate(load(PUCKS)).events


# ---- the text: YAML that means different things to different readers, or is made to hurt

TEXTS = [
    ("{mass: &m 2.0}", "there is an anchor or alias"),
    ("*m", "there is an anchor or alias"),
    ("{mass: !!float 2.0}", "there is a tag"),
    ("!!python/object/apply:os.system [ls]", "there is a tag"),
    ("{mass: 2.0, mass: 3.0}", 'the key "mass" stands here twice'),
    ("{<<: {mass: 2.0}}", "keys are merged"),
    ("{? [a] : 2.0}", "a key is not a plain word"),
    ("{1: 2.0}", "can't be a key"),
    ("{yes: 2.0}", "can't be a key"),
    ("{mass: }", "it has no value"),
    ("{mass: yes}", "means true, false or nothing"),
    ("{mass: Off}", "means true, false or nothing"),
    ("{mass: ~}", "means true, false or nothing"),
    ("{mass: 1_000}", "1_000 is not a plain number"),
    ("{mass: 0x10}", "0x10 is not a plain number"),
    ("{mass: 0o17}", "0o17 is not a plain number"),
    ("{mass: 010}", "010 is not a plain number"),
    ("{mass: 1:30}", "1:30 is not a plain number"),
    ("{mass: 2001-01-01}", "2001-01-01 is not a plain number"),
    ("{mass: .nan}", ".nan is not a plain number"),
    ("{mass: -.inf}", "-.inf is not a plain number"),
    ("{mass: 1e999}", "1e999 is too large for a number"),
    ("{mass: 1e-400000000000000000000000000000000000000000000}", "more than 40 characters"),
    (f"{{mass: {'9' * 5000}}}", "more than 40 characters"),
    ("{mass: 1٣}", "is not a plain number"),
    ("|\n          text", "text over several lines"),
    ("{mass: 2.0}\n---\na: 1", "a second document begins here"),
    ("{mass: 'open}", "this is not YAML"),
    ("{mass: 2.0", "is not a plain number"),
    ("\t{mass: 2.0}", "this is not YAML"),
    ("{mass: \x07}", "it holds the character U+0007"),
    ("{mass: 2.0} # \ud800", "it holds the character U+D800"),
    ("{mass: 2.0} # \ufeff", "it holds the character U+FEFF"),
]


@pytest.mark.parametrize(("value", "said"), TEXTS)
def test_only_plain_yaml_is_read(value: str, said: str) -> None:
    error = refused(GOOD.replace("{mass: 2.0}", value))
    assert said in error.problem
    assert re.search(r"line 1[0-4]\b|line 2\d", error.place), error.place


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "the file: it is empty"),
        ("# nothing", "the file: it is empty"),
        ("%YAML 1.1\n---\na: 1", "line 1: a %YAML or %TAG directive"),
        (f"{GOOD}---\n{GOOD}", "line 22: a second document begins here"),
        ("[" * 30_000, "nested too deeply"),
        ("{a: " * 15_000, "nested too deeply"),
        ("a: " + "[" * (MAX_DEPTH + 1) + "]" * (MAX_DEPTH + 1), "nested too deeply"),
        ("- " * 20_000, "nested too deeply"),
        ("x" * 70_000, "more than 65536 bytes"),
        ("# \N{SNOWMAN}" * 20_000, "more than 65536 bytes"),
        ("[" + "1," * (MAX_NODES + 1) + "]", "more than 4000 values"),
        ("? " * 30_000, "a key is not a plain word"),
        ("a: &a [1]\nb: &b [*a,*a]\nc: &c [*b,*b]\n", "a (line 1): there is an anchor or alias"),
    ],
)
def test_what_is_made_to_hurt_is_refused_at_once(text: str, said: str) -> None:
    begun = time.perf_counter()
    assert said in str(refused(text))
    assert time.perf_counter() - begun < 1.0


def test_values_that_the_format_has_come_back() -> None:
    value = {"a": [1, 2.5, -0.0, True, None, "yes", "x y", "1.0"], "b": {"c": {}, "d": []}, "e": [[1], [{"f": 1e-7}]]}
    assert parse(write(value)) == value
    assert repr(parse(write({"a": -0.0}))) == "{'a': -0.0}"


def test_a_reader_without_libyaml_refuses_and_reads_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    import yaml

    from sim2reason.base import yaml_text

    wanted = load(GOOD)
    monkeypatch.setattr(yaml_text, "Parser", yaml.SafeLoader)
    assert load(GOOD) == wanted
    for text in ("[" * 3_000, "a: &x 1", "a: 'open", "a: 1\n---\nb: 2", "{mass: yes}"):
        refused(text)


# ---- the values: physics.md's row on untrusted scenes, and what else can be wrong with a number or a name

VALUES = [
    ("{mass: 2.0}", "{mass: -2.0}", MASS, "-2.0 is less than 1e-06", "a number in kg, at least 1e-06"),
    ("{mass: 2.0}", "{mass: 0}", MASS, "0 is less than", "kg"),
    ("{mass: 2.0}", "{mass: NaN}", MASS, '"NaN" is not a number', "kg"),
    ("{mass: 2.0}", "{mass: '2.0'}", MASS, '"2.0" is not a number', "kg"),
    ("{mass: 2.0}", "{mass: true}", MASS, "true is not a number", "kg"),
    ("{mass: 2.0}", "{mass: [2.0]}", MASS, "[2.0] is not a number", "kg"),
    ("{mass: 2.0}", "{mass: null}", MASS, "null is not a number", "kg"),
    ("{mass: 2.0}", "{mass: 1.0e+300}", MASS, "is more than 1000000", "at most 1000000"),
    ("{mass: 2.0}", "{}", MASS, "it is missing", "kg"),
    ("{mass: 2.0}", "{mas: 2.0}", MASS.replace("mass", "mas"), "there is no such key", "did you mean: mass"),
    ("{mass: 2.0}", "2.0", MASS.replace(".mass", ""), "it is 2.0, not a mapping", "mass"),
    ("angle: 30.0", "angle: 90", SYSTEM + ".plane.angle (line 8)", "90 is not less than 90", "deg"),
    ("kind: on_plane", "kind: floating", SYSTEM + ".kind (line 7)", 'no kind "floating"', "on_plane"),
    ("        kind: on_plane\n", "", SYSTEM + ".kind (line 7)", "it does not say its kind", "on_plane"),
    ("type: MassWith", "type: MasWith", "scene.entities[0].type (line 4)", "there is no type", "MassWithFixedPulley"),
    ("name: ramp", "name: Ramp", "scene.entities[0].name (line 3)", '"Ramp" is no name', "small letters"),
    ("name: ramp", 'name: "ramp\\n"', "scene.entities[0].name (line 3)", "is no name", "small letters"),
    ("name: ramp", "name: hand", "scene.entities[1].name (line 13)", "two entities are called hand", "rename"),
    ("name: ramp", "name: 3", "scene.entities[0].name (line 3)", "it is 3, not a word", "name"),
    ("force: 5.0", "", "scene.entities[1].parameters.force (line 15)", "it is missing", "N"),
    ("    parameters: {force: 5.0}\n", "", "scene.entities[1].parameters.force (line 13)", "it is missing", "N"),
    ("gravity: 9.8", "gravity: -1", "scene.world.gravity (line 21)", "-1 is less than 0", "m/s^2"),
    ("free: 2.0", "free: 0", "scene.connections[0].free (line 20)", "0 is less than", "m"),
    (
        "parameters: {force: 5.0}",
        "force: 5.0",
        "scene.entities[1].force (line 15)",
        "no such key",
        "parameters: {force",
    ),
    ("free: 2.0", "fee: 2.0", "scene.connections[0].fee (line 20)", "there is no such key", "free"),
    ("direction: end", "direction: ed", "scene.connections[0].tendon[1].direction (line 19)", "no direction", "end"),
    ("entity: hand", "entity: hend", "scene.connections[0].tendon[1].entity (line 19)", "no entity", "hand"),
    ("entity: hand, ", "", "scene.connections[0].tendon[1].entity (line 19)", "it is missing", "entity"),
    ("- tendon:", "- tender:", "scene.connections[0] (line 17)", "does not say which kind", "tendon"),
    ("    - {entity: hand, direction: end}\n", "", "scene.connections[0].tendon (line 18)", "two ends", "list two"),
    (
        "  world: {gravity: 9.8}",
        "  glued: [moon]",
        "scene.glued (line 21)",
        "nothing that could move",
        "ramp.system.blocks.0",
    ),
    ("  world: {gravity: 9.8}", "  glued: [1]", "scene.glued[0] (line 21)", "it is 1", "ramp.blocks.0"),
    ("  world: {gravity: 9.8}", "  worlds: {}", "scene.worlds (line 21)", "there is no such key", "world"),
]


def test_what_stands_beside_the_scene_is_told_to_stand_below_it() -> None:
    error = refused(dedent(GOOD.partition("\n")[2]))
    assert error.problem == "there is no such key here"
    assert "begin with the line scene:" in error.remedy


@pytest.mark.parametrize("name", ["world", "tendon_1"])
def test_a_name_at_which_something_else_stands_is_refused(name: str) -> None:
    error = refused(GOOD.replace("name: hand", f"name: {name}").replace("entity: hand", f"entity: {name}"))
    assert (error.place, error.remedy) == ("scene.entities[1].name (line 13)", "rename one")
    assert f"called '{name}'" in error.problem


@pytest.mark.parametrize(("old", "new", "place", "problem", "remedy"), VALUES)
def test_the_path_the_problem_and_the_remedy_are_told(
    old: str, new: str, place: str, problem: str, remedy: str
) -> None:
    assert old in GOOD
    error = refused(GOOD.replace(old, new, 1))
    assert error.place == place
    assert problem in error.problem
    assert remedy in error.remedy


def test_several_mistakes_in_one_value_are_counted_in_one_error() -> None:
    error = refused(PUCKS.replace("x: 0.0, y: 0.0", "x: a, y: b"))
    assert error.problem == '"a" is not a number (and 1 more mistake here)'


def test_long_values_are_cut_short() -> None:
    assert len(str(refused(GOOD.replace("{mass: 2.0}", f"{{mass: {'x' * 5000}}}")))) < 250


# ---- physical misfits

HOOKS = "{name: a, type: FixedSupport}, {name: b, type: FixedSupport}"
HANDS = HOOKS.replace("FixedSupport", "ConstantForcePuller, parameters: {force: 1.0}")
JOINED = "connections: [{tendon: [{entity: a, direction: end}, {entity: b, direction: end}]}]"
STUCK = GOOD.replace("  world: {gravity: 9.8}", "  glued: [ramp.system.blocks.0, ramp.system.blocks.1]")


@pytest.mark.parametrize(
    ("text", "place", "problem"),
    [
        (PUCKS.replace("x: 1.0", "x: 0.1"), "scene.entities[0].parameters (line 6)", "pucks.0 and pucks.1 overlap"),
        (f"scene: {{entities: [{HOOKS}], {JOINED}}}", "scene.connections[0] (line 1)", "nothing hangs on this string"),
        (f"scene: {{entities: [{HANDS}], {JOINED}}}", "scene.connections[0] (line 1)", "nothing hangs on this string"),
        (GOOD.partition("  connections:")[0], "scene.entities[0] (line 3)", "its port 'tail' is open"),
        (STUCK, "scene.glued (line 21)", "nothing in this scene can move"),
        ("scene: {entities: []}", "scene.entities (line 1)", "there are 0"),
    ],
)
def test_what_can_not_be_built_is_refused_by_its_place_in_the_file(text: str, place: str, problem: str) -> None:
    error = refused(text)
    assert (error.place, error.problem[: len(problem)]) == (place, problem)


def test_two_hands_on_one_string_are_refused() -> None:
    text = (
        "scene: {entities: [{name: q, type: MassWithReverseMovablePulley, parameters: {pulley: {mass: 1.0}}}, "
        f"{HANDS}], connections: [{{tendon: [{{entity: a, direction: end}}, {{entity: q, direction: left}}]}}, "
        "{tendon: [{entity: q, direction: right}, {entity: b, direction: end}]}]}"
    )
    assert "both ends of one string are drawn in" in str(refused(text))


def test_errors_of_files_do_not_name_the_reader(tmp_path: Path) -> None:
    path = tmp_path / "bad.yaml"
    path.write_text(GOOD.replace("{mass: 2.0}", "{mass: x}"))
    with pytest.raises(SceneError) as raised:
        load(path)
    assert not re.search(r"pydantic|yaml\.|Traceback|ValidationError", str(raised.value))
    assert raised.value.__cause__ is None


def test_an_error_survives_the_way_out_of_a_worker() -> None:
    import pickle

    error = refused(GOOD.replace("{mass: 2.0}", "{mass: x}"))
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), again.place, str(again)) == (SceneError, error.place, str(error))


def test_a_loaded_scene_has_its_mechanism_built() -> None:
    assert "mechanism" in vars(load(GOOD))
    assert isinstance(load(GOOD), Scene)

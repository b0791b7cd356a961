"""Tests of loading and dumping scenes: exact round trips, and the paper's shorthand for connections."""

import re
from pathlib import Path
from textwrap import dedent

import pytest
import yaml

from scene_files import CLOSERS, KINDS, drawn
from sim2reason.base.yaml_text import MAX_BYTES
from sim2reason.errors import SceneError
from sim2reason.scenes.connections.string import String
from sim2reason.scenes.dsl.connection import Link
from sim2reason.scenes.dsl.entity import ENTITIES, declared_ports, outer_ports
from sim2reason.scenes.dsl.ports import Pass
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import dump, load, loads
from sim2reason.scenes.files.sections import directions, end_to_plain

BIGHT = """\
scene:
  name: bight
  entities:
  - name: a
    type: MassWithFixedPulley
    parameters:
      system:
        kind: hanging
        length: 2.5
        blocks:
        - {mass: 2.0}
        - {mass: 1.0e-05}
      pulley: {mass: 0.0}
  - name: q
    type: MassWithReverseMovablePulley
    parameters:
      pulley: {mass: 0.5}
      load: {mass: 3.0}
      length: 1.0
  - {name: hook, type: FixedSupport}
  connections:
  - tendon:
    - {entity: a, direction: tail}
    - {entity: q, direction: left}
    free: 2.75
  - tendon:
    - {entity: q, direction: right}
    - {entity: hook, direction: end}
  world: {gravity: 9.8}
"""
LEFT, RIGHT = "{entity: q, direction: left}", "{entity: q, direction: right}"
TAIL, HOOK = "{entity: a, direction: tail}", "{entity: hook, direction: end}"


def links(text: str) -> list[str]:
    (connection,) = load(text).connections
    return [f"{link}{' flipped' * link.flipped}" for link in connection.links]


def with_pairs(*pairs: tuple[str, str], free: int = 0) -> str:
    """Return the file with other pairs of ends, one of them with the string's length."""
    head, _, rest = BIGHT.partition("  connections:\n")
    said = [f"  - tendon: [{one}, {other}]\n" for one, other in pairs]
    said[free] += "    free: 2.75\n"
    return f"{head}  connections:\n{''.join(said)}{rest[rest.index('  world') :]}"


def test_random_scenes_of_the_pinned_entities_come_back_equal_in_the_same_bytes() -> None:
    met: set[str] = set()
    for scene in drawn(180):
        text = dump(scene)
        assert load(text) == scene
        assert dump(load(text)) == text
        met |= {type(named.entity).__name__ for named in scene.entities}
    assert met >= {*KINDS, *CLOSERS}


def test_any_reader_of_yaml_reads_the_same() -> None:
    for scene in drawn(40, seed=1):
        text = dump(scene)
        other = yaml.safe_dump(yaml.safe_load(text))
        assert load(other) == scene


def test_glued_bodies_and_the_world_come_back() -> None:
    scene = load(BIGHT).gluing("a.system.blocks.1").having("world.gravity", 1.62)
    text = dump(scene)
    assert "glued: [a.system.blocks.1]" in text
    assert "gravity: 1.62" in text
    assert load(text) == scene


def test_a_file_is_canonical() -> None:
    assert dump(load(BIGHT)) == BIGHT
    loose = BIGHT.replace("mass: 2.0", "mass: 2").replace("MassWithFixedPulley", "mass_with_fixed_pulley")
    loose = loose.replace("  world: {gravity: 9.8}\n", "").replace("name: bight", 'name: "bight"')
    assert dump(load(loose)) == BIGHT


def test_floats_keep_every_digit() -> None:
    for value in (0.1 + 0.2, 1e-5, 123456.78900000002, 2.0000000000000004, 1e6, 5e-6):
        scene = load(BIGHT).having("q.load.mass", value)
        assert load(dump(scene)).value("q.load.mass") == value
        assert yaml.safe_load(dump(scene))["scene"]["entities"][1]["parameters"]["load"]["mass"] == value


def test_names_that_yaml_takes_for_other_things_are_quoted() -> None:
    for name in ("yes", "no", "on", "null", "true", "e1"):
        text = BIGHT.replace("name: hook", f'name: "{name}"').replace("entity: hook", f'entity: "{name}"')
        scene = load(text)
        assert load(dump(scene)) == scene
        assert yaml.safe_load(dump(scene))["scene"]["entities"][2]["name"] == name


def test_a_path_is_a_file_and_a_text_is_a_text(tmp_path: Path) -> None:
    path = tmp_path / "scene.yaml"
    path.write_text(f"\ufeff# a comment\r\n{BIGHT}", encoding="utf-8", newline="\r\n")
    assert load(path) == load(BIGHT)
    path.write_bytes(b"scene: \xff")
    with pytest.raises(SceneError, match=r"line 1: the file is not UTF-8; save it as UTF-8"):
        load(path)
    path.write_bytes(b"#" * (MAX_BYTES + 1))
    with pytest.raises(SceneError, match="more than 65536 bytes"):
        load(path)


@pytest.mark.parametrize("ending", ["yaml", "yml", "json"])
def test_a_line_with_the_ending_of_a_file_is_a_path(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ending: str
) -> None:
    monkeypatch.chdir(tmp_path)
    Path(f"a scene.{ending}").write_text(BIGHT, encoding="utf-8")
    assert load(f"a scene.{ending}") == load(str(tmp_path / f"a scene.{ending}")) == load(BIGHT)
    with pytest.raises(FileNotFoundError, match=f"nowhere.{ending}"):
        load(f"nowhere.{ending}")


@pytest.mark.parametrize("text", ["{a: x.yaml", "[x.json", "scene: \nx.yaml", "x\0.yaml", "x.yaml ", "x.text", ""])
def test_everything_else_is_a_text(text: str) -> None:
    with pytest.raises(SceneError):
        load(text)


@pytest.mark.parametrize("text", ["x.yaml", "/etc/passwd.json"])
def test_a_text_that_looks_like_a_path_leads_nowhere(text: str) -> None:
    """The content of a file is not read as the path of another."""
    with pytest.raises(SceneError, match="not a mapping"):
        loads(text)


# ---- strings


def test_pairs_that_meet_at_a_passed_pulley_are_one_path() -> None:
    assert links(BIGHT) == ["a.tail", "q.under", "hook.end"]


@pytest.mark.parametrize(
    ("pairs", "wanted"),
    [
        ([(TAIL, RIGHT), (LEFT, HOOK)], ["a.tail", "q.under flipped", "hook.end"]),
        ([(LEFT, TAIL), (RIGHT, HOOK)], ["hook.end", "q.under flipped", "a.tail"]),
        ([(HOOK, RIGHT), (LEFT, TAIL)], ["hook.end", "q.under flipped", "a.tail"]),
        ([(RIGHT, HOOK), (TAIL, LEFT)], ["a.tail", "q.under", "hook.end"]),
        ([(RIGHT, HOOK), (LEFT, TAIL)], ["a.tail", "q.under", "hook.end"]),
    ],
)
def test_a_path_is_travelled_as_its_first_pair_is_written(pairs: list[tuple[str, str]], wanted: list[str]) -> None:
    text = with_pairs(*pairs)
    assert links(text) == wanted
    assert load(dump(load(text))) == load(text)


def test_a_longer_path_may_pass_pulleys_both_ways() -> None:
    scene = load(BIGHT)
    second = scene.entities[1].model_copy(update={"name": "p"})
    path = [("a", "tail", False), ("q", "under", True), ("p", "under", False), ("hook", "end", False)]
    string = String(links=tuple(Link(entity=e, port=p, flipped=f) for e, p, f in path), free=2.25)
    long = Scene(entities=(*scene.entities, second), connections=(string,))
    assert load(dump(long)) == long
    assert dump(long).count("- tendon:") == 3


def test_what_is_true_of_a_string_stands_beside_any_of_its_pairs() -> None:
    assert load(with_pairs((TAIL, LEFT), (RIGHT, HOOK), free=1)) == load(BIGHT)


def test_a_side_may_be_said_as_a_connecting_point() -> None:
    assert load(BIGHT.replace(LEFT, "{entity: q, direction: under, connecting_point: left}")) == load(BIGHT)


def forget_ports() -> None:
    """Clear the caches of properties of classes, which only change in a test."""
    for kept in (directions, outer_ports, declared_ports):
        kept.cache_clear()


def test_sides_whose_names_are_used_twice_are_told_by_their_pulley(monkeypatch: pytest.MonkeyPatch) -> None:
    entity = ENTITIES["MassWithReverseMovablePulley"]
    monkeypatch.setattr(entity, "second", Pass(sites=("pulley.left", "pulley.right"), passes=""), raising=False)
    forget_ports()
    try:
        assert ("left", "") not in directions(entity)
        assert end_to_plain("q", entity, "under", 0) == {
            "entity": "q",
            "direction": "under",
            "connecting_point": "left",
        }
    finally:
        monkeypatch.undo()
        forget_ports()


@pytest.mark.parametrize("name", sorted(ENTITIES))
def test_every_outer_port_of_every_entity_has_directions(name: str) -> None:
    assert {port for port, _ in directions(ENTITIES[name]).values()} == set(outer_ports(ENTITIES[name]))
    for port, side in directions(ENTITIES[name]).values():
        told = end_to_plain("x", ENTITIES[name], port, side)
        assert directions(ENTITIES[name])[told["direction"], told.get("connecting_point", "")] == (port, side)


RINGS = [
    (
        with_pairs((TAIL, HOOK), (LEFT, RIGHT)),
        r"connections\[1\].tendon\[1\] \(line \d+\): the string closes on itself",
    ),
    (
        with_pairs((TAIL, LEFT)),
        r"connections\[0\].tendon\[1\] \(line \d+\): the string comes to this pulley and does not",
    ),
    (
        with_pairs((TAIL, LEFT), (LEFT, HOOK)),
        r"connections\[1\].tendon\[0\] \(line \d+\): .* is the same end; use each",
    ),
    (
        with_pairs((TAIL, HOOK), (HOOK, LEFT)),
        r"connections\[1\].tendon\[0\] \(line \d+\): .* is the same end; use each",
    ),
    (
        BIGHT.replace(f"    - {HOOK}\n", f"    - {HOOK}\n    free: 2.0\n"),
        r"connections\[1\].free .*: it is given twice",
    ),
]


@pytest.mark.parametrize(("text", "said"), RINGS)
def test_rings_and_half_passed_pulleys_are_refused(text: str, said: str) -> None:
    with pytest.raises(SceneError) as raised:
        load(text)
    assert re.search(said, str(raised.value)), raised.value


def test_scenes_in_memory_obey_the_same_rules() -> None:
    scene = load(BIGHT)
    (string,) = scene.connections
    a, q, hook = string.links
    for wrong, said in [
        ((a,), "fewer than two ends"),
        ((a, q), "q.under can only be passed"),
        ((a, hook, q), "hook.end can't be passed"),
        ((a.model_copy(update={"flipped": True}), q, hook), "no sides to flip"),
    ]:
        with pytest.raises(SceneError, match=said):
            Scene(entities=scene.entities, connections=(String(links=wrong),))


def test_the_example_of_the_page_is_a_scene() -> None:
    page = (Path(__file__).parents[3] / "docs/scene-format.md").read_text(encoding="utf-8")
    example = page.partition("```yaml\n")[2].partition("```")[0]
    assert [named.name for named in load(dedent(example)).entities] == ["fixed", "lower_pulley", "hook"]

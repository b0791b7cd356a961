"""Tests of scenes: built from ports, changed into other scenes, refused if inconsistent."""

import pytest

from sim2reason.errors import SceneError
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import FixedBall
from sim2reason.scenes.bodies.simple_machines import FixedPulley, MovablePulley, Plane
from sim2reason.scenes.connections.string import String
from sim2reason.scenes.dsl.connection import Connection, Link
from sim2reason.scenes.dsl.defaults import opposite_direction
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.mechanism import X, Z
from sim2reason.scenes.dsl.ports import Port
from sim2reason.scenes.dsl.scene import Scene, World
from sim2reason.scenes.entities.pendulums import RotationEntity
from sim2reason.scenes.entities.pieces import FIRST, BallPiece
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley, MassWithReverseMovablePulley
from sim2reason.scenes.entities.slopes import TwoSideMassPlane
from sim2reason.scenes.entities.string_ends import ConstantForcePuller, FixedSupport, Hanging
from sim2reason.simulation.scenes import simulate


def hanging(mass: float) -> MassWithFixedPulley:
    return MassWithFixedPulley(system=Hanging(blocks=(Block(mass=mass),)), pulley=FixedPulley())


RAMP = TwoSideMassPlane(plane=Plane(angle=30.0, friction=0.1), blocks=(Block(mass=2.0), Block(mass=1.0)))
BIGHT = MassWithReverseMovablePulley(pulley=MovablePulley(mass=0.4), load=Block(mass=3.0))
LEFT, RIGHT, UNDER = MassWithFixedPulley.tail, TwoSideMassPlane.right, MassWithReverseMovablePulley.under


def scene(connections: tuple[Connection, ...], **entities: Entity) -> Scene:
    return Scene(entities=tuple(Named(name=n, entity=e) for n, e in entities.items()), connections=connections)


def bight() -> Scene:
    """Build a ramp, a pulley in a loop of string and a hanging block, all on one string."""
    string = String.between(("ramp", RIGHT), ("bight", UNDER), ("left", LEFT))
    return scene((string,), ramp=RAMP, bight=BIGHT, left=hanging(1.5))


def test_equal_scenes_are_equal_and_parameters_have_addresses() -> None:
    assert bight() == bight()
    found = {parameter.path: parameter.value for parameter in bight().parameters}
    assert found["ramp.blocks.1.mass"] == 1.0
    assert found["bight.pulley.mass"] == 0.4
    assert found["world.gravity"] == 9.8
    assert all(bight().value(path) == value for path, value in found.items())


def test_having_makes_another_scene() -> None:
    new = bight().having("ramp.plane.angle", 45.0).having("world.gravity", 1.6).having("tendon_1.free", 3.3)
    assert (new.value("ramp.plane.angle"), new.world.gravity, new.value("tendon_1.free")) == (45.0, 1.6, 3.3)
    assert new.mechanism.gravity == (0.0, 0.0, -1.6)
    assert bight().value("ramp.plane.angle") == 30.0


def test_a_scene_with_other_numbers_equals_a_validated_one() -> None:
    new, plane = bight().having("ramp.plane.angle", 45.0), Plane(angle=45.0, friction=0.1)
    string = bight().connections[0]
    ramp = TwoSideMassPlane(plane=plane, blocks=RAMP.blocks)
    assert new == scene((string,), ramp=ramp, bight=BIGHT, left=hanging(1.5))
    assert Scene.model_validate(new) == new
    assert "builder" not in new.__dict__


def test_a_number_that_only_an_open_port_needs_is_refused() -> None:
    ball = BallPiece(body=FixedBall(mass=1.0), distance=0.4, side=FIRST)
    arm = scene((), arm=RotationEntity(pieces=(ball,), angle=50.0))
    with pytest.raises(SceneError, match="reach only matters to what is joined"):
        arm.having("arm.reach", 0.5)


def test_without_an_entity_a_string_that_passed_it_goes_on() -> None:
    kept = bight().without("bight")
    assert [named.name for named in kept.entities] == ["ramp", "left"]
    assert [str(link) for link in kept.connections[0].links] == ["ramp.right", "left.tail"]


def test_without_an_entity_a_string_that_ended_there_is_gone() -> None:
    alone = scene((String.between(("ramp", RIGHT), ("left", LEFT)),), ramp=RAMP, left=hanging(1.5)).without("left")
    assert alone.connections == ()
    assert simulate(alone, 0.1).state.a[0, 0] < 0.0


def test_without_a_part_or_a_member() -> None:
    assert bight().without("bight.load").value("bight.load") is None
    assert len(bight().without("ramp.blocks.0").value("ramp.blocks")) == 1


def test_gluing_welds_and_is_remembered() -> None:
    glued = bight().gluing("ramp.blocks.0", "ramp.blocks.1")
    moving = {c.name.rpartition(".")[0] for c in glued.mechanism.coordinates}
    assert not any(name.startswith("ramp") for name in moving)
    assert glued.glued == ("ramp.blocks.0", "ramp.blocks.1")
    with pytest.raises(SceneError, match="nothing that could move"):
        bight().gluing("ramp.plane")


def test_a_glued_bight_lets_the_rest_move_as_if_it_were_fixed() -> None:
    """With the ramp's blocks glued, the pulley and the hanging block are an Atwood machine with 2:1 string.

    m₁ = 1.5 kg on the free end, m₂ = 3.0 + 0.4 kg on the axle, and the wheel's ½M = 0.2 kg at the rim speed of
    the string relative to the axle: with u the speed of m₂ upwards, m₁ sinks at 2u, and the rim runs at u.
    Energy: (m₂ + 4m₁ + 0.2)·u̇ = (2m₁ − m₂)g.
    """
    trace = simulate(bight().gluing("ramp.blocks.0", "ramp.blocks.1"), 0.2)
    names = [c.name for c in trace.mechanism.coordinates]
    expected = (2.0 * 1.5 - 3.4) * 9.8 / (3.4 + 4.0 * 1.5 + 0.2)
    assert trace.state.a[0, names.index("bight.load.slide")] == pytest.approx(expected, rel=1e-9)


def test_a_string_brings_a_pulley_where_directions_need_one() -> None:
    assert opposite_direction(X, (-1.0, 0.0, 0.0))
    assert opposite_direction(None, Z)
    assert not opposite_direction(Z, Z)
    assert [name for name in bight().bodies if name.startswith("tendon_1")] == ["tendon_1.pulley1"]


class _Pivot(Port):
    """Port that accepts no string."""


class _Rod(Connection):
    key = "rod"
    joins = _Pivot


@pytest.mark.parametrize(
    ("connections", "problem"),
    [
        ((), "is open"),
        ((String.between(("left", LEFT), ("left", LEFT)),), "used twice"),
        ((String.between(("left", LEFT), ("nobody", LEFT)),), "no entity is called"),
        ((String(links=(Link(entity="left", port="over"), Link(entity="hook", port="end"))),), "no port"),
        ((_Rod(links=(Link(entity="left", port="tail"), Link(entity="hook", port="end"))),), "can not be joined"),
    ],
)
def test_connections_that_do_not_fit_are_refused_in_words(connections: tuple[Connection, ...], problem: str) -> None:
    with pytest.raises(SceneError, match=problem):
        scene(connections, left=hanging(1.0), hook=FixedSupport())


def test_rings_and_doubled_names_are_refused() -> None:
    ends = String.between(("ramp", TwoSideMassPlane.left), ("ramp", TwoSideMassPlane.right))
    with pytest.raises(SceneError, match="ring"):
        scene((ends,), ramp=RAMP)
    with pytest.raises(SceneError, match="two entities are called"):
        Scene(entities=(Named(name="a", entity=RAMP), Named(name="a", entity=RAMP)))


def test_names_at_which_something_else_stands_are_refused() -> None:
    """An address begins with the name of an entity or connection or with *world*, so these must differ."""
    string = String.between(("ramp", RIGHT), ("left", LEFT))
    assert scene((string,), ramp=RAMP, left=hanging(1.0)).value("tendon_1") == string
    for name in ("world", "tendon_1"):
        tied = String.between((name, RIGHT), ("left", LEFT))
        with pytest.raises(SceneError, match=rf"entities\.0\.name: an entity and .* called '{name}'; rename one"):
            scene((tied,), **{name: RAMP}, left=hanging(1.0))
    free = scene((string,), ramp=RAMP, left=hanging(1.0), tendon_2=RAMP, world_1=RAMP)
    assert free.value("tendon_2.blocks.0.mass") == 2.0


def test_an_address_of_nobody_is_named_whole() -> None:
    for path in ("nobody.blocks.0.mass", "nobody.mass"):
        with pytest.raises(SceneError, match=rf"^{path}: no entity is called 'nobody'"):
            scene((), ramp=RAMP).having(path, 1.0)


def test_two_hands_on_one_string_are_refused() -> None:
    hands = {"one": ConstantForcePuller(force=1.0), "two": ConstantForcePuller(force=2.0)}
    string = String.between(("one", ConstantForcePuller.end), ("bight", UNDER), ("two", ConstantForcePuller.end))
    with pytest.raises(SceneError, match="both ends"):
        scene((string,), bight=BIGHT, **hands).check()


def test_where_an_entity_stands_does_not_matter() -> None:
    """The accelerations are the same in either order of the entities."""
    one = scene((String.between(("a", LEFT), ("b", LEFT)),), a=hanging(1.0), b=hanging(2.0))
    other = scene((String.between(("a", LEFT), ("b", LEFT)),), b=hanging(2.0), a=hanging(1.0))
    first, second = simulate(one, 0.3).state.a[0], simulate(other, 0.3).state.a[0]
    assert sorted(first) == pytest.approx(sorted(second), rel=1e-12)


def test_a_world_without_weight_is_a_world() -> None:
    still = Scene(entities=(Named(name="ramp", entity=RAMP),), world=World(gravity=0.0))
    assert not simulate(still, 0.1).state.a.any()

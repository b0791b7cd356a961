"""Tests of springs and rods, which are straight and can pass over no pulley."""

from math import cos, sqrt

import pytest

from sim2reason import certify, describe, parse_scene
from sim2reason.generation.recipes.ports import OpenPort
from sim2reason.scenes.bodies.blocks import Slab
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.connections.string import String
from sim2reason.scenes.connections.two_ended import Rod, SpringConnection, Straight, TwoEnded
from sim2reason.scenes.dsl.connection import Connection
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.ports import SitePort
from sim2reason.scenes.dsl.scene import Scene, World
from sim2reason.scenes.dsl.template import Wordings
from sim2reason.scenes.entities.stacked_mass_plane import StackedMassPlane
from sim2reason.scenes.entities.string_ends import FixedSupport
from sim2reason.simulation.scenes import simulate

SEEDS = range(12)
STACK = StackedMassPlane(
    plane=Plane(angle=30.0, friction=0.0), lower=Slab(mass=2.0), upper=Slab(mass=1.0), friction=0.4
)
STEEP = StackedMassPlane(
    plane=Plane(angle=40.0, friction=0.0), lower=Slab(mass=2.0), upper=Slab(mass=1.0), friction=0.4
)
HOOK = FixedSupport()
KINDS: tuple[tuple[type[Straight], dict[str, float]], ...] = ((SpringConnection, {"stiffness": 80.0}), (Rod, {}))


def joined(kind: type[Straight], port: SitePort, numbers: dict[str, float], *, turned: bool = False) -> Scene:
    ends = (("stack", port), ("hook", FixedSupport.end))
    return Scene(
        entities=(Named(name="stack", entity=STACK), Named(name="hook", entity=HOOK)),
        connections=(kind.between(*(ends[::-1] if turned else ends), **numbers),),
    )


@pytest.mark.parametrize(("kind", "numbers"), KINDS)
@pytest.mark.parametrize("turned", [False, True])
def test_the_text_tells_which_way_it_runs(kind: type[Straight], numbers: dict[str, float], *, turned: bool) -> None:
    for port, way in ((StackedMassPlane.lower_left, "down"), (StackedMassPlane.lower_right, "up")):
        scene = joined(kind, port, numbers, turned=turned)
        for seed in SEEDS:
            text = describe(scene, seed).text
            assert f"runs {way} the " in text
            read = parse_scene(text).scene.connections[0]
            assert port.name in {link.port for link in read.links}


@pytest.mark.parametrize(("kind", "numbers"), KINDS)
def test_it_has_three_wordings_from_an_end_with_a_direction(kind: type[Straight], numbers: dict[str, float]) -> None:
    scene = joined(kind, StackedMassPlane.lower_right, numbers)
    assert len({describe(scene, seed).sentences[-1] for seed in range(40)}) >= 3


@pytest.mark.parametrize(("kind", "numbers"), KINDS)
@pytest.mark.parametrize("other", [STEEP, STACK])
def test_it_does_not_turn_on_its_way(kind: type[Straight], numbers: dict[str, float], other: StackedMassPlane) -> None:
    """Ends that do not face each other, for example on two different slopes, can only be joined by a string."""
    far = StackedMassPlane.lower_right if other is STACK else StackedMassPlane.lower_left
    scene = Scene(
        entities=(Named(name="one", entity=STACK), Named(name="two", entity=other)),
        connections=(kind.between(("one", StackedMassPlane.lower_right), ("two", far), **numbers),),
    )
    with pytest.raises(Exception, match=r"one.lower_right and two.lower_\w+ do not face each other"):
        scene.check()


def test_two_ends_that_face_each_other_are_joined() -> None:
    """The description names the ends in their given order."""
    scene = Scene(
        entities=(Named(name="one", entity=STACK), Named(name="two", entity=STACK)),
        connections=(
            SpringConnection.between(
                ("one", StackedMassPlane.lower_right), ("two", StackedMassPlane.lower_left), stiffness=50.0
            ),
        ),
    )
    for seed in SEEDS:
        read = parse_scene(describe(scene, seed).text).scene
        assert [link.port for link in read.connections[0].links] == ["lower_right", "lower_left"]


def test_a_slider_on_a_spring_from_the_side_swings_as_a_spring_makes_it() -> None:
    """Both slabs (3 kg) move down the slope by x = (m g sin 30° / k) (1 - cos ωt) with ω = √(k / m)."""
    scene = Scene(
        entities=(
            Named(name="stack", entity=STACK.model_copy(update={"friction": 9.0})),
            Named(name="hook", entity=HOOK),
        ),
        connections=(
            SpringConnection.between(
                ("stack", StackedMassPlane.lower_left), ("hook", FixedSupport.end), stiffness=60.0
            ),
        ),
        world=World(gravity=10.0),
    )
    rate, mass = sqrt(60.0 / 3.0), 3.0
    trace = simulate(scene, 2.0)
    for time, place in zip(trace.state.times.tolist(), trace.state.q[:, 0].tolist(), strict=True):
        assert abs(place) == pytest.approx(10.0 * 0.5 * mass / 60.0 * (1.0 - cos(rate * time)), rel=1e-8, abs=1e-12)
    assert not certify(scene)[1].reason


def test_recipes_join_only_what_faces_each_other() -> None:
    """A string can turn over a pulley from one slope to another; a spring or rod cannot."""
    one, two = Named(name="one", entity=STACK), Named(name="two", entity=STEEP)
    here, there = OpenPort(one, StackedMassPlane.lower_right), OpenPort(two, StackedMassPlane.lower_left)
    same = OpenPort(Named(name="two", entity=STACK), StackedMassPlane.lower_left)
    kinds: tuple[type[Connection], ...] = (String, SpringConnection, Rod)
    assert [here.meets(there, kind) for kind in kinds] == [True, False, False]
    assert [here.meets(same, kind) for kind in kinds] == [True, True, True]


def test_a_wording_that_does_not_tell_the_way_is_refused() -> None:
    with pytest.raises(TypeError, match="leaves way unsaid"):
        type("Bar", (TwoEnded,), {"leads": Wordings(("{a} is joined to {b}.",)), "__module__": __name__})

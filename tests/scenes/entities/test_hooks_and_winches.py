"""Tests of a pulley with a hook, winches and loads, against textbook results."""

from math import cos, radians, sin

import pytest

from joined_entities import Followed, close, scene, string
from sim2reason.errors import SceneError
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import FixedPulley, MovablePulley, Plane
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley, ThreePointMovablePulley
from sim2reason.scenes.entities.slopes import TwoSideMassPlane
from sim2reason.scenes.entities.string_ends import (
    ConstantForcePuller,
    ConstantVelocityPuller,
    FixedSupport,
    Hanging,
    HangingMass,
)

G = 9.8


def lifted(load: float, weight: float, pulley: float = 0.0) -> Scene:
    """Build a load on the hook of a movable pulley, held by a weight over a fixed pulley."""
    entities = {
        "nail": FixedSupport(),
        "it": ThreePointMovablePulley(pulley=MovablePulley(mass=pulley)),
        "weight": MassWithFixedPulley(system=Hanging(blocks=(Block(mass=weight),)), pulley=FixedPulley()),
        "load": HangingMass(system=Hanging(blocks=(Block(mass=load),))),
    }
    return scene(entities, string("nail.end", "it.strand", "weight.tail"), string("it.eye", "load.end"))


@pytest.mark.parametrize("pulley", [0.0, 0.8])
def test_a_load_on_the_hook(pulley: float) -> None:
    """The load rises with a, the weight M falls with 2a, by Newton's laws for a pulley that is a uniform disc.

    T₂ = M (g − 2a), T₂ − T₁ = ½ m_p a, T₁ + T₂ = (m + m_p)(g + a).
    """
    load, weight = 3.0, 2.2
    found = Followed(lifted(load, weight, pulley), 0.5)
    a = G * (2.0 * weight - load - pulley) / (load + 1.5 * pulley + 4.0 * weight)
    close(found.a("it.carrier.slide"), a)
    close(found.a("weight.system.blocks.0.slide"), -2.0 * a)
    close(found.tension("tendon_2"), load * (G + a))


def test_a_winch_on_a_hook_that_points_up() -> None:
    """A pulley drawn up at constant speed u is an Atwood machine, with a = g (m₂ − m₁)/(m₁ + m₂)."""
    left, right, speed = 1.0, 1.8, 0.3
    entities = {
        "it": ThreePointMovablePulley(pulley=MovablePulley(), hook="above"),
        "left": HangingMass(system=Hanging(blocks=(Block(mass=left),))),
        "right": HangingMass(system=Hanging(blocks=(Block(mass=right),))),
        "winch": ConstantVelocityPuller(speed=speed),
    }
    made = scene(entities, string("left.end", "it.strand", "right.end"), string("it.eye", "winch.end"))
    found = Followed(made, 0.5)
    close(found.v("it.carrier.slide")[1:], speed)
    close(found.a("left.system.blocks.0.slide")[1:], G * (right - left) / (right + left))
    close(found.tension("tendon_2"), 4.0 * left * right * G / (left + right))


def test_a_winch_draws_a_block_up_a_rough_slope() -> None:
    """At constant speed T = m g (sin θ + µ cos θ); the string is taut from the start."""
    mass, friction, speed, slope = 2.0, 0.3, 0.4, radians(25.0)
    entities = {
        "it": TwoSideMassPlane(plane=Plane(angle=25.0, friction=friction), blocks=(Block(mass=mass),)),
        "winch": ConstantVelocityPuller(speed=speed),
    }
    found = Followed(scene(entities, string("it.right", "winch.end")), 1.0)
    close(found.q("it.blocks.0.slide"), speed * found.times)
    close(found.tension("tendon_1"), mass * G * (sin(slope) + friction * cos(slope)))


def test_a_winch_takes_in_twice_what_its_movable_pulley_rises() -> None:
    """The load rises with u/2, and each side of the string carries half of the load's weight."""
    load, speed = 3.0, 0.5
    entities = {
        "nail": FixedSupport(),
        "it": ThreePointMovablePulley(pulley=MovablePulley()),
        "winch": ConstantVelocityPuller(speed=speed),
        "load": HangingMass(system=Hanging(blocks=(Block(mass=load),))),
    }
    made = scene(entities, string("nail.end", "it.strand", "winch.end"), string("it.eye", "load.end"))
    found = Followed(made, 1.0)
    close(found.v("it.carrier.slide")[1:], speed / 2.0)
    close(found.tension("tendon_1"), load * G / 2.0)


def test_two_that_draw_at_one_string_are_refused() -> None:
    entities = {
        "hand": ConstantForcePuller(force=3.0),
        "it": ThreePointMovablePulley(pulley=MovablePulley()),
        "winch": ConstantVelocityPuller(speed=0.3),
        "load": HangingMass(system=Hanging(blocks=(Block(mass=1.0),))),
    }
    made = scene(entities, string("hand.end", "it.strand", "winch.end"), string("it.eye", "load.end"))
    with pytest.raises(SceneError, match="both ends"):
        made.check()

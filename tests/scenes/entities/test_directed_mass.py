"""Tests of a block on slanting strings, against work and energy and the closed form for a winch."""

from math import cos, radians, sin

import numpy as np

from joined_entities import Followed, close, scene, string
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import FixedPulley
from sim2reason.scenes.dsl.entity import Entity
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley
from sim2reason.scenes.entities.string_ends import ConstantForcePuller, ConstantVelocityPuller, DirectedMass, Hanging

G, MASS = 9.8, 2.2
BLOCK = DirectedMass(
    block=Block(mass=MASS),
    left_distance=0.9,
    left_angle=40.0,
    left_side="above",
    right_distance=1.4,
    right_angle=25.0,
    right_side="below",
)


def joined(left: Entity, left_port: str, right: Entity, right_port: str) -> Scene:
    entities = {"it": BLOCK, "left": left, "right": right}
    return scene(entities, string("it.side_1", f"left.{left_port}"), string("it.side_2", f"right.{right_port}"))


def lengths(x: Array | float) -> tuple[Array, Array]:
    """Return the lengths of both strings' slanting parts in m, with the block moved by x to the right."""
    sides = []
    for distance, angle, way in ((0.9, 40.0, -1.0), (1.4, 25.0, 1.0)):
        base, height = distance * cos(radians(angle)), distance * sin(radians(angle))
        sides.append(np.sqrt((base - way * x) ** 2 + height**2))
    return sides[0], sides[1]


def hanging(mass: float) -> MassWithFixedPulley:
    return MassWithFixedPulley(system=Hanging(blocks=(Block(mass=mass),)), pulley=FixedPulley())


def test_two_hands_do_work() -> None:
    """The work is ½ m v² = F₁ Δℓ₁ + F₂ Δℓ₂, and initially m a = F₂ cos θ₂ − F₁ cos θ₁.

    Each Δℓ is the length of string drawn in.
    """
    one, two = 3.0, 8.0
    found = Followed(joined(ConstantForcePuller(force=one), "end", ConstantForcePuller(force=two), "end"), 1.5)
    x, v = found.q("it.block.slide"), found.v("it.block.slide")
    begun, now = lengths(0.0), lengths(x)
    close(0.5 * MASS * v**2, one * (begun[0] - now[0]) + two * (begun[1] - now[1]))
    close(found.a("it.block.slide")[0], (two * cos(radians(25.0)) - one * cos(radians(40.0))) / MASS)


def test_two_hanging_blocks_keep_the_energy() -> None:
    """The sum ½ (m + M₁ ℓ₁′² + M₂ ℓ₂′²) v² + M₁ g Δℓ₁ + M₂ g Δℓ₂ stays zero.

    M₁ and M₂ are the hanging masses, and ℓ′ = dℓ/dx.
    """
    one, two = 0.9, 1.7
    found = Followed(joined(hanging(one), "tail", hanging(two), "tail"), 1.0)
    x, v = found.q("it.block.slide"), found.v("it.block.slide")
    assert float(np.abs(x).max()) > 0.1
    begun, now = lengths(0.0), lengths(x)
    slopes = ((0.9 * cos(radians(40.0)) + x) / now[0], (x - 1.4 * cos(radians(25.0))) / now[1])
    kinetic = 0.5 * (MASS + one * slopes[0] ** 2 + two * slopes[1] ** 2) * v**2
    close(kinetic + one * G * (now[0] - begun[0]) + two * G * (now[1] - begun[1]), 0.0, float(kinetic.max()))


def test_a_winch_draws_the_block_in() -> None:
    """The motion is that of a boat drawn in by a winch at speed u.

    ℓ = ℓ₀ − u t, d² = ℓ² − h², v = u ℓ/d, a = u² h²/d³ and T cos θ = m a + F cos θ₁.
    """
    speed, pull = 0.4, 2.0
    made = joined(ConstantForcePuller(force=pull), "end", ConstantVelocityPuller(speed=speed), "end")
    found = Followed(made, 1.2)
    length, height = 1.4 - speed * found.times, 1.4 * sin(radians(25.0))
    away = np.sqrt(length**2 - height**2)
    acceleration = (speed * height) ** 2 / away**3
    close(found.q("it.block.slide"), 1.4 * cos(radians(25.0)) - away)
    close(found.v("it.block.slide")[1:], (speed * length / away)[1:])
    close(found.a("it.block.slide"), acceleration)
    x = found.q("it.block.slide")
    back = (0.9 * cos(radians(40.0)) + x) / lengths(x)[0]
    close(found.tension("tendon_2"), (MASS * acceleration + pull * back) * length / away)

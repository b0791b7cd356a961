"""Tests of blocks on springs and strings and of a pendulum on a carriage: closed forms and invariants."""

from math import cos, pi, radians, sin, sqrt
from typing import Literal

import numpy as np
import pytest

from joined_entities import Followed, close, pivot, scene, string
from sim2reason.errors import SceneError
from sim2reason.scenes.bodies.blocks import Block, Carriage
from sim2reason.scenes.bodies.oscillators import Ball, LightRod, Spring
from sim2reason.scenes.bodies.simple_machines import FixedPulley, Plane
from sim2reason.scenes.connections.two_ended import Weld
from sim2reason.scenes.dsl.connection import Link
from sim2reason.scenes.entities.pendulums import LightRodPendulum, SliderMass
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley
from sim2reason.scenes.entities.spring_blocks import AnchoredSpring, SpringMassIncline
from sim2reason.scenes.entities.string_ends import ConstantForcePuller, ConstantVelocityPuller, Hanging

G, K = 9.8, 80.0
SPRING = Spring(stiffness=K, length=0.4)


@pytest.mark.parametrize("support", ["wall", "ceiling", "floor"])
def test_a_block_on_a_spring_oscillates(support: Literal["wall", "ceiling", "floor"]) -> None:
    """The block oscillates with ω² = k/m about the length at which the spring carries its weight."""
    mass, start = 0.8, 0.45
    entity = AnchoredSpring(spring=SPRING, block=Block(mass=mass), support=support, start=start)
    found = Followed(scene({"it": entity}), 2.0)
    middle = 0.4 + {"wall": 0.0, "ceiling": 1.0, "floor": -1.0}[support] * mass * G / K
    stretched = middle + (start - middle) * np.cos(sqrt(K / mass) * found.times)
    close(found.q("it.block.slide") * (-1.0 if support == "ceiling" else 1.0), stretched - start)
    close(found.tension("it.spring"), K * (stretched - 0.4))


def test_a_hanging_block_on_the_other_end_of_the_string() -> None:
    """While the string is taut, both oscillate with ω² = k/(m + M) about k x = M g; T = M (g − x″)."""
    mass, load = 0.8, 0.5
    entities = {
        "it": AnchoredSpring(spring=SPRING, block=Block(mass=mass), support="wall", start=0.44),
        "load": MassWithFixedPulley(system=Hanging(blocks=(Block(mass=load),)), pulley=FixedPulley()),
    }
    found = Followed(scene(entities, string("it.end", "load.tail")), 2.0)
    omega, middle = sqrt(K / (mass + load)), 0.4 + load * G / K
    length = middle + (0.44 - middle) * np.cos(omega * found.times)
    close(found.q("it.block.slide"), length - 0.44)
    close(found.tension("tendon_1"), load * (G + omega**2 * (length - middle)))


def test_a_winch_stretches_a_spring() -> None:
    """The block moves with u, so the winch pulls with k (ℓ + u t − ℓ₀)."""
    speed, start = 0.2, 0.41
    entities = {
        "it": AnchoredSpring(spring=SPRING, block=Block(mass=1.0), support="wall", start=start),
        "winch": ConstantVelocityPuller(speed=speed),
    }
    found = Followed(scene(entities, string("it.end", "winch.end")), 1.0)
    close(found.tension("tendon_1"), K * (start + speed * found.times - 0.4))


def test_a_pull_up_the_slope() -> None:
    """On a smooth incline, the block oscillates with ω² = k/m about k x = F − m g sin θ."""
    mass, force, start, slope = 1.0, 9.0, 0.35, radians(30.0)
    entities = {
        "it": SpringMassIncline(
            plane=Plane(angle=30.0, friction=0.0), block=Block(mass=mass), spring=SPRING, start=start
        ),
        "hand": ConstantForcePuller(force=force),
    }
    found = Followed(scene(entities, string("it.right", "hand.end")), 0.9)
    middle = 0.4 + (force - mass * G * sin(slope)) / K
    close(found.q("it.block.slide"), (middle - start) * (1.0 - np.cos(sqrt(K / mass) * found.times)))


def test_friction_takes_a_like_share_of_every_swing() -> None:
    """On a rough level plane each half swing takes π/ω and ends 2 µ m g/k nearer, until the spring is too weak."""
    mass, friction, start = 1.0, 0.3, 0.56
    entity = SpringMassIncline(
        plane=Plane(angle=0.0, friction=friction), block=Block(mass=mass), spring=SPRING, start=start
    )
    found = Followed(scene({"it": entity}), 2.0)
    stops = [time for kind, _, time in found.events() if kind in ("stick", "slip")]
    close(stops, [(number + 1) * pi / sqrt(K / mass) for number in range(len(stops))])
    lost, begun = 2.0 * friction * mass * G / K, start - 0.4
    halves = len(stops)
    assert abs(begun - halves * lost) <= lost / 2.0 < abs(begun - (halves - 1) * lost)
    close(found.q("it.block.slide")[-1], 0.4 + (-1) ** halves * (begun - halves * lost) - start)


def test_a_rod_on_a_carriage_keeps_energy_and_momentum() -> None:
    """Conservation laws give the motion of a pendulum hinged to a carriage.

    ½ m ℓ² θ′² (1 − m cos²θ/(M + m)) = m g ℓ (cos θ − cos θ₀), and (M + m) X′ + m ℓ cos θ θ′ = 0.
    """
    ball, cart, length, start = 0.4, 1.5, 0.6, radians(130.0)
    entities = {
        "cart": SliderMass(carriage=Carriage(mass=cart)),
        "it": LightRodPendulum(bob=Ball(mass=ball), rod=LightRod(length=length), angle=130.0),
    }
    found = Followed(scene(entities, pivot("cart.pivot", "it.base")), 2.0)
    angle, rate = start - found.q("it.bob.hinge"), found.v("it.bob.hinge")
    kinetic = 0.5 * ball * length**2 * rate**2 * (1.0 - ball * np.cos(angle) ** 2 / (cart + ball))
    close(kinetic, ball * G * length * (np.cos(angle) - cos(start)))
    momentum = (cart + ball) * found.v("cart.carriage.slide") - ball * length * np.cos(angle) * rate
    close(momentum, 0.0, ball * length * float(np.abs(rate).max()))


def test_a_carriage_that_a_winch_draws_along() -> None:
    """The carriage has constant velocity, so the ball swings as from a fixed point after an initial jerk.

    At t = 0 the hinge begins to move with u to the right; the ball keeps its velocity along the arc, so that
    ℓ θ′ = −u cos θ₀ relative to the hinge. The string pulls with what the rod takes, T = m (g cos θ + ℓ θ′²) |sin θ|.
    """
    ball, length, speed, start = 0.4, 0.6, 0.5, radians(-40.0)
    entities = {
        "cart": SliderMass(carriage=Carriage(mass=1.5)),
        "it": LightRodPendulum(bob=Ball(mass=ball), rod=LightRod(length=length), angle=40.0, side="left"),
        "winch": ConstantVelocityPuller(speed=speed),
    }
    made = scene(entities, pivot("cart.pivot", "it.base"), string("cart.right", "winch.end"))
    found = Followed(made, 0.35)
    angle, rate = start - found.q("it.bob.hinge")[1:], -found.v("it.bob.hinge")[1:]
    close(found.v("cart.carriage.slide")[1:], speed)
    energy = 0.5 * (length * rate) ** 2 - G * length * np.cos(angle)
    close(energy, 0.5 * (speed * cos(start)) ** 2 - G * length * cos(start))
    close(found.tension("tendon_2")[1:], ball * (G * np.cos(angle) + length * rate**2) * np.sin(-angle))


def test_a_rod_that_is_welded_to_a_carriage_can_not_be_launched() -> None:
    entities = {
        "cart": SliderMass(carriage=Carriage(mass=1.5)),
        "it": LightRodPendulum(bob=Ball(mass=0.4), rod=LightRod(length=0.6), angle=40.0, speed=1.0),
    }
    weld = Weld(links=(Link(entity="cart", port="pivot"), Link(entity="it", port="base")))
    with pytest.raises(SceneError, match="it is welded"):
        scene(entities, weld).check()

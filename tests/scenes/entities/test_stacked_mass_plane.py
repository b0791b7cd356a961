"""Tests of slabs that slide on each other, against solutions of Newton's laws."""

from math import cos, radians, sin

import pytest

from joined_entities import Followed, close, scene, string
from sim2reason.errors import SceneError
from sim2reason.scenes.bodies.blocks import Block, Slab
from sim2reason.scenes.bodies.simple_machines import FixedPulley, Plane
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley
from sim2reason.scenes.entities.stacked_mass_plane import StackedMassPlane
from sim2reason.scenes.entities.string_ends import ConstantForcePuller, Hanging

G = 9.8
FLOOR = Plane(angle=0.0, friction=0.0)


def stack(plane: Plane = FLOOR, friction: float = 0.3, speed: float | None = None) -> StackedMassPlane:
    return StackedMassPlane(plane=plane, lower=Slab(mass=4.0), upper=Slab(mass=1.5), friction=friction, speed=speed)


def three(plane: Plane, frictions: tuple[float, float]) -> StackedMassPlane:
    return StackedMassPlane(
        plane=plane,
        lower=Slab(mass=3.0),
        upper=Slab(mass=2.0),
        top=Slab(mass=1.0),
        friction=frictions[0],
        top_friction=frictions[1],
    )


def drawn(entity: StackedMassPlane, port: str, force: float) -> Scene:
    return scene({"it": entity, "hand": ConstantForcePuller(force=force)}, string(f"it.{port}", "hand.end"))


def test_a_launched_slab_takes_the_other_along() -> None:
    """Both slabs have the velocity m v/(m + M) from t = v M/(µ g (M + m)) on; until then friction is µ m g."""
    friction, speed, lower, upper = 0.3, 2.0, 4.0, 1.5
    found = Followed(scene({"it": stack(speed=speed)}), 2.0)
    together = speed * lower / (friction * G * (lower + upper))
    ((kind, subjects, time),) = found.events()
    assert (kind, subjects) == ("stick", ("it.upper",))
    close(time, together)
    close(found.v("it.lower.slide")[-1], upper * speed / (lower + upper))
    close(found.v("it.upper.slide")[-1], 0.0, speed)
    close(found.a("it.lower.slide")[0], friction * upper * G / lower)
    close(found.a("it.upper.slide")[0], -friction * G * (1.0 + upper / lower))


@pytest.mark.parametrize("factor", [1.0 - 1e-6, 1.0 + 1e-6])
def test_the_upper_slab_slips_off_a_lower_one_that_is_drawn_too_hard(factor: float) -> None:
    """Friction accelerates the upper slab by at most µ g, so the greatest force without slip is µ (M + m) g."""
    friction, lower, upper = 0.3, 4.0, 1.5
    force = factor * friction * (lower + upper) * G
    found = Followed(drawn(stack(), "lower_right", force), 0.5)
    if factor < 1.0:
        close(found.a("it.lower.slide"), force / (lower + upper))
        close(found.v("it.upper.slide"), 0.0, 1.0)
    else:
        close(found.a("it.lower.slide"), (force - friction * upper * G) / lower)
        close(found.a("it.upper.slide"), friction * G - (force - friction * upper * G) / lower, G)


def test_drawn_at_the_upper_slab_the_lower_one_follows_by_friction() -> None:
    """A force F = 2 µ m g (1 + m/M), twice that without slip, gives A = µ m g/M, a = (F − µ m g)/m."""
    friction, lower, upper = 0.3, 4.0, 1.5
    force = 2.0 * friction * upper * G * (1.0 + upper / lower)
    found = Followed(drawn(stack(), "upper_left", force), 0.5)
    close(found.a("it.lower.slide"), -friction * upper * G / lower)
    close(found.a("it.upper.slide"), -(force - friction * upper * G) / upper + friction * upper * G / lower)


def test_each_face_of_three_has_its_own_friction() -> None:
    """With µ₀ = 0.2, µ₁ = 0.1, µ₂ = 0.4 on a slope of 30°, the top two slabs slide as one on the lower slab.

    Both: a = g (sin θ − µ₁ cos θ); lower: a = g sin θ + (µ₁ (m₁ + m₂) − µ₀ (m₀ + m₁ + m₂)) g cos θ/m₀.
    """
    angle = radians(30.0)
    found = Followed(scene({"it": three(Plane(angle=30.0, friction=0.2), (0.1, 0.4))}), 1.0)
    upper = -G * (sin(angle) - 0.1 * cos(angle))
    lower = -G * (sin(angle) + (0.1 * 3.0 - 0.2 * 6.0) * cos(angle) / 3.0)
    close(found.a("it.lower.slide"), lower)
    close(found.a("it.upper.slide"), upper - lower)
    close(found.v("it.top.slide"), 0.0, 1.0)
    close(found.trace.state.friction["it.top"], 1.0 * (upper + G * sin(angle)), G)


def test_a_string_from_the_upper_slab_to_a_hanging_block() -> None:
    """The lower slab stays at rest on rough ground: (M + m) a = M g − µ m g, T = M (g − a)."""
    friction, upper, load = 0.3, 1.5, 2.5
    entity = stack(Plane(angle=0.0, friction=0.6), friction)
    hanging = MassWithFixedPulley(system=Hanging(blocks=(Block(mass=load),)), pulley=FixedPulley())
    found = Followed(scene({"it": entity, "load": hanging}, string("it.upper_right", "load.tail")), 0.5)
    acceleration = (load - friction * upper) * G / (load + upper)
    close(found.a("it.upper.slide"), acceleration)
    close(found.v("it.lower.slide"), 0.0, 1.0)
    close(found.tension("tendon_1"), load * (G - acceleration))


def test_a_third_slab_and_its_friction_come_together() -> None:
    with pytest.raises(ValueError, match="top, top_friction"):
        StackedMassPlane(plane=FLOOR, lower=Slab(mass=4.0), upper=Slab(mass=1.5), friction=0.3, top_friction=0.3)


def test_a_string_at_a_slab_that_is_not_there_is_refused() -> None:
    with pytest.raises(SceneError, match="nothing at its port 'top_left'"):
        drawn(stack(), "top_left", 2.0).check()

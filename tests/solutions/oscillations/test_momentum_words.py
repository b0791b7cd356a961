"""Tests of the conservation of momentum, of reduced and effective masses, and of power at any velocity."""

import re
from math import cos, radians

import pytest

from plain_scenes import row
from sim2reason.questions import Query, Target
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import Prism
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.slopes import MassPrismPlane
from sim2reason.scenes.entities.spring_chains import SpringMassRing
from sim2reason.solutions import STRATEGIES, Solution, solve_with
from worked import asked, solution_text

M, ONE, TWO, LEFT, RIGHT = 1.3, 1.8, 1.6, 31.0, 24.0


def solved(scene: Scene, query: Query, strategy: str) -> Solution:
    found = solve_with(STRATEGIES[strategy], asked(scene, query))
    assert found.answer is not None, found.reason
    return found


def lone(entity: Entity) -> Scene:
    return Scene(entities=(Named(name="it", entity=entity),))


def prism() -> Solution:
    """Return the solution by momentum for the kinetic energy of a block on a freely sliding prism."""
    blocks = (Block(mass=ONE),), (Block(mass=TWO),)
    solid = Prism(mass=M, left=LEFT, right=RIGHT)
    scene = lone(MassPrismPlane(prism=solid, left_blocks=blocks[0], right_blocks=blocks[1]))
    bodies = [body.name for body in scene.mechanism.bodies if body.mass]
    carrier = next(body.parent for body in scene.mechanism.bodies if body.parent is not None)
    riding = next(name for name in bodies if name != carrier)
    assert carrier is not None
    return solved(scene, Query("event", Target("kinetic energy", riding), Moved(carrier, 0.4)), "momentum")


def test_of_a_prism_only_the_horizontal_momentum_is_conserved() -> None:
    text = prism().text
    assert "The total horizontal momentum is zero, so the common centre of mass does not move horizontally." in text
    assert r"The total horizontal momentum is conserved; with the velocity $v_M$ of the prism" in text
    assert "Momentum is conserved" not in text
    assert "centre of mass stays at rest" not in text


def test_the_effective_mass_of_blocks_on_a_prism_follows_from_the_recoil() -> None:
    """T = ½ (m + m′) u² − ½ (Σ m cos)² u²/M; the mass isn't called reduced, a term for two bodies on one line."""
    found = prism()
    part = ONE * cos(radians(LEFT)) + TWO * cos(radians(RIGHT))
    assert found.values[r"\mu"] == pytest.approx(ONE + TWO - part**2 / (M + ONE + TWO), rel=1e-9)
    assert "the total kinetic energy is" in found.text
    assert "reduced" not in found.text


def test_along_a_level_track_momentum_and_the_reduced_mass_are_those_of_every_textbook() -> None:
    scene = row((1.2, 3.0), (60.0,), "free", strain=0.1)
    one, other = (body.name for body in scene.mechanism.bodies if body.mass)
    found = solved(scene, Query("event", Target("acceleration", one), Moved(other, 0.02)), "momentum")
    assert "The total momentum along the track is zero, so the common centre of mass stays at rest." in found.text
    assert r"the relative motion has the reduced mass $\mu = \frac{m_A m_B}{" in found.text


def test_an_acceleration_at_a_place_follows_from_the_power_at_any_velocity() -> None:
    """The text doesn't divide by a speed that may be zero, and states the extension of the spring."""
    scene = row((1.2, 3.0), (60.0,), "free", strain=0.1)
    one, other = (body.name for body in scene.mechanism.bodies if body.mass)
    found = solved(scene, Query("event", Target("acceleration", one), Moved(other, 0.02)), "momentum")
    assert "Dividing" not in found.text
    assert re.search(r"The extension of the spring is \$d [+-] x\$\.", found.text)
    assert r"the kinetic energy $\tfrac{1}{2} \mu \dot{x}^{2}$ changes at the rate $\mu \dot{x} a$" in found.text


def test_beads_on_a_ring_keep_their_angular_momentum() -> None:
    beads, springs = ({"mass": 0.5}, {"mass": 1.1}), ({"stiffness": 60.0}, {"stiffness": 90.0})
    entity = SpringMassRing.model_validate({"radius": 1.2, "beads": beads, "springs": springs, "strain": {"by": 0.15}})
    scene = lone(entity)
    bead = next(body.name for body in scene.mechanism.bodies if body.mass)
    found = solved(scene, Query("state", Target("velocity", bead), AtTime(0.2)), "oscillation")
    assert "The angular momentum about the centre of the circle is conserved" in found.text
    assert "omentum is conserved" not in found.text.replace("The angular momentum about the centre", "")


def test_the_kinetic_energy_of_the_only_body_is_the_work_itself() -> None:
    """No velocity is computed on the way."""
    scene = row((1.2,), (60.0,), "right", strain=0.1)
    cart = next(body.name for body in scene.mechanism.bodies if body.mass)
    found = solved(scene, Query("event", Target("kinetic energy", cart), Moved(cart, 0.04)), "energy")
    assert found.answer == pytest.approx(30.0 * (0.1**2 - 0.06**2), rel=1e-9)
    assert "By the work-energy theorem, the kinetic energy of the " in found.text
    assert "velocity" not in found.text


def test_a_shared_velocity_has_a_direction() -> None:
    text = solution_text("box-easy-multipart-301926-0")
    assert "with the velocity $v_M$ of the prism to the right: " in text


def test_a_centre_of_mass_that_stays_was_at_rest() -> None:
    text = solution_text("box-easy-reverse-301928-0")
    assert "has a component to the left, and they start from rest, so their centre of mass does not move" in text

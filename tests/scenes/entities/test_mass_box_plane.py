"""Tests of a sliding box with blocks on it, against solutions of Lagrange's equations."""

import pytest

from joined_entities import Followed, close, scene, string
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import Box
from sim2reason.scenes.entities.slopes import MassBoxPlane
from sim2reason.scenes.entities.string_ends import ConstantForcePuller

G, BOX, TOP, SIDE = 9.8, 1.6, 0.7, 0.3


def box(friction: float = 0.0, left: float | None = None) -> MassBoxPlane:
    return MassBoxPlane(
        box=Box(mass=BOX, friction=friction),
        blocks=(Block(mass=TOP),),
        right=Block(mass=SIDE),
        left=Block(mass=left) if left is not None else None,
    )


def test_the_box_recoils() -> None:
    """The accelerations solve (M + m₁ + m₂) X″ + m₁ s″ = 0 and m₁ X″ + (m₁ + m₂) s″ = m₂ g.

    s is the displacement along the string.
    """
    found = Followed(scene({"it": box()}), 1.0)
    whole = BOX + TOP + SIDE
    along = SIDE * G / (TOP + SIDE - TOP**2 / whole)
    close(found.a("it.blocks.0.right"), along)
    close(found.a("it.right.slide"), -along)
    close(found.a("it.box.slide"), -TOP * along / whole)
    close(found.tension("it.right_rope"), SIDE * (G - along))


def test_a_force_on_the_box_holds_the_blocks_where_they_are() -> None:
    """The force is F = (M + m₁ + m₂) g m₂/m₁.

    The string pulls with m₂ g, which gives the upper block the box's acceleration.
    """
    force = (BOX + TOP + SIDE) * G * SIDE / TOP
    entities = {"it": box(), "hand": ConstantForcePuller(force=force)}
    found = Followed(scene(entities, string("it.right_end", "hand.end")), 0.6)
    close(found.v("it.blocks.0.right"), 0.0, 1.0)
    close(found.v("it.right.slide"), 0.0, 1.0)
    close(found.a("it.box.slide"), G * SIDE / TOP)
    close(found.tension("it.right_rope"), SIDE * G)


@pytest.mark.parametrize("factor", [1.0 - 1e-6, 1.0 + 1e-6])
def test_the_upper_block_stays_if_friction_can_hold_the_other(factor: float) -> None:
    """The block slips if m₂ g > µ m₁ g; otherwise the forces of guide and string on the box cancel."""
    friction = SIDE / TOP / factor
    found = Followed(scene({"it": box(friction)}), 1.0)
    if factor < 1.0:
        close(found.v("it.blocks.0.right"), 0.0, 1.0)
        close(found.v("it.box.slide"), 0.0, 1.0)
        close(found.tension("it.right_rope"), SIDE * G)
    else:
        assert found.v("it.blocks.0.right")[-1] > 0.0


def test_two_sides_make_an_atwood_machine() -> None:
    """The equation for s is (m₁ + m₂ + m₃) s″ + m₁ X″ = (m₂ − m₃) g.

    m₁ slides to the right and m₃ hangs on the left.
    """
    left = 0.2
    found = Followed(scene({"it": box(left=left)}), 1.0)
    whole = BOX + TOP + SIDE + left
    along = (SIDE - left) * G / (TOP + SIDE + left - TOP**2 / whole)
    close(found.a("it.blocks.0.right"), along)
    close(found.a("it.left.slide"), along)
    close(found.a("it.box.slide"), -TOP * along / whole)
    close(found.tension("it.left_rope"), left * (G + along))

"""Tests that halving and doubling a number shows whether it matters."""

import pytest

from sim2reason.generation.recipes.ranges import MIN_RESPONSE_CHANGE, idle_numbers
from sim2reason.scenes.bodies.round_bodies import Sphere
from sim2reason.scenes.entities.pieces import RoundPiece


def inertia(piece: RoundPiece) -> tuple[float]:
    """Return the moment of inertia per mass, 2/5 r² + d²."""
    return (0.4 * piece.body.radius**2 + piece.distance**2,)


@pytest.mark.parametrize("radius", [0.05, 0.15, 0.2, 0.3, 0.5])
def test_a_radius_bears_where_doubling_it_counts(radius: float) -> None:
    """A doubled radius adds 1.2 r² to 0.4 r² + d²; a mass that cancels never matters, a distance does."""
    piece = RoundPiece(body=Sphere(mass=2.0, radius=radius), distance=0.6)
    bears = 1.2 * radius**2 > MIN_RESPONSE_CHANGE * (0.4 * radius**2 + 0.36)
    assert set(idle_numbers(piece, inertia)) == {"body.mass", *([] if bears else ["body.radius"])}

"""Tests of moments of inertia about an axle: the source of each number, and the bodies taken as point masses."""

from math import cos, pi, radians

import pytest

from sim2reason.questions import Query, Target
from sim2reason.questions.moments.times import AtStart
from sim2reason.scenes.bodies.blocks import PolygonalPrism
from sim2reason.scenes.bodies.eccentric_bodies import Hemisphere
from sim2reason.scenes.bodies.oscillators import FixedBall, UniformRod
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import RotationEntity
from sim2reason.scenes.entities.pieces import AxialPiece, BallPiece, CappedPiece, TiltedPiece, WeldedPiece
from sim2reason.solutions import Solution
from worked import derived

G, DISTANCE, MASS, RADIUS, ANGLE = 9.8, 0.13, 7.6, 0.1, 74.0


def released(*pieces: WeldedPiece) -> Solution:
    """Return the solution for the angular acceleration of an arm just after its release."""
    scene = Scene(entities=(Named(name="arm", entity=RotationEntity(pieces=pieces, angle=ANGLE)),))
    body = next(body.name for body in scene.mechanism.bodies if body.mass)
    return derived(scene, Query("start", Target("acceleration", body), AtStart()))


def inertia(found: Solution) -> float:
    return next(value for name, value in found.values.items() if name.startswith("I_{0") or name == "I_0")


def test_the_number_of_a_pentagonal_prism_is_that_of_any_regular_one() -> None:
    prism = PolygonalPrism(mass=MASS, shape="pentagonal", radius=RADIUS, height=0.31)
    found = released(AxialPiece(body=prism, axis="at right angles to both arm and axle", distance=DISTANCE))
    square = (2.0 + cos(2.0 * pi / 5.0)) / 12.0 * RADIUS**2
    assert inertia(found) == pytest.approx(MASS * (square + 0.31**2 / 12.0), rel=1e-9)
    assert r"\cos\left(\frac{2\,\pi}{5}\right)" in found.text
    assert "here $n = 5$. The height adds" in found.text


def test_a_hemisphere_is_told_by_whole_fractions_and_from_where_it_is_counted() -> None:
    body = Hemisphere(mass=MASS, radius=RADIUS)
    found = released(CappedPiece(body=body, faces="away from the axle", distance=0.17))
    assert inertia(found) == pytest.approx(83.0 / 320.0 * MASS * RADIUS**2, rel=1e-9)
    assert r"\left(\tfrac{2}{5} - \left(\tfrac{3}{8}\right)^{2}\right)" in found.text
    assert "from the centre of its flat face is" in found.text


def test_of_a_tilted_rod_its_extension_across_the_axle_counts_and_a_ball_is_a_point_mass() -> None:
    rod = TiltedPiece(body=UniformRod(mass=MASS, length=1.2), tilt=51.0, distance=0.3)
    found = released(rod, BallPiece(body=FixedBall(mass=1.4), distance=0.36, side="on the other side"))
    assert inertia(found) == pytest.approx(MASS * 1.2**2 * cos(radians(51.0)) ** 2 / 12.0, rel=1e-9)
    assert (
        r"Only the extension of the rod perpendicular to the axle matters, its length times $\cos\beta$." in found.text
    )
    assert "By the parallel-axis theorem, with ball B as a point mass," in found.text

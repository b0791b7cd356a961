"""Tests of rigid bodies' volume, centroid and inertia, against point clouds and textbook values."""

from math import pi

import numpy as np
import pytest

from quadrature import CLOUDS, moments
from sim2reason.scenes.bodies.blocks import PolygonalPrism
from sim2reason.scenes.bodies.eccentric_bodies import Hemisphere, SphericalCap
from sim2reason.scenes.bodies.oscillators import Bar, FixedBall, UniformRod
from sim2reason.scenes.bodies.round_bodies import Cylinder, Disc, HollowSphere, Hoop, Sphere, SphericalShell
from sim2reason.scenes.dsl.body import BODIES
from sim2reason.scenes.dsl.model import draw
from sim2reason.scenes.dsl.solids import TENSOR_INDICES, Shape

SHAPES = [cls for cls in BODIES.values() if issubclass(cls, Shape)]
CLOSE = 1e-10
DRAWS = 6


def test_each_shape_is_summed_over_points_here() -> None:
    sized = {cls for cls in SHAPES if cls.__module__.startswith("sim2reason.") and cls is not FixedBall}
    assert sized == set(CLOUDS)


@pytest.mark.parametrize("cls", list(CLOUDS), ids=lambda cls: cls.__name__)
def test_size_centroid_and_second_moments_are_those_of_its_points(cls: type[Shape]) -> None:
    """An independent integration, in coordinates fitted to the shape, agrees to 1e-10 of its size and extent."""
    for seed in range(DRAWS):
        body = draw(cls, np.random.default_rng(seed), {})
        size, center, second = moments(CLOUDS[cls](body))
        found, extent = body.solid, max(body.reach((0.0, 0.0, 1.0)), body.reach((1.0, 0.0, 0.0)))
        assert found.size == pytest.approx(size, rel=CLOSE)
        assert found.center == pytest.approx(center.tolist(), abs=CLOSE * extent)
        wanted = [float(second[i, j]) for i, j in TENSOR_INDICES]
        assert found.second == pytest.approx(wanted, abs=CLOSE * size * extent**2)


@pytest.mark.parametrize("cls", list(CLOUDS), ids=lambda cls: cls.__name__)
def test_it_reaches_as_far_as_its_points_and_no_farther(cls: type[Shape]) -> None:
    """The extent in any direction bounds all points; for prisms it is that of the circumscribed cylinder."""
    for seed in range(DRAWS):
        rng = np.random.default_rng(seed)
        body = draw(cls, rng, {})
        points, _ = CLOUDS[cls](body)
        way = rng.normal(size=3)
        way /= np.linalg.norm(way)
        assert (points @ way).max() <= body.reach((float(way[0]), float(way[1]), float(way[2]))) + 1e-12


def about(body: Shape, axis: int) -> float:
    """Return I/m for one of the body's own axes through its centre of mass."""
    return body.solid.inertia(body.mass)[axis] / body.mass


def test_the_moments_of_textbooks() -> None:
    """Moments of inertia agree with Halliday, Resnick and Walker, Fundamentals of Physics, table 10-2.

    The value 83/320 mr² for a hemisphere is about its centre of mass.
    """
    m, r, h = 3.0, 0.2, 0.5
    assert about(Sphere(mass=m, radius=r), 0) == pytest.approx(2 / 5 * r**2)
    assert about(SphericalShell(mass=m, radius=r), 0) == pytest.approx(2 / 3 * r**2)
    assert about(Cylinder(mass=m, radius=r, height=h), 2) == pytest.approx(r**2 / 2)
    assert about(Cylinder(mass=m, radius=r, height=h), 0) == pytest.approx(r**2 / 4 + h**2 / 12)
    assert about(Disc(mass=m, radius=r), 0) == pytest.approx(r**2 / 4)
    assert about(Hoop(mass=m, radius=r), 2) == pytest.approx(r**2)
    assert about(Hoop(mass=m, radius=r), 0) == pytest.approx(r**2 / 2)
    assert about(UniformRod(mass=m, length=h), 0) == pytest.approx(h**2 / 12)
    assert about(Bar(mass=m, length=h, width=r, thickness=0.1), 1) == pytest.approx((h**2 + r**2) / 12)
    assert about(Hemisphere(mass=m, radius=r), 2) == pytest.approx(2 / 5 * r**2)
    assert about(Hemisphere(mass=m, radius=r), 0) == pytest.approx(83 / 320 * r**2)
    assert Hemisphere(mass=m, radius=r).solid.center[2] == pytest.approx(3 / 8 * r)
    assert about(PolygonalPrism(mass=m, shape="hexagonal", radius=r, height=h), 2) == pytest.approx(5 / 12 * r**2)


def test_limits_of_cut_outs() -> None:
    """A cap as high as its radius is a hemisphere; a thin-walled sphere has the moment of a spherical shell."""
    cap, half = SphericalCap(mass=1.0, radius=0.2, height=0.2), Hemisphere(mass=1.0, radius=0.2)
    assert cap.solid.second == pytest.approx(half.solid.second)
    assert cap.solid.size == pytest.approx(2 / 3 * pi * 0.2**3)
    assert about(HollowSphere(mass=1.0, radius=0.2, thickness=1e-5), 0) == pytest.approx(2 / 3 * 0.2**2, rel=1e-4)


@pytest.mark.parametrize(
    ("cls", "fields", "says"),
    [
        ("Bowl", {"radius": 0.1, "height": 0.05, "thickness": 0.06}, "as thick as the bowl"),
        ("Bowl", {"radius": 0.1, "height": 0.195, "thickness": 0.01}, "no opening"),
        ("SphericalCap", {"radius": 0.1, "height": 0.2}, "nothing is cut off"),
        ("HollowSphere", {"radius": 0.1, "thickness": 0.1}, "thicker than the sphere"),
        ("SphereWithHole", {"radius": 0.1, "hole": 0.06, "offset": 0.05}, "breaks through"),
        ("BoredCylinder", {"radius": 0.1, "hole": 0.06, "offset": 0.05}, "breaks through"),
        ("ThickPipe", {"radius": 0.1, "bore": 0.1}, "not less than the outer"),
        ("HollowSphereWithHole", {"radius": 0.1, "thickness": 0.01, "hole": 0.02, "offset": 0.05}, "through the wall"),
    ],
)
def test_what_can_not_be_made_is_refused(cls: str, fields: dict[str, float], says: str) -> None:
    with pytest.raises(ValueError, match=says):
        BODIES[cls](mass=1.0, **fields)  # type: ignore[call-arg]

"""Tests of slips about the distribution of mass, friction and angles, against results by hand."""

from math import cos, radians, sin

import numpy as np
import pytest

from plain_scenes import G, arm, massive, ramp
from sim2reason.questions import Query, SimulatedScene, Target
from sim2reason.questions.simplifications import MISCONCEPTIONS
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.eccentric_bodies import BoredCylinder, Hemisphere, SphereWithHole
from sim2reason.scenes.bodies.oscillators import Bar
from sim2reason.scenes.bodies.round_bodies import Cylinder, HollowSphere, Sphere, ThickPipe
from sim2reason.scenes.bodies.simple_machines import Incline, Plane
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.solids import Shape
from sim2reason.scenes.entities.pendulums import RotationEntity
from sim2reason.scenes.entities.pieces import AxialPiece, BarPiece, CappedPiece, RoundPiece, WeldedPiece
from sim2reason.scenes.entities.rolling import Hole, NoSlipping, RollingEntity
from sim2reason.scenes.entities.slopes import TwoSideMassPlane

ROLLER = "roller.body"
R, HOLE, OFFSET = 0.2, 0.1, 0.06  # m


def at_once(name: str, scene: Scene, quantity: str, subject: str, about: str | None = None) -> float:
    """Return the magnitude of a quantity just after the start, with a slip."""
    study, slip = SimulatedScene.of(scene, np.linspace(0.0, 0.1, 11)), MISCONCEPTIONS[name]
    subjects = list(slip.subjects(Query("state", Target(quantity, subject)), study))
    assert about is None or about in subjects
    found = slip.simplified(study, about if about is not None else subjects[0], 0.1)
    assert found is not None
    return Target(quantity, subject).value(found.trace.sample(np.zeros(1)))


def subjects(name: str, scene: Scene) -> list[str]:
    study = SimulatedScene.of(scene, np.linspace(0.0, 0.1, 3))
    return list(MISCONCEPTIONS[name].subjects(Query("state", None), study))


def rolling(body: Shape, angle: float = 0.0, hole: Hole | None = None) -> Scene:
    """Build a round body that rolls without slipping from rest on a plane."""
    entity = RollingEntity(body=body, plane=Incline(angle=angle), hole=hole, grip=NoSlipping())  # type: ignore[arg-type]
    return Scene(entities=(Named(name="roller", entity=entity),))


def level(body: Shape) -> Scene:
    """Build a body on a level plane, with the hole beside its axis."""
    return rolling(body, hole=Hole(bearing=90.0, towards="right"))


def swinging(*pieces: WeldedPiece) -> Scene:
    """Build pieces on a light arm that is released from the horizontal."""
    return Scene(entities=(Named(name="arm", entity=RotationEntity(pieces=pieces, angle=90.0)),))


HOLES = [  # share of the body that is cut away, its I/m R² without the hole
    (BoredCylinder(mass=2.0, radius=R, hole=HOLE, offset=OFFSET), (HOLE / R) ** 2, 0.5),
    (SphereWithHole(mass=2.0, radius=R, hole=HOLE, offset=OFFSET), (HOLE / R) ** 3, 0.4),
]


@pytest.mark.parametrize(("body", "cut", "k"), HOLES)
def test_a_hole_that_is_forgotten_in_the_inertia(body: Shape, cut: float, k: float) -> None:
    """The centre of mass is c = d s/(1 - s) from the axis, s the share cut away; α = g c/(I/m + R² + c²)."""
    c = OFFSET * cut / (1.0 - cut)
    found = at_once("hole left out of the inertia", level(body), "angular acceleration", ROLLER)
    assert found == pytest.approx(G * c / ((k + 1.0) * R**2 + c**2))
    about_center = at_once("hole left out of the inertia about the centre", level(body), "angular acceleration", ROLLER)
    assert about_center == pytest.approx(G * c / ((k + 1.0) * R**2))
    assert at_once("hole left out", level(body), "angular acceleration", ROLLER) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("body", "k"),
    [(HollowSphere(mass=2.0, radius=R, thickness=0.08), 2.0 / 3.0), (ThickPipe(mass=2.0, radius=R, bore=0.1), 1.0)],
)
def test_a_wall_that_is_taken_as_thin(body: Shape, k: float) -> None:
    """The acceleration is a = g sin θ/(1 + k)."""
    found = at_once("wall taken as thin", rolling(body, 30.0), "acceleration", ROLLER)
    assert found == pytest.approx(0.5 * G / (1.0 + k))


def test_what_is_taken_as_a_thin_rod_or_a_thin_disc() -> None:
    """α = g d/(I/m + d²) for a cylinder across the arm or parallel to the axle, and for a bar along the arm."""
    cylinder = Cylinder(mass=2.0, radius=0.2, height=0.5)
    across = swinging(AxialPiece(body=cylinder, axis="at right angles to both arm and axle", distance=0.6))
    piece = "arm.pieces.0.body"
    for name, own in (("body taken as a thin rod", 0.5**2 / 12.0), ("body taken as a thin disc", 0.2**2 / 4.0)):
        assert at_once(name, across, "angular acceleration", piece) == pytest.approx(G * 0.6 / (own + 0.36))
    parallel = swinging(AxialPiece(body=cylinder, axis="parallel to the axle", distance=0.6))
    rod = at_once("body taken as a thin rod", parallel, "angular acceleration", piece)
    assert rod == pytest.approx(G / 0.6, rel=1e-6)
    bar = BarPiece(
        body=Bar(mass=1.0, length=0.8, width=0.3, thickness=0.1), distance=0.6, along="length", across="width"
    )
    found = at_once("body taken as a thin rod", swinging(bar), "angular acceleration", piece)
    assert found == pytest.approx(G * 0.6 / (0.8**2 / 12.0 + 0.36))


def test_a_centre_of_mass_that_is_taken_to_be_at_the_centre() -> None:
    """The centre of mass of a hemisphere is 3R/8 from its flat face, and I = (2/5 - 9/64) m R² about it."""
    piece = CappedPiece(body=Hemisphere(mass=2.0, radius=0.3), distance=0.6, faces="the axle")
    found = at_once("centre of mass not displaced", swinging(piece), "angular acceleration", "arm.pieces.0.body")
    assert found == pytest.approx(G * 0.6 / ((0.4 - 9.0 / 64.0) * 0.09 + 0.36))


def test_one_of_two_bodies_is_taken_as_a_point() -> None:
    """α = g Σ m d/Σ I, without 2/5 m R² for one of the two."""
    pieces = (
        RoundPiece(body=Sphere(mass=2.0, radius=0.2), distance=0.4),
        RoundPiece(body=Sphere(mass=1.0, radius=0.3), distance=1.0),
    )
    scene, name = swinging(*pieces), "arm.pieces.1.body"
    own = 2.0 * (0.4 * 0.04 + 0.16) + 1.0
    found = at_once("own inertia left out", scene, "angular acceleration", name, name)
    assert found == pytest.approx(G * 1.8 / own)
    assert not subjects("own inertia left out", arm()), "of a single one all are left out"


def test_the_parallel_axis_theorem_is_forgotten() -> None:
    """α = g Σ m d/Σ 2/5 m R² on an arm; a rolling body with a hole has the inertia about c about its axis."""
    pieces = (
        RoundPiece(body=Sphere(mass=2.0, radius=0.2), distance=0.4),
        RoundPiece(body=Sphere(mass=1.0, radius=0.3), distance=1.0),
    )
    piece = "arm.pieces.0.body"
    found = at_once("parallel axis forgotten", swinging(*pieces), "angular acceleration", piece)
    assert found == pytest.approx(G * 1.8 / (0.4 * (2.0 * 0.04 + 0.09)))
    body = BoredCylinder(mass=2.0, radius=R, hole=HOLE, offset=OFFSET)
    cut = (HOLE / R) ** 2
    c = OFFSET * cut / (1.0 - cut)
    own = 0.5 * R**2 * (1.0 + cut) - cut / (1.0 - cut) * OFFSET**2 - c**2  # about the centre of mass, over m
    rolls = at_once("parallel axis forgotten", level(body), "angular acceleration", ROLLER)
    assert rolls == pytest.approx(G * c / (own + R**2))
    assert not subjects("parallel axis forgotten", rolling(Sphere(mass=1.0, radius=0.1), 30.0))


def test_friction_under_one_of_two_blocks() -> None:
    """a = g(sin θ - μ cos θ m₂/(m₁ + m₂)) without the friction under the first block, the lower one."""
    entity = TwoSideMassPlane(plane=Plane(angle=30.0, friction=0.2), blocks=(Block(mass=1.0), Block(mass=3.0)))
    scene = Scene(entities=(Named(name="ramp", entity=entity),))
    found = at_once("friction on one body left out", scene, "acceleration", "ramp.blocks.0", "ramp.blocks.0")
    expected = G * (sin(radians(30.0)) - 0.2 * cos(radians(30.0)) * 3.0 / 4.0)
    assert found == pytest.approx(expected, rel=1e-6)
    assert not subjects("friction on one body left out", ramp(friction=0.2)), "of a single one all is left out"


def test_sine_for_cosine() -> None:
    assert at_once("sine for cosine", ramp(), "acceleration", "ramp.blocks.0") == pytest.approx(G * cos(radians(30.0)))


def test_a_fixed_pulley_alone_is_taken_as_light() -> None:
    """Only a movable pulley can have its weight counted without its rotation."""
    assert not subjects("pulley rotation left out", massive(2.0))
    assert not subjects("pulley rotations left out", massive(2.0))

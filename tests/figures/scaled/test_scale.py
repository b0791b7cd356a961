"""Tests that drawings to scale show the geometry of the mechanism: angles, ratios of lengths, sizes."""

from math import acos, asin, hypot, pi, sin, sqrt

import pytest

from figure_parts import LEANING, RodPendulum, Slider, scene_of
from sim2reason.figures.drawing import drawing
from sim2reason.figures.plane import Polygon, cross, degrees
from sim2reason.figures.shapes import Arc, Area, Drawing, LineShape
from sim2reason.scenes.bodies.blocks import Block, LongPrism, Puck, Slab, SlidingBall, Table
from sim2reason.scenes.bodies.oscillators import Ball, Cord, LightRod
from sim2reason.scenes.bodies.simple_machines import FixedPulley, Incline, Plane, Track
from sim2reason.scenes.dsl.body import Axial, Body, BodyLook, Capped, Rectangular, Silhouette, Spherical
from sim2reason.scenes.dsl.builder import Axes, Frame
from sim2reason.scenes.dsl.connection import CONNECTIONS, Link
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.mechanism import X, Y, Z
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.scenes.entities.pendulums import Pendulum
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley
from sim2reason.scenes.entities.rolling import TumblingPrism
from sim2reason.scenes.entities.slopes import TwoSideMassPlane
from sim2reason.scenes.entities.stacked_mass_plane import StackedMassPlane
from sim2reason.scenes.entities.string_ends import FixedSupport, Hanging
from sim2reason.scenes.entities.track_collisions import ComplexCollisionPlane
from sim2reason.scenes.entities.two_d_collision_plane import TwoDCollisionPlane


def texts(drawn: Drawing) -> set[str]:
    return {label.text for label in drawn.labels}


def area(polygon: Polygon) -> float:
    return 0.5 * abs(sum(cross(a, b) for a, b in zip(polygon, (*polygon[1:], polygon[0]), strict=True)))


@pytest.mark.parametrize("hanger", [Cord(length=1.5), LightRod(length=1.5)])
@pytest.mark.parametrize("angle", [12.0, 60.0, 120.0])
def test_a_pendulum_leans_as_it_is_said_to(hanger: Cord | LightRod, angle: float) -> None:
    drawn = drawing(scene_of(it=Pendulum(bob=Ball(mass=1.0), hanger=hanger, angle=angle, speed=2.0)))
    held = next(s for s in drawn.shapes if isinstance(s, LineShape) and s.weight in ("string", "rod"))
    bob = next(s for s in drawn.shapes if isinstance(s, Arc) and s.fill == "ball")
    top = max(held.points, key=lambda p: abs(p - bob.center))
    assert degrees((bob.center - top) / -1j) == pytest.approx(angle)
    assert {f"{angle:g}°", "1.5 m", "2.0 m/s", "ball"} == texts(drawn)


def test_a_projectile_shows_height_speed_and_angle_and_its_axes() -> None:
    drawn = drawing(scene_of(it=Projectile(ball=Ball(mass=1.0), height=3.0, speed=5.0, angle=40.0)))
    assert texts(drawn) == {"3.0 m", "5.0 m/s", "40°", "ball", "x", "y"}
    bob = next(s for s in drawn.shapes if isinstance(s, Arc) and s.fill == "ball")
    arrow = next(
        s for s in drawn.shapes if isinstance(s, LineShape) and s.arrow and abs(s.points[0] - bob.center) < 0.3
    )
    assert degrees(arrow.points[1] - arrow.points[0]) == pytest.approx(40.0)


def table(tilt: float = 0.0) -> TwoDCollisionPlane:
    pucks = (Puck(mass=1.0, x=-1.0, y=0.5, vx=1.0, vy=-2.0), Puck(mass=2.0, x=1.0, y=1.5, vx=0.1, vy=0.0))
    return TwoDCollisionPlane(table=Table(angle=tilt), radius=0.25, pucks=pucks, restitution=0.5)


@pytest.mark.parametrize("tilt", [0.0, 40.0])
def test_a_table_is_seen_from_above_with_places_sizes_and_velocities_to_scale(tilt: float) -> None:
    drawn = drawing(scene_of(it=table(tilt)))
    one, other = (s for s in drawn.shapes if isinstance(s, Arc) and s.whole)
    scale = abs(other.center - one.center) / hypot(2.0, 1.0)
    assert other.center - one.center == pytest.approx(scale * complex(2.0, 1.0))
    assert one.radius == pytest.approx(scale * 0.25)
    arrows = [s for s in drawn.shapes if isinstance(s, LineShape) and s.arrow]
    fast = next(a for a in arrows if abs(abs(a.points[0] - one.center) - one.radius) < 1e-9)
    slow = next(a for a in arrows if abs(abs(a.points[0] - other.center) - other.radius) < 1e-9)
    assert degrees(fast.points[1] - fast.points[0]) == pytest.approx(degrees(complex(1.0, -2.0)))
    assert abs(slow.points[1] - slow.points[0]) >= 0.4  # not shorter than its head
    legend = min(arrows, key=lambda a: a.points[1].imag)
    per_speed = abs(fast.points[1] - fast.points[0]) / sqrt(5.0)
    assert abs(legend.points[1] - legend.points[0]) == pytest.approx(2.0 * per_speed)
    assert "2 m/s" in texts(drawn)
    assert any("tilted at 40°" in text for text in texts(drawn)) == (tilt > 0.0)


def test_strings_run_from_an_arranged_machine_to_the_port_of_what_is_to_scale() -> None:
    machine = MassWithFixedPulley(system=Hanging(blocks=(Block(mass=1.0),)), pulley=FixedPulley())
    links = [(("s", "right"), ("m", "tail")), (("s", "pivot"), ("r", "top"))]
    string, pivot = (tuple(Link(entity=e, port=p) for e, p in ends) for ends in links)
    scene = scene_of(
        CONNECTIONS["tendon"](links=string),
        CONNECTIONS["pivot"](links=pivot),
        s=Slider(carriage=Block(mass=2.0)),
        r=RodPendulum(bob=Ball(mass=1.0), rod=LightRod(length=1.2)),
        m=machine,
    )
    drawn = drawing(scene)
    blocks = [s for s in drawn.shapes if isinstance(s, Area) and s.fill == "block"]
    strings = [s for s in drawn.shapes if isinstance(s, LineShape) and s.weight == "string"]
    assert len(blocks) == len(strings) == 2
    carriage = max(blocks, key=lambda b: b.points[0].imag)
    right = max(p.real for p in carriage.points)
    level = next(s for s in strings if abs((s.points[1] - s.points[0]).imag) < 1e-9)
    assert min(p.real for p in level.points) == pytest.approx(right)
    rod = next(
        s
        for s in drawn.shapes
        if isinstance(s, LineShape) and s.weight == "rod" and s.points[0].imag > s.points[1].imag
    )
    assert degrees((rod.points[1] - rod.points[0]) / -1j) == pytest.approx(LEANING * 180.0 / pi)


def test_a_spring_between_a_block_and_a_hook_is_a_coil_with_its_dashpot_beside_it() -> None:
    plane = TwoSideMassPlane(plane=Plane(angle=30.0, friction=0.0), blocks=(Block(mass=1.0),))
    links = (Link(entity="p", port="right"), Link(entity="h", port="end"))
    strokes = list[int]()
    for damping in (0.0, 2.0):
        spring = CONNECTIONS["spring"](links=links, stiffness=40.0, damping=damping)  # type: ignore[call-arg]
        drawn = drawing(scene_of(spring, p=plane, h=FixedSupport()))
        assert any(isinstance(s, LineShape) and len(s.points) > 6 for s in drawn.shapes)
        strokes.append(sum(isinstance(s, LineShape) for s in drawn.shapes))
    assert strokes[1] > strokes[0] + 4


class Shaped(Body):
    """Body with a look that the test chooses."""

    nouns = ("thing",)
    lone = ("a {noun}", "one {noun}")
    named = ("{noun} {letter}", "a {noun} {letter}")

    @property
    def look(self) -> BodyLook:
        """Return the look that the test has set."""
        return LOOKS[0]


LOOKS: list[BodyLook] = []
TURNED: list[Axes] = []


class Swinging(Entity):
    """Entity that hangs 1 m below an axle."""

    thing: Shaped

    says = ("{thing} swings.",)

    def build(self, room: Frame) -> None:
        """Build the body, welded to a light arm."""
        arm = room.body("arm").hinge(Y, 1.0)
        arm.body("thing", 1.0, at=(0.0, 0.0, -1.0)).turned(TURNED[0])


def shape(monkeypatch: pytest.MonkeyPatch, look: BodyLook, axes: Axes) -> list[Area | Arc]:
    monkeypatch.setitem(globals(), "LOOKS", [look])
    monkeypatch.setitem(globals(), "TURNED", [axes])
    drawn = drawing(scene_of(it=Swinging(thing=Shaped())))
    return [s for s in drawn.shapes if isinstance(s, Area | Arc) and s.fill == "block"]


UPRIGHT: Axes = (X, Y, Z)
SIDEWAYS: Axes = (Y, Z, X)  # z to the right
TOWARDS: Axes = (X, (0.0, 0.0, -1.0), Y)  # z away from the reader


def segment(r: float, h: float) -> float:
    """Return the area of a circular segment of height h."""
    return r**2 * acos((r - h) / r) - (r - h) * sqrt(h * (2.0 * r - h))


@pytest.mark.parametrize("axes", [UPRIGHT, SIDEWAYS])
def test_a_cap_has_the_area_of_a_segment(monkeypatch: pytest.MonkeyPatch, axes: Axes) -> None:
    radius, height = 0.2, 0.15
    (drawn,) = shape(monkeypatch, Capped(radius, height), axes)
    assert isinstance(drawn, Area)
    assert area(drawn.points) / 25.0 == pytest.approx(segment(radius, height), rel=0.01)
    across = max(p.real for p in drawn.points) - min(p.real for p in drawn.points)
    tall = max(p.imag for p in drawn.points) - min(p.imag for p in drawn.points)
    wide = 2.0 * sqrt(height * (2.0 * radius - height))
    wanted = (wide, height) if axes is UPRIGHT else (height, wide)
    assert (across / 5.0, tall / 5.0) == pytest.approx(wanted, rel=0.01)


def test_a_bowl_is_the_difference_of_two_caps(monkeypatch: pytest.MonkeyPatch) -> None:
    (drawn,) = shape(monkeypatch, Capped(0.2, 0.2, 0.03), UPRIGHT)
    assert isinstance(drawn, Area)
    assert area(drawn.points) / 25.0 == pytest.approx(segment(0.2, 0.2) - segment(0.17, 0.17), rel=0.01)


@pytest.mark.parametrize(("sides", "factor"), [(3, 3.0), (4, 4.0), (6, 6.0)])
def test_a_prism_seen_along_its_axis_is_its_polygon(monkeypatch: pytest.MonkeyPatch, sides: int, factor: float) -> None:
    (drawn,) = shape(monkeypatch, Axial(0.2, 0.5, sides=sides), TOWARDS)
    assert isinstance(drawn, Area)
    assert area(drawn.points) / 25.0 == pytest.approx(0.5 * factor * 0.04 * sin(2.0 * pi / sides))


def test_cylinders_bars_and_outlines_have_their_sizes(monkeypatch: pytest.MonkeyPatch) -> None:
    (side,) = shape(monkeypatch, Axial(0.1, 0.3), SIDEWAYS)
    assert isinstance(side, Area)
    assert area(side.points) / 25.0 == pytest.approx(0.2 * 0.3)
    (end,) = shape(monkeypatch, Axial(0.1, 0.3), TOWARDS)
    assert isinstance(end, Arc)
    assert end.radius == pytest.approx(0.5)
    (bar,) = shape(monkeypatch, Rectangular(0.1, 0.2, 0.3), UPRIGHT)
    assert isinstance(bar, Area)
    assert area(bar.points) / 25.0 == pytest.approx(0.1 * 0.3)
    (own,) = shape(monkeypatch, Silhouette(((0.0, 0.0), (0.2, 0.0), (0.0, 0.1))), UPRIGHT)
    assert isinstance(own, Area)
    assert area(own.points) / 25.0 == pytest.approx(0.01)


def test_a_sphere_shows_its_hole_and_an_open_shell_its_gap(monkeypatch: pytest.MonkeyPatch) -> None:
    (ball,) = shape(monkeypatch, Spherical(0.2, hole=0.05, offset=0.1), UPRIGHT)
    assert isinstance(ball, Arc)
    (shell,) = shape(monkeypatch, Spherical(0.2, wall=0.02, hole=0.1, offset=0.2), UPRIGHT)
    assert isinstance(shell, Area)
    outer, inner = (
        1.0 - 2.0 * asin(0.5 * 0.1 / 0.2) / pi,
        1.0 - acos((0.18**2 + 0.2**2 - 0.1**2) / (2 * 0.18 * 0.2)) / pi,
    )
    assert pi * (0.2**2 * outer - 0.18**2 * inner) == pytest.approx(area(shell.points) / 25.0, rel=0.05)


def test_a_stated_angular_velocity_is_a_curved_arrow_in_its_sense() -> None:
    prism = LongPrism(shape="hexagonal", radius=0.1, mass=2.0)
    drawn = drawing(scene_of(it=TumblingPrism(prism=prism, plane=Incline(angle=0.0), rate=3.0)))
    assert "3.0 rad/s" in texts(drawn)
    bent = next(s for s in drawn.shapes if isinstance(s, LineShape) and s.arrow and len(s.points) > 2)
    assert bent.points[-1].real > bent.points[0].real  # over the top to the right, as it tips
    solid = next(s for s in drawn.shapes if isinstance(s, Area) and s.fill == "block")
    low = sorted(p.imag for p in solid.points)
    assert low[1] - low[0] == pytest.approx(0.0, abs=1e-9)  # it lies on a face


def test_a_rough_face_has_dots_and_its_coefficient() -> None:
    for friction in (0.0, 0.25):
        plane = TwoSideMassPlane(plane=Plane(angle=30.0, friction=friction), blocks=(Block(mass=1.0),))
        drawn = drawing(scene_of(it=plane))
        assert any(isinstance(s, LineShape) and s.weight == "dots" for s in drawn.shapes) == (friction > 0.0)
        assert ("µ = 0.25" in texts(drawn)) == (friction > 0.0)


def test_a_slab_lies_on_the_one_below() -> None:
    stack = StackedMassPlane(
        plane=Plane(angle=0.0, friction=0.0), lower=Slab(mass=2.0), upper=Slab(mass=1.0), friction=0.1
    )
    slabs = [s for s in drawing(scene_of(it=stack)).shapes if isinstance(s, Area) and s.fill == "block"]
    (_, below), (above, _) = (sorted((min(p.imag for p in s.points), max(p.imag for p in s.points))) for s in slabs)
    assert above == pytest.approx(below)


def test_a_velocity_to_the_left_has_its_size_at_its_arrow() -> None:
    balls = (SlidingBall(mass=1.0, x=-0.9, v=2.23), SlidingBall(mass=1.0, x=1.84, v=-0.35))
    entity = ComplexCollisionPlane(track=Track(angle=0.0), gliders=balls, restitution=0.76)
    drawn = drawing(Scene(entities=(Named(name="track", entity=entity),)))
    assert {text for text in texts(drawn) if text.endswith("m/s")} == {"2.23 m/s", "0.35 m/s"}, "no scale is needed"

"""Tests of round bodies on a plane, against textbook formulas and integrated equations of motion."""

from collections.abc import Callable, Iterator
from math import cos, inf, pi, radians, sin, sqrt, tan
from typing import NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

import sim2reason
from drawn_entities import certified, drawn_entity, travels
from lone_entities import alone, followed
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.eccentric_bodies import BoredCylinder
from sim2reason.scenes.bodies.round_bodies import (
    Disc,
    HollowSphere,
    Hoop,
    Pipe,
    Roller,
    Sphere,
    SphericalShell,
    ThickPipe,
)
from sim2reason.scenes.bodies.simple_machines import FixedPulley, Incline
from sim2reason.scenes.connections.string import String
from sim2reason.scenes.dsl.connection import Link
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.solids import Shape
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley
from sim2reason.scenes.entities.rolling import Hole, NoSlipping, Rolling, RollingEntity, Rough, Sliding, Spinning
from sim2reason.scenes.entities.string_ends import Hanging
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.quantities import QUANTITIES

G = 9.8
CLOSE = 1e-8
CHOICES = {"hole?": 0.4, "start?": 0.6}
LEVEL = {**CHOICES, "angle": 0.0, "way": ("to the right",)}
SIZE = {"mass": 2.0, "radius": 0.12}
ROUND: list[tuple[Shape, float]] = [  # and I/(mR²) as textbooks have it
    (Sphere(**SIZE), 2 / 5),
    (SphericalShell(**SIZE), 2 / 3),
    (HollowSphere(thickness=0.02, **SIZE), 2 / 5 * (1 - (5 / 6) ** 5) / (1 - (5 / 6) ** 3)),
    (Roller(**SIZE), 1 / 2),
    (Disc(**SIZE), 1 / 2),
    (Hoop(**SIZE), 1.0),
    (Pipe(**SIZE), 1.0),
    (ThickPipe(bore=0.06, **SIZE), (1 + 1 / 4) / 2),
]
BORED = BoredCylinder(mass=5.0, radius=0.2, hole=0.08, offset=0.1)
Array = NDArray[np.float64]


def rolls(body: Shape, angle: float, friction: float = inf, **fields: object) -> RollingEntity:
    """Build a body on a plane; it never slips unless a coefficient of friction is given."""
    grip = NoSlipping() if friction == inf else Rough(friction=friction)
    return RollingEntity(body=body, plane=Incline(angle=angle), grip=grip, **fields)  # type: ignore[arg-type]


@pytest.mark.parametrize(("body", "share"), ROUND)
def test_rolling_down_an_incline(body: Shape, share: float) -> None:
    """The acceleration is a = g sin α/(1 + I/mR²); Halliday, Resnick and Walker, eq. 11-10."""
    trace = followed(rolls(body, 25.0), 1.0, 21)
    acceleration = -G * sin(radians(25.0)) / (1.0 + share)
    assert trace.state.a[:, 0] == pytest.approx(acceleration, rel=CLOSE)
    assert trace.state.q[-1] == pytest.approx([acceleration / 2.0, acceleration / 0.24], rel=CLOSE)
    assert trace.state.friction["it.body"] == pytest.approx(2.0 * (acceleration + G * sin(radians(25.0))), rel=CLOSE)


@pytest.mark.parametrize(("body", "share"), ROUND)
def test_the_least_friction_for_rolling(body: Shape, share: float) -> None:
    """The threshold is µ = tan α/(1 + mR²/I), below which the body slides with g(sin α − µ cos α)."""
    slope = radians(35.0)
    least = tan(slope) / (1.0 + 1.0 / share)
    more, less = (followed(rolls(body, 35.0, least * factor), 0.5, 6).state for factor in (1.0 + 1e-6, 1.0 - 1e-6))
    assert more.a[:, 0] == pytest.approx(0.12 * more.a[:, 1], rel=CLOSE)
    assert less.a[:, 0] == pytest.approx(-G * (sin(slope) - least * (1.0 - 1e-6) * cos(slope)), rel=CLOSE)
    assert abs(less.a[0, 0]) > abs(0.12 * less.a[0, 1])


def test_a_sliding_ball_begins_to_roll() -> None:
    """The ball rolls after 2v₀/(7µg), with 5v₀/7; Kleppner and Kolenkow, problem 7.38 in essence."""
    trace = followed(rolls(Sphere(**SIZE), 0.0, 0.2, start=Sliding(speed=3.0, way="to the right")), 3.0)
    assert [(event.kind, event.time) for event in trace.events] == [
        ("stick", pytest.approx(6.0 / (7.0 * 0.2 * G), rel=CLOSE))
    ]
    assert trace.state.v[-1] == pytest.approx([15.0 / 7.0, 15.0 / 7.0 / 0.12], rel=CLOSE)


def test_a_spinning_ball_begins_to_roll() -> None:
    """The ball rolls after 2Rω₀/(7µg), with 2Rω₀/7, since friction accelerates it and slows its spin."""
    trace = followed(rolls(Sphere(**SIZE), 0.0, 0.3, start=Spinning(spin=40.0, way="to the right")), 2.0)
    assert [(event.kind, event.time) for event in trace.events] == [
        ("stick", pytest.approx(2.0 * 4.8 / (7.0 * 0.3 * G), rel=CLOSE))
    ]
    assert trace.state.v[-1, 0] == pytest.approx(2.0 * 4.8 / 7.0, rel=CLOSE)


def test_rolling_up_and_down_again() -> None:
    """The body reverses after v₀/a, a = g sin α/(1 + I/mR²)."""
    trace = followed(rolls(Hoop(**SIZE), 20.0, start=Rolling(speed=2.0, way="up the slope")), 3.0)
    turns = {event.time for event in trace.events}
    assert [kind for kind, _ in {(event.kind, event.subjects) for event in trace.events}] == ["turn", "turn"]
    assert sorted(turns) == pytest.approx([2.0 / (G * sin(radians(20.0)) / 2.0)] * len(turns), rel=CLOSE)


class OffCentre(NamedTuple):
    """Equations of motion of a bored cylinder, derived by hand from Newton's laws."""

    body: BoredCylinder
    slope: float  # rad
    start: float  # rad, from the outward normal to the centre of mass, clockwise

    @property
    def offset(self) -> float:
        """Return the distance of the centre of mass from the axis, from that of the missing disc."""
        area = self.body.radius**2 - self.body.hole**2
        return self.body.offset * self.body.hole**2 / area

    @property
    def inertia(self) -> float:
        """Return the moment of inertia about the centre of mass, over the mass.

        It is ½R² and ½r² of the discs, moved by the parallel-axis theorem.
        """
        R, r, e = self.body.radius, self.body.hole, self.body.offset
        axis = (0.5 * R**4 - r**2 * (0.5 * r**2 + e**2)) / (R**2 - r**2)
        return axis - self.offset**2

    def turning(self, angle: Array, rate: Array) -> Array:
        """Return φ̈ of rolling without slipping, from the torques about the point of contact."""
        R, d = self.body.radius, self.offset
        s, c = np.sin(self.start + angle), np.cos(self.start + angle)
        pull = R * d * s * rate**2 - G * (R + d * c) * sin(self.slope) + G * d * s * cos(self.slope)
        return pull / (self.inertia + (R + d * c) ** 2 + (d * s) ** 2)

    def forces(self, angle: Array, rate: Array) -> tuple[Array, Array]:
        """Return the friction up the slope and the normal force, over the mass."""
        R, d = self.body.radius, self.offset
        s, c = np.sin(self.start + angle), np.cos(self.start + angle)
        more = self.turning(angle, rate)
        along = (R + d * c) * more - d * s * rate**2
        out = -d * s * more - d * c * rate**2
        return along + G * sin(self.slope), out + G * cos(self.slope)

    def steps(self, rate: float, step: float) -> Iterator[tuple[float, float, float]]:
        """Yield time, angle and rate by the classical Runge–Kutta method."""
        here, time = np.array([0.0, rate]), 0.0

        def change(state: Array) -> Array:
            return np.array([state[1], self.turning(state[0], state[1])])

        while True:
            yield time, float(here[0]), float(here[1])
            first = change(here)
            second = change(here + 0.5 * step * first)
            third = change(here + 0.5 * step * second)
            fourth = change(here + step * third)
            here = here + step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth)
            time += step

    def first(self, rate: float, margin: Callable[[float, float], float], step: float = 2e-4) -> float:
        """Return the time at which a function of angle and rate turns negative, by successively finer steps."""
        time, angle = 0.0, 0.0
        shifted = self
        while step > 1e-14:
            for later, ahead, faster in shifted.steps(rate, step):
                if margin(angle + ahead, faster) < 0.0:
                    break
                last = later, ahead, faster
            time, angle, rate = time + last[0], angle + last[1], last[2]
            shifted = self._replace(start=self.start + angle)
            step /= 16.0
        return time


def placed(angle: float, bearing: float) -> OffCentre:
    """Return equations with the hole downhill of the upward vertical, or to its right on level ground.

    The centre of mass is opposite the hole.
    """
    side = -1.0 if angle else 1.0
    return OffCentre(BORED, radians(angle), side * radians(bearing) + radians(angle) + pi)


def hole(angle: float, bearing: float) -> Hole:
    """Return the same hole in terms of the entity's parameters."""
    return Hole(bearing=bearing, towards="downhill" if angle else "right")


@pytest.mark.parametrize(("angle", "bearing", "speed"), [(0.0, 90.0, 0.0), (15.0, 60.0, 0.0), (10.0, 140.0, 0.8)])
def test_off_centre_without_slipping(angle: float, bearing: float, speed: float) -> None:
    """φ̈, the friction and the normal force at every sample satisfy Newton's laws, and energy is conserved."""
    way = "down the slope" if angle else "to the right"
    start = Rolling(speed=speed, way=way) if speed else None
    trace = followed(rolls(BORED, angle, hole=hole(angle, bearing), start=start), 1.2, 121)
    assert trace.events == () or {event.kind for event in trace.events} == {"turn"}
    paper, state = placed(angle, bearing), trace.state
    phi, rate = state.q[:, 1], state.v[:, 1]
    assert state.a[:, 1] == pytest.approx(paper.turning(phi, rate), abs=CLOSE * 100)
    friction, normal = paper.forces(phi, rate)
    assert state.friction["it.body"] == pytest.approx(5.0 * friction, abs=CLOSE * 50)
    assert state.normal["it.body"] == pytest.approx(5.0 * normal, abs=CLOSE * 50)
    kinetic = QUANTITIES["kinetic energy"].evaluate(state, "it.body")
    potential = QUANTITIES["potential energy"].evaluate(state, "it.body")
    assert kinetic + potential == pytest.approx(kinetic[0], abs=CLOSE * 10)


def test_small_oscillations_of_an_off_centre_cylinder() -> None:
    """With the hole near the top, ω² = mgd/(I + m(R − d)²).

    Landau and Lifshitz, §32, problem 5 in essence.
    """
    paper = placed(0.0, 0.0)
    period = 2.0 * pi * sqrt((paper.inertia + (0.2 - paper.offset) ** 2) / (G * paper.offset))
    trace = followed(rolls(BORED, 0.0, hole=Hole(bearing=1e-3, towards="right")), 1.2 * period)
    turns = sorted({round(event.time, 6) for event in trace.events})
    times = [event.time for event in trace.events if event.subjects == ("it.body.hinge",)]
    assert len(turns) == 2
    assert times == pytest.approx([period / 2.0, period], rel=CLOSE)


def test_an_off_centre_cylinder_begins_to_slip() -> None:
    """The slip begins at the first instant with |f| > µN, found by a separate Runge–Kutta integration."""
    mu = 0.148
    paper = placed(15.0, 60.0)

    def margin(angle: float, rate: float) -> float:
        friction, normal = paper.forces(np.array(angle), np.array(rate))
        return float(mu * normal - abs(friction))

    when = paper.first(0.0, margin)
    trace = followed(rolls(BORED, 15.0, mu, hole=hole(15.0, 60.0)), 2.0)
    assert (trace.events[0].kind, trace.events[0].subjects) == ("slip", ("it.body",))
    assert trace.events[0].time == pytest.approx(when, rel=CLOSE)


def test_an_off_centre_cylinder_leaves_the_plane() -> None:
    """The cylinder leaves at the first instant with N < 0, found by a separate Runge–Kutta integration."""
    paper = placed(20.0, 0.0)
    when = paper.first(-12.0, lambda angle, rate: float(paper.forces(np.array(angle), np.array(rate))[1]))
    start = Rolling(speed=2.4, way="down the slope")
    trace = followed(rolls(BORED, 20.0, hole=Hole(bearing=0.0), start=start), 5.0)
    assert trace.cut == "lift"
    assert trace.stable_until == pytest.approx(when, rel=CLOSE)


def test_a_disc_drawn_by_a_string_over_a_pulley() -> None:
    """The acceleration is a = (M − m sin α)g/(M + m + I/R²), with the string at the disc's axle."""
    disc = Named(name="roller", entity=rolls(Disc(**SIZE), 25.0))
    side = MassWithFixedPulley(system=Hanging(blocks=(Block(mass=3.0),)), pulley=FixedPulley())
    links = (Link(entity="roller", port="axle"), Link(entity="side", port="tail"))
    scene = Scene(entities=(disc, Named(name="side", entity=side)), connections=(String(links=links),))
    trace = simulate(scene.mechanism, np.linspace(0.0, 0.3, 4))
    wanted = G * (3.0 - 2.0 * sin(radians(25.0))) / (3.0 + 2.0 + 1.0)
    assert trace.state.a[:, 0] == pytest.approx(wanted, rel=CLOSE)
    text = sim2reason.describe(scene, 5).text
    assert sim2reason.parse_scene(text).scene.entities[0].entity == disc.entity, text
    trace, certificate = sim2reason.certify(scene)
    assert (trace.cut, certificate.reason) == ("reach", "reach")


def test_both_engines_see_an_off_centre_roller_reach_the_pulley() -> None:
    """The string's direction reverses where its ends meet, in a mechanism whose mass matrix is not constant."""
    roller = Named(name="roller", entity=rolls(BORED, 25.0, hole=hole(25.0, 60.0)))
    side = MassWithFixedPulley(system=Hanging(blocks=(Block(mass=9.0),)), pulley=FixedPulley())
    links = (Link(entity="roller", port="axle"), Link(entity="side", port="tail"))
    scene = Scene(entities=(roller, Named(name="side", entity=side)), connections=(String(links=links),))
    trace, certificate = sim2reason.certify(scene)
    assert [event.kind for event in trace.events] == ["reach"]
    assert certificate.reason == "reach"


@pytest.mark.parametrize("seed", range(50))
def test_text_and_file_lead_back(seed: int) -> None:
    travels(drawn_entity(RollingEntity, seed, LEVEL if seed % 4 == 0 else CHOICES), seed)


@pytest.mark.parametrize("seed", range(8))
def test_engines_agree(seed: int) -> None:
    assert certified(drawn_entity(RollingEntity, 1000 + seed, CHOICES)) == 1.0


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({"hole": Hole(bearing=20.0)}, "if the body has one"),
        ({"body": BORED}, "if the body has one"),
        ({"body": BORED, "hole": Hole(bearing=20.0, towards="right")}, "right on a level plane"),
        ({"start": Rolling(speed=1.0, way="to the right")}, "to the right on a level plane"),
        ({"start": Sliding(speed=1.0, way="up the slope")}, "never slips"),
    ],
)
def test_what_makes_no_sense_is_refused(fields: dict[str, object], says: str) -> None:
    with pytest.raises(ValueError, match=says):
        rolls(**{"body": Sphere(**SIZE), "angle": 20.0, **fields})  # type: ignore[arg-type]


def test_it_is_told_where_the_hole_is() -> None:
    """The hole is 60° from the upward vertical on the left, downhill side, as the plane rises to the right."""
    scene = alone(rolls(BORED, 15.0, hole=hole(15.0, 60.0)))
    body = scene.mechanism.body["it.body"]
    offset = placed(15.0, 60.0).offset
    assert body.center == pytest.approx([offset * sin(radians(60.0)), 0.0, -offset * cos(radians(60.0))])
    assert "60° with the upward vertical, on the downhill side" in sim2reason.describe(scene, 1).text

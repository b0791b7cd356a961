"""Tests of orbits, charges in fields, and rotating and rocking bodies, against independent closed forms."""

from dataclasses import replace
from math import acos, asin, cos, cosh, degrees, exp, hypot, pi, radians, sin, sinh, sqrt

import numpy as np
import pytest

from sim2reason.questions import Query, StatedResult, Target
from sim2reason.questions.kinds.equilibrium import EquilibriumQuery
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.angles import Deflected, Orbited
from sim2reason.questions.moments.distances import Away, Closest, Farthest
from sim2reason.questions.moments.strings import MostCompressed, MostStretched, NaturalLength
from sim2reason.questions.moments.times import AtStart, AtTime, WholeMotion
from sim2reason.questions.moments.turning_points import LowestPoint, Stopped
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.charges import ChargedBead, Launched, Released
from sim2reason.scenes.bodies.eccentric_bodies import BoredCylinder
from sim2reason.scenes.bodies.oscillators import NailedSpring, UniformRod
from sim2reason.scenes.bodies.simple_machines import Incline
from sim2reason.scenes.bodies.space import Planet, Star
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.fields import (
    ElectricField,
    LinearDrag,
    LinearElectric,
    Medium,
    QuadraticDrag,
    Trend,
    UniformElectric,
    UniformMagnetic,
)
from sim2reason.scenes.entities.particles import EmEntity
from sim2reason.scenes.entities.pendulums import RotationEntity
from sim2reason.scenes.entities.pieces import AxialPiece
from sim2reason.scenes.entities.rolling import Hole, NoSlipping, RollingEntity
from sim2reason.scenes.entities.space import SolarSystem
from sim2reason.scenes.entities.spring_blocks import Launch, SpringBlock
from sim2reason.scenes.entities.varying_fields import OscillatingElectric
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.solutions import solve
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from worked import answer, asked

G = 9.8
GM = 4.0 * pi**2  # au³/yr²
PLANET, BEAD, ROD = "system.planets.0", "fields.particle", "arm.pieces.0.body"
PAIR = f"{PLANET} & system.star"


def at(quantity: str, subject: str, moment: Moment, kind: str = "event") -> Query:
    return Query(kind, Target(quantity, subject), moment)


# ---- orbits


def orbit(query: Query, vy: float = 7.5) -> float:
    """Return the answer for an orbit with perihelion at x = 1 au.

    v² = GM(1 + e)/r at the perihelion; 2π au/yr gives a circle.
    """
    planet = Planet(x=1.0, y=0.0, vx=0.0, vy=vy)
    return answer("system", SolarSystem(star=Star(mass=1.0), planets=(planet,)), query)


E = 7.5**2 / GM - 1.0  # the eccentricity
A = 1.0 / (1.0 - E)


def test_the_period_is_by_keplers_third_law() -> None:
    assert orbit(PeriodQuery("period", of=(PLANET,))) == pytest.approx(A**1.5)


def test_the_aphelion_comes_after_half_a_period_and_is_slowest() -> None:
    assert orbit(Query("time_to_event", None, Farthest(PAIR))) == pytest.approx(A**1.5 / 2.0)
    assert orbit(at("velocity", PLANET, Farthest(PAIR))) == pytest.approx(7.5 * (1.0 - E) / (1.0 + E))
    assert orbit(at("distance", PAIR, AtTime(A**1.5 / 2.0), "state")) == pytest.approx(A * (1.0 + E))


def test_a_quarter_of_the_way_round_it_is_at_the_semi_latus_rectum() -> None:
    """At ν = 90°: r = ℓ = a(1 − e²), v² = GM(2/r − 1/a), and the time follows from E = arccos e and E − e sin E."""
    late = acos(E) - E * sin(acos(E))
    assert orbit(Query("time_to_event", None, Orbited(PAIR, 90))) == pytest.approx(late * A**1.5 / (2.0 * pi))
    parameter = A * (1.0 - E**2)
    assert orbit(at("velocity", PLANET, Orbited(PAIR, 90))) == pytest.approx(sqrt(GM * (2.0 / parameter - 1.0 / A)))


def test_the_area_swept_out_in_half_an_orbit_is_half_the_ellipse() -> None:
    query = StretchQuery("sum", None, Farthest(PAIR), "area swept", PAIR)
    assert orbit(query) == pytest.approx(pi * A**2 * sqrt(1.0 - E**2) / 2.0)


def test_the_least_distance_and_the_greatest_displacement() -> None:
    inward = 5.0  # begun at the aphelion
    e = 1.0 - inward**2 / GM
    a = 1.0 / (1.0 + e)
    query = StretchQuery("extremum", None, WholeMotion(), "least distance", PAIR)
    assert orbit(query, inward) == pytest.approx(a * (1.0 - e))
    assert orbit(Query("time_to_event", None, Closest(PAIR)), inward) == pytest.approx(a**1.5 / 2.0)
    query = StretchQuery("extremum", None, WholeMotion(), "greatest displacement", PLANET)
    assert orbit(query, inward) == pytest.approx(2.0 * a)


def test_it_is_away_from_its_start_when_keplers_equation_says_so() -> None:
    """From the perihelion x = a (cos E − e) and y = b sin E; distances are sampled along the ellipse."""
    angles = np.linspace(0.0, 1.5, 400001)
    apart = np.hypot(A * (np.cos(angles) - 1.0), A * sqrt(1.0 - E**2) * np.sin(angles))
    grown = float(np.interp(0.5, apart, angles))
    expected = (grown - E * sin(grown)) * A**1.5 / (2.0 * pi)
    assert orbit(Query("time_to_event", None, Away(PLANET, 0.5))) == pytest.approx(expected, rel=1e-8)


# ---- charges in fields

BEAD_MASS, CHARGE, SPEED = 2.0, 3.0, 2.0
B, FIELD = 0.8, 1.1
TURNS = CHARGE * B / BEAD_MASS


def charged(
    query: Query,
    magnetic: UniformMagnetic | None = None,
    electric: ElectricField | None = None,
    medium: Medium | None = None,
) -> float:
    particle = ChargedBead(mass=2.0, charge=3.0, sign="positive")
    start = Launched(speed=SPEED, angle=0.0)
    entity = EmEntity(magnetic=magnetic, electric=electric, medium=medium, particle=particle, start=start)
    return answer("fields", entity, query)


MAGNETIC = UniformMagnetic(strength=B, way="positive z")
ELECTRIC = UniformElectric(strength=FIELD, way="positive y")


def test_a_magnetic_field_leads_round_a_circle() -> None:
    assert charged(PeriodQuery("period", of=(BEAD,)), magnetic=MAGNETIC) == pytest.approx(2.0 * pi / TURNS)
    radius = SPEED / TURNS
    time = charged(Query("time_to_event", None, Away(BEAD, 1.0)), magnetic=MAGNETIC)
    assert time == pytest.approx(2.0 / TURNS * asin(1.0 / (2.0 * radius)))


def test_an_electric_field_alone_gives_a_parabola() -> None:
    """With a = qE/m perpendicular to the initial velocity, v² = v₀² + (a t)²."""
    speed = charged(at("velocity", BEAD, AtTime(1.5), "state"), electric=ELECTRIC)
    assert speed == pytest.approx(sqrt(SPEED**2 + (CHARGE * FIELD / BEAD_MASS * 1.5) ** 2))


def test_crossed_fields_add_a_drift() -> None:
    """The drift E/B to the right is added to a circular motion, so v is between their difference and sum."""
    query = StretchQuery("extremum", None, AtTime(5.0), "least speed", BEAD)
    assert charged(query, MAGNETIC, ELECTRIC) == pytest.approx(abs(2.0 * FIELD / B - SPEED))
    place = charged(Query("state", Target("displacement", BEAD), AtTime(1.0)), MAGNETIC, ELECTRIC)
    drift, turns = FIELD / B, SPEED - FIELD / B
    x, y = drift + turns * sin(TURNS) / TURNS, -turns * (1.0 - cos(TURNS)) / TURNS
    assert place == pytest.approx(sqrt(x**2 + y**2))


def test_a_field_that_oscillates() -> None:
    """v_y = qE/(mν) sin νt."""
    field = OscillatingElectric(strength=FIELD, way="positive y", frequency=3.0)
    speed = charged(at("velocity", BEAD, AtTime(0.7), "state"), electric=field)
    across = CHARGE * FIELD / BEAD_MASS / 3.0 * sin(3.0 * 0.7)
    assert speed == pytest.approx(sqrt(SPEED**2 + across**2))


@pytest.mark.parametrize("trend", ["increases", "decreases"])
def test_a_field_that_grows_along_itself_crosses_a_magnetic_one(trend: Trend) -> None:
    """m v_x + q B y is constant, so along y it is ÿ = a₀ + (±qk/m − Ω²) y; see Jackson, § 12.3."""
    electric = LinearElectric(strength=FIELD, way="positive y", trend=trend, axis="y", slope=0.4)
    first = CHARGE * FIELD / BEAD_MASS - TURNS * SPEED
    back = TURNS**2 - (1.0 if trend == "increases" else -1.0) * CHARGE * 0.4 / BEAD_MASS
    y = first / back * (1.0 - cos(sqrt(back) * 1.3))
    speeds = SPEED + TURNS * y, first / sqrt(back) * sin(sqrt(back) * 1.3)
    assert charged(at("velocity", BEAD, AtTime(1.3), "state"), MAGNETIC, electric) == pytest.approx(hypot(*speeds))
    x = (SPEED + TURNS * first / back) * 1.3 - TURNS * first / back * sin(sqrt(back) * 1.3) / sqrt(back)
    assert charged(at("displacement", BEAD, AtTime(1.3), "state"), MAGNETIC, electric) == pytest.approx(hypot(x, y))


def test_a_steep_field_drives_it_away_in_spite_of_a_magnetic_one() -> None:
    electric = LinearElectric(strength=FIELD, way="positive y", trend="increases", axis="y", slope=1.2)
    first, rate = CHARGE * FIELD / BEAD_MASS - TURNS * SPEED, sqrt(CHARGE * 1.2 / BEAD_MASS - TURNS**2)
    y = first / rate**2 * (cosh(rate * 0.9) - 1.0)
    speeds = SPEED + TURNS * y, first / rate * sinh(rate * 0.9)
    assert charged(at("velocity", BEAD, AtTime(0.9), "state"), MAGNETIC, electric) == pytest.approx(hypot(*speeds))


def test_from_rest_in_crossed_fields_it_is_fastest_at_the_far_end() -> None:
    """With v_x = Ω y and y = y_c (1 − cos ωt), v² is largest at y = 2 y_c if −k q/m < Ω²; no time is needed."""
    electric = LinearElectric(strength=FIELD, way="positive y", trend="decreases", axis="y", slope=0.4)
    particle = ChargedBead(mass=2.0, charge=3.0, sign="positive")
    entity = EmEntity(magnetic=MAGNETIC, electric=electric, particle=particle, start=Released())
    query = StretchQuery("extremum", None, Stopped(BEAD), "greatest speed", BEAD)
    center = CHARGE * FIELD / BEAD_MASS / (TURNS**2 + CHARGE * 0.4 / BEAD_MASS)
    assert answer("fields", entity, query) == pytest.approx(2.0 * TURNS * center)


def test_a_medium_that_resists_by_the_square_slows_what_a_magnetic_field_turns() -> None:
    """m v̇ = −c v² gives v = v₀/(1 + c v₀ t/m), in the direction Ωt, and the deceleration γ v/(1 + γt)."""
    medium, rate = QuadraticDrag(coefficient=0.5), 0.5 * SPEED / BEAD_MASS
    slow = SPEED / (1.0 + 2.0 * rate)
    assert charged(at("velocity", BEAD, AtTime(2.0), "state"), MAGNETIC, medium=medium) == pytest.approx(slow)
    pull = hypot(rate / (1.0 + 2.0 * rate), TURNS) * slow
    assert charged(at("acceleration", BEAD, AtTime(2.0), "state"), MAGNETIC, medium=medium) == pytest.approx(pull)
    lost = StretchQuery("sum", None, AtTime(2.0), "energy lost to drag", BEAD)
    energy = 0.5 * BEAD_MASS * (SPEED**2 - slow**2)
    assert charged(lost, MAGNETIC, medium=medium) == pytest.approx(energy)
    push = StretchQuery("sum", None, AtTime(2.0), "impulse of the net force", BEAD)
    change = hypot(slow * cos(2.0 * TURNS) - SPEED, slow * sin(2.0 * TURNS))
    assert charged(push, MAGNETIC, medium=medium) == pytest.approx(BEAD_MASS * change)


def test_in_uniform_fields_only_a_medium_makes_the_acceleration_smaller() -> None:
    """The acceleration obeys the law of a velocity without an electric field: a = a₀ exp(−bt/m) for all B."""
    medium, first = LinearDrag(coefficient=0.5), CHARGE * FIELD / BEAD_MASS - TURNS * SPEED
    begun = hypot(first, 0.5 * SPEED / BEAD_MASS)
    found = charged(at("acceleration", BEAD, AtTime(2.0), "state"), MAGNETIC, ELECTRIC, medium)
    assert found == pytest.approx(begun * exp(-2.0 * 0.5 / BEAD_MASS))
    assert charged(at("net force", BEAD, AtTime(2.0), "state"), MAGNETIC, ELECTRIC) == pytest.approx(
        BEAD_MASS * abs(first)
    )


# ---- bodies on an axle

MASS, LENGTH, PLACE, ANGLE = 2.0, 0.9, 0.3, 60.0
ABOUT = MASS * (LENGTH**2 / 12.0 + PLACE**2)


def swung(query: Query) -> float:
    rod = AxialPiece(distance=PLACE, body=UniformRod(mass=MASS, length=LENGTH), axis="along the arm")
    return answer("arm", RotationEntity(pieces=(rod,), angle=ANGLE), query)


def test_the_angle_of_an_arm_is_that_of_its_centre_of_mass() -> None:
    """The centre of mass starts at 180° − 60° and falls to 30°; ω² = 2 g S (cos 30° + cos 60°)/I."""
    light, heavy = UniformRod(mass=1.0, length=0.6), UniformRod(mass=3.0, length=LENGTH)
    pieces = (
        AxialPiece(distance=0.2, body=light, axis="along the arm"),
        AxialPiece(distance=0.5, side="on the other side", body=heavy, axis="along the arm"),
    )
    inertia = 0.6**2 / 12.0 + 0.2**2 + 3.0 * (LENGTH**2 / 12.0 + 0.5**2)
    fallen = cos(radians(30.0)) + cos(radians(60.0))
    rate = answer(
        "arm", RotationEntity(pieces=pieces, angle=ANGLE), at("angular velocity", ROD, Deflected("arm.arm", 30.0))
    )
    assert rate == pytest.approx(sqrt(2.0 * G * (3.0 * 0.5 - 0.2) * fallen / inertia))


def test_a_rod_let_go_at_an_angle() -> None:
    grown = swung(at("angular acceleration", ROD, AtStart(), "start"))
    assert grown == pytest.approx(MASS * G * PLACE * sin(radians(ANGLE)) / ABOUT)


@pytest.mark.parametrize(("moment", "angle"), [(LowestPoint(ROD), 0.0), (Deflected("arm.arm", 25.0), 25.0)])
def test_a_rod_that_swings_keeps_its_energy(moment: Moment, angle: float) -> None:
    rate = sqrt(2.0 * MASS * G * PLACE * (cos(radians(angle)) - cos(radians(ANGLE))) / ABOUT)
    assert swung(at("velocity", ROD, moment)) == pytest.approx(PLACE * rate)
    assert swung(at("kinetic energy", ROD, moment)) == pytest.approx(ABOUT * rate**2 / 2.0)


def test_the_greatest_angular_speed_and_the_period_of_small_oscillations() -> None:
    query = StretchQuery("extremum", None, WholeMotion(), "greatest angular speed", "arm.arm")
    assert swung(query) == pytest.approx(sqrt(2.0 * MASS * G * PLACE * (1.0 - cos(radians(ANGLE))) / ABOUT))
    period = swung(PeriodQuery("period", small=True, of=("arm.arm",)))
    assert period == pytest.approx(2.0 * pi * sqrt(ABOUT / (MASS * G * PLACE)))


# ---- a body on a spring

STIFF, FREE = 50.0, 0.4


def sprung(query: Query) -> float:
    """Return the answer for a block released 0.5 m from a nail on a line of slope 3:4: x(t) = 0.1 cos √(k/m) t."""
    spring = NailedSpring(stiffness=STIFF, length=FREE, x=0.1, y=0.1)
    entity = SpringBlock(block=Block(mass=MASS), springs=(spring,), x=0.4, y=0.5)
    return answer("springs", entity, query)


def test_a_block_oscillates_along_its_spring() -> None:
    rate, block = sqrt(STIFF / MASS), "springs.block"
    speed = sprung(at("velocity", block, AtTime(0.25), "state"))
    assert speed == pytest.approx(0.1 * rate * abs(sin(0.25 * rate)))
    assert sprung(PeriodQuery("period", of=(block,))) == pytest.approx(2.0 * pi / rate)
    assert sprung(Query("time_to_event", None, Away(block, 0.15))) == pytest.approx(acos(1.0 - 1.5) / rate)
    query = StretchQuery("extremum", None, WholeMotion(), "greatest kinetic energy", block)
    assert sprung(query) == pytest.approx(STIFF * 0.1**2 / 2.0)


def turning(query: Query) -> float:
    """Return the answer for a block launched from (0.3, 0.4) at 0.5 m/s along x, with h = 0.2 m²/s."""
    spring = NailedSpring(stiffness=STIFF, length=FREE, x=0.0, y=0.0)
    entity = SpringBlock(block=Block(mass=MASS), springs=(spring,), x=0.3, y=0.4, launch=Launch(x=0.5, y=0.0))
    return answer("springs", entity, query)


def test_a_spring_that_turns_keeps_energy_and_angular_momentum() -> None:
    spring, relaxed = "springs.springs.0", NaturalLength("springs.springs.0")
    energy, h = 0.5**2 + STIFF / MASS * 0.1**2, 0.3 * 0.0 - 0.4 * 0.5
    assert turning(at("velocity", "springs.block", relaxed)) == pytest.approx(sqrt(energy))
    assert turning(at("extension rate", spring, relaxed)) == pytest.approx(sqrt(energy - (h / FREE) ** 2))
    length = turning(at("spring length", spring, MostStretched(spring)))
    assert (h / length) ** 2 + STIFF / MASS * (length - FREE) ** 2 == pytest.approx(energy)
    assert turning(at("velocity", "springs.block", MostStretched(spring))) == pytest.approx(abs(h) / length)


def test_a_dashpot_pulls_at_the_start_by_how_fast_its_spring_grows() -> None:
    """Launched at 0.5 m/s along +x with the spring along (0.6, 0.8): F = k s + b 0.5·0.6."""
    spring = NailedSpring(stiffness=STIFF, length=FREE, x=0.1, y=0.1)
    entity = SpringBlock(
        block=Block(mass=MASS), springs=(spring,), damping=3.0, x=0.4, y=0.5, launch=Launch(x=0.5, y=0.0)
    )
    pull = STIFF * (0.5 - FREE) + 3.0 * 0.5 * 0.6
    up = Sense("away from us", (0.0, 1.0, 0.0), axis="y")
    query = Query("start", Target("acceleration", "springs.block", up), AtStart())
    assert answer("springs", entity, query) == pytest.approx(-0.8 * pull / MASS)


def led_round(query: Query) -> float:
    """Return the answer for a block launched at 2 m/s along +x from (0.3, 0.4) relative to a nail: h = 0.8 m²/s."""
    spring = NailedSpring(stiffness=STIFF, length=FREE, x=0.1, y=0.1)
    entity = SpringBlock(block=Block(mass=MASS), springs=(spring,), x=0.4, y=0.5, launch=Launch(x=2.0, y=0.0))
    return answer("springs", entity, query)


def test_a_spring_leads_a_block_round_by_energy_and_angular_momentum() -> None:
    """Both extreme lengths are roots of E = m h²/(2ℓ²) + k (ℓ − ℓ₀)²/2; see Kleppner and Kolenkow, chapter 10."""
    block, spring, energy = "springs.block", "springs.springs.0", MASS * 2.0 + STIFF * 0.1**2 / 2.0

    # ℓ² (m h²/(2ℓ²) + k (ℓ − ℓ₀)²/2 − E) as a polynomial
    powers = STIFF / 2.0, -STIFF * FREE, STIFF * FREE**2 / 2.0 - energy, 0.0, MASS * 0.8**2 / 2.0
    near, far = sorted(root.real for root in np.roots(powers) if abs(root.imag) < 1e-9 < root.real)
    assert led_round(at("spring length", spring, MostStretched(spring))) == pytest.approx(far)
    assert led_round(at("velocity", block, MostStretched(spring))) == pytest.approx(0.8 / far)
    assert led_round(at("acceleration", block, MostCompressed(spring))) == pytest.approx(STIFF * (FREE - near) / MASS)
    relaxed = sqrt(2.0 * energy / MASS)
    assert led_round(at("momentum", block, NaturalLength(spring))) == pytest.approx(MASS * relaxed)
    inward = Sense("an increase", (0.0, 0.0, 0.0))
    query = Query("event", Target("extension rate", spring, inward), NaturalLength(spring))
    assert led_round(query) == pytest.approx(-sqrt(relaxed**2 - (0.8 / FREE) ** 2))
    query = StretchQuery("extremum", None, MostCompressed(spring), "greatest extension", spring)
    assert led_round(query) == pytest.approx(far - FREE)


# ---- a body on springs in a plane


def held(nails: tuple[tuple[float, float], ...], free: float, query: Query) -> float:
    """Return the answer for a block on identical springs, launched away from its equilibrium position."""
    springs = tuple(NailedSpring(stiffness=STIFF, length=free, x=x, y=y) for x, y in nails)
    entity = SpringBlock(block=Block(mass=MASS), springs=springs, x=0.5, y=0.1, launch=Launch(x=0.3, y=-0.1))
    return answer("springs", entity, query)


CORNERS = tuple((round(0.3 + 0.6 * cos(radians(a)), 2), round(0.2 + 0.6 * sin(radians(a)), 2)) for a in (20, 140, 260))


def test_springs_at_the_corners_of_a_triangle_balance_near_its_centre() -> None:
    """All springs are 0.6 m long at the centre, apart from the rounding of positions to centimetres."""
    query = EquilibriumQuery("equilibrium", Target("extension", "springs.springs.0"))
    assert held(CORNERS, 0.4, query) == pytest.approx(0.2, rel=2e-2)


@pytest.mark.parametrize(("rank", "share"), [(0, 0.36), (1, 0.64)])
def test_two_springs_that_are_not_strained_oscillate_along_and_across(rank: int, share: float) -> None:
    """The nails are 0.6 m apart, the block 0.4 m from their line: K = 2k diag(0.36, 0.64) along and across it."""
    query = PeriodQuery("period", measure="frequency", small=True, of=("springs.block",), rank=rank, modes=2)
    found = held(((0.0, 0.0), (0.168, 0.576)), 0.5, query)
    assert found == pytest.approx(sqrt(2.0 * STIFF * share / MASS) / (2.0 * pi))


def test_springs_nailed_nearly_above_each_other_are_nearly_at_a_right_angle_to_the_x_axis() -> None:
    """Midway between two nails, K = 2k (1 − ℓ₀/ℓ) across; a slope from rounded coordinates would be inaccurate."""
    query = PeriodQuery("period", measure="frequency", small=True, of=("springs.block",), rank=0, modes=2)
    found = held(((0.2, 0.0), (0.203, 0.8)), 0.3, query)
    assert found == pytest.approx(sqrt(2.0 * STIFF * (1.0 - 0.3 / hypot(0.0015, 0.4)) / MASS) / (2.0 * pi))


def test_a_reverse_question_about_an_equilibrium_finds_the_natural_length() -> None:
    springs = tuple(NailedSpring(stiffness=STIFF, length=0.4, x=x, y=y) for x, y in CORNERS)
    scene = Scene(
        entities=(Named(name="springs", entity=SpringBlock(block=Block(mass=MASS), springs=springs, x=0.2, y=0.1)),)
    )
    setting = asked(scene, EquilibriumQuery("equilibrium", Target("spring force", "springs.springs.0")))
    assert setting.answer is not None
    stated = StatedResult(repr(setting.answer), "N")
    reverse = replace(setting, unknown="springs.springs.1.length", stated=stated)
    found = solve(reverse)
    assert found.derived, found.reason
    assert found.answer == pytest.approx(0.4)
    assert not faults(found, 0.4)
    assert not read(found.text).broken


# ---- a body that rocks

RADIUS, HOLE, OFFSET = 0.2, 0.08, 0.1
ASIDE = HOLE**2 * OFFSET / (RADIUS**2 - HOLE**2)  # of the centre of mass, from the axis
DISC = MASS / (RADIUS**2 - HOLE**2)  # per unit of the square of a radius
OWN = DISC * (RADIUS**4 / 2.0 - HOLE**4 / 2.0 - HOLE**2 * OFFSET**2) - MASS * ASIDE**2


def rocked(query: Query, angle: float = 0.0) -> float:
    body = BoredCylinder(mass=MASS, radius=RADIUS, hole=HOLE, offset=OFFSET)
    hole = Hole(bearing=70.0, towards="right" if angle == 0.0 else "downhill")
    return answer("roller", RollingEntity(body=body, plane=Incline(angle=angle), hole=hole, grip=NoSlipping()), query)


def test_a_bored_cylinder_rocks_on_a_level_plane() -> None:
    """With the hole on top, T = 2π √(I/(m g c)), where I is about the line of contact."""
    about = OWN + MASS * (RADIUS - ASIDE) ** 2
    period = rocked(PeriodQuery("period", small=True, of=("roller.body",)))
    assert period == pytest.approx(2.0 * pi * sqrt(about / (MASS * G * ASIDE)))


def test_a_bored_cylinder_begins_to_roll() -> None:
    """The centre of mass is c sin 70° to the left of the contact and R − c cos 70° above it."""
    lever, high = ASIDE * sin(radians(70.0)), RADIUS - ASIDE * cos(radians(70.0))
    grown = MASS * G * lever / (OWN + MASS * (lever**2 + high**2))
    assert rocked(at("angular acceleration", "roller.body", AtStart(), "start")) == pytest.approx(grown)
    friction = rocked(at("friction force", "roller.body", AtStart(), "start"))
    assert friction == pytest.approx(MASS * grown * high)


def test_on_a_slope_its_centre_of_mass_comes_to_rest_above_the_contact() -> None:
    """The equilibrium has sin ψ = (R/c) sin β, with the centre of mass R cos β − c cos ψ above the contact."""
    tilt = radians(3.0)
    psi = asin(RADIUS * sin(tilt) / ASIDE)
    about = OWN + MASS * (RADIUS * cos(tilt) - ASIDE * cos(psi)) ** 2
    period = rocked(PeriodQuery("period", small=True, of=("roller.body",)), 3.0)
    assert degrees(psi) > 3.0
    assert period == pytest.approx(2.0 * pi * sqrt(about / (MASS * G * ASIDE * cos(psi))))

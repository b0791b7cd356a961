"""Tests of a pendulum on a freely sliding carriage against closed forms derived by hand.

A ball of mass m hangs on a light rod of length ℓ, hinged to a carriage of mass M, and is released at rest at θ.
The total momentum along the rail stays zero, so with μ = M + m and u = ℓ φ′ the carriage has the velocity
V = m u cos φ/μ, and by energy
½ M V² + ½ m ((u cos φ − V)² + (u sin φ)²) = m g ℓ (cos φ − cos θ); hence u² = 2 g ℓ (cos φ − cos θ) μ/(M + m sin² φ).
Along the rod in the frame of the carriage, which is accelerated by A = T sin φ/M: T + m A sin φ = m g cos φ + m u²/ℓ.
See Morin, Introduction to Classical Mechanics, chapters 5 and 6.
"""

from math import atan, cos, degrees, pi, radians, sin, sqrt

import numpy as np
import pytest

from joined_entities import pivot, scene, string
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.angles import Deflected, TurnedThrough
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.times import AtStart, WholeMotion
from sim2reason.questions.moments.turning_points import HighestPoint, LowestPoint, Stopped
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.questions.query import Query, Target
from sim2reason.scenes.bodies.blocks import Block, Carriage
from sim2reason.scenes.bodies.oscillators import Ball, LightRod, UniformRod
from sim2reason.scenes.bodies.round_bodies import Sphere
from sim2reason.scenes.dsl.entity import Entity
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import LightRodPendulum, RigidPendulum, SliderMass
from sim2reason.scenes.entities.pieces import AxialPiece, RoundPiece
from sim2reason.scenes.entities.string_ends import ConstantForcePuller, Hanging, HangingMass
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.solutions import STRATEGIES, ProblemContext, Solution, solve, solve_with
from sim2reason.solutions.closed_forms import closed_form
from sim2reason.solutions.solution import RELATION_RTOL
from sim2reason.solutions.swings.carriage import carriage_system
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import RTOL_BY_KIND, faults
from worked import asked, solution_text

NAME = "momentum and energy on a carriage"
G, M, SMALL, LENGTH, THETA = 9.8, 3.2, 1.4, 0.9, radians(50.0)
ALL = M + SMALL
CART, BOB = "cart.carriage", "it.bob"


def swinging(*more: str, angle: float = degrees(THETA), **others: Entity) -> Scene:
    """Return a scene with a pendulum on a carriage and optional strings, as in ``swinging("right", hand=...)``."""
    rod = LightRodPendulum(bob=Ball(mass=SMALL), rod=LightRod(length=LENGTH), angle=angle)
    entities = {"cart": SliderMass(carriage=Carriage(mass=M)), "it": rod, **others}
    strings = [string(f"cart.{side}", f"{name}.end") for side, name in zip(more, others, strict=True)]
    return scene(entities, pivot("cart.pivot", "it.base"), *strings)


def derived(setting: ProblemContext) -> Solution:
    found = solve(setting)
    assert found.strategy == NAME, found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer, RTOL_BY_KIND.get(setting.query.kind, RELATION_RTOL)), found.text
    reading = read(found.text)
    assert not [*reading.broken, *reading.unread]
    return found


def close(made: Scene, query: Query, expected: float) -> None:
    assert derived(asked(made, query)).answer == pytest.approx(expected, rel=1e-7)


def relative(phi: float) -> float:
    """Return the speed of the ball relative to the carriage."""
    return sqrt(2.0 * G * LENGTH * (cos(phi) - cos(THETA)) * ALL / (M + SMALL * sin(phi) ** 2))


def test_at_release_the_rod_pulls_the_carriage() -> None:
    """The rod force is T = M m g cos θ/(M + m sin² θ), and the carriage has the acceleration T sin θ/M."""
    pull = M * SMALL * G * cos(THETA) / (M + SMALL * sin(THETA) ** 2)
    made = swinging()
    for quantity, subject, expected in (
        ("rod force", "it.bob", pull),
        ("acceleration", CART, pull * sin(THETA) / M),
        ("net force", BOB, sqrt((pull * sin(THETA)) ** 2 + (pull * cos(THETA) - SMALL * G) ** 2)),
        ("acceleration", BOB, sqrt((pull * sin(THETA) / SMALL) ** 2 + (pull * cos(THETA) / SMALL - G) ** 2)),
    ):
        close(made, Query("start", Target(quantity, subject), AtStart()), expected)


def test_at_the_lowest_point_momenta_are_opposite() -> None:
    """m v = M V and ½ m v² + ½ M V² = m g ℓ (1 − cos θ); relative to the carriage, T − m g = m (v + V)²/ℓ."""
    energy, lowest, made = SMALL * G * LENGTH * (1.0 - cos(THETA)), LowestPoint(BOB), swinging()
    ball = sqrt(2.0 * energy * M / (SMALL * ALL))
    cart = SMALL * ball / M
    for quantity, subject, expected in (
        ("velocity", BOB, ball),
        ("velocity", CART, cart),
        ("kinetic energy", CART, 0.5 * M * cart**2),
        ("momentum", BOB, SMALL * ball),
        ("displacement", CART, SMALL * LENGTH * sin(THETA) / ALL),
        ("potential energy", BOB, energy),
        ("rod force", "it.bob", SMALL * (G + (ball + cart) ** 2 / LENGTH)),
    ):
        close(made, Query("event", Target(quantity, subject), lowest), expected)


def test_at_a_stated_angle() -> None:
    phi, made = radians(20.0), swinging()
    u, moment = relative(phi), Deflected(BOB, 20.0)
    cart = SMALL * u * cos(phi) / ALL
    ball = sqrt((u * cos(phi) - cart) ** 2 + (u * sin(phi)) ** 2)
    pull = SMALL * M * (G * cos(phi) + u**2 / LENGTH) / (M + SMALL * sin(phi) ** 2)
    ahead = (SMALL * LENGTH / ALL) * (sin(THETA) - sin(phi))
    for quantity, subject, expected in (
        ("velocity", CART, cart),
        ("velocity", BOB, ball),
        ("acceleration", CART, pull * sin(phi) / M),
        ("displacement", CART, ahead),
    ):
        close(made, Query("event", Target(quantity, subject), moment), expected)


def test_the_carriage_comes_to_rest_where_the_ball_is_as_high_as_at_first() -> None:
    """The common centre of mass stays at rest, so X = 2 m ℓ sin θ/(M + m)."""
    far, made = 2.0 * SMALL * LENGTH * sin(THETA) / ALL, swinging()
    close(made, Query("event", Target("displacement", CART), Stopped(CART)), far)
    close(made, StretchQuery("extremum", None, WholeMotion(), "greatest displacement", CART), far)
    close(made, StretchQuery("sum", None, Stopped(CART), "distance travelled", CART), far)
    close(made, Query("event", Target("displacement", BOB), Stopped(CART)), 2.0 * M * LENGTH * sin(THETA) / ALL)


def test_how_far_the_carriage_has_moved_says_where_the_ball_is() -> None:
    """The displacement of the carriage times M + m is m ℓ (sin θ − sin φ)."""
    phi = np.arcsin(sin(THETA) - 0.3 * ALL / (SMALL * LENGTH))
    close(swinging(), Query("event", Target("deflection", BOB), Moved(CART, 0.3)), degrees(abs(phi)))


def test_the_carriage_is_fastest_where_the_rod_hangs_straight_down() -> None:
    cart = SMALL * relative(0.0) / ALL
    found = StretchQuery("extremum", None, WholeMotion(), "greatest speed", CART)
    close(swinging(), found, cart)


@pytest.mark.parametrize("measure", ["period", "frequency", "angular frequency"])
def test_small_oscillations_are_faster_than_on_a_fixed_hinge(measure: str) -> None:
    """The angular frequency is given by ω² = (1 + m/M) g/ℓ."""
    rate = sqrt(ALL * G / (M * LENGTH))
    expected = {"period": 2.0 * pi / rate, "frequency": rate / (2.0 * pi), "angular frequency": rate}[measure]
    close(swinging(), PeriodQuery("period", None, None, measure, small=True, of=(CART, BOB)), expected)


def arm(*, rod: bool) -> tuple[Scene, float, float, float]:
    """Return a scene with an arm on a carriage, and the arm's mass, Σ m r and moment of inertia about the axle."""
    mass, radius, place = 2.1, 0.2, 0.6
    pieces = [RoundPiece(distance=place, body=Sphere(mass=mass, radius=radius))]
    whole, moment, inertia = mass, mass * place, mass * (place**2 + 0.4 * radius**2)
    if rod:
        pieces = [*pieces, AxialPiece(distance=0.2, body=UniformRod(mass=0.8, length=0.3), axis="along the arm")]
        whole, moment, inertia = whole + 0.8, moment + 0.8 * 0.2, inertia + 0.8 * (0.2**2 + 0.3**2 / 12.0)
    swung = RigidPendulum(pieces=tuple(pieces), angle=degrees(THETA))
    made = scene({"cart": SliderMass(carriage=Carriage(mass=M)), "it": swung}, pivot("cart.pivot", "it.axle"))
    return made, whole, moment, inertia


@pytest.mark.parametrize("rod", [False, True])
def test_an_arm_with_a_moment_of_inertia(*, rod: bool) -> None:
    """I′ = I − S²/(M + m), and α = S g sin θ/(I − S² cos² θ/(M + m)) at the start."""
    made, whole, s, inertia = arm(rod=rod)
    give = inertia - (s * cos(THETA)) ** 2 / (M + whole)
    close(made, Query("start", Target("angular acceleration", "it.arm"), AtStart()), s * G * sin(THETA) / give)
    turns = sqrt(2.0 * s * G * (1.0 - cos(THETA)) / (inertia - s**2 / (M + whole)))
    sphere = "it.pieces.0.body"
    close(made, Query("event", Target("angular velocity", "it.arm"), LowestPoint(sphere)), turns)
    close(made, Query("event", Target("velocity", CART), LowestPoint(sphere)), s * turns / (M + whole))
    small = PeriodQuery("period", None, None, "angular frequency", small=True, of=(CART, sphere))
    if not rod:
        close(made, small, sqrt(s * G / (inertia - s**2 / (M + whole))))


def test_a_hand_pulls_the_carriage() -> None:
    """The inertial force in the frame accelerated by F/(M + m) does work, too."""
    force = 12.0
    made, drift = swinging("right", hand=ConstantForcePuller(force=force)), force / ALL
    rise = (force + SMALL * G * sin(THETA) * cos(THETA)) / (M + SMALL * sin(THETA) ** 2)
    close(made, Query("start", Target("acceleration", CART), AtStart()), rise)
    phi = radians(20.0)
    worth = G * (cos(phi) - cos(THETA)) - drift * (sin(phi) - sin(THETA))
    squared = 2.0 * ALL * worth / (LENGTH * (M + SMALL * sin(phi) ** 2))
    pull = SMALL * (M * (G * cos(phi) + LENGTH * squared) - force * sin(phi)) / (M + SMALL * sin(phi) ** 2)
    close(made, Query("event", Target("rod force", "it.bob"), Deflected(BOB, 20.0)), pull)


def test_about_a_tilted_vertical_the_ball_swings_as_far_to_both_sides() -> None:
    """The effective gravity is tilted by β = arctan F/((M + m) g), so the rod turns by 2 (β − θ)."""
    force, angle = 30.0, 10.0
    made = swinging("left", angle=angle, hand=ConstantForcePuller(force=force))
    turned = 2.0 * (degrees(atan(force / (ALL * G))) - angle)
    close(made, Query("event", Target("deflection", BOB), HighestPoint(BOB)), angle + turned)
    raised = SMALL * G * LENGTH * (cos(radians(angle)) - cos(radians(angle + turned)))
    close(made, Query("event", Target("potential energy", BOB), HighestPoint(BOB)), raised)


def test_a_block_pulls_the_carriage() -> None:
    """With M′ = M + m_B and F = −m_B g: A = (m g sin θ cos θ − m_B g)/(M + m_B + m sin² θ), T = m_B (g + A)."""
    heavy = 2.0
    made = swinging("left", load=HangingMass(system=Hanging(blocks=(Block(mass=heavy),))))
    rise = (SMALL * G * sin(THETA) * cos(THETA) - heavy * G) / (M + heavy + SMALL * sin(THETA) ** 2)
    close(made, Query("start", Target("acceleration", CART), AtStart()), abs(rise))
    close(made, Query("start", Target("tension", made.mechanism.lines[0].name), AtStart()), heavy * (G + rise))


def test_a_block_that_hangs_counts_as_part_of_the_carriage() -> None:
    """The block moves vertically, so neither its weight nor its momentum has a component along the rail."""
    text = solution_text("mixed-hard-multipart-301933-0")
    said = (
        "Block B moves vertically as fast as the carriage along the rail, so it acts as a mass $m_B$ fixed to the "
        "carriage that a force $m_B g$ pulls to the right. The force along the rail"
    )
    assert text.count(said) == 1
    assert "At this moment, the arm being on the other side of the vertical, in the frame" in text
    assert "the angular acceleration of the arm, clockwise, is" in text
    assert "rod" not in text


def test_an_arm_makes_its_carriage_fastest_at_its_lowest_point() -> None:
    """V² ∝ cos² φ (cos φ − cos θ)/(M I − S² cos² φ)."""
    made, *_ = arm(rod=False)
    text = derived(asked(made, StretchQuery("extremum", None, WholeMotion(), "greatest speed", CART))).text
    assert r"\cos^{2} \varphi\,\left(\cos\varphi - \cos\theta\right)" in text


def test_what_takes_the_time_is_left_to_integration() -> None:
    made = swinging("right", hand=ConstantForcePuller(force=12.0))
    setting = asked(made, Query("event", Target("velocity", CART), Deflected(BOB, 20.0)))
    assert "takes the time" in solve_with(STRATEGIES[NAME], setting).reason
    assert solve(setting).strategy == "integration"


def test_upward_it_moves_against_the_way_in_which_the_rod_turns() -> None:
    """The upward velocity is u sin φ, negative on the side of the start and positive on the other one."""
    phi, made, up = radians(20.0), swinging(), Sense("upward", (0.0, 0.0, 1.0))
    moment, fallen = Deflected(BOB, 20.0), LENGTH * (cos(THETA) - cos(phi))
    close(made, Query("event", Target("velocity", BOB, up), moment), -relative(phi) * sin(phi))
    close(made, Query("event", Target("displacement", BOB, up), moment), fallen)
    over = Query("event", Target("momentum", BOB, up), TurnedThrough(BOB, degrees(THETA + phi)))
    close(made, over, SMALL * relative(phi) * sin(phi))


@pytest.mark.parametrize(
    "query",
    [
        Query("event", Target("velocity", CART), LowestPoint(BOB)),
        Query("event", Target("displacement", CART), Stopped(CART)),
        Query("start", Target("acceleration", CART), AtStart()),
    ],
)
def test_there_are_formulas_of_carriages(query: Query) -> None:
    """The closed forms are short enough for an answer."""
    setting = asked(swinging(), query)
    assert carriage_system(setting.mechanism) is not None
    found = solve(setting, derived=True)
    assert found.strategy == NAME
    assert len(closed_form(found).latex) < 100

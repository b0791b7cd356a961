"""Tests of times in swings and of rockets after burnout, against tables and closed forms."""

from math import acos, asin, cos, degrees, gamma, log, pi, radians, sin, sqrt

import pytest

from sim2reason.questions import Query, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.angles import Deflected, TurnedThrough
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import HighestPoint, LowestPoint, Stopped
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.bodies.oscillators import Ball, Cord, LightRod, UniformRod
from sim2reason.scenes.bodies.space import DeepSpace, LevelGround, Rocket
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum, RotationEntity
from sim2reason.scenes.entities.pieces import AxialPiece
from sim2reason.scenes.entities.space import RocketEntity
from sim2reason.solutions import solve
from worked import answer, asked

G, LENGTH = 9.8, 0.8
RATE = sqrt(G / LENGTH)
BOB = "pendulum.bob"
SCENE = Scene(
    entities=(
        Named(
            name="pendulum",
            entity=Pendulum(bob=Ball(mass=0.5), hanger=LightRod(length=LENGTH), angle=20.0, speed=1.5),
        ),
    )
)
HALF = 1.685750354812596  # K(k² = 1/4), Abramowitz and Stegun, table 17.1
LEMNISCATE = gamma(0.25) ** 2 / (4.0 * sqrt(pi))  # K(k² = 1/2), 17.3.9


def pendulum(query: Query, angle: float, speed: float | None = None, *, rod: bool = False) -> float:
    hanger = LightRod(length=LENGTH) if rod else Cord(length=LENGTH)
    return answer("pendulum", Pendulum(bob=Ball(mass=0.5), hanger=hanger, angle=angle, speed=speed), query)


@pytest.mark.parametrize(("angle", "quarter"), [(60.0, HALF), (90.0, LEMNISCATE)])
def test_a_bob_let_go_comes_down_after_a_quarter_of_its_period(angle: float, quarter: float) -> None:
    """The time is T/4 = K(sin(θ/2))/ω₀ (Landau and Lifshitz, Mechanics, § 11)."""
    found = pendulum(Query("time_to_event", None, LowestPoint(BOB)), angle)
    assert found == pytest.approx(quarter / RATE, rel=1e-9)


def test_the_angle_in_the_integral_is_introduced() -> None:
    setting = asked(SCENE, Query("time_to_event", None, LowestPoint(BOB)))
    text = solve(setting).text
    assert r"Let $\varphi$ be the angle from the lowest position. By conservation of energy, $\dot\varphi^{2}$" in text
    assert "the time since the lowest position is" in text


def test_a_bob_on_a_rod_goes_over_the_top() -> None:
    """With k = 2 the time to the top is K(1/k)/(k ω₀)."""
    query = Query("time_to_event", None, HighestPoint(BOB))
    found = pendulum(query, 0.0, 4.0 * RATE * LENGTH, rod=True)
    assert found == pytest.approx(HALF / (2.0 * RATE), rel=1e-9)


def test_after_an_eighth_of_the_period() -> None:
    """sn(K/2) = 1/√(1 + k′) gives sin(φ/2) = k/√(1 + k′) with k′ = cos(θ/2).

    Source: Abramowitz and Stegun, 16.5.2.
    """
    k, other = sin(radians(30.0)), sqrt(0.75)
    angle = 2.0 * asin(k / sqrt(1.0 + other))
    query = Query("state", Target("deflection", "pendulum.hanger"), AtTime(0.5 * HALF / RATE))
    assert pendulum(query, 60.0) == pytest.approx(degrees(angle), rel=1e-8)


def test_a_rod_that_swings_far() -> None:
    """The period follows from ω₀² = 3 g/2 L and K(sin 30°).

    From the vertical to sin(φ/2) = ½ sin 30° the time times ω₀ is F(π/6, ½) = 0.529427.
    """
    rod = AxialPiece(distance=0.5, body=UniformRod(mass=1.0, length=1.0), axis="along the arm")
    arm, rate = RotationEntity(pieces=(rod,), angle=60.0), sqrt(1.5 * G)
    period = PeriodQuery("period", None, None, "period", of=("arm.arm",))
    assert answer("arm", arm, period) == pytest.approx(4.0 * HALF / rate, rel=1e-9)
    query = Query("time_to_event", None, Deflected("arm.arm", degrees(2.0 * asin(0.25))))
    assert answer("arm", arm, query) == pytest.approx((HALF - 0.5294286270519) / rate, rel=1e-9)


# ---- rockets

START, DRY, RATE_OF_BURNING, EXHAUST = 800.0, 300.0, 10.0, 0.9
LASTS = (START - DRY) / RATE_OF_BURNING
ROCKET = "rocket.rocket"


def rocket(query: Query, place: LevelGround | DeepSpace, rate: float = RATE_OF_BURNING) -> float:
    body = Rocket(mass=START, dry=DRY)
    return answer("rocket", RocketEntity(rocket=body, place=place, exhaust=EXHAUST, rate=rate), query)


def burned(g: float, rate: float = RATE_OF_BURNING, first: float = START) -> tuple[float, float]:
    """Return the speed u ln(m₀/m) − g t and the distance at burnout (Kleppner and Kolenkow, § 3.6)."""
    u, time = 1000.0 * EXHAUST, (first - DRY) / rate
    speed = u * log(first / DRY) - g * time
    return speed, u * time - u * DRY / rate * log(first / DRY) - 0.5 * g * time**2


def test_in_empty_space_it_keeps_its_speed() -> None:
    """The speed is V = u ln(m₀/m₁) from burnout on."""
    speed, way = burned(0.0)
    found = rocket(Query("state", Target("displacement", ROCKET), AtTime(LASTS + 25.0)), DeepSpace())
    assert found == pytest.approx(way + 25.0 * speed, rel=1e-9)


def test_above_the_ground_it_goes_on_as_thrown() -> None:
    """The greatest height is H = h₁ + v₁²/2g."""
    speed, way = burned(G)
    query = StretchQuery("extremum", None, AtTime(LASTS + 1.5 * speed / G), "greatest displacement", ROCKET)
    assert rocket(query, LevelGround()) == pytest.approx(way + speed**2 / (2.0 * G), rel=1e-9)
    found = rocket(Query("time_to_event", None, Stopped(ROCKET, number=1)), LevelGround())
    assert found == pytest.approx(LASTS + speed / G, rel=1e-9)


def test_one_that_is_too_heavy_at_first_waits() -> None:
    """A rocket that is too heavy at first rises once its mass is µ u/g."""
    rate = 7.0
    first = rate * 1000.0 * EXHAUST / G
    speed, _ = burned(G, rate, first)
    query = Query("time_to_event", None, Stopped(ROCKET, number=1))
    assert rocket(query, LevelGround(), rate) == pytest.approx((START - DRY) / rate + speed / G, rel=1e-9)


# ---- what adds up


def summed(functional: str, subject: str, moment: Moment, angle: float, speed: float | None = None) -> float:
    return pendulum(StretchQuery("sum", None, moment, functional, subject), angle, speed, rod=True)


def test_a_bob_let_go_travels_its_whole_arc_until_it_stops() -> None:
    assert summed("distance travelled", BOB, Stopped(BOB), 50.0) == pytest.approx(2.0 * LENGTH * radians(50.0))


def test_after_a_period_and_an_eighth_a_bob_has_travelled_four_amplitudes_and_more() -> None:
    """A bob released at 60° is at sin(φ/2) = k/√(1 + k′) after T/8."""
    k, other = sin(radians(30.0)), sqrt(0.75)
    angle = 2.0 * asin(k / sqrt(1.0 + other))
    expected = LENGTH * (4.0 * radians(60.0) + radians(60.0) - angle)
    found = summed("distance travelled", BOB, AtTime(4.5 * HALF / RATE), 60.0)
    assert found == pytest.approx(expected, rel=1e-8)


def test_a_rod_that_is_thrown_turns_up_and_then_back() -> None:
    """A rod launched downward at 20° turns back at cos Φ = cos 20° − v²/2gℓ on the other side."""
    reach = acos(cos(radians(20.0)) - 1.5**2 / (2.0 * G * LENGTH))
    moment = AtTime(0.9)
    state = asked(SCENE, Query("state", Target("angle turned", "pendulum.hanger"), moment))
    assert state.answer is not None
    net = radians(state.answer)  # all the while below the second place where it turns back
    found = summed("total angle", "pendulum.hanger", moment, 20.0, 1.5)
    assert found == pytest.approx(degrees(2.0 * (radians(20.0) + reach) - net), rel=1e-8)


def test_what_goes_round_never_turns_back() -> None:
    """The distance travelled in one revolution from the lowest point is the circumference."""
    speed = 4.0 * RATE * LENGTH
    time = 2.0 * HALF / (2.0 * RATE)
    assert summed("distance travelled", BOB, AtTime(time), 0.0, speed) == pytest.approx(2.0 * pi * LENGTH, rel=1e-8)


def test_the_impulse_on_a_bob_is_the_change_of_its_momentum() -> None:
    """The impulse on a bob released at 60° is m v when it is at 20°."""
    speed = sqrt(2.0 * G * LENGTH * (cos(radians(20.0)) - cos(radians(60.0))))
    found = summed("impulse of the net force", BOB, Deflected("pendulum.hanger", 20.0), 60.0)
    assert found == pytest.approx(0.5 * speed)


def test_the_impulse_up_to_the_top_is_a_chord_whose_angle_is_told_without_pi() -> None:
    """For a launch downward at 30° with 7 m/s, the velocity at the top is turned by 210°; cos 210° = −cos 30°."""
    top = sqrt(49.0 - 2.0 * G * LENGTH * (1.0 + cos(radians(30.0))))
    expected = 0.5 * sqrt(49.0 + top**2 + 14.0 * top * cos(radians(30.0)))
    pendulum = Pendulum(bob=Ball(mass=0.5), hanger=LightRod(length=LENGTH), angle=30.0, speed=7.0)
    query = StretchQuery("sum", None, HighestPoint(BOB), "impulse of the net force", BOB)
    found = solve(asked(Scene(entities=(Named(name="pendulum", entity=pendulum),)), query))
    assert found.derived
    assert found.answer == pytest.approx(expected, rel=1e-9)
    assert "\\pi" not in found.text


def test_the_impulse_on_a_thrown_bob_is_a_chord() -> None:
    """For a launch downward at 30° with 2 m/s, the velocity at the lowest point is turned by 30°."""
    speed = sqrt(4.0 + 2.0 * G * LENGTH * (1.0 - cos(radians(30.0))))
    expected = 0.5 * sqrt(4.0 + speed**2 - 4.0 * speed * cos(radians(30.0)))
    assert summed("impulse of the net force", BOB, LowestPoint(BOB), 30.0, 2.0) == pytest.approx(expected)


def test_what_goes_round_is_where_it_has_turned_beyond_a_whole_turn() -> None:
    """v² = v₀² + 2 g ℓ (cos φ − cos θ); a bob launched downward at 30° is at 30° − 400° then."""
    pendulum = Pendulum(bob=Ball(mass=0.5), hanger=LightRod(length=LENGTH), angle=30.0, speed=7.0)
    query = Query("event", Target("velocity", BOB), TurnedThrough(BOB, 400.0))
    speed = sqrt(49.0 + 2.0 * G * LENGTH * (cos(radians(370.0)) - cos(radians(30.0))))
    assert answer("pendulum", pendulum, query) == pytest.approx(speed)

"""Tests of tumbling prisms: energy about each edge and angular momentum at each landing, in closed form."""

from math import cos, hypot, pi, radians, sin, sqrt

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim2reason.questions import Query, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.angles import TurnedThrough
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import HighestPoint
from sim2reason.scenes.bodies.blocks import SIDES, LongPrism, Polygon
from sim2reason.scenes.bodies.simple_machines import Incline
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.rolling import TumblingPrism
from sim2reason.solutions import solve
from worked import answer, asked

G, RADIUS, MASS, SLOPE, RATE = 9.8, 0.1, 2.0, 9.0, 5.0
PRISM = "prism.prism"


def tumbling(shape: Polygon = "octagonal", rate: float = RATE) -> TumblingPrism:
    return TumblingPrism(prism=LongPrism(shape=shape, radius=RADIUS, mass=MASS), plane=Incline(angle=SLOPE), rate=rate)


def inertia(sides: int) -> float:
    """Return the moment of inertia of a prism about an edge over m R², (8 + cos 2π/n)/6.

    For the axis through the centre of a regular polygon it is (2 + cos 2π/n)/6.
    """
    return (8.0 + cos(2.0 * pi / sides)) / 6.0


def rate_at(sides: int, rate: float, angle: float) -> float:
    """Return the angular velocity after a rotation, by energy and the factor (2 + 7c)/(8 + c) at each landing."""
    turn, first = 2.0 * pi / sides, radians(SLOPE) - pi / sides
    pull, c = 2.0 * G / (inertia(sides) * RADIUS), cos(turn)
    while angle > turn:
        rate = sqrt(rate**2 + pull * (cos(first) - cos(first + turn))) * (2.0 + 7.0 * c) / (8.0 + c)
        angle -= turn
    return sqrt(rate**2 + pull * (cos(first) - cos(first + angle)))


@settings(max_examples=8, deadline=None)
@given(st.sampled_from(["octagonal", "decagonal"]), st.integers(10, 150))
def test_how_fast_it_is_after_so_many_edges(shape: Polygon, angle: int) -> None:
    sides = SIDES[shape]
    if angle % (360 // sides) == 0:
        return
    found = answer("prism", tumbling(shape), Query("event", Target("velocity", PRISM), TurnedThrough(PRISM, angle)))
    assert found == pytest.approx(RADIUS * rate_at(sides, RATE, radians(angle)), rel=1e-8)


def test_the_acceleration_at_the_start() -> None:
    """The acceleration is R √(ω⁴ + α²) with α = g sin(θ − π/n)/(κ R)."""
    growth = G * sin(radians(SLOPE) - pi / 8.0) / (inertia(8) * RADIUS)
    found = answer("prism", tumbling(), Query("start", Target("acceleration", PRISM), AtStart()))
    assert found == pytest.approx(RADIUS * hypot(RATE**2, growth), rel=1e-9)


def test_at_the_highest_point_its_centre_is_above_an_edge() -> None:
    found = answer("prism", tumbling(), Query("event", Target("angular velocity", PRISM), HighestPoint(PRISM)))
    assert found == pytest.approx(rate_at(8, RATE, pi / 8.0 - radians(SLOPE)), rel=1e-8)


def test_the_impulse_of_all_forces() -> None:
    """The centre moves perpendicular to the line to the edge, turned by the angle since the last landing."""
    turned = radians(120.0 - 2.0 * 45.0)
    rate = rate_at(8, RATE, radians(120.0))
    expected = MASS * RADIUS * sqrt(RATE**2 + rate**2 - 2.0 * RATE * rate * cos(turned))
    query = StretchQuery("sum", None, TurnedThrough(PRISM, 120.0), "impulse of the net force", PRISM)
    assert answer("prism", tumbling(), query) == pytest.approx(expected, rel=1e-8)


def test_at_a_time_after_a_landing() -> None:
    """The time is the integral of dφ/ω, summed here over small steps of the angle."""
    angle, time, count = 0.0, 0.0, 40000
    step = 1.2 / count
    while time < 0.3:
        time += step / rate_at(8, RATE, angle + 0.5 * step)
        angle += step
    query = Query("state", Target("angular velocity", PRISM), AtTime(0.3))
    assert answer("prism", tumbling(), query) == pytest.approx(rate_at(8, RATE, angle), rel=1e-4)


def test_each_edge_begins_a_phase() -> None:
    query = Query("event", Target("velocity", PRISM), TurnedThrough(PRISM, 120.0))
    found = solve(asked(Scene(entities=(Named(name="prism", entity=tumbling()),)), query))
    assert found.strategy == "tumbling over edges"
    assert [phase.begins for phase in found.phases] == ["the start of the motion", "an edge lands", "an edge lands"]

"""Tests of a prism that tumbles from edge to edge, against conservation of angular momentum and energy."""

from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

import sim2reason
from drawn_entities import certified, drawn_entity, travels
from lone_entities import alone, followed
from sim2reason.scenes.bodies.blocks import SIDES, LongPrism
from sim2reason.scenes.bodies.simple_machines import Incline
from sim2reason.scenes.dsl.measures import Range
from sim2reason.scenes.entities.rolling import TumblingPrism
from sim2reason.simulation.trace import Trace

G = 9.8
CLOSE = 1e-8
MANY = ("hexagonal", "heptagonal", "octagonal", "decagonal", "dodecagonal")
CHOICES = {"rate?": 1.0, "angle": Range(3.0, 15.0), "LongPrism.shape": MANY}
BRISK = {**CHOICES, "angle": Range(6.0, 12.0), "LongPrism.shape": MANY[2:], "TumblingPrism.rate": Range(4.5, 6.0)}


def prism(shape: str = "hexagonal", angle: float = 10.0, rate: float | None = 6.0) -> TumblingPrism:
    """Build a prism of radius 0.1 m on a slope."""
    body = LongPrism(mass=2.0, shape=shape, radius=0.1)  # type: ignore[arg-type]
    return TumblingPrism(prism=body, plane=Incline(angle=angle), rate=rate)


def landings(trace: Trace) -> list[float]:
    """Return the times at which edges land."""
    return [event.time for event in trace.events if event.kind == "land"]


def spins(trace: Trace, times: list[float]) -> list[float]:
    """Return the angular velocity down the slope at some times, just after any event at them."""
    return [-float(w) for w in trace.sample(np.array(times)).v[:, 2]]


@pytest.mark.parametrize("shape", MANY)
def test_what_a_landing_leaves_of_the_spin(shape: str) -> None:
    """The ratio is ω⁺/ω⁻ = (I + mr² cos 2π/n)/(I + mr²) with I = mr²(2 + cos 2π/n)/6.

    For a hexagon it is 11/17: IPhO 1998, problem 1. Between landings ½(I + mr²)ω² + mgh is constant: the axis
    falls from r cos(π/n − α) to r cos(π/n + α).
    """
    n, slope, radius = SIDES[shape], radians(10.0), 0.1
    inertia = (2.0 + cos(2.0 * pi / n)) / 6.0
    kept = (inertia + cos(2.0 * pi / n)) / (inertia + 1.0)
    assert shape != "hexagonal" or kept == pytest.approx(11.0 / 17.0)
    fall = 2.0 * G * (cos(pi / n - slope) - cos(pi / n + slope)) / (radius * (inertia + 1.0))
    trace = followed(prism(shape), 1.2)
    rate, wanted = 6.0, list[float]()
    for _ in landings(trace):
        rate = kept * sqrt(rate**2 + fall)
        wanted.append(rate)
    assert len(wanted) >= 3
    assert spins(trace, landings(trace)) == pytest.approx(wanted, rel=CLOSE)


def test_when_the_first_edge_lands() -> None:
    """The time is t = ∫ dφ/ω(φ), with φ from 0 to 2π/n, by Gaussian quadrature.

    ω² = ω₀² + 2mgr(cos(π/n − α) − cos(π/n − α − φ))/(I + mr²).
    """
    half, slope = pi / 6.0, radians(10.0)
    nodes, weights = np.polynomial.legendre.leggauss(60)
    turned = half * (nodes + 1.0)
    share = 2.0 * G / (0.1 * (5.0 / 12.0 + 1.0))
    rate = np.sqrt(36.0 + share * (cos(half - slope) - np.cos(half - slope - turned)))
    assert landings(followed(prism(), 0.5))[0] == pytest.approx(float(half * (weights / rate).sum()), rel=CLOSE)


def test_too_slow_it_falls_back() -> None:
    """The prism tips over only if ½(I + mr²)ω₀² > mgr(1 − cos(π/n − α)); else the upper edge lands again."""
    least = sqrt(2.0 * G * (1.0 - cos(pi / 6.0 - radians(10.0))) / (0.1 * 17.0 / 12.0))
    for factor, edge in ((1.001, "it.edge4"), (0.999, "it.edge0")):
        trace = followed(prism(rate=factor * least), 1.5)
        assert next(event.subjects for event in trace.events if event.kind == "land") == (edge,)


def test_on_a_steep_slope_it_tips_by_itself() -> None:
    """On a slope of more than 180°/n, a prism at rest starts with ω̇ = gr sin(α − π/n)/(I/m + r²)."""
    trace = followed(prism("dodecagonal", 20.0, None), 0.1, 11)
    inertia = (2.0 + cos(pi / 6.0)) / 6.0
    assert -trace.state.a[0, 2] == pytest.approx(G * sin(radians(5.0)) / (0.1 * (inertia + 1.0)), rel=CLOSE)


def test_its_axis_stays_as_far_from_the_edge_on_which_it_stands() -> None:
    """The axis moves in a circle of radius r about the edge, which does not slip."""
    trace = followed(prism(), 0.1, 21)
    place = trace.state.vector(trace.state.frames.center("it.prism").place)
    edge = trace.state.vector(trace.state.frames.site("it.edge5").place)
    assert edge == pytest.approx(np.tile(edge[0], (21, 1)), abs=1e-10)
    assert np.linalg.norm(place - edge, axis=1) == pytest.approx(0.1, rel=CLOSE)


def test_on_level_ground_it_tumbles_to_the_right() -> None:
    trace = followed(prism("octagonal", 0.0, 8.0), 0.2)
    assert trace.state.v[0, 2] == 8.0
    assert "right-hand edge" in sim2reason.describe(alone(prism("octagonal", 0.0, 8.0)), 1).text


@pytest.mark.parametrize("seed", range(50))
def test_text_and_file_lead_back(seed: int) -> None:
    travels(drawn_entity(TumblingPrism, seed, CHOICES), seed)


@pytest.mark.parametrize("seed", range(6))
def test_engines_agree(seed: int) -> None:
    assert certified(drawn_entity(TumblingPrism, 1000 + seed, BRISK)) == 1.0


def test_engines_agree_on_how_it_rocks_to_rest() -> None:
    """The certificate ends where landings are too frequent to distinguish."""
    _, certificate = sim2reason.certify(alone(prism(angle=12.0, rate=2.1)))
    assert certificate.reason == "crowd"


@pytest.mark.parametrize(
    ("shape", "angle", "rate", "says"),
    [
        ("square", 10.0, 5.0, "at least 5 sides"),
        ("triangular", 10.0, 5.0, "takes nearly all"),
        ("hexagonal", 30.0, None, "stays"),
    ],
)
def test_what_does_not_tumble_is_refused(shape: str, angle: float, rate: float | None, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        prism(shape, angle, rate)

"""Tests of phases integrated from stated equations: closed forms, and refusal of incomplete phases."""

from collections.abc import Callable
from copy import deepcopy
from math import asin, cos, pi, sin, sqrt

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim2reason.solutions.checking import recompute
from solution_data import Data, coordinate, phase, relation, solution, step

G = 9.8


def answer(data: Data) -> float:
    found = recompute(data)
    assert not found.faults
    assert found.answer is not None
    return found.answer


# ---- one phase


def pendulum(start: float) -> Data:
    """Return a solution for a pendulum's period, as four times the time of a quarter."""
    swinging = relation("\\alpha", ["*", -1.0, ["/", "g", "\\ell"], ["sin", "\\theta"]])
    quarter = phase(
        [coordinate("\\theta", "\\omega", "\\alpha", "\\theta_0", 0.0)],
        [swinging],
        "\\theta",
        {"\\tau": "t_1"},
        direction=-1,
    )
    givens = {"g": G, "\\ell": 0.8, "\\theta_0": start}
    return solution(givens, "T", step(integration=quarter), step(relation("T", ["*", 4.0, "t_1"])))


@given(st.floats(0.01, 3.1))
@settings(max_examples=15)
def test_a_pendulum_has_the_period_of_the_elliptic_integral(start: float) -> None:
    """The period is T = 2π √(ℓ/g)/M(1, cos ½θ), by the arithmetic-geometric mean."""
    mean, other = 1.0, cos(0.5 * start)
    for _ in range(8):
        mean, other = 0.5 * (mean + other), sqrt(mean * other)
    assert answer(pendulum(start)) == pytest.approx(2.0 * pi * sqrt(0.8 / G) / mean, rel=1e-12)


@given(st.floats(0.0, 0.95), st.integers(1, 4))
@settings(max_examples=10)
def test_an_orbit_comes_back_after_the_period_of_kepler(eccentricity: float, turns: int) -> None:
    """The distance is defined by the coordinates; the orbit starts on the line at which the phase ends."""
    fall = [
        relation("r", ["sqrt", ["+", ["^", "x", 2.0], ["^", "y", 2.0]]]),
        relation("a_x", ["/", ["*", -1.0, "\\mu", "x"], ["^", "r", 3.0]]),
        relation("a_y", ["/", ["*", -1.0, "\\mu", "y"], ["^", "r", 3.0]]),
    ]
    orbit = phase(
        [coordinate("x", "v_x", "a_x", "x_0", 0.0), coordinate("y", "v_y", "a_y", 0.0, "v_0")],
        fall,
        "y",
        {"\\tau": "t"},
        direction=1,
        occurrence=turns,
    )
    givens = {"\\mu": 1.0, "x_0": 1.0 - eccentricity, "v_0": sqrt((1.0 + eccentricity) / (1.0 - eccentricity))}
    assert answer(solution(givens, "t", step(integration=orbit))) == pytest.approx(2.0 * pi * turns, rel=1e-11)


@given(st.floats(1e-6, 0.9))
@settings(max_examples=15)
def test_two_zeros_that_are_close_are_not_passed_over(part: float) -> None:
    """A ball thrown up at v passes a height just below v²/(2 g) again at t = (v + √(v² − 2 g h))/g."""
    height = (1.0 - part) * 25.0 / (2.0 * G)
    flight = phase(
        [coordinate("y", "w", "a", 0.0, "v")],
        [relation("a", ["*", -1.0, "g"])],
        ["+", "y", ["*", -1.0, "h"]],
        {"\\tau": "t"},
        occurrence=2,
    )
    data = solution({"g": G, "v": 5.0, "h": height}, "t", step(integration=flight))
    assert answer(data) == pytest.approx((5.0 + sqrt(25.0 - 2.0 * G * height)) / G, rel=1e-9)


def wedge(unknowns: tuple[str, ...] = ("N",)) -> Data:
    """Return a solution for a block on a movable wedge, with accelerations and normal force from three equations."""
    equations = [
        relation(["*", "M", "A"], ["*", "N", ["sin", "\\theta"]]),
        relation(["*", "m", ["+", "a", ["*", -1.0, "A", ["cos", "\\theta"]]]], ["*", "m", "g", ["sin", "\\theta"]]),
        relation(["+", "N", ["*", "m", "A", ["sin", "\\theta"]]], ["*", "m", "g", ["cos", "\\theta"]]),
    ]
    slide = phase(
        [coordinate("s", "u", "a", 0.0, 0.0), coordinate("X", "V", "A", 0.0, 0.0)],
        equations,
        ["+", "s", ["*", -1.0, "d"]],
        {"V": "V_1", "W": "W_1", "N": "N_1"},
        unknowns=unknowns,
        accumulated=[{"name": "W", "rate": ["*", "N", ["sin", "\\theta"], "V"], "initial": 0.0}],
    )
    givens = {"m": 2.0, "M": 5.0, "g": G, "\\theta": 0.6, "d": 1.5}
    return solution(givens, "W_1", step(integration=slide), step(relation("N_1", "N_2", "verified")))


def test_forces_and_what_is_added_up() -> None:
    data = wedge()
    data["steps"].pop()
    normal = 2.0 * G * cos(0.6) / (1.0 + 2.0 / 5.0 * sin(0.6) ** 2)
    push = normal * sin(0.6) / 5.0
    time = sqrt(2.0 * 1.5 / (G * sin(0.6) + push * cos(0.6)))
    assert answer(data) == pytest.approx(0.5 * 5.0 * (push * time) ** 2, rel=1e-12)
    data["goal"] = "N_1"
    assert answer(data) == pytest.approx(normal, rel=1e-13)


# ---- several phases


def bouncing(bounces: int, restitution: float = 0.7) -> Data:
    steps: list[Data] = []
    height, speed, time = "h", 0.0, 0.0
    for n in range(bounces):
        flight = phase(
            [coordinate("y", "v", "a", height, speed)],
            [relation("a", ["*", -1.0, "g"])],
            "y",
            {"\\tau": f"t_{n}", "v": f"u_{n}"},
            direction=-1,
            begin=time,
        )
        steps += [step(integration=flight, phase=n), step(relation(f"w_{n}", ["*", -1.0, "e", f"u_{n}"]), phase=n)]
        height, speed, time = 0.0, f"w_{n}", f"t_{n}"
    return solution({"g": G, "h": 1.3, "e": restitution}, f"t_{bounces - 1}", *steps)


@given(st.integers(1, 8), st.floats(0.2, 1.0))
@settings(max_examples=10)
def test_a_bouncing_ball_sums_a_geometric_series(bounces: int, restitution: float) -> None:
    first = sqrt(2.0 * 1.3 / G)
    series = first * (1.0 + 2.0 * sum(restitution**n for n in range(1, bounces)))
    assert answer(bouncing(bounces, restitution)) == pytest.approx(series, rel=1e-12)


def rubbing(swings: int) -> Data:
    """Return a solution for a mass on a spring with friction, each half swing 2 µ m g/k closer to the middle."""
    steps: list[Data] = []
    place, time, way = "x_0", 0.0, 0.0
    for n in range(swings):
        sense = 1.0 if n % 2 == 0 else -1.0
        swing = phase(
            [coordinate("x", "v", "a", place, 0.0)],
            [relation(["*", "m", "a"], ["+", ["*", -1.0, "k", "x"], ["*", sense, "\\mu", "m", "g"]])],
            "v",
            {"\\tau": f"t_{n + 1}", "x": f"x_{n + 1}", "S": f"S_{n + 1}"},
            begin=time,
            accumulated=[{"name": "S", "rate": ["abs", "v"], "initial": way}],
        )
        steps.append(step(integration=swing, phase=n))
        place, time, way = f"x_{n + 1}", f"t_{n + 1}", f"S_{n + 1}"
    givens = {"m": 0.5, "k": 20.0, "\\mu": 0.1, "g": G, "x_0": 0.3}
    return solution(givens, place, *steps)


@pytest.mark.parametrize("swings", [1, 2, 3, 4])
def test_a_spring_with_friction_phase_by_phase(swings: int) -> None:
    data, shorter = rubbing(swings), 2.0 * 0.1 * 0.5 * G / 20.0
    assert answer(data) == pytest.approx((-1) ** swings * (0.3 - swings * shorter), rel=1e-12)
    data["goal"] = f"t_{swings}"
    assert answer(data) == pytest.approx(swings * pi * sqrt(0.5 / 20.0), rel=1e-12)
    data["goal"] = f"S_{swings}"
    path = sum(2.0 * (0.3 - n * shorter) - shorter for n in range(swings))
    assert answer(data) == pytest.approx(path, rel=1e-12)


def on_the_circle() -> Data:
    return phase(
        [coordinate("\\theta", "\\omega", "\\alpha", 0.0, ["/", "v_0", "\\ell"])],
        [
            relation(["*", "\\ell", "\\alpha"], ["*", -1.0, "g", ["sin", "\\theta"]]),
            relation(["+", "F", ["*", -1.0, "m", "g", ["cos", "\\theta"]]], ["*", "m", "\\ell", ["^", "\\omega", 2.0]]),
        ],
        "F",
        {"\\tau": "t_1", "\\theta": "\\theta_1", "\\omega": "\\omega_1"},
        direction=-1,
        unknowns=["F"],
    )


def in_the_air() -> Data:
    flying = [relation("a_x", 0.0), relation("a_y", ["*", -1.0, "g"])]
    return phase(
        [coordinate("x", "v_x", "a_x", "x_1", "u_x"), coordinate("y", "v_y", "a_y", "y_1", "u_y")],
        flying,
        ["+", ["^", "x", 2.0], ["^", "y", 2.0], ["*", -1.0, ["^", "\\ell", 2.0]]],
        {"\\tau": "t_2", "x": "x_2", "y": "y_2", "v_x": "w_x", "v_y": "w_y"},
        direction=1,
        begin="t_1",
    )


def slack(speed: float) -> Data:
    """Return a solution for a ball on a string: a circle until it is slack, a parabola, a jerk."""
    handed_on = step(
        relation("x_1", ["*", "\\ell", ["sin", "\\theta_1"]]),
        relation("y_1", ["*", -1.0, "\\ell", ["cos", "\\theta_1"]]),
        relation("u_x", ["*", "\\ell", "\\omega_1", ["cos", "\\theta_1"]]),
        relation("u_y", ["*", "\\ell", "\\omega_1", ["sin", "\\theta_1"]]),
    )
    jerk = step(relation("v", ["/", ["+", ["*", "x_2", "w_y"], ["*", -1.0, "y_2", "w_x"]], "\\ell"]))
    givens = {"m": 0.4, "g": G, "\\ell": 0.9, "v_0": speed}
    return solution(givens, "v", step(integration=on_the_circle()), handed_on, step(integration=in_the_air()), jerk)


@pytest.mark.parametrize("height", [0.1, 0.3, 0.5])
def test_a_string_that_goes_slack_is_taut_three_times_as_far_below(height: float) -> None:
    """The string goes slack at φ above the level of the nail, where v² = g ℓ sin φ, and is taut at 3 φ below it.

    On x = ℓ cos φ − v t sin φ, y = ℓ sin φ + v t cos φ − ½ g t² the square of the distance is ℓ² at t = 4 v cos φ/g.
    """
    length, slow = 0.9, sqrt(G * 0.9 * sin(height))
    data = slack(sqrt(G * length * (2.0 + 3.0 * sin(height))))
    time = 4.0 * slow * cos(height) / G
    speeds = -slow * sin(height), slow * cos(height) - G * time
    there = length * cos(3.0 * height), -length * sin(3.0 * height)
    assert answer(data) == pytest.approx((there[0] * speeds[1] - there[1] * speeds[0]) / length, rel=1e-10)
    data["goal"] = "y_2"
    assert answer(data) == pytest.approx(there[1], rel=1e-10)


def test_the_same_circle_by_a_constraint() -> None:
    """The unknowns are x, y and the tension, with the second derivative of x² + y² = ℓ² as an equation."""
    start = sqrt(G * 0.9 * (2.0 + 3.0 * sin(0.3)))
    pull = ["/", "F", "\\ell"]
    circle = phase(
        [coordinate("x", "v_x", "a_x", 0.0, "v_0"), coordinate("y", "v_y", "a_y", ["*", -1.0, "\\ell"], 0.0)],
        [
            relation(["*", "m", "a_x"], ["*", -1.0, pull, "x"]),
            relation(["*", "m", "a_y"], ["+", ["*", -1.0, pull, "y"], ["*", -1.0, "m", "g"]]),
            relation(["+", ["*", "x", "a_x"], ["*", "y", "a_y"], ["^", "v_x", 2.0], ["^", "v_y", 2.0]], 0.0),
        ],
        "F",
        {"y": "y_1"},
        unknowns=["F"],
    )
    data = solution({"m": 0.4, "g": G, "\\ell": 0.9, "v_0": start}, "y_1", step(integration=circle))
    assert asin(answer(data) / 0.9) == pytest.approx(0.3, rel=1e-10)


# ---- what is left open


def spoiled(change: Callable[[Data], object]) -> Data:
    data = deepcopy(slack(sqrt(G * 0.9 * 2.9)))
    change(data)
    return data


@pytest.mark.parametrize(
    ("change", "fault"),
    [
        (lambda d: d["steps"][0]["integration"]["equations"].pop(), "1 equations for 2"),
        (lambda d: d["steps"][0]["integration"]["equations"].pop(0), "1 equations for 2"),
        (lambda d: d["givens"].pop("g"), "g has no value"),
        (lambda d: d["givens"].pop("v_0"), "v_0 has no value"),
        (lambda d: d["steps"].pop(0), "has no value"),
        (lambda d: d["steps"].pop(1), "has no value"),
        (lambda d: d["steps"][0]["integration"]["ends"].pop(), "has no value"),
        (lambda d: d["steps"][0]["integration"]["until"].update(occurrence=0), "no such occurrence"),
        (lambda d: d["steps"][2]["integration"]["until"].update(direction=-1), "does not come to the end"),
        (lambda d: d["steps"][2]["integration"]["equations"].append(relation("a_x", "g")), "contradict"),
        (lambda d: d["steps"][0]["integration"].update(unknowns=["\\theta"]), "two things of one name"),
        (lambda d: d["steps"][0]["integration"].update(time="g"), "has a value already"),
        (
            lambda d: d["steps"][0]["integration"]["equations"].append(relation(["^", "\\alpha", 2.0], 1.0)),
            "is not linear",
        ),
        (lambda d: d["steps"][3]["relations"].append(relation("t_1", 0.5, "derived")), "does not hold"),
    ],
)
def test_what_a_phase_leaves_open(change: Callable[[Data], object], fault: str) -> None:
    assert any(fault in said for said in recompute(spoiled(change)).faults), recompute(spoiled(change))


def test_equations_that_leave_a_force_open() -> None:
    """Two equivalent equations do not have full rank."""
    data = wedge(("N", "R"))
    data["steps"].pop()
    equations = data["steps"][0]["integration"]["equations"]
    equations.append(deepcopy(equations[0]))
    assert any("do not determine" in said for said in recompute(data).faults)


# ---- an unknown that is found by trial


def dropped(height: float, stated: float | None = None) -> Data:
    """Return a solution for a ball from unknown height that rises to 1 m after a rebound: h = 1 m/e²."""
    data = bouncing(1, 0.8)
    rise = phase(
        [coordinate("y", "v", "a", 0.0, "w_0")],
        [relation("a", ["*", -1.0, "g"])],
        "v",
        {"y": "H"},
    )
    found = step(relation("h", height if stated is None else stated, "trial"))
    reached = step(relation("H", height * 0.8**2, "condition"))
    return data | {
        "goal": "h",
        "givens": {"g": G, "e": 0.8},
        "steps": [found, *data["steps"], step(integration=rise), reached],
    }


def test_an_unknown_is_found_close_to_the_stated_number() -> None:
    height = 1.2345678901
    assert answer(dropped(height, 1.2345)) == pytest.approx(height, rel=1e-12)


@pytest.mark.parametrize(
    ("change", "fault"),
    [
        (lambda d: d["steps"][0]["relations"][0].update(right=1.3), "no value of h near 1.3"),
        (lambda d: d["steps"][-1]["relations"][0].update(right=0.9), "no value of h near"),
        (lambda d: d["steps"].pop(), "no single result"),
        (lambda d: d["steps"].append(d["steps"][0]), "several unknowns"),
        (lambda d: d["givens"].pop("e"), "has no value"),
        (lambda d: d["steps"].pop(2), "has no value"),
    ],
)
def test_what_leaves_an_unknown_open(change: Callable[[Data], object], fault: str) -> None:
    data = dropped(1.2345678901)
    change(data)
    assert any(fault in said for said in recompute(data).faults), recompute(data)


@pytest.mark.parametrize("change", [0.9, 1.1])
def test_another_restitution_leads_elsewhere(change: float) -> None:
    data, right = bouncing(3), answer(bouncing(3))
    data["steps"][3]["relations"][0]["right"] = ["*", change, data["steps"][3]["relations"][0]["right"]]
    assert not recompute(data).agrees(right, 1e-6)

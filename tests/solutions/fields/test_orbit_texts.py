"""Tests of the texts of solutions for orbits: anomalies, the choice of the quadrant, and Kepler's equation."""

import pytest

from sim2reason.questions import Query, Target
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.angles import Orbited
from sim2reason.questions.moments.distances import Closest, Farthest
from sim2reason.scenes.bodies.space import Planet, Star
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.space import SolarSystem
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.solutions import Solution, solve
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from worked import asked, solution_text

PLANET, PAIR = "system.planets.0", "system.planets.0 & system.star"
ALONG_X = Sense("to the right", (1.0, 0.0, 0.0), axis="x")
OUTWARD, INWARD, NEAR_OUTWARD, FAR_INWARD = (2.16, 6.76), (-2.16, 6.76), (2.16, 9.2), (-1.0, 5.0)


def solved(query: Query, velocity: tuple[float, float] = OUTWARD) -> Solution:
    vx, vy = velocity
    sky = SolarSystem(star=Star(mass=1.0), planets=(Planet(x=0.64, y=0.0, vx=vx, vy=vy),))
    setting = asked(Scene(entities=(Named(name="system", entity=sky),)), query)
    solution = solve(setting)
    assert solution.strategy == "orbit", solution.reason
    assert setting.answer is not None
    assert not faults(solution, setting.answer)
    assert not read(solution.text).broken
    return solution


def state(quantity: str, moment: Moment, sense: Sense | None = None) -> Query:
    return Query("event", Target(quantity, PLANET, sense), moment)


QUADRANTS = [
    (OUTWARD, r"at first recedes ($x v_x > 0$)", r"between $0^\circ$ and $180^\circ$"),
    (INWARD, r"at first approaches ($x v_x < 0$)", r"between $-180^\circ$ and $0^\circ$"),
    (NEAR_OUTWARD, "As $p > 0$,", r"between $-90^\circ$ and $90^\circ$"),
    (FAR_INWARD, "As $p < 0$ and the planet at first approaches", r"between $-180^\circ$ and $-90^\circ$"),
]


@pytest.mark.parametrize(("velocity", "reason", "limits"), QUADRANTS)
@pytest.mark.parametrize("moment", [Closest(PAIR), Farthest(PAIR)])
def test_the_quadrant_of_an_anomaly_has_a_reason(
    moment: Moment, velocity: tuple[float, float], reason: str, limits: str
) -> None:
    solution = solved(Query("time_to_event", None, moment), velocity)
    assert reason in solution.text
    assert f"the initial value $E_0$ of $E$ lies {limits}" in solution.text
    assert any(relation.role == "exceeds" for relation in solution.relations)


def test_keplers_equation_is_derived() -> None:
    text = solved(Query("time_to_event", None, Closest(PAIR))).text
    introduced = "Let $E$ be the eccentric anomaly, zero at the nearest point, and $e$ the eccentricity."
    order = [
        introduced,
        r"\left(1 - e \cos E\right)$",
        r"By Kepler's equation, $E - e \sin E$ increases at the rate $n$",
    ]
    assert [text.index(part) for part in order] == sorted(text.index(part) for part in order)


@pytest.mark.parametrize(("quarters", "told"), [(90, r"$\frac{h u_0}{\mu}$"), (180, r"$\frac{\ell}{r_0} - 1$")])
def test_the_equation_of_the_ellipse_comes_before_the_distance(quarters: int, told: str) -> None:
    text = solved(state("acceleration", Orbited(PAIR, quarters))).text
    assert r"the distance is $\frac{\ell}{1 + e \cos\nu}$, with the eccentricity $e$ and the angle $\nu$" in text
    assert told in text
    assert ("The radial velocity is $\\frac{\\mu}{h}\\,e \\sin\\nu$" in text) == (quarters == 90)


@pytest.mark.parametrize("quarters", [90, 180])
def test_components_of_a_velocity_have_a_reason(quarters: int) -> None:
    text = solved(state("velocity", Orbited(PAIR, quarters), ALONG_X)).text
    assert "The line from the star to the planet then has the direction of" in text
    assert r"$\frac{h}{r}$ at right angles to it, counted counter-clockwise." in text


def test_a_constant_has_its_unit_and_an_angular_momentum_its_point() -> None:
    text = solved(state("velocity", Closest(PAIR))).text
    assert r"$G = 4 \pi^{2}\ \text{au}^3\text{/(Msun yr}^2\text{)}$" in text
    assert "The angular momentum per unit mass about the star is" in text
    assert "the speed of the planet is" in text


@pytest.mark.parametrize("velocity", [OUTWARD, INWARD, NEAR_OUTWARD, FAR_INWARD, (0.0, 6.5)])
def test_how_far_the_anomaly_grows_in_a_right_angle_is_derived(velocity: tuple[float, float]) -> None:
    text = solved(Query("time_to_event", None, Orbited(PAIR, 90)), velocity).text
    found = (
        "by Lagrange's formulas, the sum of the initial position times",
        r"$1 - \frac{a}{r_0} \left(1 - \cos\eta\right)$",
    )
    assert " ".join(found) in text
    assert ("the scalar product of this with the initial position is zero" in text) == (velocity[0] != 0.0)


def test_half_a_turn_ends_where_the_velocity_has_no_part_in_the_place() -> None:
    """No theorem about focal chords is quoted; between the ends of the major axis the time is half a period."""
    text = solved(Query("time_to_event", None, Orbited(PAIR, 180))).text
    assert "when the initial velocity has no part in it" in text
    assert "chord" not in text
    text = solved(Query("time_to_event", None, Orbited(PAIR, 180)), (0.0, 6.5)).text
    assert "From one end of the major axis to the other it takes half a period" in text


def test_a_planet_that_moves_inwards_is_nearest_before_it_is_farthest() -> None:
    text = solution_text("orbital-hard-numeric-4711-0")
    assert "so within half a turn it comes to the least distance." in text

"""Tests of the texts of solutions for charges in fields: the equations of motion come first."""

import pytest

from sim2reason.questions import Query, Target
from sim2reason.questions.kinds.comparison import ComparisonQuery
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.distances import Away
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.bodies.charges import ChargedBead, Launched, Released
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.fields import LinearDrag, LinearElectric, UniformElectric, UniformMagnetic
from sim2reason.scenes.entities.particles import EmEntity
from sim2reason.scenes.entities.varying_fields import GrowingElectric, OscillatingElectric
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.solutions import STRATEGIES, Solution, solve, solve_with
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from worked import asked, solution_text

BEAD = "fields.particle"
MAGNETIC = UniformMagnetic(strength=0.8, way="positive z")
UNIFORM = UniformElectric(strength=1.1, way="positive y")
GROWING = GrowingElectric(strength=1.1, way="positive y", trend="increases", growth=0.4)
OSCILLATING = OscillatingElectric(strength=1.1, way="positive y", frequency=0.7)
DRAG = LinearDrag(coefficient=0.5)
TO_THE_RIGHT = Sense("to the right", (1.0, 0.0, 0.0), axis="x")


def solved(
    quantity: str,
    moment: Moment,
    sign: str = "positive",
    speed: float = 2.0,
    strategy: str = "motion in fields",
    **acting: object,
) -> Solution:
    start = Launched(speed=speed, angle=30.0) if speed else Released()
    particle = ChargedBead(mass=2.0, charge=3.0, sign=sign)  # type: ignore[arg-type]
    entity = EmEntity(particle=particle, start=start, **acting)  # type: ignore[arg-type]
    scene = Scene(entities=(Named(name="fields", entity=entity),))
    setting = asked(scene, Query("state", Target(quantity, BEAD, TO_THE_RIGHT), moment))
    solution = solve(setting)
    assert solution.strategy == strategy, solution.reason
    assert setting.answer is not None
    assert not faults(solution, setting.answer)
    assert not read(solution.text).broken
    return solution


LAWS = [
    ({"electric": UNIFORM}, r"$\dot{v}_x = \Omega v_y$ and $\dot{v}_y = a_{\text{E}} - \Omega v_x$"),
    ({"electric": GROWING}, r"$\dot{v}_y = a_{\text{E}} + j \tau - \Omega v_x$"),
    ({"electric": OSCILLATING}, r"$\dot{v}_y = a_{\text{E}} \cos\left(\omega \tau\right) - \Omega v_x$"),
    ({"electric": UNIFORM, "medium": DRAG}, r"$\dot{v}_y = a_{\text{E}} - \Omega v_x - \gamma v_y$"),
    ({"medium": DRAG}, r"$\dot{v}_x = \Omega v_y - \gamma v_x$ and $\dot{v}_y = -\Omega v_x - \gamma v_y$"),
]


@pytest.mark.parametrize(("acting", "law"), LAWS)
@pytest.mark.parametrize("quantity", ["velocity", "displacement"])
def test_the_equations_of_motion_come_before_what_solves_them(
    quantity: str, acting: dict[str, object], law: str
) -> None:
    text = solved(quantity, AtTime(1.3), magnetic=MAGNETIC, **acting).text
    assert "The equations of motion are" in text
    assert law in text
    assert text.index(law) < text.index("initially has the x component")
    assert ("integrated from 0 to $t$, gives the displacement of the bead along x" in text) == (
        quantity == "displacement"
    )
    assert "Its " not in text
    assert "terminal" not in text


DRIFTS = [
    ({"electric": UNIFORM}, [r"$a_{\text{E}} - \Omega u_x = 0$"]),
    ({"electric": UNIFORM, "medium": DRAG}, [r"$\Omega u_y - \gamma u_x = 0$"]),
    ({"electric": GROWING}, [r"$u_x + \frac{j}{\Omega} \tau$ along x", r"$a_{\text{E}} - \Omega u_x = 0$"]),
    ({"electric": OSCILLATING}, [r"$u_x \cos\left(\omega \tau\right)$ along x", r"$-\omega u_x = \Omega u_y$"]),
]


@pytest.mark.parametrize(("acting", "told"), DRIFTS)
def test_the_velocity_that_the_fields_keep_up_is_put_into_the_equations(
    acting: dict[str, object], told: list[str]
) -> None:
    solution = solved("velocity", AtTime(1.3), magnetic=MAGNETIC, **acting)
    assert all(part in solution.text for part in told)
    assert any(r.role == "result" and r.left.latex() == "u_x" for r in solution.relations)


def test_a_rotating_part_without_a_component_says_so() -> None:
    text = solved("velocity", AtTime(1.3), speed=0.0, magnetic=MAGNETIC, electric=UNIFORM).text
    assert "and the y component zero." in text


def test_the_sign_of_a_charge_is_said_once() -> None:
    text = solved("velocity", AtTime(1.3), sign="negative", magnetic=MAGNETIC, electric=UNIFORM).text
    assert text.count("The charge of the bead is $-q$.") == 1
    assert "charge of the bead" not in solved("velocity", AtTime(1.3), magnetic=MAGNETIC, electric=UNIFORM).text


FIELDS = [
    (GROWING, "$E$ is the magnitude of the electric field at the start;"),
    (OSCILLATING, "$E$ is the amplitude of the electric field;"),
    (LinearElectric(strength=1.1, way="positive x", trend="increases", axis="x", slope=0.4), "at the origin;"),
]


@pytest.mark.parametrize(("electric", "said"), FIELDS)
def test_which_field_a_strength_is(electric: object, said: str) -> None:
    assert said in solved("velocity", AtTime(1.3), magnetic=MAGNETIC, electric=electric).text


def test_the_velocity_is_said_before_a_distance_that_is_its_integral() -> None:
    text = solved("velocity", Away(BEAD, 0.5), magnetic=MAGNETIC, electric=UNIFORM).text
    assert "integrated from 0 on, this gives the displacement. The bead is at the distance $d$" in text


def test_two_cases_name_their_velocities_apart() -> None:
    """With the initial speed doubled, the motion is written again and its velocity components have new names."""
    particle = ChargedBead(mass=2.0, charge=3.0, sign="positive")
    entity = EmEntity(particle=particle, start=Launched(speed=2.0, angle=30.0), magnetic=MAGNETIC, electric=OSCILLATING)
    scene = Scene(entities=(Named(name="fields", entity=entity),))
    force = Target("net force", BEAD, TO_THE_RIGHT)
    compared = ComparisonQuery(
        "comparison", force, AtTime(1.3), base=Query("state", None, None), path="fields.magnetic.strength", factor=2.0
    )
    setting = asked(scene, compared)
    solution = solve_with(STRATEGIES["comparison of two cases"], setting)
    assert solution.answer is not None, solution.reason
    assert r"\dot{v}_{y,1}" in solution.text
    assert not read(solution.text).broken


@pytest.mark.parametrize(("quantity", "expected"), [("displacement", 1.3 * 3**0.5), ("velocity", 3**0.5)])
def test_no_law_is_written_where_no_force_acts(quantity: str, expected: float) -> None:
    """The x component of 2 m/s at 30 degrees stays 2 cos 30° m/s, which also gives the displacement after 1.3 s."""
    solution = solved(quantity, AtTime(1.3), strategy="constant acceleration", electric=UNIFORM)
    assert solution.answer is not None, solution.reason
    assert abs(solution.answer / expected - 1.0) < 1e-9
    assert "No force acts on" in solution.text
    assert "0 = m" not in solution.text


@pytest.mark.parametrize(
    ("problem", "told"),
    [
        ("electromagnetic-easy-reverse-301928-0", "(positive if clockwise as seen from positive z)"),
        ("electromagnetic-easy-reverse-301932-0", "minus the work of the electric force; its magnitude is $U = "),
        ("electromagnetic-easy-numeric-301926-0", "The radius of the circle on which the ball moves is the speed"),
        ("electromagnetic-easy-numeric-301926-0", "rotates the velocity, so the y component of the velocity is"),
        ("electromagnetic-medium-numeric-301932-1", "The equation along y is that of a harmonic oscillation"),
        ("electromagnetic-hard-multipart-301931-0", "at the start; at that moment the electric force gives"),
        (
            "electromagnetic-hard-multipart-301931-0",
            "the components of the velocity at the time $\\tau$. The equations",
        ),
        ("electromagnetic-hard-reverse-301931-0", "it is varied until the result is that given, 6.5 m, which leads to"),
    ],
)
def test_words_that_refer_to_something_are_clear(problem: str, told: str) -> None:
    assert told in solution_text(problem)


def test_the_speed_along_a_line_is_no_root_of_a_square() -> None:
    text = solution_text("electromagnetic-hard-symbolic-9191-0")
    assert r"The speed is then $v = -a_{\text{E}} t - \tfrac{1}{2} j t^{2}$." in text
    assert r"$v = \frac{E^{2} q}{2\,m k}$" in text

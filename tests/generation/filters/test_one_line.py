"""Tests of the filter of answers that are products of stated numbers, by textbook formulas."""

from math import asin, degrees, radians, tan

import numpy as np
import pytest

from plain_scenes import atwood, ramp, row, swing
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.generation.filters.products import find_product
from sim2reason.generation.filters.sums import find_sum
from sim2reason.questions import KINDS, Moment, Query, Question, SimulatedScene, StatedResult, Target
from sim2reason.questions.moments.contacts import Collided
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.strings import NaturalLength
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import LowestPoint, Stopped
from sim2reason.questions.prompt import parse_prompt
from sim2reason.scenes.bodies.blocks import Glider
from sim2reason.scenes.bodies.round_bodies import Pipe, Sphere
from sim2reason.scenes.bodies.simple_machines import Incline, Track
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.rolling import NoSlipping, Rolling, RollingEntity
from sim2reason.scenes.entities.track_collisions import ComplexCollisionPlane

BLOCK, HANGING, BOB = "ramp.blocks.0", "one.system.blocks.0", "swing.bob"


def candidate(scene: Scene, moment: Moment, target: Target | None) -> Candidate:
    study = SimulatedScene.of(scene, np.linspace(0.0, 2.0, 41))
    query = Query(moment.kind if target else "time_to_event", target, moment)
    answer = KINDS[query.kind].answer(query, study)
    assert answer is not None
    unit = KINDS[query.kind].measured(query).unit
    return Candidate(study, Question("numeric", query, "?", answer, unit), "a b c")


def reason(scene: Scene, moment: Moment, target: Target | None) -> str:
    return FILTERS["one line"].reason(candidate(scene, moment, target))


@pytest.mark.parametrize(
    ("moment", "quantity"),
    [
        pytest.param(AtTime(0.5), "normal force", id="m g cos θ"),
        pytest.param(AtTime(0.5), "net force", id="m g sin θ"),
        pytest.param(AtTime(0.5), "velocity", id="g t sin θ"),
        pytest.param(AtTime(0.5), "displacement", id="½ g t² sin θ"),
        pytest.param(Moved(BLOCK, 0.7), "velocity", id="√(2 g s sin θ)"),
        pytest.param(Moved(BLOCK, 0.7), None, id="√(2 s/(g sin θ))"),
    ],
)
@pytest.mark.parametrize("angle", [30.0, 37.0, 45.0])
def test_on_a_smooth_slope_one_line_is_enough(moment: Moment, quantity: str | None, angle: float) -> None:
    target = Target(quantity, BLOCK) if quantity else None
    assert "is a product" in reason(ramp(angle=angle), moment, target)


def test_two_forces_are_more() -> None:
    """The acceleration g (sin θ − μ cos θ) is no product."""
    assert reason(ramp(angle=30.0, friction=0.2), AtTime(0.5), Target("velocity", BLOCK)) == ""
    assert "is a product" in reason(ramp(angle=30.0, friction=0.2), AtTime(0.5), Target("friction force", BLOCK)), (
        "μ m g cos θ"
    )


def test_two_bodies_are_more() -> None:
    """a = g (M − m)/(M + m) has two sums, T = 2 M m g/(M + m) has one, and both masses occur twice in it."""
    assert reason(atwood(), AtTime(0.5), Target("velocity", HANGING)) == ""
    assert reason(atwood(), AtTime(0.5), Target("tension", "tendon_1")) == ""


def rolls(body: Pipe | Sphere, start: Rolling | None = None) -> Scene:
    ball = RollingEntity(body=body, plane=Incline(angle=20.0), grip=NoSlipping(), start=start)
    return Scene(entities=(Named(name="lane", entity=ball),))


def test_two_laws_are_more_whatever_comes_out() -> None:
    """Friction on a rolling pipe is ½ m g sin θ, on a sphere 2/7 m g sin θ; N = m g cos θ of both takes one law."""
    for body in (Pipe(mass=2.0, radius=0.1), Sphere(mass=2.0, radius=0.1)):
        assert reason(rolls(body), AtTime(0.5), Target("friction force", "lane.body")) == ""
        assert "is a product" in reason(rolls(body), AtTime(0.5), Target("normal force", "lane.body"))


def test_what_is_read_off_a_definition_is_one_line() -> None:
    """L = m R v of a rolling pipe, at the start, is a product."""
    scene = rolls(Pipe(mass=2.0, radius=0.1), Rolling(way="down the slope", speed=1.5))
    assert "is a product" in reason(scene, AtStart(), Target("angular momentum", "lane.body"))


def test_a_special_angle_makes_no_product() -> None:
    """v = √(2 g l (1 − cos θ)) is the root of a sum at any angle, though 1 − cos 60° = ½."""
    for angle in (50.0, 60.0):
        speed = candidate(swing(angle=angle), LowestPoint(BOB), Target("velocity", BOB))
        assert find_product(speed) == ""
        assert "the root of a sum" in find_sum(speed)


CHORD = (
    "A small bead (mass $m$) hangs from a fixed point by a light inextensible string of length $\\ell$. To "
    "begin with, the string is taut and makes an angle of $\\theta$ with the downward vertical. The motion "
    "begins from rest. The free-fall acceleration is g = 9.8 m/s². The distance between the bead and its "
    "starting point at the moment when it first comes to rest again is 1.98 m. Find $\\theta$. Let $m$ = "
    "0.29 kg and $\\ell$ = 1.1 m. State the answer in degrees to three significant figures, inside "
    "\\boxed{}."
)


def test_an_unknown_angle_whose_sine_is_a_product_is_one_line() -> None:
    """The bob comes to rest at the same height on the other side, 2 ℓ sin θ away."""
    asked = parse_prompt(CHORD, np.random.default_rng(1))
    (unknown,) = asked.reading.unknown
    angle = degrees(asin(1.98 / 2.2))
    scene = asked.study.scene.having(unknown, angle)
    study = SimulatedScene.of(scene, np.linspace(0.0, scene.horizon, 41))
    elasticity = radians(angle) / tan(radians(angle))  # of 2 ℓ sin θ
    given = StatedResult("1.98", "m")
    question = Question("reverse", asked.query, "", angle, "deg", "", unknown, given, elasticity)
    assert "sine of the answer" in FILTERS["one line"].reason(Candidate(study, question, "a b c"))


def cart(moment: Moment, quantity: str, *, tilt: float = 0.0) -> str:
    scene = row((1.3,), (90.0,), "right", strain=0.1, speed=0.5, tilt=tilt)
    return reason(scene, moment, Target(quantity, "row.carts.0"))


def test_energy_by_itself_is_one_line() -> None:
    """½ k d² + ½ m v² is all kinetic as the spring relaxes; the force at rest is √(k² d² + k m v²)."""
    assert "a sum of two products" in cart(NaturalLength("row.springs.0"), "kinetic energy")
    assert "the root of a sum of two products" in cart(NaturalLength("row.springs.0"), "velocity")
    assert "the root of a sum of two products" in cart(Stopped("row.carts.0"), "net force")


def test_energy_on_a_slope_is_more() -> None:
    """On a slope the cart has three kinds of energy."""
    assert cart(NaturalLength("row.springs.0"), "kinetic energy", tilt=20.0) == ""


def test_a_fall_with_a_start_is_one_line() -> None:
    """½ m v² - m g s sin θ for a block that moves up a smooth slope; friction adds a third term."""
    energy = Target("kinetic energy", BLOCK)
    assert "a sum of two products" in reason(ramp(angle=37.0, speed=3.0), Moved(BLOCK, 0.5), energy)
    assert reason(ramp(angle=37.0, speed=3.0, friction=0.2), Moved(BLOCK, 0.5), energy) == ""


def test_a_difference_of_like_numbers_counts_as_one() -> None:
    """A cart from x₁ hits one at rest at x₂ after (x₂ − x₁)/v; if that one moves, too, there are two differences."""
    for other, found in ((0.0, "the answer is a product of"), (0.5, "")):
        carts = (Glider(mass=1.0, x=0.3, v=2.0), Glider(mass=2.0, x=1.1, v=other))
        track = ComplexCollisionPlane(track=Track(), gliders=carts, restitution=0.5)
        hit = candidate(Scene(entities=(Named(name="t", entity=track),)), Collided("t.gliders.0 & t.gliders.1"), None)
        assert hit.question.answer == pytest.approx((1.1 - 0.3) / (2.0 - other))
        assert find_product(hit).startswith(found)
        assert bool(find_product(hit)) == bool(found)

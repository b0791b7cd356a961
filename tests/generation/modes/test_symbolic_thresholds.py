"""Tests of symbolic limits, against statics and energy conservation, and of their prompts read back."""

from math import acos, cos, degrees, radians, sin

import numpy as np
import pytest

from plain_scenes import half_atwood
from sim2reason.generation.item_search import sample
from sim2reason.generation.make import make
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.request import Request
from sim2reason.grading import formula
from sim2reason.questions import MODES, Question, SimulatedScene
from sim2reason.questions.inversion import ThresholdSearch
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.outcomes import OUTCOMES
from sim2reason.questions.prompt import parse_prompt, prompt
from sim2reason.questions.regimes.directions import SideOfCenterOfMass
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import Ball, Cord, FixedBall, LightRod
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum, RotationEntity
from sim2reason.scenes.entities.pieces import FIRST, OTHER_SIDE, BallPiece
from sim2reason.scenes.entities.slopes import TwoSideMassPlane
from sim2reason.simulation.scenes import simulate
from sim2reason.solutions import ProblemContext, solve
from sim2reason.text.prose.description import stated_value

SYMBOLIC = MODES["symbolic"]


def limit(outcome: str, name: str, parameter: str, unit: str, about: float, *, greatest: bool) -> ThresholdQuery:
    """Build a query for the greatest or least value at which an outcome does not happen."""
    return ThresholdQuery(
        "threshold", None, None, OUTCOMES[outcome](name), parameter, unit, greatest, happens=False, about=about
    )


def completed(scene: Scene, query: ThresholdQuery) -> tuple[QuestionSearch, Question]:
    search = QuestionSearch(scene, 0)
    asked = Question("symbolic", query, "", query.about, query.unit, unknown=query.parameter)
    found = SYMBOLIC.completed(asked, search.study, search.words, np.random.default_rng(0))
    assert found is not None
    assert found.formula is not None
    return search, found


def equal(question: Question, expected: str) -> bool:
    """Return whether a formula worked out by hand equals the one that was found, at all bindings."""
    found = question.formula
    assert found is not None
    points = [dict(zip(found.symbols, point, strict=True)) for point in found.points]
    return formula(rf"\boxed{{{expected}}}", found.latex, points, symbols=found.symbols).reward == 1.0


def rough(friction: float) -> Scene:
    """Build a block of 2 kg on a rough slope of 30°, connected to a hanging one of 3 kg."""
    scene = half_atwood()
    entity = TwoSideMassPlane(plane=Plane(angle=30.0, friction=friction), blocks=(Block(mass=2.0),))
    return scene.model_copy(update={"entities": (Named(name="ramp", entity=entity), *scene.entities[1:])})


def pendulum(hanger: Cord | LightRod, angle: float, speed: float) -> Scene:
    entity = Pendulum(bob=Ball(mass=0.5), hanger=hanger, angle=angle, speed=speed)
    return Scene(entities=(Named(name="p", entity=entity),))


def test_the_heaviest_that_friction_holds() -> None:
    """At the limit m_B g = m_A g sin θ + µ m_A g cos θ, with the greatest friction, down the slope."""
    about = 2.0 * (sin(radians(30.0)) + 0.4 * cos(radians(30.0)))
    query = limit("rises", "ramp.blocks.0", "other.system.blocks.0.mass", "kg", about, greatest=True)
    _, found = completed(rough(0.4), query)
    assert equal(found, r"m_A (\sin\theta + \mu \cos\theta)")
    assert found.formula is not None
    assert set(found.formula.symbols) == {"m_A", r"\theta", r"\mu", "g"}  # not the mass that is asked for
    assert found.assumed == ()


def test_the_least_friction_is_a_size() -> None:
    """µ m_A g cos θ balances the difference of m_B g and m_A g sin θ, whichever is larger."""
    about = (3.0 - 2.0 * sin(radians(30.0))) / (2.0 * cos(radians(30.0)))
    query = limit("slides", "ramp.blocks.0", "ramp.plane.friction", "", about, greatest=False)
    _, found = completed(rough(0.4), query)
    assert equal(found, r"\frac{|m_B - m_A \sin\theta|}{m_A \cos\theta}")


def test_a_rod_that_goes_right_round_is_at_rest_on_top() -> None:
    """½ v² = g ℓ (1 + cos θ), θ from the downward vertical."""
    about = float(np.sqrt(2.0 * 9.8 * 1.2 * (1.0 + cos(radians(29.0)))))
    query = limit("goes_round", "p.hanger", "p.speed", "m/s", about, greatest=True)
    _, found = completed(pendulum(LightRod(length=1.2), 29.0, 2.0), query)
    assert equal(found, r"\sqrt{2 g \ell (1 + \cos\theta)}")


def arm(first: float, other: float) -> Scene:
    """Build a light arm with ball A 0.3 m from the axle and ball B 0.5 m on the other side, at 3 rad/s from 40°."""
    sides = (first, 0.3, FIRST), (other, 0.5, OTHER_SIDE)
    balls = tuple(BallPiece(body=FixedBall(mass=m), distance=d, side=side) for m, d, side in sides)
    return Scene(entities=(Named(name="arm", entity=RotationEntity(pieces=balls, angle=40.0, rate=3.0)),))


@pytest.mark.parametrize(("masses", "same", "greatest"), [((1.0, 2.0), False, False), ((4.0, 1.0), True, True)])
def test_a_limit_of_an_arm_says_on_which_side_its_centre_of_mass_is(
    masses: tuple[float, float], same: bool, greatest: bool
) -> None:
    """½ I ω₀² = |S| g (1 ± cos θ) gives the least angle if B is the heavier side, the greatest if A is."""
    (a, b), spin = masses, 3.0 if not same else 5.0
    scene = arm(a, b).having("arm.rate", spin)
    moment, inertia = abs(0.3 * a - 0.5 * b), 0.09 * a + 0.25 * b
    level = 0.5 * inertia * spin**2 / (moment * 9.8) - 1.0
    about = degrees(acos(level if same else -level))
    query = limit("goes_round", "arm.arm", "arm.angle", "deg", about, greatest=greatest)
    search, found = completed(scene, query)
    assert [held for held in found.assumed if isinstance(held, SideOfCenterOfMass)] == [
        SideOfCenterOfMass("arm.pieces.0.body", same)
    ]
    side = "on the same side of the axle as" if same else "on the side of the axle opposite to"
    assert f"Assume that the centre of mass of the bodies on the arm is {side} ball A." in found.text
    study = search.study
    text = solve(ProblemContext.from_query(found, study, search.words, search.description)).text
    assert f"By assumption, the centre of mass is on {'this' if same else 'the opposite'} side, so $S" in text
    assert "The arm goes right round if $K$ is positive." in text


def test_a_limit_of_a_mass_assumes_nothing_of_the_centre_of_mass_that_hangs_on_it() -> None:
    scene = arm(1.0, 2.0)
    study, held = SimulatedScene(scene, simulate(scene)), SideOfCenterOfMass("arm.pieces.0.body", same=False)
    assert held.regardless_of(study, "arm.angle")
    assert held.regardless_of(study, "arm.rate")
    assert not held.regardless_of(study, "arm.pieces.1.body.mass")
    assert not held.regardless_of(study, "arm.pieces.0.distance")


def test_an_angle_is_asked_for_in_radians() -> None:
    """½ v² = g ℓ cos θ for a string that stays taut below its suspension."""
    query = limit("goes_slack", "p.hanger", "p.angle", "deg", degrees(acos(4.0 / (2.0 * 9.8 * 1.6))), greatest=True)
    search, found = completed(pendulum(Cord(length=1.6), 40.0, 2.0), query)
    assert equal(found, r"\arccos\frac{v^2}{2 g \ell}")
    text = prompt(SYMBOLIC.described(found, search.description), found, np.random.default_rng(0))
    assert ", in radians" in text
    assert r"$\theta$" in text


@pytest.mark.parametrize("greatest", [True, False])
def test_a_limit_on_the_other_side_is_none(greatest: bool) -> None:
    """Friction holds masses between a least and a greatest one, and each question means one of them."""
    scene = rough(0.4)
    study = SimulatedScene(scene, simulate(scene))
    held = [2.0 * (sin(radians(30.0)) + side * 0.4 * cos(radians(30.0))) for side in (1.0, -1.0)]
    trial = ThresholdSearch(study, OUTCOMES["slides"]("ramp.blocks.0"), "other.system.blocks.0.mass")
    assert [trial.changes_at(value, above=greatest) for value in held] == [greatest, not greatest]


def test_symbols_of_two_angles_are_told_apart() -> None:
    """The symbols θ_1 and θ_2 of the text are kept, though a text that leaves one number open would use θ."""
    scene = sample("hybrid", "medium", seed=11, index=1)
    search = QuestionSearch(scene, 0)
    unknown = next(found for found in search.words.in_symbols({}).unknowns if found.path.endswith("angle"))
    assert unknown.symbol == r"$\theta_1$"
    assert unknown.phrases == (r"the angle $\theta_1$", r"$\theta_1$")


@pytest.mark.parametrize(
    ("recipe", "index"),
    [
        ("pulley", 0),
        ("box", 3),
        pytest.param("hybrid", 2, marks=pytest.mark.slow),
        pytest.param("rotation", 11, marks=pytest.mark.slow),
    ],
)
def test_prompts_lead_back_to_the_limit_at_every_binding(recipe: str, index: int) -> None:
    """No value of the number asked for is given, and the worked solution ends in the formula."""
    item = make(Request(recipe, "medium", "symbolic", 5, index, weights=(("threshold", 1e6),))).item
    assert item is not None
    assert item.kind == "threshold"
    held = item.answer.formula
    assert held is not None
    for binding in held.bindings:
        given = {s: stated_value(v, u) for s, v, u in zip(held.symbols, binding.numbers, held.units, strict=True)}
        found = parse_prompt(item.prompt, given=given).answer
        assert found is not None
        assert (radians(found) if item.answer.unit == "deg" else found) == pytest.approx(binding.answer, rel=1e-6)

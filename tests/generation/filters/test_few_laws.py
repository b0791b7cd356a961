"""Tests of the filter of problems that textbooks solve by one law, or by a few with a short formula."""

from dataclasses import replace

import pytest

from plain_scenes import half_atwood, ramp, row, swing
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.generation.filters.misconceptions import TURNS
from sim2reason.questions import KINDS, Question, StatedResult
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.bodies.round_bodies import Pipe
from sim2reason.scenes.bodies.simple_machines import Incline
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.scenes.entities.rolling import NoSlipping, Rolling, RollingEntity
from worked import asked

FILTER = FILTERS["few laws"]
DOWN = Rolling(way="down the slope", speed=1.0)


def candidate(scene: Scene, said: str) -> Candidate:
    setting = asked(scene, said)
    assert setting.answer is not None
    unit = KINDS[setting.query.kind].measured(setting.query).unit
    question = Question("numeric", setting.query, said, setting.answer, unit)
    return Candidate(setting.study, question, said, words=setting.words)


def thrown(angle: float = 40.0) -> Scene:
    ball = Projectile(ball=Ball(mass=0.3), height=2.0, speed=5.0, angle=angle)
    return Scene(entities=(Named(name="throw", entity=ball),))


ROUGH = ramp(angle=30.0, friction=0.2, speed=3.0)
SPRING = row((1.0,), (100.0,), "right", strain=0.1, speed=0.5)
KNOWN = {
    "How long after t = 0 does the block first come to rest?": (ROUGH, 2, 5),  # v/(g (sin θ + µ cos θ))
    "Find the magnitude of the acceleration of block B after the release.": (half_atwood(), 2, 6),  # two weights, M + m
    "Find the tension in the string after release.": (half_atwood(), 2, 8),  # m_B (g - a)
    "What is the speed of block B after it has moved 1.0 m?": (half_atwood(), 3, 7),  # two blocks on one string
    "Find the kinetic energy of block A after it has moved 1.3 m.": (half_atwood(), 4, 8),
    "Find the magnitude of the change in the block's gravitational potential energy from t = 0 until it first comes to "
    "rest.": (ROUGH, 3, 8),  # how far, and how high that is
    "Find the horizontal displacement of the ball from its starting point just before it reaches the ground.": (
        thrown(),
        2,
        9,
    ),
    "How long after t = 0 does the ball reach the ground?": (thrown(), 1, 7),  # (v sin θ + √(v² sin² θ + 2 g h))/g
    "Find the speed of the trolley after it has moved 0.16 m.": (SPRING, 1, 6),  # energy, once
    "Between release and the moment when the ball first comes to rest again, what is the greatest speed of the ball?": (
        swing(),
        1,
        3,
    ),  # √(2 g ℓ (1 − cos θ))
}
WORTH_IT = {
    "How large is the impulse of the tension in the string from release until block A has moved 1.3 m?": half_atwood(),
    "How far is the ball from its starting point just before it reaches the ground?": thrown(),
    "Find the magnitude of the net force on the trolley at the moment when it first comes to rest.": SPRING,
    "How long after t = 0 is the ball first 1.2 m from its starting point?": thrown(),  # of the fourth degree
}


@pytest.mark.parametrize("said", KNOWN)
def test_what_few_laws_give_by_a_short_formula_is_known(said: str) -> None:
    scene, laws, symbols = KNOWN[said]
    known = f"{laws} law{'s' if laws > 1 else ''}, a formula of {symbols} symbols"
    assert FILTER.reason(replace(candidate(scene, said), difficulty="hard")) == known


def test_an_easy_problem_may_be_what_a_textbook_has_by_two_laws_but_not_by_one() -> None:
    """The tension of two blocks takes two laws and eight symbols, a cart's speed by its spring one and six."""
    two = candidate(half_atwood(), "Find the tension in the string after release.")
    one = candidate(SPRING, "Find the speed of the trolley after it has moved 0.16 m.")
    refused = [[bool(FILTER.reason(replace(of, difficulty=d))) for d in DIFFICULTIES] for of in (two, one)]
    assert refused == [[False, False, True], [True, True, True]]


@pytest.mark.parametrize("said", WORTH_IT)
def test_what_takes_more_is_a_problem(said: str) -> None:
    asked_about = replace(candidate(WORTH_IT[said], said), difficulty="hard")
    assert [*FILTER.findings(asked_about)]  # a formula is derived, and it is no short one
    assert FILTER.reason(asked_about) == ""


def rolling(said: str, start: Rolling | None = None) -> Candidate:
    lane = RollingEntity(body=Pipe(mass=2.0, radius=0.1), plane=Incline(angle=20.0), grip=NoSlipping(), start=start)
    return candidate(Scene(entities=(Named(name="lane", entity=lane),)), said)


def test_what_rolls_by_its_weight_is_kept_by_both_filters() -> None:
    """½ m (v² + g d sin θ) follows from two laws together; without weight, L = m v R is a definition."""
    asked_about = rolling(
        "What is the rotational kinetic energy of the tube about its centre of mass after it has moved 0.40 m?", DOWN
    )
    assert [*FILTER.findings(asked_about)][-1] == TURNS
    assert FILTER.reason(asked_about) == FILTERS["one line"].reason(asked_about) == ""


def test_what_rolls_is_known_by_heart_where_hardly_anything_is_left_to_say() -> None:
    """The friction on a pipe, ½ m g sin θ, takes two laws, but has only three symbols."""
    asked_about = rolling("What is the magnitude of the friction force exerted on the tube by the plane after release?")
    assert [*FILTER.findings(asked_about)][-1] == TURNS
    assert FILTER.reason(asked_about) == "2 laws, a formula of 3 symbols"


def test_it_comes_first_where_the_derivation_is_made() -> None:
    asked_about = candidate(ROUGH, next(iter(KNOWN)))
    assert not FILTER.ready(asked_about)
    assert FILTER.reason(asked_about)
    assert FILTER.ready(asked_about)


def test_it_is_known_whichever_number_is_asked_for() -> None:
    """One law connects a cart's speed with the stiffness of its spring, whichever is unknown."""
    forward = candidate(SPRING, "Find the speed of the trolley after it has moved 0.16 m.")
    asked_for, given = "row.springs.0.stiffness", StatedResult.rounded(forward.question.answer, "m/s", 3)
    question = replace(
        forward.question, mode="reverse", answer=100.0, unit="N/m", unknown=asked_for, given=given, elasticity=0.5
    )
    assert FILTER.reason(replace(forward, question=question)) == FILTER.reason(forward) != ""


def test_nothing_is_said_without_words_for_the_laws() -> None:
    assert FILTER.reason(replace(candidate(ROUGH, next(iter(KNOWN))), words=None)) == ""


def test_that_a_speed_is_the_size_of_a_velocity_is_no_law() -> None:
    """v² = v_0² + k (…)/m is one law, and v = −v_x is none."""
    said = "Find the speed of the trolley after it has moved 0.16 m."
    assert [*FILTER.findings(candidate(SPRING, said))] == ["1 law, by energy", "symbols in the formula: 6"]

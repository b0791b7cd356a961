"""Tests of the sentences that only some questions need: included there, left out of other prompts."""

import re
from collections import Counter
from dataclasses import replace
from typing import Literal

import numpy as np
import pytest

from sim2reason.errors import TextError
from sim2reason.generation.certified import CertifiedQuestion
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.recipes import RECIPES, find_difficulty
from sim2reason.questions import MODES, Formula, Query, Question, SimulatedScene, Target
from sim2reason.questions.accuracy import StatedResult
from sim2reason.questions.kinds.equilibrium import EquilibriumQuery
from sim2reason.questions.moments.reached import Reached
from sim2reason.questions.moments.strings import WentSlack
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.prompt import parse_prompt, words_of
from sim2reason.questions.regimes.strings import StaysTaut
from sim2reason.questions.sentences import irrelevant
from sim2reason.scenes.bodies.blocks import Block, Cart
from sim2reason.scenes.bodies.oscillators import Ball, Coil, Cord, FixedBall, NailedSpring
from sim2reason.scenes.bodies.round_bodies import Sphere
from sim2reason.scenes.bodies.simple_machines import RoughTrack
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.scenes.entities.pendulums import Pendulum, RotationEntity
from sim2reason.scenes.entities.pieces import BallPiece, RoundPiece
from sim2reason.scenes.entities.spring_blocks import SpringBlock
from sim2reason.scenes.entities.spring_chains import Blow, SpringMassChain, Strained
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.scenes import simulate
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose.description import describe

G = 9.8
LENGTH = 1.0
SPEED = Target("velocity", "swing.bob")
FORMULA = Formula(r"\sqrt{g l}", ("g", "l"), ("m/s^2", "m"), ((G, LENGTH),), ((G * LENGTH) ** 0.5,))
LOST = "velocity along it is lost"


def swing(speed: float) -> Scene:
    """Build a bob launched at its lowest point; it leaves its circle if 2gl < v² < 5gl."""
    entity = Pendulum(bob=Ball(mass=0.5), hanger=Cord(length=LENGTH), angle=0.0, speed=speed)
    return Scene(entities=(Named(name="swing", entity=entity),))


def throw(restitution: float | None = None) -> Scene:
    entity = Projectile(ball=Ball(mass=0.5), height=1.0, speed=5.0, angle=40.0, restitution=restitution)
    return Scene(entities=(Named(name="throw", entity=entity),))


def study(scene: Scene) -> SimulatedScene:
    return SimulatedScene(scene, simulate(scene))


def asked(query: Query, text: str = "", unknown: str = "", given: StatedResult | None = None) -> Question:
    return Question("numeric", query, text, 1.0, "m/s", unknown=unknown, given=given)


@pytest.mark.parametrize(
    ("squared", "slackens"), [(1.5 * G, False), (3.0 * G, True), (4.5 * G, True), (6.0 * G, False)]
)
def test_a_bob_that_leaves_its_circle_matters_from_then_on(squared: float, slackens: bool) -> None:
    """The tension m(v² − 2gl − 3gl cos φ)/l vanishes on the way up only if 2gl < v² < 5gl.

    The sentence about a slack string is in the text only if the question is about a later moment.
    """
    seen = study(swing(squared**0.5))
    late, early = (Query("state", SPEED, AtTime(time)) for time in (1.2, 0.05))
    assert ("slack" not in irrelevant(asked(late), seen)) is slackens
    assert "slack" in irrelevant(asked(early), seen)
    assert "slack" in irrelevant(asked(Query("start", SPEED, AtStart())), seen)


def test_what_ends_as_the_string_goes_slack_has_not_to_do_with_what_follows() -> None:
    seen = study(swing((3.5 * G) ** 0.5))
    words = words_of(describe(seen.scene))
    (moment,) = WentSlack.found(seen, words, np.random.default_rng(0))
    assert seen.time(moment) is not None
    found = asked(Query("event", SPEED, moment))
    assert "slack" in irrelevant(found, seen)
    assert "slack" in irrelevant(replace(found, formula=FORMULA), seen)


def test_where_the_answer_is_a_formula_a_string_may_go_slack_with_other_numbers() -> None:
    """The bob hangs on its string at 1.5 gl, and leaves its circle at 3 gl, unless the question is about the start."""
    seen = study(swing((1.5 * G) ** 0.5))
    late, start = Query("state", SPEED, AtTime(0.5)), Query("start", SPEED, AtStart())
    assert "slack" not in irrelevant(replace(asked(late), formula=FORMULA), seen)
    assert "slack" in irrelevant(replace(asked(start), formula=FORMULA), seen)


@pytest.mark.parametrize(
    ("unknown", "told"), [("swing.speed", True), ("swing.hanger.length", True), ("swing.bob.mass", False)]
)
def test_the_text_does_not_hang_on_what_it_hides(unknown: str, told: bool) -> None:
    """An unknown speed or length could make the bob leave its circle; an unknown mass could not."""
    given, query = StatedResult("1.0", "m/s"), Query("state", SPEED, AtTime(1.2))
    seen = study(swing((1.5 * G) ** 0.5))
    assert ("slack" not in irrelevant(asked(query, unknown=unknown, given=given), seen)) is told


def test_what_is_assumed_need_not_be_told() -> None:
    seen, query = study(swing(2.0)), Query("state", SPEED, AtTime(0.5))
    name = next(line.name for line in seen.mechanism.strings)
    taut = Question("symbolic", query, "", 1.0, "m/s", assumed=(StaysTaut(name),))
    assert "slack" in irrelevant(taut, seen)


X_VELOCITY = Target("velocity", "throw.ball", Sense("to the right", (1.0, 0.0, 0.0), axis="x"))


@pytest.mark.parametrize(
    ("target", "told"),
    [(X_VELOCITY, True), (Target("velocity", "throw.ball", Sense("upward", (0.0, 0.0, 1.0), axis="vertical")), False)],
)
def test_axes_are_told_where_one_is_used(target: Target, told: bool) -> None:
    """An axis is used by the asked component, or by the moment at which a component has a given value."""
    seen, size = study(throw()), Target("velocity", "throw.ball")
    assert ("axes" not in irrelevant(asked(Query("state", target, AtTime(0.2))), seen)) is told
    first = Query("time_to_event", None, Reached(target, StatedResult("3.0", "m/s")))
    assert ("axes" not in irrelevant(asked(first), seen)) is told
    assert "axes" in irrelevant(asked(Query("state", size, AtTime(0.2))), seen)


def _prompts(scene: Scene, mode: str, seeds: int = 10) -> list[CertifiedQuestion]:
    """Return questions about a scene, asked with different seeds."""
    found: list[CertifiedQuestion] = []
    for seed in range(seeds):
        rng = np.random.default_rng(seed)
        search = QuestionSearch(scene, seed)
        question = search.ask(MODES[mode], rng, Counter())
        found.extend([question] if question is not None else [])
    assert found
    return found


@pytest.mark.parametrize("seeds", [3, pytest.param(10, marks=pytest.mark.slow)])
@pytest.mark.parametrize("mode", ["numeric", "reverse"])
@pytest.mark.parametrize("scene", [swing(3.0), throw(restitution=0.7)])
def test_prompts_without_them_lead_to_their_answers(scene: Scene, mode: str, seeds: int) -> None:
    """The numeric and reverse prompts about a pendulum and a bouncing ball are solved from their text alone."""
    for found in _prompts(scene, mode, seeds):
        if mode == "numeric" and not found.question.query.hides:
            assert LOST not in found.prompt
        assert parse_prompt(found.prompt).answer == pytest.approx(found.question.answer, rel=1e-2), found.prompt


def turned(rate: float | None) -> Scene:
    """Build a sphere and a small ball on an arm, 70° to the right at the start, with an initial rate if given."""
    pieces = (
        RoundPiece(body=Sphere(mass=20.0, radius=0.35), distance=0.4),
        BallPiece(body=FixedBall(mass=10.0), distance=0.3, side="on the other side"),
    )
    return Scene(entities=(Named(name="it", entity=RotationEntity(pieces=pieces, angle=70.0, rate=rate)),))


@pytest.mark.parametrize("rate", [None, 2.0])
@pytest.mark.parametrize("mode", ["numeric", "symbolic"])
def test_small_oscillations_are_asked_about_without_a_start(mode: str, rate: float | None) -> None:
    """The prompt and the formula contain neither the initial angle nor the initial angular velocity."""
    search = QuestionSearch(turned(rate), 3)
    asked = (search.ask(MODES[mode], np.random.default_rng(seed), Counter(), "period") for seed in range(6))
    found = next(each for each in asked if each is not None and getattr(each.question.query, "small", False))
    assert not re.search(r"70°|theta|omega|rad/s,|downward vertical|2\.0 rad", found.prompt), found.prompt
    if mode == "numeric":
        assert parse_prompt(found.prompt).answer == pytest.approx(found.question.answer, rel=1e-9)
    else:
        assert found.question.formula is not None
        assert set(found.question.formula.symbols) == {"m_A", "R_A", "m_B", "d_1", "d_2", "g"}


@pytest.mark.parametrize("struck", [False, True])
def test_normal_modes_are_asked_about_without_a_start(struck: bool) -> None:
    """The prompt states neither the blow nor the spring's strain, and its answer is found without them."""
    chain = SpringMassChain(
        track=RoughTrack(),
        carts=(Cart(mass=4.3), Cart(mass=1.9)),
        ends="right",
        springs=(Coil(stiffness=155.0), Coil(stiffness=113.0)),
        strain=Strained(spring=1, way="compressed", by=0.28),
        blow=Blow(cart=0, toward="right", speed=1.3) if struck else None,
    )
    search = QuestionSearch(Scene(entities=(Named(name="it", entity=chain),)), 3)
    found = search.ask(MODES["numeric"], np.random.default_rng(1), Counter(), "period")
    assert found is not None
    assert not re.search(r"0\.28|1\.3 m/s|relaxed|struck|blow|set moving", found.prompt), found.prompt
    assert parse_prompt(found.prompt).answer == pytest.approx(found.question.answer, rel=1e-9)


def test_no_other_text_may_leave_out_its_start() -> None:
    """The initial state is required in a prompt about a motion and in a description without a question."""
    search = QuestionSearch(turned(None), 3)
    found = search.ask(MODES["numeric"], np.random.default_rng(1), Counter(), "extremum")
    assert found is not None
    said = next(sentence for sentence in found.description.sentences if "70°" in sentence)
    assert said in found.prompt
    with pytest.raises(TextError):
        parse_prompt(found.prompt.replace(said, "", 1))
    with pytest.raises(TextError):
        parse_scene(found.description.text.replace(said, "", 1))


def test_where_a_block_on_springs_starts_matters_only_to_what_is_measured_from_there() -> None:
    springs = (
        NailedSpring(stiffness=80.0, length=0.3, x=0.6, y=0.2),
        NailedSpring(stiffness=50.0, length=0.4, x=-0.5, y=0.0),
    )
    table = SpringBlock(block=Block(mass=2.0), springs=springs, x=0.1, y=0.2)
    scene = Scene(entities=(Named(name="table", entity=table),))
    held, beside = (
        asked(EquilibriumQuery("equilibrium", Target(*pair)))
        for pair in (("spring length", "table.springs.0"), ("displacement", "table.block"))
    )
    assert "start" in irrelevant(held, study(scene))
    assert "start" not in irrelevant(beside, study(scene))
    untold = describe(scene, without=("start",)).text
    assert "0.1" not in untold
    assert " rest" in describe(scene).text
    assert " rest" not in untold, "from nowhere in particular nothing is let go"


def strained(ends: Literal["left", "both"], by: float = 0.12) -> Scene:
    """Return two carts between springs on a slope, the highest spring initially compressed by a length in m."""
    chain = SpringMassChain(
        track=RoughTrack(angle=33.0),
        carts=(Cart(mass=3.2), Cart(mass=2.4)),
        ends=ends,
        springs=tuple(Coil(stiffness=k) for k in (143.0, 85.0, 56.0)[: 3 if ends == "both" else 2]),
        strain=Strained(spring=2 if ends == "both" else 1, way="compressed", by=by) if by else Strained(),
    )
    return Scene(entities=(Named(name="it", entity=chain),))


@pytest.mark.parametrize("by", [0.12, 0.0])
def test_how_springs_between_two_walls_are_strained_at_first_matters_to_their_equilibrium(by: float) -> None:
    """A chain at one wall only is stretched by its weight alone, whatever the initial strain of a spring."""
    stored = asked(EquilibriumQuery("equilibrium", Target("spring energy", "it.springs.1")))
    assert "start" not in irrelevant(stored, study(strained("both", by)))
    assert "start" in irrelevant(stored, study(strained("left", by)))


def test_a_prompt_that_does_not_tell_how_springs_between_two_walls_are_strained_is_refused() -> None:
    text = describe(strained("both"), without=("start",)).text
    question = "What is the energy stored in spring 2 in the position of equilibrium?"
    with pytest.raises(TextError, match="how the motion begins"):
        parse_prompt(f"{text} {question} Write the answer in J, to three significant figures, in \\boxed{{}}.")


def test_prompts_about_equilibria_of_drawn_chains_state_every_number_that_their_solutions_use() -> None:
    told = 0
    for number in range(60):
        rng = np.random.default_rng(number)
        search = QuestionSearch(RECIPES["chain"](find_difficulty("medium"), rng), number)
        found = search.ask(MODES["numeric"], rng, Counter(), "equilibrium")
        solution = found.candidate.solution if found is not None else None
        if found is None or solution is None or not solution.text.startswith("Given: "):
            continue
        given = solution.text.partition("\n\n")[0]
        for value in re.findall(r"= ([\d.]+)(?:\\|\^|\$)", given):
            assert value in found.prompt, (value, found.prompt)
            told += 1
    assert told > 20

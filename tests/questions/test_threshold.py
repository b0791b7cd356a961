"""Tests of threshold values of parameters against textbook formulas, and of their check by the second engine."""

from dataclasses import dataclass
from math import acos, cos, degrees, radians, sin, sqrt, tan

import numpy as np
import pytest

from plain_scenes import ramp
from sim2reason.errors import SimulationError
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import KINDS, MODES, SimulatedScene, Words
from sim2reason.questions.following import UNDECIDED, simulate_scene
from sim2reason.questions.inversion import ThresholdSearch
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.outcomes import OUTCOMES, Onset
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import parse_prompt, prompt, words_of
from sim2reason.questions.simplifications import MISCONCEPTIONS
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import Ball, Cord, LightRod
from sim2reason.scenes.bodies.round_bodies import Hoop
from sim2reason.scenes.bodies.simple_machines import FixedPulley, Incline, Plane
from sim2reason.scenes.dsl.connection import CONNECTIONS, Link
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley
from sim2reason.scenes.entities.rolling import RollingEntity, Rough
from sim2reason.scenes.entities.string_ends import Hanging, OnPlane
from sim2reason.scenes.files import loads
from sim2reason.simulation.scenes import simulate
from sim2reason.simulation.trace import Trace
from sim2reason.text.prose.description import describe
from sim2reason.text.prose.voices import symbolic_at

G = 9.8
LOOP = """
scene:
  entities:
  - {{name: lift, type: MassWithReverseMovablePulley, parameters: {{pulley: {{mass: 0}}, load: {{mass: {mass}}}}}}}
  - {{name: hook, type: FixedSupport}}
  - {{name: hand, type: ConstantForcePuller, parameters: {{force: 5}}}}
  connections:
  - tendon: [{{entity: hook, direction: end}}, {{entity: lift, direction: left}}]
  - tendon: [{{entity: lift, direction: right}}, {{entity: hand, direction: end}}]
"""


def study(scene: Scene) -> SimulatedScene:
    return SimulatedScene(scene, simulate(scene))


def critical(scene: Scene, outcome: str, name: str, path: str) -> float | None:
    return ThresholdSearch(study(scene), OUTCOMES[outcome](name), path).change()


def pendulum(hanger: Cord | LightRod, angle: float, speed: float) -> Scene:
    return Scene(
        entities=(Named(name="p", entity=Pendulum(bob=Ball(mass=0.5), hanger=hanger, angle=angle, speed=speed)),)
    )


@dataclass(frozen=True, slots=True)
class Slow(Onset):
    """Outcome that happens at once if friction exceeds 0.3 and otherwise only after 4 s.

    A simulation longer than 1 s fails if friction exceeds 0.3.
    """

    def happens(self, trace: Trace) -> bool | None:
        duration, rough = trace.state.times[-1], trace.mechanism.contacts["ramp.blocks.0"].friction > 0.3
        if rough and duration > 1.0:
            raise SimulationError("it can't be followed for so long")
        return True if rough or duration > 4.0 else None

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        del words
        return {}

    def duration(self, scene: Scene) -> float:
        del scene
        return 1.0

    def does(self, words: Words) -> tuple[str, ...]:
        del words
        return ()

    does_not = does


def test_what_fails_when_followed_for_long_is_followed_for_less() -> None:
    """A value whose longer simulation fails is tried with the shorter duration instead."""
    trial = ThresholdSearch(study(ramp(angle=20.0, friction=0.2)), Slow("ramp.blocks.0"), "ramp.plane.friction")
    assert trial(0.28) is True
    assert trial(0.32) is True


def test_what_changes_far_from_what_is_drawn_is_not_closed_in_on() -> None:
    """Friction is drawn up to 0.7; on a slope of 60° the threshold is tan 60° = 1.73, more than twice that."""
    scene = ramp(angle=60.0, friction=0.3)
    trial = ThresholdSearch(study(scene), OUTCOMES["slides"]("ramp.blocks.0"), "ramp.plane.friction")
    assert trial.usual_change() is None
    tried = len(trial._known)
    assert trial.change() == pytest.approx(tan(radians(60.0)), rel=1e-7)
    assert tried < len(trial._known)


def test_a_block_slips_from_the_angle_of_friction_on() -> None:
    """The thresholds are µ = tan θ and θ = atan µ."""
    scene = ramp(angle=25.0, friction=0.3)
    assert critical(scene, "slides", "ramp.blocks.0", "ramp.plane.friction") == pytest.approx(
        tan(radians(25.0)), rel=1e-7
    )
    found = critical(scene, "slides", "ramp.blocks.0", "ramp.plane.angle")
    assert found is not None
    assert tan(radians(found)) == pytest.approx(0.3, rel=1e-7)
    assert critical(scene, "slides", "ramp.blocks.0", "ramp.blocks.0.mass") is None


@pytest.mark.parametrize(("mass", "force"), [(4.0, 2.0), (80.0, 40.0), (8e3, 4e3)])
def test_a_limit_is_found_within_the_usual_range_of_a_number_and_beyond(mass: float, force: float) -> None:
    """A hand that pulls a string around a light movable pulley holds the pulley's load with half its weight."""
    scene = loads(LOOP.format(mass=mass))
    found = critical(scene, "rises", "lift.load", "hand.force")
    assert found == pytest.approx(force * G, rel=1e-6)
    words = words_of(describe(scene))
    asked = pose_question(StructuredQuestion("hand.force", when="lift.load rises"), simulate_scene(scene), words)
    assert asked.simulate_answer(simulate_scene(scene)).answer == pytest.approx(force * G, rel=1e-6)


def test_that_a_number_decides_nothing_is_the_reason() -> None:
    """The mass of a block does not decide whether it slips."""
    scene = ramp(angle=25.0, friction=0.3)
    asked = pose_question(
        StructuredQuestion("ramp.blocks.0.mass", when="slides"), simulate_scene(scene), words_of(describe(scene))
    )
    found = asked.simulate_answer(simulate_scene(scene))
    assert found.answer is None
    assert found.reason == UNDECIDED


def test_a_rod_goes_right_round_if_it_gets_to_the_top() -> None:
    """The threshold is v² = 2 g ℓ (1 + cos θ) for a start at the angle θ from the downward vertical."""
    found = critical(pendulum(LightRod(length=1.2), 29.0, 2.0), "goes_round", "p.hanger", "p.speed")
    assert found == pytest.approx(sqrt(2.0 * G * 1.2 * (1.0 + cos(radians(29.0)))), rel=1e-5)


def test_a_string_stays_taut_if_the_bob_gets_no_higher_than_its_end() -> None:
    """The threshold is v²/2 = g ℓ cos θ, at speeds too low for a full circle."""
    found = critical(pendulum(Cord(length=1.6), 40.0, 2.0), "goes_slack", "p.hanger", "p.angle")
    assert found == pytest.approx(degrees(acos(2.0**2 / (2.0 * G * 1.6))), rel=1e-6)


def test_a_speed_at_which_it_goes_slack_is_no_threshold() -> None:
    """The string goes slack between two speeds, so that the outcome changes twice."""
    assert critical(pendulum(Cord(length=1.0), 40.0, 2.0), "goes_slack", "p.hanger", "p.speed") is None


def test_one_of_two_changes_is_doubted() -> None:
    """The string goes slack from v² = 2 g ℓ cos θ on, until v² = g ℓ (3 + 2 cos θ), enough for a full circle."""
    scene, outcome = pendulum(Cord(length=1.0), 40.0, 2.0), OUTCOMES["goes_slack"]("p.hanger")
    first = sqrt(2.0 * G * cos(radians(40.0)))
    assert not ThresholdSearch(study(scene), outcome, "p.speed").changes_only_at(first)
    query = ThresholdQuery("threshold", None, None, outcome, "p.speed", "", about=first)
    assert "other values" in KINDS["threshold"].doubt(query, study(scene), None)


def lifted(mass: float = 2.0, friction: float = 0.0, disc: float = 0.0) -> Scene:
    """Build a block on a slope of 30° whose string over a pulley holds a hanging block of 1.5 kg."""
    slope = OnPlane(plane=Plane(angle=30.0, friction=friction), blocks=(Block(mass=mass),))
    ends = (
        Named(name="one", entity=MassWithFixedPulley(system=slope, pulley=FixedPulley(mass=disc))),
        Named(
            name="other", entity=MassWithFixedPulley(system=Hanging(blocks=(Block(mass=1.5),)), pulley=FixedPulley())
        ),
    )
    links = tuple(Link(entity=end.name, port="tail") for end in ends)
    return Scene(entities=ends, connections=(CONNECTIONS["tendon"](links=links),))


@pytest.mark.parametrize("friction", [0.0, 0.2])
def test_a_block_is_drawn_up_by_one_heavy_enough(friction: float) -> None:
    """The threshold is m (sin θ + µ cos θ) = M."""
    scene = lifted(friction=friction)
    block = next(address for address, body in scene.bodies.items() if getattr(body, "mass", 0.0) == 2.0)
    path = f"{block}.mass"
    expected = 1.5 / (sin(radians(30.0)) + friction * cos(radians(30.0)))
    assert critical(scene, "rises", block, path) == pytest.approx(expected, rel=1e-6)


def test_where_a_number_hardly_matters_the_limit_is_found_as_closely() -> None:
    """A light block in a train of two has 1.5 kg = (m + 2.7 kg) (sin 30° + µ cos 30°), so m = 11.2 g.

    If speeds below 1e-9 g times the time counted as rest, the limit would be 7e-7 too low.
    """
    pull = sin(radians(30.0)) + 0.0615 * cos(radians(30.0))
    expected = 1.5 / pull - 2.7
    slope = OnPlane(plane=Plane(angle=30.0, friction=0.0615), blocks=(Block(mass=0.02), Block(mass=2.7)))
    scene = lifted()
    entity = scene.entities[0].entity.model_copy(update={"system": slope})
    scene = scene.model_copy(update={"entities": (Named(name="one", entity=entity), scene.entities[1])})
    block = "one.system.blocks.0"
    trial = ThresholdSearch(study(scene), OUTCOMES["rises"](block), f"{block}.mass")
    assert trial.find_change_between(0.8 * expected, 1.2 * expected) == pytest.approx(expected, rel=3e-7)


@pytest.mark.parametrize(
    ("scene", "outcome", "name", "path"),
    [
        (ramp(angle=25.0, friction=0.3), "slides", "ramp.blocks.0", "ramp.plane.friction"),
        (pendulum(LightRod(length=1.2), 29.0, 2.0), "goes_round", "p.hanger", "p.speed"),
        (pendulum(Cord(length=1.6), 40.0, 2.0), "goes_slack", "p.hanger", "p.angle"),
    ],
)
def test_the_second_engine_sees_both_sides(scene: Scene, outcome: str, name: str, path: str) -> None:
    known, found = study(scene), critical(scene, outcome, name, path)
    assert found is not None
    query = ThresholdQuery("threshold", None, None, OUTCOMES[outcome](name), path, "", about=found)
    assert KINDS["threshold"].doubt(query, known, None) == ""
    wrong = ThresholdQuery("threshold", None, None, OUTCOMES[outcome](name), path, "", about=1.02 * found)
    first = ThresholdSearch(known, OUTCOMES[outcome](name), path)
    assert first(0.995 * found) != first(1.005 * found)
    assert KINDS["threshold"].answer(wrong, known) == pytest.approx(found, rel=1e-4)


@pytest.mark.parametrize(
    ("scene", "outcome", "name", "path"),
    [
        (ramp(angle=25.0, friction=0.3), "slides", "ramp.blocks.0", "ramp.plane.friction"),
        (lifted(friction=0.2), "rises", "one.system.blocks.0", "one.system.blocks.0.mass"),
        (pendulum(LightRod(length=1.2), 29.0, 2.0), "goes_round", "p.hanger", "p.speed"),
        (pendulum(Cord(length=1.6), 40.0, 2.0), "goes_slack", "p.hanger", "p.angle"),
    ],
)
def test_secants_lead_where_halving_does(
    scene: Scene, outcome: str, name: str, path: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Secants and bisection find the same number to 1e-9; bisection of 0.1 takes log2(1e8) = 27 trials."""
    trial = ThresholdSearch(study(scene), OUTCOMES[outcome](name), path)
    found, tried = trial.change(), len(trial._known)
    monkeypatch.setattr(ThresholdSearch, "_aimed", lambda *_: None)
    halving = ThresholdSearch(study(scene), OUTCOMES[outcome](name), path)
    assert halving.change() == pytest.approx(found, rel=2e-9)
    assert len(halving._known) > tried + 10


@pytest.mark.parametrize("outcome", [name for name, outcome in OUTCOMES.items() if outcome.drawn_by_recipes])
def test_every_outcome_has_words_for_both(outcome: str) -> None:
    """An outcome and its opposite have different clauses and at least three question shapes, all read back."""
    scenes = [ramp(angle=25.0, friction=0.3), pendulum(LightRod(length=1.2), 29.0, 2.0), lifted(friction=0.2)]
    scenes += [pendulum(Cord(length=1.6), 40.0, 2.0), rolling()]
    seen = 0
    for scene in scenes:
        known, words = study(scene), words_of(describe(scene, 2))
        for each in OUTCOMES[outcome].found(words)[:1]:
            assert not set(each.does(words)) & set(each.does_not(words))
            unknown = words.unknowns[0]
            alone = Words.of(scene, words.mentions, {unknown.path: unknown.symbol.strip("$")})
            for greatest in (False, True):
                for happens in (False, True):
                    query = ThresholdQuery("threshold", None, None, each, unknown.path, unknown.unit, greatest, happens)
                    shapes = KINDS["threshold"].shapes(query, words, None)
                    assert len(set(shapes)) >= 3
                    for shape in shapes:
                        read = MODES["numeric"].parsed(sentence(shape), known, alone)
                        assert read is not None
                        assert read.query == query
                        seen += 1
    assert seen


def rolling() -> Scene:
    """Build a hoop at rest on a slope of 36°."""
    entity = RollingEntity(plane=Incline(angle=36.0), body=Hoop(mass=2.0, radius=0.1), grip=Rough(friction=0.4))
    return Scene(entities=(Named(name="roller", entity=entity),))


def test_a_hoop_rolls_if_there_is_half_the_friction_of_its_slope() -> None:
    """Rolling needs f = m g sin θ/2, so µ = tan θ/2."""
    scene = rolling()
    slope = radians(scene.value("roller.plane.angle"))
    found = critical(scene, "slips_rolling", "roller.body", "roller.grip.friction")
    assert found == pytest.approx(0.5 * tan(slope), rel=1e-6)


def test_a_prompt_leads_back_to_its_threshold() -> None:
    for scene in (ramp(angle=25.0, friction=0.3), lifted(friction=0.2), pendulum(LightRod(length=1.2), 29.0, 2.0)):
        search = QuestionSearch(scene, 3)
        asked = (
            MODES["numeric"].ask(search.study, search.words, "threshold", np.random.default_rng(s)) for s in range(12)
        )
        question = next(each for each in asked if each is not None)
        assert question.unknown
        described = describe(scene, 3, symbolic_at(question.unknown))
        read = parse_prompt(prompt(described, question, np.random.default_rng(1)))
        assert read.query.kind == "threshold"
        assert read.answer == pytest.approx(question.answer, rel=1e-5)


@pytest.mark.parametrize(
    ("friction", "slip", "kept"),
    [
        (0.02, "no friction", sin(radians(30.0))),
        (0.2, "no friction", None),
        (0.2, "massless pulley", sin(radians(30.0)) - 0.2 * cos(radians(30.0))),
    ],
)
def test_a_wrong_idea_is_tried_on_the_mechanism_of_every_value(friction: float, slip: str, kept: float | None) -> None:
    """The hanging block rises if m < M (sin θ − µ cos θ); a wrong threshold is only searched close to it."""
    name = "other.system.blocks.0"
    seen, path = study(lifted(3.0, friction, disc=0.5)), f"{name}.mass"
    about = 3.0 * (sin(radians(30.0)) - friction * cos(radians(30.0)))
    query = ThresholdQuery("threshold", None, None, OUTCOMES["rises"](name), path, "kg", about=about)
    assert KINDS["threshold"].answer(query, seen) == pytest.approx(about)
    (subject,) = MISCONCEPTIONS[slip].subjects(query, seen)
    wrong = MISCONCEPTIONS[slip].simplified(seen, subject, 0.0)
    assert wrong is not None
    found = KINDS["threshold"].answer(query, wrong)
    assert found == (None if kept is None else pytest.approx(3.0 * kept, rel=1e-4))


def test_how_strong_gravity_is_is_no_matter() -> None:
    seen = study(lifted(3.0, 0.2))
    query = ThresholdQuery("threshold", None, None, OUTCOMES["rises"]("other.system.blocks.0"), "", "kg")
    weightless, smooth = (
        MISCONCEPTIONS[name].simplified(seen, "", 0.0) for name in ("gravity left out", "no friction")
    )
    assert weightless is not None
    assert smooth is not None
    assert KINDS["threshold"].indifferent(query, seen, weightless)
    assert not KINDS["threshold"].indifferent(query, seen, smooth)


@pytest.mark.parametrize(("greatest", "beyond"), [(True, "below which"), (False, "above which")])
def test_at_the_limit_itself_the_sentence_is_true(greatest: bool, beyond: str) -> None:
    """The outcome does not happen at the threshold, so only the values without it have a least or greatest."""
    scene = ramp(angle=25.0, friction=0.3)
    outcome, path = OUTCOMES["slides"]("ramp.blocks.0"), "ramp.plane.friction"
    trial = ThresholdSearch(study(scene), outcome, path)
    assert trial(tan(radians(25.0)) * (1.0 - 1e-6))
    assert not trial(tan(radians(25.0)) * (1.0 + 1e-12))
    words = words_of(describe(scene, 2))
    asked = {
        happens: KINDS["threshold"].shapes(
            ThresholdQuery("threshold", None, None, outcome, path, "", greatest, happens), words, None
        )
        for happens in (False, True)
    }
    assert all(beyond in shape and "slip" in shape for shape in asked[True])
    extremes = ("greatest", "largest") if greatest else ("least", "smallest")
    assert all(any(word in shape for word in extremes) and "for which" in shape for shape in asked[False])
    assert not any(word in shape for shape in asked[True] for word in (*extremes, "for which"))

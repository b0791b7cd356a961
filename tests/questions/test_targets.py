"""Tests of the quantities that can be asked about a body: noun phrases, signs and sentences."""

from collections import Counter
from math import cos, radians, sin

import numpy as np
import pytest

from motions import told_motions
from plain_scenes import G, atwood, ramp, squeezed, swing, table
from sim2reason.questions import KINDS, MODES, Noun, Query, SimulatedScene, Words
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.phrasing import QUOTA, draw_sentence, question_sentences
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import Target, targets
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import FixedBall
from sim2reason.scenes.bodies.round_bodies import Sphere
from sim2reason.scenes.bodies.simple_machines import Box, Incline
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import RotationEntity
from sim2reason.scenes.entities.pieces import BallPiece, RoundPiece
from sim2reason.scenes.entities.rolling import Rolling, RollingEntity, Rough, Sliding, Spinning
from sim2reason.scenes.entities.slopes import MassBoxPlane
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.scenes import simulate
from sim2reason.text.prose.description import describe

MAGNITUDES = ("radius", "speed", "magnitude", "amount by which", "distance", "kinetic", "tension", "normal")


def offered(scene: Scene) -> dict[str, Target]:
    """Return the targets that can be asked about, by noun phrase."""
    return {noun.phrase: target for target, noun in targets(words_of(describe(scene))).items()}


def answer(scene: Scene, phrase: str, time: float) -> float:
    query = Query("state", offered(scene)[phrase], AtTime(time))
    found = KINDS["state"].answer(query, SimulatedScene(scene, simulate(scene)))
    assert found is not None
    return found


def noun(scene: Scene) -> str:
    return words_of(describe(scene)).mentions[next(iter(scene.bodies))]


def test_a_block_on_a_ramp() -> None:
    scene = ramp(mass=2.0, angle=30.0, friction=0.2)
    block = next(said for address, said in words_of(describe(scene)).mentions.items() if "blocks" in address)
    a = G * (sin(radians(30)) - 0.2 * cos(radians(30)))
    press = 2.0 * G * cos(radians(30))
    assert answer(scene, f"the speed of {block}", 0.5) == pytest.approx(a * 0.5)
    assert answer(scene, f"the kinetic energy of {block}", 0.5) == pytest.approx(0.5 * 2.0 * (a * 0.5) ** 2)
    assert answer(scene, f"the magnitude of the net force on {block}", 0.5) == pytest.approx(2.0 * a)
    normal = next(phrase for phrase in offered(scene) if phrase.startswith("the magnitude of the normal force"))
    assert normal.endswith(("by the plane", "by the incline", "by the slope", "by the inclined plane")), normal
    assert answer(scene, normal, 0.5) == pytest.approx(press)
    drop = f"the magnitude of the change in {block}'s gravitational potential energy since the start"
    assert answer(scene, drop, 0.5) == pytest.approx(2.0 * G * 0.5 * a * 0.25 * sin(radians(30)))


def test_a_smooth_face_is_not_asked_for_its_friction() -> None:
    assert not any("friction" in phrase for phrase in offered(ramp()))
    assert any("friction" in phrase for phrase in offered(ramp(friction=0.3)))


def test_a_string_is_told_by_its_ends() -> None:
    scene = atwood(3.0, 2.0)
    tensions = {phrase: target for phrase, target in offered(scene).items() if target.quantity == "tension"}
    assert list(tensions) == ["the tension in the string"]
    assert answer(scene, "the tension in the string", 0.5) == pytest.approx(2 * 3.0 * 2.0 * G / 5.0)


def test_pucks_have_components_along_the_axes_of_the_text() -> None:
    phrases = offered(table())
    assert any(phrase.startswith("the x component of the velocity") for phrase in phrases)
    assert not any("up the slope" in (t.sense.positive if t.sense else "") for t in phrases.values())


def test_a_component_is_taken_along_the_axes_of_the_motion_at_hand() -> None:
    """The y axis is along the slope of the mechanism being measured, here one with its angle changed to 40°."""
    scene = table()
    name = next(named.name for named in scene.entities)
    target = next(t for phrase, t in offered(scene).items() if phrase.startswith("the y component of the velocity"))
    tilted = scene.having(f"{name}.table.angle", 40.0).mechanism
    assert target.direction(tilted) == pytest.approx((0.0, cos(radians(40.0)), sin(radians(40.0))))


def test_signed_targets_have_a_sense_and_magnitudes_have_none() -> None:
    for scene in (ramp(friction=0.3), atwood(), table()):
        for phrase, target in offered(scene).items():
            magnitude = any(word in phrase for word in MAGNITUDES)
            assert magnitude != target.signed, phrase


@pytest.mark.parametrize("kind", list(KINDS))
def test_every_kind_asks_in_three_shapes_that_end_as_they_begin(kind: str) -> None:
    asked = 0
    scenes = (ramp(speed=2.0), ramp(friction=0.2), atwood(), table(), squeezed(), swing())
    told = [(SimulatedScene(scene, simulate(scene)), words_of(describe(scene))) for scene in scenes]
    for study, words in [*told, *told_motions()]:
        found = targets(words)
        for seed in range(8):
            query = KINDS[kind].draw(study, words, found, np.random.default_rng(seed))
            if query is None:
                continue
            asked += 1
            shapes = KINDS[kind].shapes(query, words, found[query.target] if query.target else None)
            assert len(set(shapes)) >= 3
            assert all(shape[-1] in ".?" and shape.count("?") <= 1 for shape in shapes)
            assert KINDS[kind].answer(query, study) is not None
    assert asked


def test_a_sign_is_defined_for_components_alone() -> None:
    signed = Target("velocity", "ramp.blocks.0", Sense("up the slope", (0.0, 0.0, 1.0)))
    plain = next(t for t in offered(ramp()).values() if t.quantity == "velocity")
    assert not plain.signed, "which way the block goes, no question tells"
    assert all(
        "positive" in shape for shape in question_sentences(signed, Noun("the velocity of A"), "just after release")
    )
    assert not any(
        "positive" in shape for shape in question_sentences(plain, Noun("the speed of A"), "just after release")
    )


def test_verbs_are_drawn_by_quota() -> None:
    shapes = ("what is it?", "when, what is it?", "if so, what is it?", "find it.", "determine it.", "calculate it.")
    rng, total = np.random.default_rng(0), sum(share for verb, share in QUOTA.items() if verb != "how")
    drawn = Counter(draw_sentence(shapes, rng) for _ in range(4000))
    for verb, share in QUOTA.items():
        count = sum(number for shape, number in drawn.items() if verb in shape)
        assert verb == "how" or count / 4000 == pytest.approx(share / total, abs=0.03)


def test_a_mode_asks_what_it_answers() -> None:
    scene = ramp(speed=2.0)
    words, study = words_of(describe(scene)), SimulatedScene(scene, simulate(scene))
    for seed in range(30):
        question = MODES["numeric"].ask(study, words, "", np.random.default_rng(seed))
        if question is not None:
            assert question.answer == KINDS[question.query.kind].answer(question.query, study)
            assert question.text[0].isupper()
            assert bool(question.sign) == (question.query.target is not None and question.query.target.signed)


def test_an_unknown_time_has_no_answer() -> None:
    study = SimulatedScene(ramp(), simulate(ramp()))
    target = next(iter(offered(ramp()).values()))
    assert KINDS["state"].answer(Query("state", target, AtTime(99.0)), study) is None
    assert KINDS["time_to_event"].answer(Query("time_to_event", None, AtStart()), study) == 0.0
    assert isinstance(words_of(describe(ramp())), Words)


@pytest.mark.parametrize("riding", [True, False])
def test_what_hangs_on_the_frame_names_it_where_something_rides(riding: bool) -> None:
    """The phrases say "relative to the ground" for a block on a sliding box, not for one at a fixed pulley."""
    boxes = MassBoxPlane(box=Box(mass=8.0), blocks=(Block(mass=2.0),), right=Block(mass=1.0), length=3.0)
    scene = Scene(entities=(Named(name="table", entity=boxes),)) if riding else atwood()
    words = words_of(describe(scene))
    body = "table.blocks.0" if riding else next(iter(scene.bodies))
    of_frame = {"displacement", "velocity", "acceleration", "momentum", "kinetic energy"}
    asked = {target.quantity: noun.phrase for target, noun in targets(words).items() if target.subject == body}
    asked |= {
        name: found.noun_phrases(words)[body].phrase
        for name, found in FUNCTIONALS.items()
        if name in ("greatest kinetic energy", "greatest speed", "work of a tension")
        and body in found.noun_phrases(words)
    }
    assert of_frame <= asked.keys()
    assert ("work of a tension" in asked) == (not riding)
    for name in (of_frame | {"greatest kinetic energy", "greatest speed"}) & asked.keys():
        assert ("relative to the ground" in asked[name]) == riding, name


@pytest.mark.parametrize(
    ("angle", "start", "net"),
    [
        (20.0, None, ""),
        (20.0, Rolling(speed=2.0, way="down the slope"), ""),
        (20.0, Rolling(speed=2.0, way="up the slope"), "net "),
        (20.0, Spinning(spin=9.0, way="down the slope"), ""),
        (20.0, Spinning(spin=9.0, way="up the slope"), "net "),
        (0.0, Sliding(speed=2.0, way="to the right"), ""),
        (0.0, Spinning(spin=9.0, way="to the right"), ""),
    ],
)
def test_the_net_angle_is_asked_of_what_may_turn_back(
    angle: float, start: Rolling | Sliding | Spinning | None, net: str
) -> None:
    """A body sent up a slope may reverse its rotation; one that rolls down or slips on level ground may not."""
    ball = Sphere(mass=2.0, radius=0.1)
    held = RollingEntity(body=ball, plane=Incline(angle=angle), grip=Rough(friction=0.4), start=start)
    scene = Scene(entities=(Named(name="lane", entity=held),))
    found = {t.quantity: n for t, n in targets(words_of(describe(scene))).items()}["angle rolled"]
    assert found.phrase.startswith(f"the {net}angle through which the ")
    assert found.interval_phrase.startswith(f"the {net}angle through which the ")
    turned = QUANTITIES["angle rolled"].evaluate(simulate(scene).scan, "lane.body")
    back = bool((np.diff(turned) < -1e-9 * np.abs(turned).max()).any() and (np.diff(turned) > 0.0).any())
    assert back <= bool(net)


@pytest.mark.parametrize("several", [True, False])
def test_of_a_part_of_a_rigid_body_no_force_is_asked_for(several: bool) -> None:
    """The separate translational and rotational kinetic energies of such a part are not asked for either."""
    ball = RoundPiece(body=Sphere(mass=2.0, radius=0.2), distance=0.6)
    other = BallPiece(body=FixedBall(mass=1.0), distance=1.1)
    arm = RotationEntity(pieces=(ball, other) if several else (ball,), angle=40.0)
    scene = Scene(entities=(Named(name="arm", entity=arm),))
    found = {t.quantity for t in targets(words_of(describe(scene))) if t.subject == "arm.pieces.0.body"}
    assert {"kinetic energy", "velocity"} <= found
    asked = {"net force", "torque", "translational kinetic energy", "rotational kinetic energy"} & found
    assert bool(asked) != several
    words = words_of(describe(scene))
    assert ("arm.pieces.0.body" in FUNCTIONALS["impulse of the net force"].noun_phrases(words)) != several

"""Tests of structured questions."""

from math import atan, cos, degrees, pi, radians, sin, sqrt
from pathlib import Path

import numpy as np
import pytest

from plain_scenes import G, atwood, ramp, row, swing, table
from sim2reason.datasets.items import sample
from sim2reason.errors import TextError
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import KINDS, MOMENTS, Words
from sim2reason.questions.following import SimulatedAnswer, simulate_scene
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.questions.posing import PosedQuestion, findable_names, pose_question
from sim2reason.questions.prompt import words_of
from sim2reason.questions.sentences import parse_question
from sim2reason.questions.structured import StructuredQuestion, moment_named, moment_told, resolve_name
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import load, loads
from sim2reason.text.prose.description import describe

SLIDING = ramp(angle=0.0, friction=0.05, speed=5.0)
FAR, LATE = 25.0 / (0.1 * G), 5.0 / (0.05 * G)


def read(scene: Scene, **parts: str) -> tuple[PosedQuestion, Words]:
    """Return the query of a structured question, and the words of its scene."""
    words = words_of(describe(scene))
    return pose_question(StructuredQuestion.read(parts), simulate_scene(scene), words), words


def found(scene: Scene, **parts: str) -> SimulatedAnswer:
    """Return the answer to a structured question, with the motion."""
    return read(scene, **parts)[0].simulate_answer(simulate_scene(scene))


@pytest.mark.parametrize(
    ("scene", "parts", "answer"),
    [
        (SLIDING, {"find": "velocity", "of": "ramp.blocks.0", "when": "moved 0.5 m"}, sqrt(25.0 - 0.05 * G)),
        (SLIDING, {"find": "speed", "of": "the block", "when": "moved 50 cm"}, sqrt(25.0 - 0.05 * G)),
        (SLIDING, {"find": "velocity", "of": "block", "when": "t = 2 s"}, 5.0 - 0.1 * G),
        (SLIDING, {"find": "velocity", "when": "0.7485907357575928 s"}, 5.0 - 0.05 * G * 0.7485907357575928),
        (SLIDING, {"find": "velocity", "when": "0.05 min"}, 5.0 - 0.15 * G),
        (SLIDING, {"find": "time", "when": "stopped"}, LATE),
        (SLIDING, {"find": "time", "when": "the block stopped"}, LATE),
        (SLIDING, {"find": "time", "when": "velocity = 2 m/s"}, 3.0 / (0.05 * G)),
        (SLIDING, {"find": "acceleration"}, 0.05 * G),
        (SLIDING, {"find": "energy dissipated by friction", "when": "stopped"}, 25.0),
        (SLIDING, {"find": "greatest speed", "when": "stopped"}, 5.0),
        (SLIDING, {"find": "ramp.speed", "when": "stopped", "given": "displacement = 100 m"}, sqrt(10.0 * G)),
        (SLIDING, {"find": "ramp.plane.friction", "when": "stopped", "given": "time = 100 s"}, 5.0 / (100.0 * G)),
        (SLIDING, {"find": "displacement", "when": "stopped", "change": "ramp.speed = 10 m/s"}, 4.0),
        (
            SLIDING,
            {"find": "displacement", "when": "stopped", "change": "ramp.speed × 2", "compare": "difference"},
            3.0 * FAR,
        ),
        (ramp(friction=0.4, angle=20.0), {"find": "ramp.plane.angle", "when": "slides"}, degrees(atan(0.4))),
        (atwood(), {"find": "time", "when": "velocity of block A along up = -1 m/s"}, 5.0 / G),
        (atwood(), {"find": "kinetic energy", "of": "block A + block B", "when": "0.5 s"}, 0.5 * 5.0 * (0.1 * G) ** 2),
        (atwood(), {"find": "tension", "when": "0.1 s"}, 2.4 * G),
        (atwood(), {"find": "speed", "of": "block A", "when": "B moved 1 m"}, sqrt(0.4 * G)),
        (row((2.0,), (50.0,), "left", speed=1.5), {"find": "period", "when": "equilibrium"}, 2.0 * pi / 5.0),
        (row((2.0,), (50.0,), "left", speed=1.5), {"find": "greatest extension"}, 0.3),
        (row((2.0,), (50.0,), "left", speed=1.5), {"find": "frequency"}, 2.5 / pi),
        (swing(60.0), {"find": "tension", "when": "lowest point"}, 0.5 * G * 2.0),
        (SLIDING, {"find": "displacement", "when": "velocity = 3 m/s"}, 16.0 / (0.1 * G)),
        (SLIDING, {"find": "displacement", "when": "speed = 3 m/s"}, 16.0 / (0.1 * G)),
        (SLIDING, {"find": "energy dissipated by friction", "when": "velocity = 3 m/s"}, 16.0),
        (SLIDING, {"find": "acceleration", "when": "stopped before"}, 0.05 * G),
        (SLIDING, {"find": "time", "when": "stopped minus velocity = 2 m/s"}, 2.0 / (0.05 * G)),
        (SLIDING, {"find": "kinetic energy", "when": "at start minus velocity = 3 m/s"}, 16.0),
    ],
)
def test_a_question_in_parts_has_its_answer(scene: Scene, parts: dict[str, str], answer: float) -> None:
    """The answers agree with closed forms."""
    told = found(scene, **parts)
    assert told.answer == pytest.approx(answer, rel=1e-6), told.reason


@pytest.mark.parametrize("when", ["height above the ground of the ball = 5.2 m", "velocity of the ball = 8.446 m/s"])
def test_the_axis_of_a_question_is_none_of_its_moment(when: str) -> None:
    """The displacement of a thrown ball along x is found at a height or a speed, neither of which is along x."""
    scene = load(Path(__file__).parents[1] / "data" / "ordinary_scenes" / "low_passing_throw.yaml")
    forward, up = 8.9 * cos(radians(26.0)), 8.9 * sin(radians(26.0))
    rest = sqrt(up**2 - 2.0 * 9.8 * 0.4) if "height" in when else sqrt(8.446**2 - forward**2)
    told = found(scene, find="displacement", along="x", when=when)
    assert told.answer == pytest.approx(forward * (up - rest) / 9.8, rel=1e-6), told.reason


@pytest.mark.parametrize(
    ("parts", "said"),
    [
        ({"find": "velocty"}, "did you mean: velocity"),
        ({"find": "velocity", "of": "ramp.blok"}, "did you mean: ramp.blocks.0"),
        ({"find": "velocity", "when": "mved 2 m"}, "did you mean: moved"),
        ({"find": "velocity", "when": "moved 3 kg"}, "is not measured in m"),
        ({"find": "velocity", "when": "moved far"}, "is no number"),
        ({"find": "velocity", "along": "x"}, "has no components here"),
        ({"find": "ramp.speed"}, "name a moment"),
        ({"find": "time", "when": "stopped minus 1 s", "change": "ramp.speed × 2"}, "ask for each of the two moments"),
        ({"find": "time", "when": "stopped minus soon"}, "names no moment"),
        ({"find": "ramp.sped", "given": "velocity = 2 m/s"}, "did you mean: ramp.speed"),
        ({"find": "ramp.speed", "given": "fast"}, "is no equation"),
        ({"find": "velocity", "when": "2 s", "change": "ramp.sped = 2 m/s"}, "did you mean: ramp.speed"),
        ({"find": "velocity", "when": "2 s", "change": "more"}, "changes nothing"),
        ({"find": "velocity", "when": "2 s", "change": "ramp.speed × 2", "compare": "ratios"}, "did you mean: ratio"),
        ({"fnd": "velocity"}, "did you mean: find"),
        ({"of": "block"}, "it does not say what to find"),
        ({"find": "x" * 300}, "it is no short text"),
        ({"find": "velocity", "when": "velocity = 3 kg"}, "is not measured in m/s"),
    ],
)
def test_what_means_nothing_is_one_error_with_its_place(parts: dict[str, str], said: str) -> None:
    """The error names the part, and similar names."""
    with pytest.raises(TextError, match=said):
        read(SLIDING, **parts)


def test_a_sentence_is_one_writing_of_the_same_query() -> None:
    """The sentence of a structured question is parsed as the same query."""
    for parts in ({"find": "velocity", "when": "moved 0.5 m"}, {"find": "time", "when": "stopped"}):
        question, words = read(SLIDING, **parts)
        assert parse_question(question.sentence(words), simulate_scene(SLIDING).study, words) == question.query


def test_what_no_text_gives_is_not_found() -> None:
    """A text that gives only the extension of a spring leaves its length to a number of the library's own."""
    with pytest.raises(TextError, match="the text does not give the length"):
        found(row((2.0,), (50.0,), "left", speed=1.5), find="spring length", when="1 s")


@pytest.mark.parametrize("recipe", list(RECIPES))
def test_every_moment_that_a_scene_offers_is_told_and_read(recipe: str) -> None:
    """Each moment that a motion offers is read back from its name."""
    scene = sample(recipe, seed=3)
    study, words = simulate_scene(scene).study, words_of(describe(scene))
    for cls in MOMENTS.values():
        for moment in cls.found(study, words, np.random.default_rng(1)):
            told = moment_told(moment, words)
            named = moment_named(StructuredQuestion("velocity", when=told), words)
            # whether a motion may drift on follows from what is asked for
            assert named == (WholeMotion() if isinstance(moment, WholeMotion) else moment), told


@pytest.mark.parametrize("recipe", ["collision", "springs", "rotation", "orbital"])
def test_every_quantity_and_functional_of_a_scene_can_be_found(recipe: str) -> None:
    """The name alone is enough, without a list of names."""
    scene = sample(recipe, seed=3)
    motion, words = simulate_scene(scene), words_of(describe(scene))
    for name in findable_names(words):
        if name in FUNCTIONALS or not any(name in KINDS[kind].finds(words) for kind in ("state", "sum")):
            continue
        try:
            question = pose_question(StructuredQuestion(name, when="at 0.1 s"), motion, words)
        except TextError as error:
            assert error.place == "of" or "the text does not give" in str(error), error  # several have it  # noqa: PT017
        else:
            assert question.query.kind == "state"


def test_names_as_people_say_them() -> None:
    """A name may be the address, its last part, the text's name with or without an article, or its letter."""
    names = {"left.block": "block A", "right.block": "block B", "right.wheel": "the pulley"}
    for said, meant in [
        ("left.block", "left.block"),
        ("block A", "left.block"),
        ("the block B", "right.block"),
        ("B", "right.block"),
        ("pulley", "right.wheel"),
        ("wheel", "right.wheel"),
    ]:
        assert resolve_name("of", said, names) == meant
    with pytest.raises(TextError, match="there are: left"):
        resolve_name("of", "", names)
    assert resolve_name("of", "", {"one": "it"}) == "one"
    assert len(table().bodies) > 1


@pytest.mark.parametrize("find", ["angular velocity", "angular acceleration"])
def test_what_turns_as_one_body_has_one_angular_velocity(find: str) -> None:
    """An arm and a rod welded to it have one angular velocity, but different energies."""
    scene = loads(
        "scene: {entities: [{name: arm, type: RotationEntity, parameters: {angle: 60, pieces: [{kind: axial_piece,"
        " distance: 1, axis: along the arm, body: {kind: uniform_rod, mass: 3, length: 2}}]}}]}"
    )
    answer = found(scene, find=find, when="at 0.4 s").answer
    assert answer == found(scene, find=find, of="arm.arm", when="at 0.4 s").answer
    assert answer == found(scene, find=find, of="arm.pieces.0.body", when="at 0.4 s").answer
    with pytest.raises(TextError, match="does not say what it is about"):
        found(atwood(), find="velocity", when="at 0.4 s")

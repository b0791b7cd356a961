"""Tests that every motion has a question, in the units of its text."""

import numpy as np
import pytest

import motions
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import KINDS, MODES, Query, Question, SimulatedScene, Words
from sim2reason.questions.choices import has_formula_of_time
from sim2reason.questions.moments.times import AtStart
from sim2reason.questions.query import targets
from sim2reason.scenes.bodies.oscillators import Ball, Cord, LightRod
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.units import ASTRONOMICAL
from sim2reason.scenes.entities.pendulums import Pendulum
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.scenes import simulate


def questions(study: SimulatedScene, words: Words, draws: int = 60) -> list[Question]:
    """Return the questions of many draws."""
    found = (MODES["numeric"].ask(study, words, "", np.random.default_rng(seed)) for seed in range(draws))
    return [question for question in found if question is not None]


@pytest.mark.parametrize("name", motions.MOTIONS)
def test_there_is_something_to_ask_of_every_motion(name: str) -> None:
    study, words = motions.MOTIONS[name]().told()
    asked = questions(study, words)
    kinds = {question.query.kind for question in asked}
    assert len({question.text for question in asked}) >= 10
    assert "event" in kinds
    assert ("state" in kinds) == has_formula_of_time(study.mechanism)
    assert all(np.isfinite(question.answer) for question in asked)


@pytest.mark.parametrize("hanger", [Cord(length=0.8), LightRod(length=0.8)], ids=["string", "rod"])
def test_a_bob_is_displaced_whatever_it_hangs_from(hanger: Cord | LightRod) -> None:
    """A bob released at 60° has v² = 2g·(its drop), and turns on the other side, 2ℓ sin 60° from its start."""
    scene = Scene(entities=(Named(name="it", entity=Pendulum(bob=Ball(mass=0.5), hanger=hanger, angle=60.0)),))
    trace = simulate(scene)
    places = QUANTITIES["displacement"].evaluate(trace.scan, "it.bob")
    speeds = np.linalg.norm(QUANTITIES["velocity"].evaluate(trace.scan, "it.bob"), axis=1)
    assert np.abs(speeds**2 + 2.0 * 9.8 * places[:, 2]).max() <= 1e-8
    assert np.linalg.norm(places, axis=1).max() == pytest.approx(1.6 * np.sin(np.radians(60.0)), rel=1e-4)
    search = QuestionSearch(scene, 1)
    asked = {question.text for question in questions(search.study, search.words)}
    assert any("angle" in text for text in asked)
    assert any("lowest point" in text for text in asked)


def test_a_rolling_ball_is_asked_for_its_speed_and_its_turning() -> None:
    _, words = motions.rolling_ball().told()
    phrases = {noun.phrase for noun in targets(words).values()}
    assert {"the speed of the ball", "the magnitude of the angular velocity of the ball"} <= phrases


def test_answers_stand_in_the_units_of_the_text() -> None:
    study, words = motions.orbit(units=ASTRONOMICAL).told()
    asked = questions(study, words, 150)
    units = {question.unit for question in asked}
    assert units >= {"au", "au/yr", "yr"}
    assert not units & {"m", "s", "m/s", "m/s^2", "N", "J", "kg m/s"}
    assert not any(f" {unit} " in question.text for question in asked for unit in ("m", "s"))


def test_what_hangs_on_a_mass_that_is_not_said_is_not_asked() -> None:
    words = motions.orbit().told()[1]
    silent = Words(words.mechanism, words.mentions, words.released, frozenset({"sky.star.mass"}))
    quantities = {target.quantity for target in targets(silent)}
    assert "velocity" in quantities
    assert not quantities & {"momentum", "kinetic energy", "net force", "potential energy"}


def test_a_tension_belongs_to_the_string_that_is_named() -> None:
    """A hand lifts A (1 kg) with 30 N, and B (2 kg) hangs below it: a = 30/3 − g, and T = 2(g + a) = 20 N."""
    study, words = motions.two_strings().told()
    offered = {noun.phrase: target for target, noun in targets(words).items()}
    tensions = [phrase for phrase in offered if phrase.startswith("the tension")]
    assert tensions == ["the tension in the string between block A and block B"]
    assert KINDS["start"].answer(Query("start", offered[tensions[0]], AtStart()), study) == pytest.approx(20.0)

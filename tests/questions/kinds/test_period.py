"""Tests of questions for a period: the possible ones, and their answers against formulas."""

from math import pi, sqrt

import numpy as np
import pytest

from motions import light_rod, orbit, rod_pendulum, spring_block
from plain_scenes import atwood
from sim2reason.generation.item_search import generator
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import KINDS, SimulatedScene, Words
from sim2reason.questions.phrasing import PeriodQuery, sentence
from sim2reason.questions.prompt import words_of
from sim2reason.questions.sentences import parse_question
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Y, Z
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.scenes import simulate as simulate_scene
from sim2reason.text.prose.description import describe

G = 9.8
KIND = KINDS["period"]
SEEDS = range(12)
Told = tuple[SimulatedScene, Words]


def told(mechanism: Mechanism, mentions: dict[str, str], duration: float = 4.0, *, released: bool = True) -> Told:
    """Return a simulated mechanism, and the words for its bodies."""
    trace = simulate(mechanism, np.linspace(0.0, duration, 21))
    return SimulatedScene(atwood(), trace), Words(mechanism, mentions, released)  # no one looks at the scene


def drawn(study: SimulatedScene, words: Words) -> set[PeriodQuery]:
    """Return all period queries that the kind draws by many seeds."""
    found = (KIND.draw(study, words, {}, np.random.default_rng(seed)) for seed in SEEDS)
    return {query for query in found if isinstance(query, PeriodQuery)}


def answers(study: SimulatedScene, words: Words) -> dict[str, set[float]]:
    """Return rounded answers by measure."""
    found: dict[str, set[float]] = {}
    for query in drawn(study, words):
        answer = KIND.answer(query, study)
        assert answer is not None
        found.setdefault(query.measure, set()).add(round(answer, 7))
    return found


def slider() -> Mechanism:
    """Build a pendulum of 0.6 m and 0.5 kg on a cart of 1.5 kg that slides freely."""
    builder = Builder()
    cart = builder.room().body("cart", 1.5).rest(X, Z)
    cart.body("rod").hinge(Y).body("bob", 0.5, at=(0.36, 0.0, -0.48))
    return builder.finish()


def two_between_walls() -> Mechanism:
    """Build two carts of 1 kg and springs of 30, 20 and 30 N/m from wall to wall: ω² = 30 and 70 s⁻²."""
    builder = Builder()
    room = builder.room().site("left", (-1.0, 0.0, 0.0)).site("right", (2.0, 0.0, 0.0))
    for name, x, speed in (("a", 0.0, 0.3), ("b", 1.0, 0.0)):
        room.body(name, 1.0, at=(x, 0.0, 0.0)).rest(X, Z, speed=speed).site(f"{name}.hook")
    for name, ends, stiffness in (
        ("one", ("left", "a.hook"), 30.0),
        ("two", ("a.hook", "b.hook"), 20.0),
        ("three", ("b.hook", "right"), 30.0),
    ):
        room.spring(name, *ends, stiffness=stiffness, length=1.0)
    return builder.finish()


def test_where_small_and_large_have_one_period_nothing_is_called_small() -> None:
    """The scene is a block of 0.5 kg on a spring of 20 N/m."""
    study, words = spring_block().told()
    expected = 2.0 * pi * sqrt(0.5 / 20.0)
    assert answers(study, words) == {"period": {round(expected, 7)}, "frequency": {round(1.0 / expected, 7)}}
    assert not any(query.small for query in drawn(study, words))


def test_a_pendulum_that_swings_far_is_asked_for_its_own_period_and_a_beam_for_both() -> None:
    """√(ℓ/g) alone is never asked for; a rod of 1.2 m about its end has √(2ℓ/(3g)) for small swings."""
    assert {query.small for query in drawn(*told(light_rod(80.0).mechanism, {"swing.bob": "the bob"}))} == {False}
    assert {query.small for query in drawn(*told(rod_pendulum(80.0).mechanism, {"swing.rod": "the rod"}))} == {
        False,
        True,
    }
    study, words = rod_pendulum(20.0).told()
    assert {query.small for query in drawn(study, words)} == {True}
    assert round(2.0 * pi * sqrt(2.0 * 1.2 / (3.0 * G)), 7) in answers(study, words)["period"]
    assert drawn(*light_rod(20.0).told()) == set()


def test_two_bodies_that_nothing_holds_oscillate_against_each_other() -> None:
    """The angular frequency is given by ω² = (1 + m/M) g/ℓ."""
    study, words = told(slider(), {"cart": "cart A", "bob": "bead B"})
    small = {query for query in drawn(study, words) if query.small}
    assert {query.of for query in small} == {("cart", "bob")}
    (frequency,) = answers(study, words)["angular frequency"]
    assert frequency == pytest.approx(sqrt((1.0 + 0.5 / 1.5) * G / 0.6), abs=1e-6)
    assert any("relative to each other" in shape for query in small for shape in KIND.shapes(query, words, None))


def test_of_several_modes_the_slowest_or_the_fastest_is_asked() -> None:
    study, words = told(two_between_walls(), {"a": "cart A", "b": "cart B"}, released=False)
    queries = drawn(study, words)
    assert {(query.modes, query.rank) for query in queries} == {(2, 0), (2, 1)}
    for query in queries:
        omega = sqrt(70.0 if query.rank else 30.0)
        expected = {"period": 2.0 * pi / omega, "frequency": omega / (2.0 * pi), "angular frequency": omega}
        assert KIND.answer(query, study) == pytest.approx(expected[query.measure], rel=1e-8)


def test_a_planet_goes_round_its_star() -> None:
    study, words = orbit(0.3).told()
    (query,) = drawn(study, words)
    assert KIND.answer(query, study) == pytest.approx(1.0, rel=1e-8)
    assert "what is the orbital period of the planet?" in KIND.shapes(query, words, None)
    assert KIND.time(query, study) == KIND.answer(query, study)
    assert KIND.channels(query)


def test_what_falls_has_no_period() -> None:
    scene = atwood()
    study, words = SimulatedScene(scene, simulate_scene(scene)), words_of(describe(scene))
    assert drawn(study, words) == set()
    query = PeriodQuery("period", small=True)
    assert KIND.answer(query, study) is None
    assert KIND.doubt(query, study, None)
    assert KIND.answer(PeriodQuery("period", of=("one.system.blocks.0",)), study) is None


@pytest.mark.parametrize("scenes", [5, pytest.param(20, marks=pytest.mark.slow)])
@pytest.mark.parametrize("recipe", ["chain", "mixed", "rotation", "rolling", "orbital", "electromagnetic"])
def test_every_sentence_leads_back_and_is_vouched_for(recipe: str, scenes: int) -> None:
    """Every shape of every query about random scenes, of at least three, is tested."""
    seen = 0
    for difficulty in ("easy", "medium"):
        for index in range(scenes):
            scene = RECIPES[recipe](difficulty, generator(recipe, difficulty, "numeric", 11, index, 0))
            study, words = SimulatedScene(scene, simulate_scene(scene)), words_of(describe(scene))
            for query in drawn(study, words):
                shapes = KIND.shapes(query, words, None)
                assert len(set(shapes)) >= 3
                assert {parse_question(sentence(shape), study, words) for shape in shapes} == {query}
                if query.small:
                    assert KIND.doubt(query, study, None) == ""
                    assert KIND.time(query, study) == 0.0
                seen += 1
    assert seen


def test_how_far_a_spring_is_pulled_is_of_no_matter_by_nature() -> None:
    """The period does not depend on the initial stretch, but on the mass and the stiffness."""
    study, words = spring_block(0.2).told()
    query = next(iter(drawn(study, words)))
    assert KIND.indifferent(query, study, spring_block(0.25).told()[0])
    assert not KIND.indifferent(query, study, rod_pendulum(60.0).told()[0])
    assert not KINDS["state"].indifferent(query, study, spring_block(0.25).told()[0])


@pytest.mark.parametrize(("recipe", "stable"), [("rotation", True), ("chain", False)])
def test_an_equilibrium_is_called_stable_where_there_may_be_another(recipe: str, *, stable: bool) -> None:
    """A pendulum can also stand upright, while carts on springs have one equilibrium."""
    seen = 0
    for index in range(5):
        scene = RECIPES[recipe]("medium", generator(recipe, "medium", "numeric", 11, index, 0))
        study, words = SimulatedScene(scene, simulate_scene(scene)), words_of(describe(scene))
        for query in filter(lambda query: query.small, drawn(study, words)):
            assert all(("stable equilibrium" in shape) is stable for shape in KIND.shapes(query, words, None))
            seen += 1
    assert seen

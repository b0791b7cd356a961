"""Tests of questions about equilibrium positions."""

from collections.abc import Callable, Iterator
from contextlib import suppress

import numpy as np
import pytest

from drawn_entities import drawn_entity
from lone_entities import alone
from motions import Motion, rod_pendulum, string_pendulum
from plain_scenes import atwood
from sim2reason.errors import SceneError
from sim2reason.generation.item_search import generator
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import KINDS, Query, SimulatedScene, Target, Words
from sim2reason.questions.kinds.equilibrium import EquilibriumQuery
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import targets
from sim2reason.questions.sentences import parse_question
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.measures import Count
from sim2reason.scenes.dsl.mechanism import GRAVITY, Mechanism, X, Z
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.spring_blocks import SpringBlock
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.equilibrium import equilibrium
from sim2reason.simulation.scenes import simulate as simulate_scene
from sim2reason.text.prose.description import describe

G = GRAVITY
KIND = KINDS["equilibrium"]
SEEDS = range(30)
TABLE = "table"


def drawn(study: SimulatedScene, words: Words) -> set[Query]:
    """Return all queries that the kind draws by many seeds."""
    found = (KIND.draw(study, words, targets(words), np.random.default_rng(seed)) for seed in SEEDS)
    return {query for query in found if query is not None}


def held() -> Mechanism:
    """Build a block of 2 kg on a level floor, between a spring of 80 N/m and 0.5 m and a string to 1 kg."""
    builder = Builder()
    room = builder.room("bench").site("wall", (-0.7, 0.0, 0.0)).site("in", (2.0, 0.0, 0.0)).site("out", (2.1, 0.0, 0.0))
    room.body("block", 2.0).rest(X, Z).site("eye").site("hook")
    room.body("load", 1.0, at=(2.1, 0.0, -1.0)).slide(Z).site("clasp")
    room.spring("spring", "bench.wall", "bench.eye", stiffness=80.0, length=0.5)
    room.string("string", "bench.hook", "bench.in", "bench.out", "bench.clasp")
    return builder.finish()


def test_a_spring_that_a_load_stretches() -> None:
    """The extension is x = mg/k, the length l₀ + x; mg itself, and values at the start, are not asked for."""
    mentions = {"bench.block": "block A", "bench.load": "block B", "bench.spring": "the spring", "bench.string": "it"}
    mechanism = held()
    said = frozenset({"bench.spring.stiffness", "bench.spring.length", "bench.block.mass", "bench.load.mass"})
    study = SimulatedScene(atwood(), simulate(mechanism, np.linspace(0.0, 1.0, 11)))
    words = Words(mechanism, mentions, released=True, stated_paths=said)
    extension = 1.0 * G / 80.0
    expected = {
        "extension": extension,
        "spring length": 0.5 + extension,
        "spring energy": 0.5 * 80.0 * extension**2,
        "displacement": abs(0.2 - extension),
    }
    queries = drawn(study, words)
    asked = {query.target.quantity for query in queries if query.target is not None}
    assert {"extension", "displacement"} <= asked <= set(expected)
    for query in queries:
        assert query.target is not None
        assert KIND.answer(query, study) == pytest.approx(expected[query.target.quantity], rel=1e-8)
        assert KIND.doubt(query, study, None) == ""
        assert KIND.time(query, study) == 0.0
        assert KIND.channels(query) == ()
        assert KIND.of_motion(query) is (query.target.quantity == "displacement")


@pytest.mark.parametrize("made", [rod_pendulum, string_pendulum])
def test_of_what_hangs_below_its_point_nothing_is_asked(made: Callable[[], Motion]) -> None:
    assert drawn(*made().told()) == set()


def test_what_has_no_equilibrium_has_no_answer() -> None:
    scene = atwood()
    study, words = SimulatedScene(scene, simulate_scene(scene)), words_of(describe(scene))
    assert drawn(study, words) == set()
    query = EquilibriumQuery("equilibrium", Target("displacement", "one.system.blocks.0"))
    assert KIND.answer(query, study) is None
    assert KIND.doubt(query, study, None)


def scenes(of: str) -> Iterator[Scene]:
    """Yield random scenes of a recipe, or of a body on a table with two or more springs."""
    for difficulty, index in [(level, index) for level in ("easy", "medium") for index in range(5)]:
        if of == TABLE:
            yield alone(drawn_entity(SpringBlock, index, {"springs": Count(2, 3), "launch?": 0.0}))
            continue
        with suppress(SceneError):
            yield RECIPES[of](difficulty, generator(of, difficulty, "numeric", 12, index, 0))


@pytest.mark.parametrize("of", ["chain", "mixed", TABLE])
def test_every_sentence_leads_back_and_forces_balance(of: str) -> None:
    """The text leads back to the query, and the springs on a crate on a table have no net force."""
    seen = 0
    for scene in scenes(of):
        study, words = SimulatedScene(scene, simulate_scene(scene)), words_of(describe(scene))
        offered = targets(words)
        for query in drawn(study, words):
            assert query.target is not None
            shapes = KIND.shapes(query, words, offered[query.target])
            assert len(set(shapes)) >= 3
            assert {parse_question(sentence(shape), study, words) for shape in shapes} == {query}
            seen += 1
        rest = equilibrium(scene.mechanism)
        if of == TABLE and rest is not None:
            _check_table(scene.mechanism, rest.coordinates)
    assert seen


def _check_table(mechanism: Mechanism, gone: np.ndarray) -> None:
    """Check that Σ k (r − l) r̂ = 0, from the sites and springs alone."""
    body = next(body for body in mechanism.bodies if body.mass)
    place = np.array(body.at) + sum(
        move * np.array(c.axis) for move, c in zip(gone, mechanism.coordinates, strict=True)
    )
    total, largest = np.zeros(3), 0.0
    for line in mechanism.lines:
        nail = next(site for site in map(mechanism.site.__getitem__, line.through) if site.body is None)
        apart = np.array(nail.at) - place
        pull = line.law.stiffness * (np.linalg.norm(apart) - line.law.length)  # type: ignore[union-attr]
        total, largest = total + pull * apart / np.linalg.norm(apart), max(largest, abs(pull))
    assert np.abs(total).max() <= 1e-7 * max(largest, 1.0)

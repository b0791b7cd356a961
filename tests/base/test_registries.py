"""Contract tests of the registries, which every member has to pass."""

from collections import Counter
from collections.abc import Mapping
from functools import cache
from inspect import getdoc, signature
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sim2reason
from motions import told_motions
from plain_scenes import arm, atwood, ramp, row, squeezed, swing, table
from sim2reason.base.registry import Registry, similar_names
from sim2reason.datasets.exports import EXPORTS
from sim2reason.errors import UnknownNameError
from sim2reason.evaluation.benchmarks import BENCHMARKS
from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.evaluation.policies import POLICIES
from sim2reason.figures.curves import panels
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.generation.item_search import sample
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import KINDS, MODES, MOMENTS, Query, SimulatedScene, Words
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.moments.times import AllAlong, AtTime
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import targets
from sim2reason.questions.regimes import REGIMES
from sim2reason.questions.sentences import parse_question
from sim2reason.scenes.dsl.body import BODIES, Body
from sim2reason.scenes.dsl.connection import CONNECTIONS, Connection
from sim2reason.scenes.dsl.entity import ENTITIES
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.model import Model, field_types
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.scenes.files import dump, load
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.scenes import simulate
from sim2reason.simulation.trace import ENGINES, channels
from sim2reason.testing import CHECKS
from sim2reason.text.prose.description import describe
from sim2reason.training.corpora import CORPORA
from sim2reason.training.models import MODELS

REGISTRIES: Mapping[str, Registry[Any]] = {
    registry.kind: registry
    for registry in (
        *(ENTITIES, CONNECTIONS, RECIPES, QUANTITIES, ENGINES, FILTERS, CHECKS),
        *(KINDS, MODES, MOMENTS, FUNCTIONALS, REGIMES, EXPORTS),
        *(POLICIES, BENCHMARKS, SCORINGS),
        *(CORPORA, MODELS),
    )
}
MEMBERS = [(kind, name) for kind, registry in REGISTRIES.items() for name in registry]
SOURCE = Path(sim2reason.__file__).parent


def all_bodies() -> list[type[Body]]:
    """Return every registered body class."""
    return list(BODIES.values())


def scenes() -> list[Scene]:
    return [ramp(friction=0.3), atwood(), table()]


@pytest.mark.parametrize(("kind", "name"), MEMBERS)
def test_every_member_is_documented_and_found_by_its_name(kind: str, name: str) -> None:
    member = REGISTRIES[kind][name]
    described = getattr(member, "evaluate", member)
    if not callable(described) or isinstance(described, type):
        described = described if isinstance(described, type) else type(described)
    elif not hasattr(described, "__name__"):
        described = type(described)
    text = getdoc(described)
    assert text
    assert text.split("\n", maxsplit=1)[0].endswith((".", ":", "?", "*")), text


def test_only_what_is_about_as_near_as_the_nearest_is_near() -> None:
    assert similar_names("spring", RECIPES) == ["springs"], "rolling shares four letters with it"
    assert similar_names("MassWithPulley", ENTITIES) == ["MassWithFixedPulley", "MassWithMovablePulley"]
    assert similar_names("qzqzqz", RECIPES) == similar_names("x" * 1_000_000, RECIPES) == []


@pytest.mark.parametrize("kind", list(REGISTRIES))
def test_every_registry_is_sorted_and_refuses_what_it_does_not_hold(kind: str) -> None:
    registry = REGISTRIES[kind]
    assert list(registry) == sorted(registry)
    assert len(registry) > 0
    nearest = next(iter(registry))
    with pytest.raises(UnknownNameError, match="did you mean"):
        _ = registry[nearest + "x"]
    for name in ("qzqzqz", "x" * 1_000_000):
        with pytest.raises(UnknownNameError, match=r"there are: |see: sim2reason list \w+") as refused:
            _ = registry[name]
        assert len(str(refused.value)) < 1000
    with pytest.raises(ValueError, match="registered twice"):
        registry.add(nearest, lambda: None)


@pytest.mark.parametrize("body", all_bodies(), ids=lambda body: body.__name__)
def test_bodies_are_introduced_in_two_ways_with_all_their_numbers(body: type[Body]) -> None:
    assert getdoc(body)
    assert body.nouns
    assert len(body.lone) >= 2
    assert not body.letters or len(body.named) >= 2
    said = {name for name, held in field_types(body).items() if held.measure is not None and not held.hidden}
    assert all(held.drawn is not None for name, held in field_types(body).items() if name in said)


@pytest.mark.parametrize("name", list(CONNECTIONS))
def test_connections_are_named_by_their_key_and_say_what_they_join(name: str) -> None:
    cls = CONNECTIONS[name]
    assert issubclass(cls, Connection)
    assert cls.key == name
    assert getdoc(cls.joins)


@pytest.mark.parametrize("difficulty", DIFFICULTIES)
@pytest.mark.parametrize("name", list(RECIPES))
def test_recipes_draw_scenes_that_travel_through_a_file(name: str, difficulty: str) -> None:
    scene = sample(name, difficulty, seed=1)
    assert load(dump(scene)) == scene
    assert describe(scene, 3).text == describe(load(dump(scene)), 3).text


@pytest.mark.parametrize("name", list(QUANTITIES))
def test_quantities_are_read_off_any_motion(name: str) -> None:
    quantity, seen = QUANTITIES[name], 0
    assert quantity.name == name
    assert quantity.symbol
    for study, _ in varied():
        state = study.trace.state
        for subject in quantity.subjects(study.mechanism):
            values = quantity.evaluate(state, subject)
            assert values.shape == ((len(state.times), 3) if quantity.vector else (len(state.times),))
            assert np.isfinite(values[state.times <= study.trace.stable_until]).all() or name in (
                "deflection",
                "radius of curvature",
            )
            seen += 1
    assert seen


def told(scene: Scene) -> tuple[SimulatedScene, Words]:
    """Return a scene with its motion and the words of its text."""
    return SimulatedScene(scene, simulate(scene)), words_of(describe(scene))


SCENES = Path(__file__).parents[1] / "data" / "ordinary_scenes"


@cache
def varied() -> list[tuple[SimulatedScene, Words]]:
    """Return motions about which everything that is registered can be asked."""
    carts = row((2.0, 1.0), (50.0, 30.0), "left", tilt=20.0)
    own = [
        load(SCENES / f"{name}.yaml")
        for name in (
            "trolley_bob",
            "cyclotron",
            "heavy_launch",
            "tow",
            "smooth_box",
            "tumbling_prism",
            "spiralling_bead",
            "crossed_fields",
        )
    ]
    made = ramp(friction=0.3, speed=2.0), squeezed(), swing(), arm(), carts, *scenes(), *own
    return [*map(told, made), *told_motions()]


def shapes(query: Query, words: Words) -> tuple[str, ...]:
    """Return all sentences that ask a query, as they appear in a text."""
    noun = targets(words)[query.target] if query.target is not None else None
    return tuple(sentence(shape) for shape in KINDS[query.kind].shapes(query, words, noun))


@pytest.mark.parametrize("name", list(QUANTITIES))
def test_quantities_with_words_are_offered_and_every_phrase_is_parsed_back(name: str) -> None:
    quantity, offered = QUANTITIES[name], set[bool]()
    for study, words in varied():
        for target in targets(words):
            if target.quantity == name:
                offered.add(target.signed)
                query = Query("start", target, AllAlong()) if quantity.timeless else Query("state", target, AtTime(0.5))
                assert {parse_question(text, study, words) for text in shapes(query, words)} == {query}
    assert offered == {
        signed for signed, template in ((False, quantity.magnitude), (True, quantity.signed)) if template
    }


@pytest.mark.parametrize("name", list(QUANTITIES))
def test_quantities_that_have_a_panel_are_plotted(name: str) -> None:
    titles = {panel.title for study, words in varied() for panel in panels(study.trace.state, words.mentions)}
    assert any(title.startswith(QUANTITIES[name].panel or "nothing") for title in titles) == bool(
        QUANTITIES[name].panel
    )


@pytest.mark.parametrize("name", list(ENGINES))
def test_engines_describe_the_same_motion_at_the_same_times(name: str) -> None:
    for scene in scenes():
        times = np.linspace(0.0, scene.horizon, 101)
        trace, recorded = ENGINES[name](scene.mechanism, times), ENGINES[RECORDED](scene.mechanism, times)
        assert trace.engine == name
        assert trace.mechanism == scene.mechanism
        assert np.array_equal(trace.state.times, recorded.state.times)
        assert trace.stable_until == pytest.approx(recorded.stable_until, abs=1e-6)
        within = trace.state.times <= trace.stable_until
        assert np.allclose(trace.state.q[within], recorded.state.q[within], atol=1e-6)


@pytest.mark.parametrize("name", list(KINDS))
def test_kinds_draw_and_say(name: str) -> None:
    kind = KINDS[name]
    assert list(signature(kind.draw).parameters) == ["study", "words", "targets", "rng"]
    assert list(signature(kind.shapes).parameters) == ["query", "words", "noun"]


@pytest.mark.parametrize("seeds", [1, pytest.param(4, marks=pytest.mark.slow)])
@pytest.mark.parametrize("name", list(KINDS))
def test_kinds_have_a_share_and_every_sentence_is_parsed_back(name: str, seeds: int) -> None:
    kind, asked = KINDS[name], 0
    assert kind.name == name
    assert kind.share > 0.0
    for study, words in varied():
        for seed in range(seeds):
            query = kind.draw(study, words, targets(words), np.random.default_rng(seed))
            if query is None:
                continue
            asked += 1
            assert query.kind == name
            assert {parse_question(text, study, words) for text in shapes(query, words)} == {query}
            assert kind.answer(query, study) is not None
            assert kind.time(query, study) is not None
            assert parse_unit(kind.measured(query).unit)
    assert asked


def names(mechanism: Mechanism) -> set[str]:
    """Return all subjects that quantities and moments can have."""
    return {channel.subject for channel, _ in channels(mechanism)}


@pytest.mark.parametrize("name", list(MOMENTS))
def test_moments_are_found_and_every_phrase_is_parsed_back(name: str) -> None:
    cls, found = MOMENTS[name], 0
    assert cls.kind in KINDS
    assert sum(other.label == cls.label for other in MOMENTS.values()) == 1, "what items record must tell them apart"
    for study, words in varied():
        for moment in cls.found(study, words, np.random.default_rng(1)):
            found += 1
            assert moment.time(study.trace) == study.time(moment) is not None
            assert set(moment.subjects) <= names(study.mechanism)
            phrases = moment.phrases(words)
            assert len(set(phrases)) >= 3
            assert all(moment in cls.parsed(f"What is it {phrase}?", study.trace, words) for phrase in phrases)
            assert all(
                told.subject in names(study.mechanism) and told.quantity in QUANTITIES
                for told in moment.revealed_channels
            )
            assert set(moment.channels) <= {channel for channel, _ in channels(study.mechanism)}
    assert found


@pytest.mark.parametrize("most", [2, pytest.param(1000, marks=pytest.mark.slow)])
@pytest.mark.parametrize("name", list(MODES))
def test_modes_ask_every_kind_of_some_scene(name: str, most: int) -> None:
    """Each mode asks `most` questions of each kind, or as many as all motions offer."""
    asked = Counter[str]()
    for seed, (study, words), kind in product(range(6), varied(), KINDS):
        if asked[kind] < most and (kind in MODES[name].kinds or seed == 0):
            question = MODES[name].ask(study, words, kind, np.random.default_rng(seed))
            if question is not None:
                asked[question.query.kind] += 1
                assert question.mode == name
                assert parse_unit(question.unit)
    assert asked.keys() >= MODES[name].kinds


@pytest.mark.parametrize("name", list(FILTERS))
def test_filters_give_a_reason_or_none(name: str) -> None:
    found = FILTERS[name]
    assert isinstance(found.needs_witness, bool)
    for scene in scenes():
        search = QuestionSearch(scene, 1)
        words = words_of(search.description)
        question = MODES["numeric"].ask(search.study, words, "state", np.random.default_rng(2))
        if question is not None:
            reason = found.reason(Candidate(search.study, question, search.description.text))
            assert isinstance(reason, str)
            assert "\n" not in reason


def test_models_are_frozen_and_refuse_what_they_do_not_know() -> None:
    for cls in (*ENTITIES.values(), *all_bodies()):
        assert issubclass(cls, Model)
        assert cls.model_config.get("frozen")
        assert cls.model_config.get("extra") == "forbid"

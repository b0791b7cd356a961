"""Tests that a quantity, a moment or a kind of question is one new file, from asking to plotting."""

import importlib.util
import re
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from plain_scenes import atwood, ramp, swing, three
from sim2reason.figures.curves import motion_curves
from sim2reason.generation.certified import CertifiedQuestion
from sim2reason.generation.make import build_item
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.request import Request
from sim2reason.questions import KINDS, MODES, MOMENTS, Query, SimulatedScene, Target
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.prompt import parse_prompt, words_of
from sim2reason.questions.query import targets
from sim2reason.questions.sentences import parse_question
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.certify import certify_trace
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import Channel

QUANTITY = '''
import numpy as np

from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies


@quantity
class PowerOfWeight(Quantity):
    """The rate at which its weight does work on a body."""

    name, unit, symbol = "power of weight", "W", "P"
    of = Bodies()
    magnitude = "the magnitude of the power of the weight of {body}"
    how = "how strongly does its weight drive or brake {body}{ground} {when}?"
    needs = ("mass",)
    floor, heavy = 0.1, True
    panel = "power"

    @staticmethod
    def evaluate(state, subject):
        """m g·v, (n,)."""
        gravity = np.array(state.mechanism.gravity)
        return state.mechanism.body[subject].mass * Velocity.evaluate(state, subject) @ gravity
'''
MOMENT = '''
from dataclasses import dataclass

import numpy as np

from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.crossings import Threshold
from sim2reason.questions.words import rounded_as_written


@MOMENTS.register("sped_up")
@dataclass(frozen=True, slots=True)
class SpedUp(Threshold):
    """The first time that a body has a stated speed."""

    label, of, hangs_on, unit = "speed", Bodies(), "velocity", "m/s"

    @classmethod
    def drawn(cls, name, trace, rng):
        """A part of the greatest."""
        return rounded_as_written(rng.uniform(0.2, 0.8) * _speed(trace.scan, name).max())

    def excess(self, state):
        """How much faster it is."""
        return _speed(state, self.name) - self.value

    def phrases(self, words):
        """As in: when the block first moves at 2.0 m/s."""
        first = f"{self.subject(words)} first moves at {self.said(words)}"
        return (f"when {first}", f"at the moment when {first}", f"as soon as {first}")

    def clause(self, words):
        """As in: the block first moves at 2.0 m/s."""
        speed = self.said(words)
        return Clause(self.subject(words), "does", f"first move at {speed}", f"first moves at {speed}")


def _speed(state, body):
    return np.linalg.norm(QUANTITIES["velocity"].evaluate(state, body), axis=1)
'''
KIND = '''
import numpy as np

from sim2reason.questions.choices import draw_target
from sim2reason.questions.kinds import Kind, kind
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.query import Query


@kind
class GreatestKind(Kind):
    """What is the greatest value of a quantity up to a stated time?"""

    name, share = "greatest", 0.5

    def draw(self, study, words, targets, rng):
        """Any magnitude."""
        target, found = draw_target([t for t in targets if not t.signed], rng), AtTime.found(study, words, rng)
        return Query(self.name, target, found[0]) if target and found else None

    def answer(self, query, study):
        """The largest of many samples."""
        time = self.time(query, study)
        if time is None:
            return None
        times = np.linspace(0.0, time, 33)
        return max(query.target.value(study.trace.sample(times[n : n + 1])) for n in range(len(times)))

    def shapes(self, query, words, noun):
        """As in: what is the greatest value of the speed of A until 0.80 s after release?"""
        return tuple(
            shape
            for when in query.moment.phrases(words)
            for shape in (f"what is the greatest value of {noun.phrase} until the instant that is {when}?",
                          f"find the greatest value of {noun.phrase} until the instant that is {when}.")
        )

    def parsed(self, text, study, words, targets):
        """Every quantity that is named, with every time."""
        moments = list(AtTime.parsed(text, study.trace, words))
        return (Query(self.name, target, moment) for moment in moments for target in targets)
'''
SUBJECT = '''
from dataclasses import dataclass

import numpy as np

from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.kinematics import Displacement
from sim2reason.simulation.quantities.subjects import Sense, Subject
from sim2reason.simulation.quantities.subjects.interactions import pair


@dataclass(frozen=True)
class Couples(Subject):
    """Every two bodies that may meet."""

    name, slot = "couple", "pair"

    def names(self, mechanism):
        """By the names of both."""
        return tuple(f"{met.a} {met.b}" for met in mechanism.meetings)

    def phrases(self, mechanism, mentions):
        """As in: pucks A and B."""
        return {name: pair(*(mentions[body] for body in name.split())) for name in self.names(mechanism)}

    def gives(self, need, mechanism, name, said):
        """Of both."""
        return all(f"{body}.{need}" in said for body in name.split())

    def senses(self, mechanism, name):
        """They can part."""
        return [Sense("a growing distance", (0.0, 0.0, 0.0))]


@quantity
class Gap(Quantity):
    """How much farther apart the centres of two bodies are than at the start."""

    name, unit, symbol = "gap", "m", "d"
    of = Couples()
    magnitude = "the change in the distance between the centres of {pair} since the start"
    signed = "the gain in the distance between the centres of {pair} since the start"
    floor = 0.1
    panel = "gap"

    @staticmethod
    def evaluate(state, subject):
        """|r_a − r_b| less that at the start, (n,)."""
        a, b = subject.split()
        start = np.subtract(state.mechanism.body[a].at, state.mechanism.body[b].at)
        now = start + Displacement.evaluate(state, a) - Displacement.evaluate(state, b)
        return np.linalg.norm(now, axis=1) - np.linalg.norm(start)
'''
PUCKS = "table.pucks.0 table.pucks.1"
FUNCTIONAL = '''
from sim2reason.simulation.quantities.momentum import Momentum
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.aggregates import Extreme


@functional
class GreatestMomentum(Extreme):
    """The greatest momentum of a body."""

    name = "greatest momentum"
    quantity = Momentum
    phrase = "the greatest momentum of {body}{ground}"
    weight = 50.0
'''
ADDED = {
    "quantity": (QUANTITY, QUANTITIES),
    "moment": (MOMENT, MOMENTS),
    "kind": (KIND, KINDS),
    "subject": (SUBJECT, QUANTITIES),
    "sense": (re.sub(" *magnitude = .*\n", "", SUBJECT), QUANTITIES),
    "functional": (FUNCTIONAL, FUNCTIONALS),
}
Wanted = Callable[[Query], bool]
BLOCKS = (ramp(friction=0.2), atwood())
WANTED: list[tuple[str, str, str, Wanted, tuple[Scene, ...]]] = [
    ("a quantity", "quantity", "", lambda q: q.target is not None and q.target.quantity == "power of weight", BLOCKS),
    ("at a moment", "moment", "event", lambda q: type(q.moment).__name__ == "SpedUp", BLOCKS),
    ("until a moment", "moment", "time_to_event", lambda q: type(q.moment).__name__ == "SpedUp", BLOCKS),
    ("a kind", "kind", "", lambda q: q.kind == "greatest", BLOCKS),
    ("a subject", "subject", "", lambda q: q.target == Target("gap", PUCKS), (three(),)),
    (
        "a sense",
        "sense",
        "",
        lambda q: q.target not in (None, Target("gap", PUCKS)) and q.subject == PUCKS,
        (three(),),
    ),
]
CASES = [
    pytest.param(thing, kind, wanted, scene, id=f"{name}, {scene.entities[0].name}")
    for name, thing, kind, wanted, scenes in WANTED
    for scene in scenes
]


@pytest.fixture
def added(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[None]:
    """Import a module with one new member, as if it was in its package, and unregister the member afterwards."""
    source, registry = ADDED[request.param]
    before = set(registry)
    path = tmp_path / f"new_{request.param}.py"
    path.write_text(source, encoding="utf-8")
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    spec.loader.exec_module(importlib.util.module_from_spec(spec))
    yield
    for name in set(registry) - before:
        del registry._members[name]


@pytest.mark.parametrize(("added", "kind", "wanted", "scene"), CASES, indirect=["added"])
@pytest.mark.usefixtures("added")
def test_one_file_is_enough(kind: str, wanted: Wanted, scene: Scene) -> None:
    search = QuestionSearch(scene, 3)
    certified = _asked(search, kind, wanted)
    query, words = certified.question.query, words_of(search.description)
    # told, and parsed back to the same query and the same answer
    offered = targets(words)
    shapes = KINDS[query.kind].shapes(query, words, offered[query.target] if query.target is not None else None)
    assert certified.question.text in {sentence(shape) for shape in shapes}
    assert {parse_question(sentence(shape), search.study, words) for shape in shapes} == {query}
    read = parse_prompt(certified.prompt)
    assert read.query.kind == query.kind
    assert read.answer == pytest.approx(certified.question.answer, rel=1e-6)
    # certified by channel
    channels = {*KINDS[query.kind].channels(query), *query.moment.channels}
    assert channels
    assert all(certified.certificate.until[channel] > 0.0 for channel in channels)
    # recorded
    record = build_item(Request("pulley", "easy", "numeric", 0, 0), certified)
    measured = KINDS[query.kind].measured(query)
    assert (record.asked.quantity, record.answer.unit, record.kind) == (measured.name, measured.unit, query.kind)
    assert record.asked.event == query.moment.label
    assert record.asked.time == pytest.approx(search.study.time(query.moment))


def _asked(search: QuestionSearch, kind: str, wanted: Wanted) -> CertifiedQuestion:
    """Return the first wanted question that passes every filter."""
    for seed in range(400):
        certified = search.ask(MODES["numeric"], np.random.default_rng(seed), Counter(), kind)
        if certified is not None and wanted(certified.question.query):
            return certified
    pytest.fail("it is never asked")


@pytest.mark.parametrize("added", ["functional"], indirect=True)
@pytest.mark.usefixtures("added")
def test_a_functional_is_one_file() -> None:
    certified = _asked(QuestionSearch(swing(), 3), "extremum", lambda query: query.name == "swing.bob")
    record = build_item(Request("pendulum", "easy", "numeric", 0, 0), certified)
    assert (record.asked.quantity, record.answer.unit) == ("greatest momentum", "kg m/s")
    assert record.answer.value == pytest.approx(0.5 * np.sqrt(2.0 * 9.8 * 0.8 * 0.5))
    assert parse_prompt(certified.prompt).answer == pytest.approx(record.answer.value)


@pytest.mark.parametrize("added", ["quantity"], indirect=True)
@pytest.mark.usefixtures("added")
def test_a_new_quantity_is_a_channel_and_has_a_panel() -> None:
    search = QuestionSearch(atwood(), 3)
    shown = motion_curves(search.study.trace, search.description)
    panel = next(panel for panel in shown.panels if panel.title == "power (W)")
    assert [curve.name for curve in panel.curves] == ["A", "B"]
    assert all(np.abs(curve.values).max() > 1.0 for curve in panel.curves)
    assert Channel("one.system.blocks.0", "power of weight") in certify_trace(search.study.trace)[1].until


@pytest.mark.parametrize("share", [None, 0.0, -1.0, float("nan")])
def test_a_kind_without_a_share_is_refused_since_it_would_never_be_asked(share: float | None) -> None:
    class Never:
        """Kind of question that is never asked."""

        name = "never"

    if share is not None:
        Never.share = share
    try:
        with pytest.raises(ValueError, match="share"):
            KINDS.add("never", Never())
    finally:
        KINDS._members.pop("never", None)


def test_a_study_works_nothing_out_twice() -> None:
    study = SimulatedScene.of(ramp(), np.linspace(0.0, 2.0, 41))
    steeper = ramp(angle=40.0)
    assert study.variant(steeper) is study.variant(ramp(angle=40.0))
    assert study.variant(steeper).scene == steeper
    assert study.variant(steeper).trace.state.times[-1] == 2.0

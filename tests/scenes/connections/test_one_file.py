"""Tests that a new kind of connection needs one file: described, parsed, built, certified and drawn."""

import importlib.util
from collections.abc import Iterator
from math import pi, sqrt
from pathlib import Path

import numpy as np
import pytest

from joined_entities import Followed, close, scene, string
from sim2reason.base.registry import Registry, further_members
from sim2reason.figures.drawing import drawing
from sim2reason.figures.shapes import LineShape
from sim2reason.scenes.bodies.blocks import Carriage
from sim2reason.scenes.dsl.connection import CONNECTIONS, Link
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import SliderMass
from sim2reason.scenes.entities.string_ends import ConstantForcePuller
from sim2reason.simulation.scenes import certify
from sim2reason.text.prose.description import describe
from told import check_told, check_whole

CORD = '''
"""A light elastic cord between two points: it pulls where it is stretched, and never pushes."""

from math import dist
from typing import ClassVar

from sim2reason.scenes.connections.two_ended import Straight
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import Joint, Look, connection
from sim2reason.scenes.dsl.measures import Stiffness, Strain
from sim2reason.scenes.dsl.mechanism import Elastic
from sim2reason.scenes.dsl.template import Wordings, either


@connection
class ElasticCord(Straight):
    """A cord that is stretched at the start."""

    key: ClassVar[str] = "elastic_cord"
    look: ClassVar[Look] = "string"
    stiffness: Stiffness
    by: Strain

    says: ClassVar[Wordings] = either(
        "an elastic cord of stiffness {stiffness}, at first stretched by {by}, joins {a} to {b}.",
        "{a} is joined to {b} by an elastic cord of stiffness {stiffness} at first stretched by {by}.",
        "between {a} and {b} runs an elastic cord of stiffness {stiffness}, at first stretched by {by}.",
    )
    leads: ClassVar[Wordings] = either(
        "from {a} an elastic cord of stiffness {stiffness}, at first stretched by {by}, {way} to {b}.",
        "an elastic cord of stiffness {stiffness} is tied to {a}; at first stretched by {by}, it {way} to {b}.",
        "to {a} is tied an elastic cord of stiffness {stiffness}, which {way} to {b}, stretched by {by} at first.",
    )

    def build(self, joint: Joint, builder: Builder) -> None:
        """From site to site; its natural length follows from how far they are apart."""
        ends = self.ends(joint, builder)
        length = dist(*map(builder.position, ends)) - self.by
        builder.add_line(joint.name, ends, Elastic(self.stiffness, length, acts="pulls"))
'''
K, BY, FORCE, ONE, OTHER = 60.0, 0.03, 4.0, 0.8, 2.0
MU = ONE * OTHER / (ONE + OTHER)
PERIOD = 2.0 * pi * sqrt(MU / K)


@pytest.fixture
def towed(tmp_path: Path) -> Iterator[Scene]:
    """Yield two carriages joined by a cord of the new kind, the second pulled to the right by a hand."""
    path = tmp_path / "elastic_cord.py"
    path.write_text(CORD, encoding="utf-8")
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    spec.loader.exec_module(importlib.util.module_from_spec(spec))
    ends = (Link(entity="one", port="right"), Link(entity="other", port="left"))
    cord = CONNECTIONS["elastic_cord"].model_validate({"links": ends, "stiffness": K, "by": BY})
    carriages = {name: SliderMass(carriage=Carriage(mass=mass)) for name, mass in (("one", ONE), ("other", OTHER))}
    yield scene({**carriages, "hand": ConstantForcePuller(force=FORCE)}, cord, string("other.right", "hand.end"))
    del CONNECTIONS._members["elastic_cord"]


def test_it_pulls_as_its_law_says(towed: Scene) -> None:
    """The stretch is s = s₁ + (s₀ − s₁) cos ωt, s₁ = µF/(m₂k), ω² = k/µ, from µ s″ = µF/m₂ − k s."""
    found, mean = Followed(towed, 2.0 * PERIOD, 41), MU * FORCE / (OTHER * K)
    wanted = mean + (BY - mean) * np.cos(2.0 * pi * found.times / PERIOD)
    assert wanted.min() > 0.0
    close(found.q("other.carriage.slide") - found.q("one.carriage.slide"), wanted - BY)
    close(found.tension("elastic_cord_1"), K * wanted)


def test_it_is_told_read_back_certified_and_drawn(towed: Scene) -> None:
    for seed in range(6):
        assert "elastic cord" in describe(towed, seed).text
        check_told(towed, seed)
    check_whole(towed, 0)
    assert not certify(towed, 1.5)[1].reason  # before the carriage gets to the hand
    without = Scene(entities=towed.entities, connections=towed.connections[1:], world=towed.world)
    assert strings(towed) == strings(without) + 1


def strings(made: Scene) -> int:
    """Return the number of lines drawn in the style of strings."""
    return sum(isinstance(shape, LineShape) and shape.weight == "string" for shape in drawing(made).shapes)


def test_a_member_that_is_taken_away_again_is_no_further_one() -> None:
    """Worker processes need not import the module of a removed member."""
    things: Registry[object] = Registry("things")
    things.add("work", test_a_member_that_is_taken_away_again_is_no_further_one)
    assert "work" in further_members()[__name__]
    del things._members["work"]
    assert __name__ not in further_members()

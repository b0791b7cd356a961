"""Tests of scenes in words: three voices, names, symbols, and wordings chosen by a seed."""

import re
from typing import get_args

import pytest

from sim2reason.errors import SceneError
from sim2reason.generation.item_search import sample
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import FixedPulley, Plane
from sim2reason.scenes.connections.string import String
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import Topic
from sim2reason.scenes.entities.pulleys import MassWithFixedPulley
from sim2reason.scenes.entities.slopes import TwoSideMassPlane
from sim2reason.scenes.entities.string_ends import Hanging
from sim2reason.text.prose import describe
from sim2reason.text.prose.closings import closings
from sim2reason.text.prose.phrases import introduce_another, join, letter_at
from sim2reason.text.prose.voices import symbolic, symbolic_at, voice_of

SLIDE = Scene(
    entities=(
        Named(
            name="ramp",
            entity=TwoSideMassPlane(plane=Plane(angle=30.0, friction=0.25), blocks=(Block(mass=2.0),), speed=1.5),
        ),
    )
)


def atwood(mass: float = 0.0) -> Scene:
    sides = {name: Hanging(blocks=(Block(mass=m),)) for name, m in (("left", 2.0), ("right", 3.5))}
    machines = {name: MassWithFixedPulley(system=side, pulley=FixedPulley(mass=mass)) for name, side in sides.items()}
    tail = MassWithFixedPulley.tail
    return Scene(
        entities=tuple(Named(name=name, entity=machine) for name, machine in machines.items()),
        connections=(String.between(("left", tail), ("right", tail)),),
    )


def test_every_number_is_said_once() -> None:
    for seed in range(12):
        text = describe(SLIDE, seed).text
        assert [text.count(said) for said in ("2.0 kg", "30°", "0.25", "1.5 m/s", "9.8 m/s²")] == [1] * 5, text


def test_the_voices_say_the_same_sentences() -> None:
    for seed in range(12):
        spoken = describe(SLIDE, seed).sentences
        marked = describe(SLIDE, seed, symbolic).sentences
        for numeric, symbols in zip(spoken[:-1], marked[:-1], strict=True):  # g is named, not said to equal itself
            pattern = re.sub(r"\\\$.*?\\\$", ".+", re.escape(symbols))
            assert re.fullmatch(pattern, numeric), (numeric, symbols)


def test_one_value_can_be_hidden() -> None:
    text = describe(SLIDE, 0, symbolic_at("ramp.blocks.0.mass")).text
    assert "$m$" in text
    assert "2.0 kg" not in text
    assert "0.25" in text
    assert voice_of((), "symbolic") is symbolic


def test_symbols_follow_from_names() -> None:
    description = describe(atwood(0.5))
    assert description.symbols["left.system.blocks.0.mass"] == "m_A"
    assert description.symbols["right.pulley.mass"] == "M_Q"
    assert describe(SLIDE).symbols["ramp.blocks.0.mass"] == "m"
    assert describe(SLIDE).symbols["ramp.plane.angle"] == r"\theta"


def test_letters_follow_the_order_of_first_mention() -> None:
    for seed in range(12):
        text = describe(atwood(), seed).text
        found = re.findall(r"(?:block|crate|pulley) ([A-Z])\b", text, re.IGNORECASE)
        met = list(dict.fromkeys(found))
        assert [letter for letter in met if letter in "AB"] == ["A", "B"], text
        assert [letter for letter in met if letter in "PQ"] == ["P", "Q"], text


def test_wordings_depend_on_the_seed_alone() -> None:
    texts = [describe(atwood(), seed).text for seed in range(30)]
    assert texts == [describe(atwood(), seed).text for seed in range(30)]
    assert len(set(texts)) > 20


def test_a_special_value_is_told_by_a_word_alone() -> None:
    smooth = SLIDE.having("ramp.plane.friction", 0.0)
    for seed in range(8):
        text = describe(smooth, seed).text
        assert "smooth" in text
        assert "friction" not in text
        assert "rough" in describe(SLIDE, seed).text


def test_what_is_absent_stays_unsaid() -> None:
    still = SLIDE.having("ramp.speed", None)
    assert "m/s " not in describe(still).text
    assert "rest" in describe(still).text


@pytest.mark.parametrize(
    ("scene", "names"),
    [
        (SLIDE, ["g"]),
        (SLIDE.having("ramp.speed", None), ["rest of one body", "g"]),
        (atwood(), ["rest with the string taut", "pulleys and room", "g"]),
        (atwood(0.5), ["rest with the string taut", "massive pulleys and room", "g"]),
    ],
)
def test_closings_are_said_only_where_they_matter(scene: Scene, names: list[str]) -> None:
    assert [closing.name for closing in closings(scene)] == names


def test_only_what_the_text_mentions_has_a_mention() -> None:
    description = describe(atwood())
    assert description.mention("left.system.blocks.0") in ("block A", "crate A")
    with pytest.raises(SceneError, match="mentions no such body"):
        description.mention("left.system")


@pytest.mark.parametrize("recipe", ["collision", "incline", "pulley", "springs", "mixed"])
def test_a_text_knows_the_topics_that_it_speaks_of(recipe: str) -> None:
    for index in range(6):
        told = describe(sample(recipe, "hard", seed=3, index=index), index)
        matter = {t for t in get_args(Topic) if told.leaving_out({t}).sentences != told.sentences}
        assert told.topics == matter
        assert told.leaving_out(matter).topics == set()


def test_small_words() -> None:
    assert join(["A"]) == "A"
    assert join(["A", "B", "C"]) == "A, B and C"
    assert introduce_another("a smooth plane") == "another smooth plane"
    assert [letter_at("PQ", index) for index in range(4)] == ["P", "Q", "P2", "Q2"]

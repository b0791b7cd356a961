"""Tests of the nouns that a pronoun may replace in the words for a moment."""

import pytest

from sim2reason.questions import Words
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.kinds.stretches import nouns
from sim2reason.questions.moments.strings import MostCompressed
from sim2reason.questions.moments.times import BurnedOut
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.questions.phrasing import use_pronoun
from sim2reason.questions.prompt import words_of
from sim2reason.questions.query import Target, targets
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import NailedSpring
from sim2reason.scenes.bodies.space import AirlessPlanet, DeepSpace, LevelGround, Rocket
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.space import RocketEntity
from sim2reason.scenes.entities.spring_blocks import SpringBlock
from sim2reason.text.prose.description import describe

BEFORE = "from t = 0 until {} first "


def damped() -> Words:
    """Return the words of a block on two springs, each with a dashpot."""
    springs = (
        NailedSpring(stiffness=60.0, length=0.5, x=-0.6, y=0.0),
        NailedSpring(stiffness=80.0, length=0.4, x=0.5, y=0.3),
    )
    entity = SpringBlock(block=Block(mass=2.0), springs=springs, damping=3.0, x=0.1, y=0.0)
    return words_of(describe(Scene(entities=(Named(name="it", entity=entity),))))


@pytest.mark.parametrize(
    ("functional", "pronoun"), [("energy dissipated by a dashpot", False), ("greatest extension", True)]
)
def test_no_pronoun_could_be_the_dashpot_beside_a_spring(functional: str, pronoun: bool) -> None:
    """In *the energy that the dashpot beside spring 2 dissipates until it …*, *it* would be the dashpot."""
    words, moment = damped(), MostCompressed("it.springs.1")
    noun, spring = nouns(FUNCTIONALS[functional], words)["it.springs.1"], moment.subject(words)
    for when in moment.stretches(words):
        said = use_pronoun(moment, noun.phrase, when, words)
        assert ("it first" in said) is pronoun
        assert (spring in said) is not pronoun


def test_a_pronoun_stands_for_what_a_phrase_is_about_alone() -> None:
    words = damped()
    block, moment = words.mentions["it.block"], Stopped("it.block")
    when = f"when {block} first comes to rest"
    short = "when it first comes to rest"
    for phrase in (f"the speed of {block}", f"the energy that {block} loses", f"the distance by which {block} moves"):
        assert use_pronoun(moment, phrase, when, words) == short
    for phrase in (
        f"the work that the tension in the string does on {block}",
        f"the energy that friction between {block} and the plane dissipates",
        f"the normal force exerted on {block} by the plane",
        "the tension in the string",
    ):
        assert use_pronoun(moment, phrase, when, words) == when
    speeds = [noun.phrase for target, noun in targets(words).items() if target.quantity == "velocity"]
    assert any(block in phrase for phrase in speeds)


@pytest.mark.parametrize(
    ("place", "noun"),
    [
        (LevelGround(), "the height of the rocket above the ground"),
        (AirlessPlanet(radius=2000.0, gravity=2.0), "the height of the rocket above the ground"),
        (DeepSpace(), "the distance between the rocket and its starting point"),
    ],
)
def test_a_rocket_that_starts_from_the_ground_has_a_height(
    place: AirlessPlanet | LevelGround | DeepSpace, noun: str
) -> None:
    """The pronoun *it* means the rocket, not the ground."""
    entity = RocketEntity(rocket=Rocket(mass=1000.0, dry=200.0), place=place, exhaust=2.0, rate=8.0)
    words, moment = words_of(describe(Scene(entities=(Named(name="pad", entity=entity),)))), BurnedOut("pad.rocket")
    said = targets(words)[Target("displacement", "pad.rocket")].phrase
    assert said.replace("probe", "rocket") == noun
    assert [use_pronoun(moment, said, when, words) for when in moment.phrases(words)] == [
        "when it has burnt all its fuel",
        "when it runs out of fuel",
        "at the moment when it has used up its fuel",
    ]

"""Tests that a formula's assumptions are one sentence in textbook style, which is read back."""

from collections.abc import Sequence

import numpy as np
import pytest

from plain_scenes import half_atwood
from sim2reason.generation.modes.symbolic import assuming, parse_assumptions, split_assumptions
from sim2reason.questions import SimulatedScene, Words
from sim2reason.questions.prompt import words_of
from sim2reason.questions.regimes import Regime, possible, regimes
from sim2reason.questions.regimes.directions import MovesOneWay
from sim2reason.questions.regimes.events import BurntOut, DelayedLiftoff
from sim2reason.scenes.bodies.space import LevelGround, Rocket
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.space import RocketEntity
from sim2reason.text.prose.description import describe

LIFTS = "lifts off as soon as its engine starts"


def told(scene: Scene) -> tuple[SimulatedScene, Words]:
    return SimulatedScene.of(scene, np.linspace(0.0, 80.0, 11)), words_of(describe(scene))


def rocket() -> Scene:
    """Build a rocket of 1000 kg, of which 700 kg is fuel for 70 s, that lifts off at once."""
    entity = RocketEntity(rocket=Rocket(mass=1000.0, dry=300.0), place=LevelGround(), exhaust=1.0, rate=10.0)
    return Scene(entities=(Named(name="rocket", entity=entity),))


def of_rocket() -> tuple[SimulatedScene, Words, dict[type[Regime], Regime]]:
    study, words = told(rocket())
    found = {type(held): held for held in regimes(study, words, 75.0)}
    falls = next(held for held in possible(study, words) if isinstance(held, BurntOut) and held.out)
    return study, words, {**found, BurntOut: BurntOut(falls.name, out=True, falls=True)}


@pytest.mark.parametrize(
    ("chosen", "expected"),
    [
        ([BurntOut], "Assume that {it} has burned all its fuel by that moment but has not yet fallen back."),
        (
            [BurntOut, MovesOneWay],
            "Assume that {it} keeps moving up and that it has burned all its fuel by that moment.",
        ),
        (
            [BurntOut, MovesOneWay, DelayedLiftoff],
            f"Assume that {{it}} {LIFTS}, that it keeps moving up, and that it has burned all its fuel by that moment.",
        ),
    ],
)
def test_three_clauses_stand_in_the_order_of_time(chosen: Sequence[type[Regime]], expected: str) -> None:
    _, words, found = of_rocket()
    said = assuming([found[kind] for kind in chosen], words)
    name = next(iter(words.subject_phrases(found[MovesOneWay].of).values()))
    assert said == expected.format(it=name)


@pytest.mark.parametrize("count", [1, 2, 3])
def test_what_is_assumed_is_read_back(count: int) -> None:
    """Two blocks on a string move in different directions, so the sentence does not call both *it*."""
    study, words = told(half_atwood())
    held = regimes(study, words, 0.5)[:count]
    sentence = assuming(held, words)
    found = parse_assumptions(sentence, study, words)
    assert found is not None
    assert set(found) == set(held)
    assert split_assumptions(f"Find it. {sentence}") == (sentence, "Find it.")


def test_what_nothing_in_the_scene_may_do_is_not_read() -> None:
    study, words = told(half_atwood())
    assert parse_assumptions("Assume that block A flies.", study, words) is None

"""Tests that questions with implausible numbers, answers or springs are dropped with a reason in words."""

from dataclasses import replace

import numpy as np
import pytest

from plain_scenes import atwood, ramp
from sim2reason.generation.filters import FILTERS, Candidate, SceneFilter, apply_filters
from sim2reason.questions import KINDS, Moment, Query, Question, SimulatedScene, StatedResult, Target
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import Spring
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.spring_blocks import AnchoredSpring

BLOCK = "one.system.blocks.0"


def candidate(scene: Scene, target: Target, moment: Moment) -> Candidate:
    study = SimulatedScene.of(scene, np.linspace(0.0, 2.0, 81))
    query = Query("state", target, moment)
    answer = KINDS["state"].answer(query, study)
    assert answer is not None
    return Candidate(study, Question("numeric", query, "?", answer, KINDS["state"].measured(query).unit), "a b c")


def sprung(start: float) -> Scene:
    """Build a block of 2.0 kg that oscillates about the natural length, 0.50 m, of a spring of 100 N/m."""
    spring = Spring(stiffness=100.0, length=0.5)
    entity = AnchoredSpring(spring=spring, block=Block(mass=2.0), start=start)
    return Scene(entities=(Named(name="it", entity=entity),))


def test_a_scene_with_a_number_that_no_textbook_prints_goes() -> None:
    speed = Target("velocity", "ramp.blocks.0")
    assert not FILTERS["magnitudes"].reason(candidate(ramp(), speed, AtTime(0.5)))
    heavy = candidate(ramp(mass=5000.0), speed, AtTime(0.5))
    assert FILTERS["magnitudes"].reason(heavy) == "ramp.blocks.0.mass is 5000 kg"
    assert apply_filters(heavy, witnessed=False).filter == "magnitudes"
    assert isinstance(FILTERS["magnitudes"], SceneFilter), "then no question about it is asked"


def test_an_answer_that_nobody_would_print_goes() -> None:
    found = candidate(atwood(), Target("tension", "tendon_1"), AtTime(0.5))
    assert not FILTERS["outcome"].reason(found)
    small = replace(found, question=replace(found.question, answer=3e-4))
    assert FILTERS["outcome"].reason(small) == "the answer is 0.0003 N"
    fast = replace(found, question=replace(found.question, answer=1e9, unit="m/s"))
    assert FILTERS["outcome"].reason(fast) == "the answer is 1e+09 m/s"
    given = replace(found, question=replace(found.question, given=StatedResult("2000000", "N")))
    assert FILTERS["outcome"].reason(given) == "the given result is 2e+06 N"
    counted = replace(found, question=replace(found.question, answer=1e9, unit=""))
    assert not FILTERS["outcome"].reason(counted), "what stands in no table is not judged"


@pytest.mark.parametrize(("start", "refused"), [(0.65, False), (0.26, False), (0.74, False)])
def test_springs_that_stay_near_their_natural_length_are_kept(start: float, refused: bool) -> None:
    found = candidate(sprung(start), Target("velocity", "it.block"), AtTime(0.3))
    assert bool(FILTERS["outcome"].reason(found)) == refused


def test_a_spring_that_is_squeezed_on_the_way_goes() -> None:
    """A block below the ceiling falls by 2mg/k = 0.39 m, from 0.50 m to 0.89 m, in π√(m/k) = 0.44 s."""
    spring = Spring(stiffness=100.0, length=0.5)
    entity = AnchoredSpring(spring=spring, block=Block(mass=2.0), support="ceiling", start=0.5)
    scene = Scene(entities=(Named(name="it", entity=entity),))
    speed = Target("velocity", "it.block")
    assert not FILTERS["outcome"].reason(candidate(scene, speed, AtTime(0.2))), "it is still less than 0.75 m long"
    late = FILTERS["outcome"].reason(candidate(scene, speed, AtTime(1.0)))
    assert late == "it.spring is stretched to 1.8 of its natural length"

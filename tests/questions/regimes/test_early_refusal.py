"""Tests of the quick refusal of motions that violate an assumption from the start."""

import numpy as np
import pytest

from plain_scenes import atwood, ramp
from sim2reason.questions import SimulatedScene
from sim2reason.questions.prompt import words_of
from sim2reason.questions.regimes import possible, regimes
from sim2reason.questions.regimes.events import CollideInTurn
from sim2reason.scenes.bodies.blocks import Glider
from sim2reason.scenes.bodies.simple_machines import Track
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.track_collisions import ComplexCollisionPlane
from sim2reason.text.prose.description import describe

TIMES = (0.0, 1e-9, 1e-4, 0.1, 0.5, 1.0)


def carts() -> Scene:
    """Build three carts, of which the middle one meets the left one first, then the right one."""
    each = (Glider(mass=1.0, x=-1.0, v=2.0), Glider(mass=2.0, x=0.0, v=0.5), Glider(mass=3.0, x=1.0, v=0.0))
    return Scene(
        entities=(Named(name="t", entity=ComplexCollisionPlane(track=Track(), gliders=each, restitution=0.5)),)
    )


@pytest.mark.parametrize(
    ("scene", "refused"),
    [
        (ramp(friction=0.3), {"SlidesThroughout", "MovesOneWay", "MovesFirst"}),
        (ramp(friction=0.7), {"SlidesThroughout", "MovesFirst"}),
        (ramp(friction=0.3, speed=2.0), {"SlidesThroughout"}),
        (atwood(), {"MovesOneWay", "MovesFirst"}),
        (carts(), {"CollideInTurn"}),
    ],
)
def test_what_is_refused_early_never_holds(scene: Scene, refused: set[str]) -> None:
    study, words = SimulatedScene.of(scene, np.linspace(0.0, 1.0, 11)), words_of(describe(scene))
    never = [regime for regime in possible(study, words) if regime.never_holds(study)]
    assert {type(regime).__name__ for regime in never} == refused
    assert not any(regime in regimes(study, words, until) for regime in never for until in TIMES)


def test_collisions_may_still_come() -> None:
    """Within 1 s only the left two carts meet."""
    study = SimulatedScene.of(carts(), np.array([0.0, 1.0]))
    left, right = ("t.gliders.0", "t.gliders.1"), ("t.gliders.1", "t.gliders.2")
    assert [event.subjects for event in study.trace.events if event.kind == "collision"] == [left]
    assert not any(CollideInTurn("", order).never_holds(study) for order in ((), (left,), (left, right)))
    assert CollideInTurn("", (right,)).never_holds(study)

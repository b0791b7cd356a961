"""Tests of the moment at which a body first stops sliding on its support."""

import numpy as np
import pytest

from sim2reason.questions.following import simulate_scene
from sim2reason.questions.moments.contacts import StoppedSlipping
from sim2reason.questions.prompt import words_of
from sim2reason.scenes.bodies.blocks import Slab
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.stacked_mass_plane import StackedMassPlane
from sim2reason.text.prose.description import describe


@pytest.mark.parametrize(("angle", "offered"), [(28.0, False), (5.0, True)])
def test_a_body_that_turned_back_before_is_not_asked_about(angle: float, *, offered: bool) -> None:
    """A slab sent up a stack on a steep slope turns back while it slips, before it sticks."""
    slabs = StackedMassPlane(
        plane=Plane(angle=angle, friction=0.16),
        lower=Slab(mass=9.1),
        upper=Slab(mass=8.7),
        top=Slab(mass=8.6),
        friction=0.20,
        top_friction=0.35,
        speed=4.0,
    )
    scene = Scene(entities=(Named(name="stack", entity=slabs),))
    study = simulate_scene(scene, 20.0).study
    moment = StoppedSlipping("stack.upper")
    assert moment.time(study.trace) is not None
    assert moment.turned_back(study.trace) is not offered
    found = StoppedSlipping.found(study, words_of(describe(scene)), np.random.default_rng(0))
    assert (moment in found) is offered

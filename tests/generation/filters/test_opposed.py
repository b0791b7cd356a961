"""Tests of the filters of weights that all pull the same way, and of bodies that slide too far on others."""

import pytest

from plain_scenes import atwood, half_atwood, ramp
from sim2reason.generation.filters import FILTERS, Candidate
from sim2reason.generation.item_search import sample
from sim2reason.questions import Query, Question, SimulatedScene, Target
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.bodies.blocks import Slab
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.slopes import TwoSideMassPlane
from sim2reason.scenes.entities.stacked_mass_plane import StackedMassPlane
from sim2reason.scenes.files import load
from sim2reason.simulation.scenes import simulate

SLOPE_AND_WEIGHT = """
scene:
  name: joined
  entities:
  - name: ramp
    type: TwoSideMassPlane
    parameters: {{plane: {{angle: 30.0, friction: 0.0}}, blocks: [{{mass: 2.0}}]}}
  - name: weight
    type: MassWithFixedPulley
    parameters: {{system: {{kind: hanging, blocks: [{{mass: 1.5}}]}}, pulley: {{mass: 0.0}}}}
  connections:
  - tendon: [{{entity: weight, direction: tail}}, {{entity: ramp, direction: {side}}}]
"""


def candidate(scene: Scene, subject: str, time: float = 0.3) -> Candidate:
    study = SimulatedScene(scene, simulate(scene, duration=time + 0.5))
    question = Question("numeric", Query("state", Target("velocity", subject), AtTime(time)), "?", 1.0, "m/s")
    return Candidate(study, question, "a b c")


@pytest.mark.parametrize(("side", "refused"), [("right", False), ("left", True)])
def test_a_weight_that_draws_a_block_down_its_slope_is_refused(side: str, refused: bool) -> None:
    scene = load(SLOPE_AND_WEIGHT.format(side=side))
    assert bool(FILTERS["opposed"].reason(candidate(scene, "ramp.blocks.0"))) is refused


@pytest.mark.parametrize("scene", [atwood(), half_atwood(), ramp()], ids=["Atwood", "half", "ramp"])
def test_a_weight_that_has_something_to_draw_is_none_the_worse(scene: Scene) -> None:
    assert FILTERS["opposed"].reason(candidate(scene, next(iter(scene.mechanism.body)))) == ""


def test_most_grown_scenes_lead_strings_up_slopes() -> None:
    """At most 30 % of the slopes have a string from the lower port alone."""
    down = slopes = 0
    for seed in range(40):
        scene = sample("hybrid", "easy", seed=seed)
        ports = {link.port for connection in scene.connections for link in connection.links}
        sloping = [named for named in scene.entities if isinstance(named.entity, TwoSideMassPlane)]
        slopes += len(sloping)
        down += bool(sloping) and "right" not in ports
    assert slopes >= 30
    assert down <= 0.3 * slopes


@pytest.mark.parametrize(("time", "refused"), [(0.5, False), (3.0, True)])
def test_no_slab_is_so_long_that_another_slides_far_on_it(time: float, refused: bool) -> None:
    """The relative acceleration of the slabs is µ g cos θ (1 + m/M)."""
    plane, slabs = Plane(angle=0.0, friction=0.0), (Slab(mass=4.0), Slab(mass=1.0))
    stack = StackedMassPlane(plane=plane, lower=slabs[0], upper=slabs[1], friction=0.1, speed=6.0)
    scene = Scene(entities=(Named(name="stack", entity=stack),))
    assert bool(FILTERS["slide"].reason(candidate(scene, "stack.lower", time))) is refused

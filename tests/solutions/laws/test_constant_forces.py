"""Tests of Newton's laws with a constant force that an entity exerts on a body."""

import subprocess
import sys
from pathlib import Path

SUPPORT = Path(__file__).parents[2] / "support"
PULLED = '''
from math import cos, radians, sin

from sim2reason.authoring import Angle, Entity, Force, Frame, Friction, Profile, Push, X, Z, entity
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.questions import Query, Target
from sim2reason.questions.moments.times import AtStart
from sim2reason.questions.moments.distances import Moved
from worked import answer


@entity
class PulledBlock(Entity):
    """A block on a rough floor that a constant force pulls to the right and up."""

    load: Block
    pull: Force
    angle: Angle
    friction: Friction

    says = (
        "{load} lies on a level floor, and a constant force of {pull} pulls it to the right, {angle} above the level.",
        "between {load} and the floor the coefficient of friction, static and kinetic, is {friction}.",
    )

    def build(self, room: Frame) -> None:
        slope = radians(self.angle)
        load = room.body("load", self.load.mass).rest(X, Z, self.friction)
        load.force("pull", Push((cos(slope), 0.0, sin(slope)), Profile(self.pull)))


mass, pull, angle, friction = 2.5, 14.0, 30.0, 0.25
block = PulledBlock(load=Block(mass=mass), pull=pull, angle=angle, friction=friction)
normal = mass * 9.8 - pull * sin(radians(angle))
expected = (pull * cos(radians(angle)) - friction * normal) / mass
asked = Target("acceleration", "it.load"), Target("normal force", "it.load")
found = [answer("it", block, Query("start", target, AtStart())) for target in asked]
assert abs(found[0] / expected - 1.0) < 1e-9, (found, expected)
assert abs(found[1] / normal - 1.0) < 1e-9, (found, normal)
energy = answer("it", block, Query("event", Target("kinetic energy", "it.load"), Moved("it.load", 1.5)))
assert abs(energy / (mass * expected * 1.5) - 1.0) < 1e-9, energy
print("fine")
'''


def test_a_slanted_pull_draws_and_lifts() -> None:
    """N = mg - F sin α and ma = F cos α - µN.

    The test runs in a separate process, since it adds an entity to the registry.
    """
    script = f"import sys; sys.path.insert(0, {str(SUPPORT)!r})\n{PULLED}"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120, check=False)
    assert done.stdout.strip() == "fine", done.stderr

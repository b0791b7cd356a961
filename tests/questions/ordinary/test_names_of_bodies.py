"""Tests of questions that use other names for bodies than the text, and of the time of a fall."""

from math import sqrt

import pytest

from sim2reason.datasets.scene_questions import solve
from sim2reason.errors import TextError
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import loads

G = 9.8


def scene(kind: str, parameters: str) -> Scene:
    """Build a scene of one entity."""
    return loads(f"scene: {{entities: [{{name: it, type: {kind}, parameters: {{{parameters}}}}}]}}")


STEPPED = scene(
    "BlocksOnSteppedPulley",
    "pulley: {outer: 0.3, inner: 0.1, inertia: 0.05}, outer_block: {mass: 1.0}, inner_block: {mass: 2.0}",
)


CARRIED = """
scene:
  entities:
  - {name: rail, type: SliderMass, parameters: {carriage: {mass: 3}}}
  - name: arm
    type: RigidPendulum
    parameters:
      angle: 60
      pieces:
      - {kind: ball_piece, distance: 1, body: {mass: 1}}
      - {kind: ball_piece, distance: 0.5, side: on the same side, body: {mass: 2}}
  connections: [{pivot: [{entity: rail, direction: pivot}, {entity: arm, direction: axle}]}]
"""


def charge(mass: float, sign: str = "negative") -> Scene:
    """Build a charge, with a mass in mg, in a magnetic field."""
    return scene(
        "EmEntity",
        "magnetic: {kind: uniform_magnetic, strength: 0.001, way: positive z}, start: {kind: launched, speed: 1.0e6,"
        f" angle: 0}}, particle: {{mass: {mass}, charge: 1.602e-13, sign: {sign}}}",
    )


def thrown(height: float, angle: float, side: str = "above") -> Scene:
    """Build a ball thrown at 3 m/s from a height above level ground."""
    return scene("Projectile", f"ball: {{mass: 1.0}}, height: {height}, speed: 3.0, angle: {angle}, side: {side}")


def test_the_pulley_is_the_stepped_one_where_there_is_no_other() -> None:
    """The angular acceleration is α = (m R − M r) g/(I + m R² + M r²)."""
    found = solve(STEPPED, question="What is the angular acceleration of the pulley?")
    assert found.answer == pytest.approx((0.3 - 0.2) * G / (0.05 + 0.09 + 0.02))


@pytest.mark.parametrize("question", ["What is the radius of the {}'s path?", "What is the radius of the {}'s orbit?"])
def test_a_mass_tells_an_electron_and_a_proton(question: str) -> None:
    """The radius of the path is r = m v/(q B)."""
    found = solve(charge(9.109e-25), question=question.format("electron"))
    assert found.answer == pytest.approx(9.109e-31 * 1e6 / (1.602e-19 * 0.001))
    found = solve(charge(1.673e-21, "positive"), question=question.format("proton"))
    assert found.answer == pytest.approx(1.673e-27 * 1e6 / (1.602e-19 * 0.001))


@pytest.mark.parametrize(("mass", "name"), [(9.109e-25, "proton"), (2e-25, "electron"), (1.673e-21, "electron")])
def test_no_other_mass_is_taken_for_a_particle(mass: float, name: str) -> None:
    """A question about another particle is not understood."""
    with pytest.raises(TextError, match="not understood"):
        solve(charge(mass), question=f"What is the radius of the {name}'s path?")


def test_the_time_of_a_fall() -> None:
    """A ball falls for (√(v² + 2 g h) − v)/g if thrown straight down at v, for √(2 h/g) if thrown horizontally."""
    asked = "How long does the ball take to fall?"
    assert solve(thrown(20.0, 90.0, "below"), question=asked).answer == pytest.approx((sqrt(9.0 + 40.0 * G) - 3.0) / G)
    assert solve(thrown(20.0, 0.0), question=asked).answer == pytest.approx(sqrt(40.0 / G))


@pytest.mark.parametrize(("height", "angle"), [(0.0, 45.0), (20.0, 30.0), (20.0, 90.0)])
def test_what_rises_first_has_no_one_time_of_fall(height: float, angle: float) -> None:
    """The time may count from the throw or from the highest point."""
    with pytest.raises(TextError, match="does not only fall"):
        solve(thrown(height, angle), question="How long does the ball take to fall?")


def test_the_energy_of_a_light_arm_is_that_of_what_it_carries() -> None:
    """The energy excludes that of the trolley below, and a massless wheel is not an arm that carries blocks."""
    swung = loads(CARRIED)
    arm, trolley, whole = (
        solve(swung, question=f"What is the {energy} after 0.3 s?").answer or 0.0
        for energy in (
            "kinetic energy of the arm",
            "kinetic energy of the trolley",
            "total kinetic energy of the system",
        )
    )
    assert 0.0 < trolley < arm < whole
    assert arm + trolley == pytest.approx(whole, rel=1e-9)
    with pytest.raises(TextError, match="not understood"):
        solve(STEPPED, question="What is the kinetic energy of the pulley after 2 s?")

"""Tests of the choice of the numbers that a text may leave unknown."""

from collections import Counter

import numpy as np
import pytest

from sim2reason.questions.prompt import words_of
from sim2reason.questions.unknown import draw_unknowns, far_from
from sim2reason.scenes.files import loads
from sim2reason.text.prose.description import describe

SLOPES = """
scene:
  entities:
  - name: upper
    type: TwoSideMassPlane
    parameters: {{plane: {{angle: 40.0, friction: 0.0}}, blocks: [{{mass: 2.0}}]}}
  - name: lower
    type: TwoSideMassPlane
    parameters: {{plane: {{angle: {angle}, friction: 0.0}}, blocks: [{{mass: 3.0}}]}}
  connections:
  - {{tendon: [{{entity: upper, direction: left}}, {{entity: lower, direction: right}}], free: 2.0}}
"""


def asked_for(angle: float) -> set[str]:
    scene = loads(SLOPES.format(angle=angle))
    words = words_of(describe(scene, 1))
    return {
        found.path for seed in range(60) for found in draw_unknowns(words.unknowns, scene, np.random.default_rng(seed))
    }


def test_no_angle_is_asked_for_where_another_one_would_need_a_pulley() -> None:
    """A string between two slopes of equal angle is straight, and the text mentions no pulley."""
    masses = {path for path in asked_for(40.0) if path.endswith("mass")}
    assert len(masses) == 2
    assert asked_for(40.0) == masses
    assert {path for path in asked_for(50.0) if path.endswith("angle")} == {"upper.plane.angle", "lower.plane.angle"}


ROCKET = """
scene:
  entities:
  - name: rocket
    type: RocketEntity
    parameters: {rocket: {mass: 800.0, dry: 200.0}, place: {kind: deep_space}, rate: 5.0, exhaust: 2.0}
"""


def test_one_of_two_masses_of_a_body_is_named_by_its_symbol() -> None:
    """A rocket has a mass with fuel and one without, so *the mass of the rocket* is ambiguous."""
    words = words_of(describe(loads(ROCKET), 1))
    masses = [found for found in words.unknowns if found.name == "mass"]
    assert {found.symbol for found in masses} == {"$m_0$", "$m_1$"}
    assert all(found.symbol in phrase for found in masses for phrase in found.phrases)
    (block, _) = (
        found for found in words_of(describe(loads(SLOPES.format(angle=50.0)), 1)).unknowns if found.name == "mass"
    )
    assert any("$" not in phrase for phrase in block.phrases)


def test_what_people_measure_by_what_happens_is_left_unknown_more_often() -> None:
    """Masses and angles are usually known, whereas a coefficient of friction is measured."""
    scene = loads(
        "scene: {entities: [{name: ramp, type: TwoSideMassPlane, parameters: {plane: {angle: 40.0, friction: 0.2}, "
        "blocks: [{mass: 2.0}], speed: 3.0}}]}"
    )
    words = words_of(describe(scene, 1))
    first = Counter(next(draw_unknowns(words.unknowns, scene, np.random.default_rng(seed))).name for seed in range(400))
    assert set(first) >= {"mass", "angle", "coefficient of friction"}
    assert first["coefficient of friction"] > 2.0 * max(first["mass"], first["angle"])


@pytest.mark.parametrize(
    ("values", "about", "count"),
    [
        ((2.0, 5.0, 20.0), 1.0, 28),
        ((2.0, 5.0, 20.0), 10.0, 29),
        ((2.0, 5.0, 20.0), 40.0, 28),
        ((2.0, 5.0, 20.0), -10.0, 36),
        ((-5.0, 0.0, 20.0), 10.0, 16),
        ((-5.0, 0.0, 20.0), -10.0, 20),
    ],
)
def test_far_values_lie_outside_the_range_and_have_the_sign_of_the_value(
    values: tuple[float, ...], about: float, count: int
) -> None:
    """They go up to a hundred times the value and down to a hundredth, in 16 steps each way, and to a thousand."""
    found = far_from(values, about, "m")
    assert all(value * about > 0.0 and not values[0] <= value <= values[-1] for value in found)
    distances = [max(value / about, about / value) for value in found]
    assert distances == pytest.approx(sorted(distances)), "the nearest ones come first"
    assert len(found) == count
    assert max(distances) == pytest.approx(1e3)


def test_there_are_no_far_angles_and_none_far_from_zero() -> None:
    assert far_from((2.0, 20.0), 10.0, "deg") == []
    assert far_from((2.0, 20.0), 0.0, "m") == []

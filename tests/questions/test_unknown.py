"""Tests of the choice of the numbers that a text may leave unknown."""

from collections import Counter

import numpy as np
import pytest

from plain_scenes import arm, ramp, table
from sim2reason.questions.prompt import words_of
from sim2reason.questions.unknown import beyond_range, draw_unknowns, far_from, find_limits, is_usual, range_of
from sim2reason.scenes.dsl.scene import Scene
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


ROUGH = ramp(friction=0.3, speed=2.0)
RANGES = [
    (ROUGH, "ramp.blocks.0.mass", (0.05, 100.0), (5e-6, 1e6), (0.25, 20.0)),
    (ROUGH, "ramp.speed", (0.05, 50.0), (5e-6, 5e5), (0.25, 10.0)),
    (ROUGH, "ramp.plane.friction", (0.01, 7.0), (1e-6, 10.0), (0.05, 1.4)),
    (ROUGH, "ramp.plane.angle", (1.0, 90.0), None, (5.0, 140.0)),
    (table(), "table.restitution", (0.03, 1.0), (3e-6, 1.0), (0.15, 2.0)),
    (arm(), "arm.pieces.0.distance", (0.015, 12.0), (1.5e-6, 1e3), (0.075, 2.4)),
]
"""A number with its range, how far it is searched for beyond, and its usual range."""


@pytest.mark.parametrize(("scene", "path", "ends", "far", "usual"), RANGES)
def test_a_number_has_a_range_ten_times_as_wide_at_either_end(
    scene: Scene, path: str, ends: tuple[float, float], far: tuple[float, float] | None, usual: tuple[float, float]
) -> None:
    """It ends where the declaration does, as at 1 for a coefficient of restitution; angles are evenly spaced."""
    values = range_of(scene, path)
    assert (values[0], values[-1]) == pytest.approx(ends, rel=1e-9)
    steps = np.diff(values) if path.endswith("angle") else np.diff(np.log(values))
    assert steps == pytest.approx(np.full(63, steps[0]), rel=1e-6)
    beyond = beyond_range(scene, path)
    assert bool(beyond) is (far is not None)
    if far is not None:
        assert (beyond[0][0], beyond[0][-1]) == pytest.approx((far[0], ends[0]), rel=1e-9)
        assert (beyond[-1][-1], len(beyond)) == pytest.approx((far[1] if len(beyond) == 2 else ends[0], len(beyond)))
        assert len(beyond) == 1 + (far[1] > ends[1])
    for value, inside in ((usual[0], 1.001), (usual[1], 0.999)):
        assert is_usual(scene, path, value * inside)
        assert not is_usual(scene, path, value / inside)


@pytest.mark.parametrize(
    ("path", "about", "end"),
    [
        ("ramp.blocks.0.mass", 10.0, 100.0),
        ("ramp.blocks.0.mass", 1e4, 1e5),
        ("ramp.speed", 1e3, 1e4),
        ("ramp.speed", 1e8, 3e7),  # not faster than a tenth of light
        ("ramp.plane.friction", 5.0, 10.0),
    ],
)
def test_a_range_goes_on_to_ten_times_a_known_value(path: str, about: float, end: float) -> None:
    values, farther = range_of(ROUGH, path), range_of(ROUGH, path, about)
    assert farther[:64] == values
    assert farther[-1] == pytest.approx(end, rel=1e-9)
    assert np.diff(np.log(farther)).max() <= np.log(values[1] / values[0]) * (1.0 + 1e-6)
    assert np.diff(np.log(farther)).min() > 0.4 * np.log(values[1] / values[0])


def test_static_friction_stays_above_kinetic_friction() -> None:
    """Of the coefficients 0.4 and 0.3, each may come as near to the other as 0.1 %."""
    scene = ROUGH.having("ramp.plane.static_friction", 0.4)
    assert find_limits(scene, "ramp.plane.friction") == pytest.approx((0.0, 0.4 / 1.001))
    assert find_limits(scene, "ramp.plane.static_friction") == pytest.approx((0.3 * 1.001, 10.0))

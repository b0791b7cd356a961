"""Tests of the comparison at rest of mechanisms that differ in one number."""

from collections.abc import Mapping
from math import cos, radians, sin

import pytest

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.oscillation import agree_at_rest

PLAIN = {"mass": 2.0, "stiffness": 80.0, "natural": 0.5, "start": 0.7, "speed": 0.0, "slope": 0.3}
EVERYTHING = ("lengths", "forces", "inertia", "stiffness")


def on_a_slope(numbers: Mapping[str, float]) -> Mechanism:
    """Build a block on a smooth slope, held from above by a spring along the slope."""
    slope = numbers["slope"]
    up, out = (cos(slope), 0.0, sin(slope)), (-sin(slope), 0.0, cos(slope))
    builder = Builder()
    room = builder.room().site("top")
    place = tuple(-numbers["start"] * part for part in up)
    block = room.body("block", numbers["mass"], at=(place[0], place[1], place[2]))
    block.rest(up, out, speed=numbers["speed"]).site("eye")
    room.spring("spring", "top", "eye", stiffness=numbers["stiffness"], length=numbers["natural"])
    return builder.finish()


@pytest.mark.parametrize(
    ("name", "value", "alike"),
    [
        ("speed", 1.0, EVERYTHING),
        ("start", 0.8, EVERYTHING),
        ("natural", 0.6, ("forces", "inertia", "stiffness")),
        ("slope", radians(40.0), ("inertia", "stiffness")),
        ("mass", 2.1, ("stiffness",)),
        ("stiffness", 85.0, ("forces", "inertia")),
    ],
)
def test_one_number_at_a_time(name: str, value: float, alike: tuple[str, ...]) -> None:
    """Numbers that change neither x = mg sin θ/k nor T = 2π √(m/k) leave the mechanisms alike."""
    one, other = on_a_slope(PLAIN), on_a_slope({**PLAIN, name: value})
    assert {aspect for aspect in EVERYTHING if agree_at_rest(one, other, (aspect,))} == set(alike)
    assert agree_at_rest(one, other, alike)


def test_what_never_rests_is_like_itself_alone() -> None:
    def falling(mass: float, speed: float) -> Mechanism:
        builder = Builder()
        builder.room().body("ball", mass).slide((0.0, 0.0, 1.0), speed)
        return builder.finish()

    assert agree_at_rest(falling(1.0, 0.0), falling(1.0, 2.0), EVERYTHING)
    assert not agree_at_rest(falling(1.0, 0.0), falling(2.0, 0.0), ("stiffness",))

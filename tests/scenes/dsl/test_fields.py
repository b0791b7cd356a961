"""Tests of force laws and regions: gradients by differences, shifted origins, declared properties."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.scenes.dsl.fields import Central, Law, Magnetic, Profile, Push, Resistance
from sim2reason.scenes.dsl.vectors import BoxRegion, DiscRegion, HalfSpace, Region, Vector, unit

NUMBER = st.floats(-3.0, 3.0)
SIZE = st.floats(0.2, 3.0)
VECTOR = st.tuples(NUMBER, NUMBER, NUMBER)
WAY = VECTOR.filter(lambda v: math.hypot(*v) > 0.1).map(unit)
PROFILE = st.builds(Profile, NUMBER, NUMBER, WAY, NUMBER, st.floats(0.0, 5.0))
LAW: st.SearchStrategy[Law] = st.one_of(
    st.builds(Push, WAY, PROFILE),
    st.builds(Magnetic, WAY, PROFILE),
    st.builds(Resistance, SIZE, SIZE),
    st.builds(Central, VECTOR, NUMBER, st.integers(-1, 4)),
)
WITH_POTENTIAL: st.SearchStrategy[Law] = st.one_of(
    WAY.flatmap(lambda way: st.builds(Push, st.just(way), st.builds(Profile, NUMBER, NUMBER, st.just(way)))),
    st.builds(Push, WAY, st.builds(Profile, NUMBER)),
    st.builds(Central, VECTOR, NUMBER, st.sampled_from([-1, 0, 2, 3, 4])),
)
REGION: st.SearchStrategy[Region] = st.one_of(
    st.builds(HalfSpace, WAY, NUMBER),
    st.builds(lambda way, low, wide: BoxRegion(((way, low, low + wide),)), WAY, NUMBER, SIZE),
    st.builds(DiscRegion, VECTOR, SIZE, WAY),
)
H = 1e-5


def shifted(place: Vector, by: Vector) -> Vector:
    return (place[0] + by[0], place[1] + by[1], place[2] + by[2])


def far(law: Law, place: Vector) -> bool:
    """Return whether a place is far enough from a centre of force for finite differences."""
    return not isinstance(law, Central) or math.dist(law.center, place) > 0.3


@given(law=WITH_POTENTIAL, place=VECTOR)
def test_a_force_is_the_downhill_slope_of_its_potential(law: Law, place: Vector) -> None:
    if not far(law, place):
        return
    force = law.force(place, (0.4, -0.3, 0.2), 0.7, math)
    for axis in range(3):
        step = tuple(H if i == axis else 0.0 for i in range(3))
        back = tuple(-part for part in step)
        up, down = (law.potential(shifted(place, way), math) for way in (step, back))  # type: ignore[arg-type]
        assert up is not None
        assert down is not None
        assert force[axis] == pytest.approx(-(up - down) / (2.0 * H), rel=1e-5, abs=1e-5)


@given(law=LAW, place=VECTOR, velocity=VECTOR, time=SIZE, by=VECTOR)
def test_a_law_about_another_origin_is_the_same_law(
    law: Law, place: Vector, velocity: Vector, time: float, by: Vector
) -> None:
    if far(law, place):
        wanted = law.force(place, velocity, time, math)
        assert law.moved(by).force(shifted(place, by), velocity, time, math) == pytest.approx(
            wanted, rel=1e-9, abs=1e-9
        )


@given(law=LAW, place=VECTOR, velocity=VECTOR, time=SIZE, other=VECTOR, later=SIZE)
def test_a_law_that_calls_itself_constant_is(
    law: Law, place: Vector, velocity: Vector, time: float, other: Vector, later: float
) -> None:
    if law.constant:
        assert law.force(place, velocity, time, math) == law.force(other, place, later, math)


@given(law=LAW, place=VECTOR, velocity=VECTOR, time=SIZE)
def test_floats_and_arrays_give_the_same(law: Law, place: Vector, velocity: Vector, time: float) -> None:
    if far(law, place):
        wanted = law.force(place, velocity, time, math)
        many = [[np.full(2, part) for part in vector] for vector in (place, velocity)]
        found = law.force(tuple(many[0]), tuple(many[1]), np.full(2, time), np)  # type: ignore[arg-type]
        assert [float(np.broadcast_to(part, 2)[1]) for part in found] == pytest.approx(wanted, rel=1e-12, abs=1e-12)


@given(way=WAY, profile=PROFILE, place=VECTOR, velocity=VECTOR, time=SIZE)
def test_a_magnetic_force_does_no_work(
    way: Vector, profile: Profile, place: Vector, velocity: Vector, time: float
) -> None:
    force = Magnetic(way, profile).force(place, velocity, time, math)
    assert float(np.dot(force, velocity)) == pytest.approx(0.0, abs=1e-9)
    assert float(np.dot(force, way)) == pytest.approx(0.0, abs=1e-9)


@given(linear=SIZE, quadratic=SIZE, velocity=VECTOR)
def test_drag_is_against_the_motion(linear: float, quadratic: float, velocity: Vector) -> None:
    force, speed = Resistance(linear, quadratic).force((0.0, 0.0, 0.0), velocity, 0.0, math), math.hypot(*velocity)
    assert float(np.dot(force, velocity)) == pytest.approx(-(linear * speed**2 + quadratic * speed**3), rel=1e-12)


@given(value=NUMBER, slope=NUMBER, way=WAY, other=WAY)
def test_a_push_that_changes_aside_has_no_potential(value: float, slope: float, way: Vector, other: Vector) -> None:
    """The curl, of magnitude slope · |other × way|, is not zero."""
    law = Push(way, Profile(value, slope, other))
    aside = float(np.linalg.norm(np.cross(other, way))) > 1e-6
    assert (law.potential((0.0, 0.0, 0.0), math) is None) == (slope != 0.0 and aside)


@given(region=REGION, place=VECTOR, by=VECTOR)
def test_a_region_elsewhere_has_the_same_borders(region: Region, place: Vector, by: Vector) -> None:
    assert region.moved(by).margins(shifted(place, by), math) == pytest.approx(region.margins(place, math), abs=1e-7)


@given(region=REGION, place=VECTOR, step=WAY)
def test_a_margin_is_a_distance(region: Region, place: Vector, step: Vector) -> None:
    """A step of length h changes no margin by more than h."""
    there = (place[0] + 0.01 * step[0], place[1] + 0.01 * step[1], place[2] + 0.01 * step[2])
    for here, then in zip(region.margins(place, math), region.margins(there, math), strict=True):
        assert abs(then - here) <= 0.01 + 1e-12


def test_inside_and_outside() -> None:
    box = BoxRegion((((1.0, 0.0, 0.0), -1.0, 2.0), ((0.0, 1.0, 0.0), 0.0, 0.5)))
    assert all(margin > 0.0 for margin in box.margins((1.9, 0.2, 9.0), math))
    assert not all(margin > 0.0 for margin in box.margins((2.1, 0.2, 0.0), math))
    disc = DiscRegion((1.0, 1.0, 0.0), 0.5)
    assert disc.margins((1.3, 1.4, 7.0), math) == pytest.approx((0.0,))
    assert HalfSpace((0.0, 0.0, 1.0), 2.0).margins((5.0, 5.0, 2.5), math) == (0.5,)

"""Tests of worked solutions about charges whose velocity has turned, against closed forms."""

from math import cos, hypot, pi, radians, sin, sqrt, tan

import pytest

from sim2reason.questions import Query, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.fields import AcrossField, VelocityReturned, VelocityTurned
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.scenes.bodies.charges import ChargedBead, Launched, Released
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.fields import LinearElectric, UniformElectric, UniformMagnetic
from sim2reason.scenes.entities.particles import EmEntity
from worked import answer, derived

BEAD = "fields.particle"
MASS, CHARGE, SPEED, B, FIELD, SLOPE = 2.0, 3.0, 2.0, 0.8, 1.1, 0.7
TURNS, PULL, DRIFT = CHARGE * B / MASS, CHARGE * FIELD / MASS, FIELD / B
ANGLE = radians(40.0)
VX, VY = SPEED * cos(ANGLE), SPEED * sin(ANGLE)
MAGNETIC = UniformMagnetic(strength=B, way="positive z")
ELECTRIC = UniformElectric(strength=FIELD, way="positive y")
OPPOSED = UniformElectric(strength=FIELD, way="negative y")
LINEAR = LinearElectric(strength=FIELD, way="positive y", trend="decreases", axis="y", slope=SLOPE)
OBLIQUE, ALONG_X, REST = Launched(speed=SPEED, angle=40.0), Launched(speed=SPEED, angle=0.0), Released()


def fields(**acting: object) -> EmEntity:
    particle = ChargedBead(mass=MASS, charge=CHARGE, sign="positive")
    return EmEntity(particle=particle, **{"start": OBLIQUE, **acting})  # type: ignore[arg-type]


def at(moment: Moment, quantity: str, **acting: object) -> float:
    """Return the magnitude of a quantity at the given moment from a solution that passes every check."""
    return answer("fields", fields(**acting), Query("event", Target(quantity, BEAD), moment))


def whole(functional: str, **acting: object) -> float:
    """Return an extreme value over the whole motion from a solution that passes every check."""
    return answer("fields", fields(**acting), StretchQuery("extremum", None, WholeMotion(True), functional, BEAD))


def text(moment: Moment, quantity: str, **acting: object) -> str:
    scene = Scene(entities=(Named(name="fields", entity=fields(**acting)),))
    return derived(scene, Query("event", Target(quantity, BEAD), moment)).text


def test_an_arc_has_its_chord() -> None:
    """The displacement is the chord 2R sin(α/2) with R = m v/(q B)."""
    far = at(VelocityTurned(BEAD, 60.0), "displacement", magnetic=MAGNETIC)
    assert far == pytest.approx(2.0 * SPEED / TURNS * sin(radians(30.0)))


def test_across_an_electric_field_a_charge_goes_round_a_parabola() -> None:
    """tan α = a t/v, x = v t, y = a t²/2; the component across the field is constant, so the speed is v/cos α."""
    time = SPEED * tan(radians(30.0)) / PULL
    turned = VelocityTurned(BEAD, 30.0)
    far = at(turned, "displacement", electric=ELECTRIC, start=ALONG_X)
    assert far == pytest.approx(hypot(SPEED * time, 0.5 * PULL * time**2))
    assert at(turned, "velocity", electric=ELECTRIC, start=ALONG_X) == pytest.approx(SPEED / cos(radians(30.0)))
    apex = at(AcrossField(BEAD), "displacement", electric=OPPOSED)
    assert apex == pytest.approx(hypot(VX * VY / PULL, VY**2 / (2.0 * PULL)))


def test_half_a_cycloid_is_as_wide_as_half_a_turn_of_its_wheel() -> None:
    """From rest: π u/Ω along the drift, 2u/Ω along the field, speed 2u at the top (Griffiths, example 5.2)."""
    crossed = {"electric": ELECTRIC, "magnetic": MAGNETIC, "start": REST}
    assert at(AcrossField(BEAD), "displacement", **crossed) == pytest.approx(DRIFT / TURNS * hypot(pi, 2.0))
    assert at(AcrossField(BEAD), "velocity", **crossed) == pytest.approx(2.0 * DRIFT)
    told = text(AcrossField(BEAD), "displacement", **crossed)
    assert "has made half a turn" in told
    assert told.count("Over half a turn") == 2


def test_over_a_period_of_the_velocity_only_the_drift_moves_it() -> None:
    """The period of the velocity is 2π m u/(q B)."""
    crossed = {"electric": ELECTRIC, "magnetic": MAGNETIC}
    far = at(VelocityReturned(BEAD), "displacement", **crossed)
    assert far == pytest.approx(2.0 * pi * DRIFT / TURNS)
    assert "adds nothing to the displacement" in text(VelocityReturned(BEAD), "displacement", **crossed)


def test_distances_from_an_axis_are_told_by_centre_and_radius() -> None:
    """The greatest distance from the axis is R (1 + |cos θ|) in a magnetic field.

    In crossed fields the same holds for the circular part of the motion; from rest in a restoring field it is 2y_c.
    """
    axis = "greatest distance from the x axis"
    turned = hypot(VX - DRIFT, VY)
    assert whole(axis, magnetic=MAGNETIC) == pytest.approx(SPEED / TURNS * (1.0 + cos(ANGLE)))
    crossed = whole(axis, electric=ELECTRIC, magnetic=MAGNETIC)
    assert crossed == pytest.approx((abs(VX - DRIFT) + turned) / TURNS)
    assert whole(axis, electric=LINEAR, magnetic=MAGNETIC, start=REST) == pytest.approx(
        2.0 * PULL / (CHARGE * SLOPE / MASS + TURNS**2)
    )


@pytest.mark.parametrize("magnetic", [None, MAGNETIC])
def test_a_field_that_drives_it_back_makes_it_fastest_where_it_is_zero(magnetic: UniformMagnetic | None) -> None:
    """v² = v₀² + a E/k by energy, as the magnetic force does no work; the maximum is at y = E/k, which is reached."""
    start = Launched(speed=SPEED, angle=140.0)
    fastest = whole("greatest speed", electric=LINEAR, magnetic=magnetic, start=start)
    assert fastest == pytest.approx(sqrt(SPEED**2 + PULL * FIELD / SLOPE))


def test_half_an_oscillation_ends_at_its_other_end() -> None:
    """The displacement is 2y_c along the field and (v + Ω y_c) π/ω across it, with Ω² + kq/m = ω².

    The speed at the other end is v + 2Ω y_c.
    """
    square = CHARGE * SLOPE / MASS + TURNS**2
    center = (PULL - TURNS * SPEED) / square
    both = {"electric": LINEAR, "magnetic": MAGNETIC, "start": ALONG_X}
    assert at(AcrossField(BEAD), "velocity", **both) == pytest.approx(abs(SPEED + 2.0 * TURNS * center))
    across = (SPEED + TURNS * center) * pi / sqrt(square)
    assert at(AcrossField(BEAD), "displacement", **both) == pytest.approx(hypot(across, 2.0 * center))
    alone = hypot(SPEED * pi / sqrt(CHARGE * SLOPE / MASS), 2.0 * FIELD / SLOPE)
    assert at(AcrossField(BEAD), "displacement", electric=LINEAR, start=ALONG_X) == pytest.approx(alone)

"""Tests of a charged bead's distance from an axis, and of its speed in crossed fields, by closed forms."""

from math import cos, hypot, radians, sin, sqrt

import pytest

from sim2reason.questions import KINDS, SimulatedScene, Words
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.questions.prompt import words_of
from sim2reason.questions.sentences import parse_question
from sim2reason.scenes.bodies.charges import ChargedBead, Launched, Released
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.fields import LinearElectric, UniformElectric, UniformMagnetic
from sim2reason.scenes.entities.particles import EmEntity
from sim2reason.solutions import ProblemContext, solve
from sim2reason.text.prose.description import describe

BEAD = "fields.particle"
MASS, CHARGE, SPEED, B, FIELD, SLOPE = 2.0, 3.0, 2.0, 0.8, 1.1, 0.7
TURNS, PULL, DRIFT, BEND = CHARGE * B / MASS, CHARGE * FIELD / MASS, FIELD / B, CHARGE * SLOPE / MASS
ANGLE = radians(40.0)
VX, VY = SPEED * cos(ANGLE), SPEED * sin(ANGLE)
MAGNETIC = UniformMagnetic(strength=B, way="positive z")
ELECTRIC = UniformElectric(strength=FIELD, way="positive y")
LINEAR = LinearElectric(strength=FIELD, way="positive y", trend="decreases", axis="y", slope=SLOPE)
X_AXIS, Y_AXIS = "greatest distance from the x axis", "greatest distance from the y axis"
LAUNCHED, REST = Launched(speed=SPEED, angle=40.0), Released()


def told(**acting: object) -> tuple[SimulatedScene, Words]:
    """Return a positive bead in fields, and its words."""
    particle = ChargedBead(mass=MASS, charge=CHARGE, sign="positive")
    made = EmEntity(particle=particle, **{"start": LAUNCHED, **acting})  # type: ignore[arg-type]
    scene = Scene(entities=(Named(name="fields", entity=made),))
    return simulate_scene(scene).study, words_of(describe(scene))


def checked(functional: str, moment: WholeMotion, **acting: object) -> float:
    """Return the answer, checked against the sentence that asks for it and a worked solution in closed form."""
    study, words = told(**acting)
    query = StretchQuery("extremum", None, moment, functional, BEAD)
    value = KINDS["extremum"].answer(query, study)
    assert value is not None
    text = KINDS["extremum"].shapes(query, words, None)[0]
    assert parse_question(text[0].upper() + text[1:], study, words) == query
    found = solve(ProblemContext(study.scene, words, describe(study.scene).symbols, study, query))
    assert found.strategy == "motion in fields", found.reason
    assert found.answer == pytest.approx(value, rel=1e-6)
    return value


def test_round_a_circle_the_distance_from_an_axis_is_that_of_the_centre_and_the_radius() -> None:
    """The distance is R (1 + |cos θ|) from the x axis, R (1 + |sin θ|) from the y axis."""
    radius = SPEED / TURNS
    assert checked(X_AXIS, WholeMotion(), magnetic=MAGNETIC) == pytest.approx(radius * (1.0 + cos(ANGLE)), rel=1e-8)
    assert checked(Y_AXIS, WholeMotion(), magnetic=MAGNETIC) == pytest.approx(radius * (1.0 + sin(ANGLE)), rel=1e-8)


def test_in_crossed_fields_speeds_are_the_drift_and_what_turns() -> None:
    """The extreme speeds are |u| ± |v₀ − u| with u = E × B/B², here E/B along x (Griffiths, example 5.2)."""
    turned = hypot(VX - DRIFT, VY)
    both = {"electric": ELECTRIC, "magnetic": MAGNETIC}
    fastest = checked("greatest speed", WholeMotion(drifts=True), **both)
    slowest = checked("least speed", WholeMotion(drifts=True), **both)
    assert fastest == pytest.approx(DRIFT + turned, rel=1e-8)
    assert slowest == pytest.approx(abs(DRIFT - turned), rel=1e-8)
    far = (abs(VX - DRIFT) + turned) / TURNS
    assert checked(X_AXIS, WholeMotion(drifts=True), **both) == pytest.approx(far, rel=1e-8)


def test_from_rest_in_crossed_fields_it_goes_twice_as_fast_as_the_drift() -> None:
    """The greatest speed is 2E/B, the distance 2mE/(qB²) along the field (Griffiths, example 5.2)."""
    held = {"electric": ELECTRIC, "magnetic": MAGNETIC, "start": REST}
    assert checked("greatest speed", WholeMotion(drifts=True), **held) == pytest.approx(2.0 * DRIFT, rel=1e-8)
    assert checked(X_AXIS, WholeMotion(drifts=True), **held) == pytest.approx(2.0 * DRIFT / TURNS, rel=1e-8)


def test_where_a_field_drives_it_back_it_oscillates_about_where_that_is_zero() -> None:
    """The amplitude about y_c = E/k is √(y_c² + (v_y/ω)²); v² = v₀² + (q/m) E²/k at the centre, by energy."""
    center, rate = FIELD / SLOPE, sqrt(BEND)
    far = center + hypot(center, VY / rate)
    assert checked(X_AXIS, WholeMotion(drifts=True), electric=LINEAR) == pytest.approx(far, rel=1e-8)
    fastest = sqrt(SPEED**2 + PULL * center)
    assert checked("greatest speed", WholeMotion(drifts=True), electric=LINEAR) == pytest.approx(fastest, rel=1e-8)


def test_a_magnetic_field_makes_such_an_oscillation_faster() -> None:
    """With v_x = v₀ₓ + Ω y, ω² = k q/m + Ω² and y_c = (a − Ω v₀ₓ)/ω²; the magnetic force does no work."""
    square = BEND + TURNS**2
    center = (PULL - TURNS * VX) / square
    far = abs(center) + hypot(center, VY / sqrt(square))
    both = {"electric": LINEAR, "magnetic": MAGNETIC}
    assert checked(X_AXIS, WholeMotion(drifts=True), **both) == pytest.approx(far, rel=1e-8)


def test_along_a_drift_no_distance_is_greatest() -> None:
    _, words = told(electric=ELECTRIC, magnetic=MAGNETIC)
    assert BEAD in FUNCTIONALS[X_AXIS].noun_phrases(words)
    assert BEAD not in FUNCTIONALS[Y_AXIS].noun_phrases(words)
    assert not FUNCTIONALS["greatest displacement"].when(WholeMotion(drifts=True), words, BEAD)

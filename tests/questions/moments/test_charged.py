"""Tests of moments at which a charged bead's velocity has turned, is across the field, or recurs."""

from dataclasses import replace
from math import pi, radians, sin, tan

import numpy as np
import pytest

from sim2reason.questions import Moment
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.moments.distances import Away
from sim2reason.questions.moments.fields import AcrossField, VelocityReturned, VelocityTurned
from sim2reason.questions.prompt import words_of
from sim2reason.scenes.bodies.charges import ChargedBead, Launched, Released
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.fields import LinearDrag, UniformElectric, UniformMagnetic
from sim2reason.scenes.entities.particles import EmEntity
from sim2reason.text.prose.description import describe

BEAD = "fields.particle"
MASS, CHARGE, SPEED, B, FIELD = 2.0, 3.0, 2.0, 0.8, 1.1
TURNS, PULL = CHARGE * B / MASS, CHARGE * FIELD / MASS
MAGNETIC = UniformMagnetic(strength=B, way="positive z")
ELECTRIC = UniformElectric(strength=FIELD, way="positive y")
DRAG = LinearDrag(coefficient=0.5)
REST = Released()


def scene(angle: float = 0.0, **acting: object) -> Scene:
    """Build a positive bead in fields, launched at an angle, deg, unless a start is given."""
    particle = ChargedBead(mass=MASS, charge=CHARGE, sign="positive")
    held = {"start": Launched(speed=SPEED, angle=angle), **acting}
    return Scene(entities=(Named(name="fields", entity=EmEntity(particle=particle, **held)),))  # type: ignore[arg-type]


def when(moment: Moment, angle: float = 0.0, **acting: object) -> float | None:
    """Return the time of the moment, s."""
    study = simulate_scene(scene(angle, **acting), 12.0).study
    return moment.time(study.trace)


@pytest.mark.parametrize("angle", [30.0, 90.0, 150.0])
@pytest.mark.parametrize("medium", [None, DRAG])
def test_a_magnetic_field_turns_a_velocity_uniformly(angle: float, medium: LinearDrag | None) -> None:
    """t = α m/(q B) (Serway and Jewett, § 29.2), even with drag, which acts along the velocity."""
    found = when(VelocityTurned(BEAD, angle), 40.0, magnetic=MAGNETIC, medium=medium)
    assert found == pytest.approx(radians(angle) / TURNS, rel=1e-8)


def test_an_electric_field_turns_a_velocity_by_the_ratio_of_components() -> None:
    """The velocity across the field is constant, so tan α = a t/v, as for a ball thrown horizontally."""
    found = when(VelocityTurned(BEAD, 60.0), electric=ELECTRIC)
    assert found == pytest.approx(SPEED * tan(radians(60.0)) / PULL, rel=1e-8)
    assert when(VelocityTurned(BEAD, 120.0), electric=ELECTRIC) is None  # it tends to a right angle
    assert when(VelocityTurned(BEAD, 30.0), 20.0, electric=ELECTRIC) is None  # not launched across the field


def test_a_bead_turns_back_along_an_electric_field_as_a_ball_under_gravity() -> None:
    """The time is t = v sin θ/a."""
    down = UniformElectric(strength=FIELD, way="negative y")
    assert when(AcrossField(BEAD), 40.0, electric=down) == pytest.approx(SPEED * sin(radians(40.0)) / PULL, rel=1e-8)
    assert when(AcrossField(BEAD), 90.0, electric=down) is None  # it is at rest then
    assert when(AcrossField(BEAD), 40.0, electric=ELECTRIC) is None


def test_from_rest_in_crossed_fields_it_is_across_the_field_after_half_a_turn() -> None:
    """On a cycloid the time is π m/(q B) (Griffiths, Introduction to Electrodynamics, example 5.2)."""
    found = when(AcrossField(BEAD), start=REST, electric=ELECTRIC, magnetic=MAGNETIC)
    assert found == pytest.approx(pi / TURNS, rel=1e-8)


def test_in_crossed_fields_a_velocity_comes_again_after_a_full_turn() -> None:
    """The time is 2π m/(q B); a bead from rest comes to rest again, which is a different moment."""
    assert when(VelocityReturned(BEAD), 70.0, electric=ELECTRIC, magnetic=MAGNETIC) == pytest.approx(
        2.0 * pi / TURNS, rel=1e-8
    )
    assert when(VelocityReturned(BEAD), start=REST, electric=ELECTRIC, magnetic=MAGNETIC) is None
    assert when(VelocityReturned(BEAD), 70.0, magnetic=MAGNETIC) is None


def test_a_question_calls_the_velocity_by_a_pronoun_only_after_the_body() -> None:
    told = scene(magnetic=MAGNETIC)
    words = words_of(describe(told))
    moment = VelocityTurned(BEAD, 60.0)
    assert moment.phrases(words)[0] == f"when the velocity of {moment.candidates(words)[BEAD]} has turned through 60°"
    clause = moment.clause(words)
    assert clause is not None
    assert clause.takes == "to turn through 60°"


def test_recipes_seldom_ask_when_a_charge_is_so_far_away() -> None:
    study = simulate_scene(scene(magnetic=MAGNETIC)).study
    words, rng = words_of(describe(study.scene)), np.random.default_rng(2)
    found = sum(bool(Away.found(study, words, rng)) for _ in range(200))
    assert 0 < found < 40


def test_a_turned_velocity_tells_how_the_force_has_turned() -> None:
    moment = VelocityTurned(BEAD, 60.0)
    assert {told.quantity for told in moment.revealed_channels} == {"acceleration", "net force"}
    assert replace(moment, value=45.0).stated == ((45.0, "deg"),)


@pytest.mark.parametrize(("angle", "again"), [(0.0, True), (60.0, False)])
def test_a_bead_that_is_launched_across_the_field_moves_across_it_again(angle: float, *, again: bool) -> None:
    """A bead launched across the field moves across it at the start, so *first* alone would mean the start."""
    words = words_of(describe(scene(angle, electric=ELECTRIC, magnetic=MAGNETIC)))
    assert all((" again" in phrase) is again for phrase in AcrossField(BEAD).phrases(words))

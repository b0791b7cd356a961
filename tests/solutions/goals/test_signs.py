"""Tests of the signs of the quantities asked for: magnitudes, compressions, and relative positions."""

from dataclasses import replace

import pytest

from plain_scenes import ramp, row, squeezed
from sim2reason.questions import Formula, Query, Target
from sim2reason.questions.moments.strings import MostCompressed, MostStretched
from sim2reason.questions.moments.times import AtTime
from sim2reason.simulation.quantities.subjects.interactions import PAIR_SEPARATOR
from sim2reason.solutions import solve
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.functions import Absolute
from sim2reason.solutions.goals import modulus
from sim2reason.solutions.writing.steps import SolutionBuilder
from worked import asked


@pytest.mark.parametrize(("moment", "noun"), [(MostCompressed, "compression"), (MostStretched, "extension")])
def test_a_compression_is_not_called_an_extension(moment: type, noun: str) -> None:
    scene = row((2.0,), (50.0,), "left", speed=1.0)
    line = scene.mechanism.lines[0].name
    found = solve(asked(scene, Query("event", Target("extension", line), moment(line))))
    assert found.answer == pytest.approx(0.2)
    assert ("compression" in found.text) == (noun == "compression")


def test_a_distance_is_that_of_a_position_relative_to_the_other_body() -> None:
    scene = squeezed()
    one, other = (body.name for body in scene.mechanism.bodies if body.mass)
    found = solve(asked(scene, Query("state", Target("distance", f"{one}{PAIR_SEPARATOR}{other}"), AtTime(0.5))))
    assert found.answer == pytest.approx(0.5)
    assert "relative to the ground" not in found.text


@pytest.mark.parametrize(("value", "either", "barred"), [(2.0, False, False), (2.0, True, True), (-2.0, False, True)])
def test_in_symbols_what_may_have_either_sign_stands_between_bars(value: float, either: bool, barred: bool) -> None:
    book = SolutionBuilder(called={})
    book.set_value("w", value)
    found = modulus(Symbol("w"), book, of_either_sign=either)
    assert found == (Absolute(Symbol("w")) if barred else Symbol("w"))
    assert found.value(book.values) == abs(value)


def test_what_hangs_on_an_unknown_changes_its_sign_instead() -> None:
    book = SolutionBuilder()
    book.set_value("w", -2.0)
    book.hidden.add("w")
    assert modulus(Symbol("w"), book) == -Symbol("w")


@pytest.mark.parametrize("speed", [None, 4.0])
def test_the_magnitude_of_a_change_in_potential_energy_has_no_sign(speed: float | None) -> None:
    """The symbolic result has an absolute value, as the block may be above or below its starting point."""
    scene = ramp(speed=speed)
    block = next(body.name for body in scene.mechanism.bodies if body.mass)
    setting = asked(scene, Query("state", Target("potential energy", block), AtTime(0.5)))
    in_symbols = Formula("U", ("m", r"\theta", "v", "g", "t"), ("kg", "°", "m/s", "m/s²", "s"), (), ())
    found = solve(replace(setting, formula=in_symbols))
    assert found.answer is not None, found.reason
    last = next(held for held in reversed(found.relations) if held.left.latex() == found.goal)
    assert isinstance(last.right, Absolute) or any(isinstance(part, Absolute) for part in last.right.parts)

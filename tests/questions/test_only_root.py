"""Tests that another root of a result is found, however narrow its surroundings are."""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf, sqrt

import numpy as np
import pytest

from plain_scenes import atwood, half_atwood
from sim2reason.questions import Query, SimulatedScene
from sim2reason.questions.conditions import UniquenessScan
from sim2reason.questions.dependence import AnswerFunction
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.query import Target
from sim2reason.questions.unknown import far_from, lengthen_strings
from sim2reason.simulation.scenes import simulate

ROOT = 2.0
VALUES = tuple(np.geomspace(0.2, 100.0, 64).tolist())
MARGIN = 1e-3


@dataclass
class Known:
    """Result as a known function of the unknown."""

    result: Callable[[float], float]
    hits: tuple[float, ...] = ()  # numbers from which on one thing more happens
    ends: tuple[float, float] = (-inf, inf)  # beyond which there is no result
    late: tuple[float, ...] = ()  # where there may be one that is not waited for

    def __call__(self, value: float) -> float | None:
        return self.result(value) if self.ends[0] <= value <= self.ends[1] else None

    def is_late(self, value: float) -> bool:
        return value in self.late

    def course(self, value: float) -> tuple[int, ...]:
        return tuple(number for number, hit in enumerate(self.hits) if value > hit)

    def rate(self, value: float) -> float:
        return (self.result(value * (1.0 + 1e-6)) - self.result(value)) / (1e-6 * value)


def found(result: Callable[[float], float], *hits: float) -> float | None:
    return UniquenessScan(Known(result, hits), ROOT, result(ROOT), MARGIN).find_other_root(VALUES)  # type: ignore[arg-type]


def kinked(height: float, tip: float) -> Callable[[float], float]:
    """Return a result that falls through 1 at the root, and beyond it peaks at `height` < 1, steeply on the left."""

    def result(value: float) -> float:
        if value < 4.0:
            return 1.0 - (value - ROOT) / 4.0
        return height - (0.3 * (tip - value) if value < tip else 0.004 * (value - tip))

    return result


@pytest.mark.parametrize("tip", [5.3, 5.95, 6.7, 20.0])
def test_the_tip_of_a_kink_is_looked_at(tip: float) -> None:
    at = found(kinked(1.0 - 0.5 * MARGIN, tip))
    assert at == pytest.approx(tip, rel=0.05)


@pytest.mark.parametrize("tip", [5.3, 5.95, 6.7, 20.0])
def test_a_tip_that_stays_clear_is_none(tip: float) -> None:
    assert found(kinked(1.0 - 1.5 * MARGIN, tip)) is None


@pytest.mark.parametrize("top", [5.3, 9.0, 20.0])
@pytest.mark.parametrize(("height", "excluded"), [(1.0 - 0.5 * MARGIN, False), (1.0 - 1.5 * MARGIN, True)])
def test_the_top_of_a_round_hill_is_looked_at(top: float, height: float, *, excluded: bool) -> None:
    def result(value: float) -> float:
        return 1.0 - (value - ROOT) / 4.0 if value < 4.0 else height - 0.05 * (value - top) ** 2

    assert (found(result) is None) is excluded


@pytest.mark.parametrize("last", [5.3, 6.7581, 20.0])
def test_where_results_come_back_just_before_they_end_is_looked_at(last: float) -> None:
    """The result returns with the square root of the distance from the end, within 4e-5 of it.

    A string that goes slack near the top of a circle has such a result.
    """

    def result(value: float) -> float:
        return max(1.0 - (value - ROOT) / 4.0, 1.0 + 3.0 * (sqrt(4e-5) - sqrt(abs(1.0 - value / last))))

    known = Known(result, ends=(-inf, last))
    at = UniquenessScan(known, ROOT, result(ROOT), MARGIN).find_other_root(VALUES)  # type: ignore[arg-type]
    assert at == pytest.approx(last, rel=1e-4)


def test_between_numbers_for_which_different_things_happen_more_are_tried() -> None:
    """Between two points of the scan another event happens, and the result differs in a short interval."""
    low, high = VALUES[40:42]
    begin, end = low + 0.3 * (high - low), low + 0.6 * (high - low)

    def result(value: float) -> float:
        return 1.5 if begin < value < end else 1.0 - (value - ROOT) / 4.0

    assert found(result, begin, end) is not None
    assert found(result) is None


def test_what_begins_to_happen_at_the_root_makes_no_other_root() -> None:
    """A number that can't be distinguished from the root is the root."""
    assert found(lambda value: 1.0 - (value - ROOT) / 4.0, 1.001 * ROOT) is None


@pytest.mark.parametrize(("other", "seen"), [(70.0, True), (1e4, False)])
def test_another_root_far_beyond_the_range_is_seen(other: float, *, seen: bool) -> None:
    """A quadratic has another root at 70 times the first, as a launch so fast that it returns from the other side."""
    scan = UniquenessScan(Known(lambda value: value + other * ROOT**2 / value), ROOT, ROOT * (1.0 + other), MARGIN)  # type: ignore[arg-type]
    assert scan.find_other_root(VALUES) is None
    assert (scan.find_distant_root(far_from(VALUES, ROOT, "m/s")) is not None) is seen


def test_what_is_far_from_a_number_has_its_sign() -> None:
    both = (-5.0, -1.0, 0.0, 1.0, 5.0)
    assert {at < 0.0 for at in far_from(both, -2.0, "m")} == {True}
    assert max(map(abs, far_from(both, -2.0, "m"))) == pytest.approx(2000.0)
    assert far_from(both, 30.0, "deg") == []


def test_a_function_that_only_rises_has_one_root() -> None:
    assert found(lambda value: value**3) is None


@pytest.mark.parametrize(("depth", "other"), [(0.7, False), (1.1, True)])
def test_where_the_answer_swings_it_is_looked_at_more_closely(depth: float, *, other: bool) -> None:
    """From 8 on the result rises, but oscillates once in 1.5 steps of the scan, down to the given value if deep."""
    step = np.log(VALUES[1] / VALUES[0])

    def result(value: float) -> float:
        phase = np.pi * np.log(value / VALUES[0]) / (1.5 * step)
        return value / ROOT * (1.0 if value < 8.0 else 1.0 - depth * np.sin(phase) ** 8)

    assert all(result(value) > 1.0 for value in VALUES if value > ROOT)
    assert (found(result) is not None) is other


@dataclass
class Wayward(Known):
    """Magnitude that beyond 4 falls to zero at 11.6 and rises again, but has no value from 11.7 to 12.5."""

    def __call__(self, value: float) -> float | None:
        return None if 11.7 < value < 12.5 else self.result(value)

    def course(self, value: float) -> tuple[int, ...]:
        return () if self(value) is None else (int(value > 11.6),)


def test_where_a_magnitude_passes_through_zero_next_to_where_it_has_no_value() -> None:
    """The change of a counterweight's potential energy vanishes at balance, and just beyond takes too long."""
    result = Wayward(lambda value: value / ROOT if value < 4.0 else min(2.0, 10.0 * abs(value - 11.6)))
    at = UniquenessScan(result, ROOT, 1.0, MARGIN).find_other_root(VALUES)  # type: ignore[arg-type]
    assert at == pytest.approx(11.6, abs=0.11)


def test_which_way_coordinates_have_gone_belongs_to_what_happens() -> None:
    """An Atwood machine reverses where the masses are equal, without any event."""
    scene = atwood(left=3.0, right=2.0)
    query = Query("state", Target("velocity", "one.system.blocks.0"), AtTime(0.5))
    dependence = AnswerFunction(query, SimulatedScene(scene, simulate(scene)), "one.system.blocks.0.mass")
    heavier, heaviest, lighter = (dependence.course(mass) for mass in (2.5, 4.0, 1.5))
    assert heavier == heaviest != lighter


@pytest.mark.parametrize(
    ("ends", "edge"),
    [((0.5, 9.0), None), ((1.995, 9.0), 1.98), ((0.5, 2.005), 2.02), ((1.9, 2.1), None), ((-inf, inf), None)],
)
def test_where_results_end_close_to_the_root_is_told(ends: tuple[float, float], edge: float | None) -> None:
    scan = UniquenessScan(Known(lambda value: value, ends=ends), ROOT, ROOT, MARGIN)  # type: ignore[arg-type]
    assert scan.find_missing_answer(VALUES) == (edge if edge is None else pytest.approx(edge))


def test_the_end_of_a_range_is_no_edge() -> None:
    """A search for the root may begin or end there."""
    scan = UniquenessScan(Known(lambda value: value, ends=(0.0, ROOT)), ROOT, ROOT, MARGIN)  # type: ignore[arg-type]
    assert scan.find_missing_answer([0.2, 1.0, 2.001]) is None


@pytest.mark.parametrize(
    ("turn", "fall", "end"), [(90.0, 0.15, 100.0), (60.0, 0.8, 100.0), (20.0, 40.0, None), (200.0, 1.0, None)]
)
def test_a_root_just_behind_the_range_is_foreseen(turn: float, fall: float, end: float | None) -> None:
    """The result rises from 1 at the root up to a turn, and is back at 1 at (1 + `fall`) times the turn."""

    def result(value: float) -> float:
        peak = 1.0 + (turn - ROOT) / 10.0
        return 1.0 + (value - ROOT) / 10.0 if value < turn else peak - (peak - 1.0) * (value / turn - 1.0) / fall

    scan = UniquenessScan(Known(result), ROOT, 1.0, MARGIN)  # type: ignore[arg-type]
    assert scan.find_extrapolated_root(VALUES) == (end if end is None else pytest.approx(end))


def test_a_number_whose_answer_may_come_later_than_is_waited_is_not_excluded() -> None:
    late = VALUES[50]
    known = Known(lambda value: value, ends=(0.0, VALUES[49]), late=(late,))
    assert UniquenessScan(known, ROOT, ROOT, MARGIN).find_other_root(VALUES) == late  # type: ignore[arg-type]


def test_no_body_of_a_roomy_scene_reaches_a_pulley() -> None:
    """The text says that none does, so that a root hidden by the library's own lengths counts."""
    scene = half_atwood()
    reach = simulate(scene)
    assert reach.cut == "reach"
    later = 2.0 * reach.stable_until
    assert SimulatedScene.of(lengthen_strings(scene), np.array([0.0, later])).trace.stable_until == later

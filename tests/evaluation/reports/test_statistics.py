"""Tests of shares, intervals, pass@k, paired differences and rank correlation, by published values."""

from itertools import combinations
from math import isclose

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.evaluation.reports.results import difference, item_mean, pass_at, rank_correlation, wilson_interval


@pytest.mark.parametrize(
    ("right", "total", "low", "high"),
    [(81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0, 0.1611), (1, 29, 0.0061, 0.1718)],
)
def test_wilson_has_the_published_ends(right: int, total: int, low: float, high: float) -> None:
    """The values are those of method 3 in table I of Newcombe, Statistics in Medicine 17, 857 (1998)."""
    found = wilson_interval(right, total)
    assert (round(found.low, 4), round(found.high, 4)) == (low, high)


@given(total=st.integers(1, 2000), data=st.data())
def test_an_interval_holds_its_share_and_mirrors(total: int, data: st.DataObject) -> None:
    right = data.draw(st.integers(0, total))
    found, other = wilson_interval(right, total), wilson_interval(total - right, total)
    assert 0.0 <= found.low <= found.value <= found.high <= 1.0
    assert isclose(found.low, 1.0 - other.high, abs_tol=1e-12)


def test_shares_need_trials() -> None:
    for right, total in ((0, 0), (3, 2), (-1, 2)):
        with pytest.raises(ValueError, match="a share needs trials"):
            wilson_interval(right, total)


@given(st.lists(st.booleans(), min_size=1, max_size=9), st.integers(1, 9))
def test_pass_at_k_is_the_mean_over_all_choices(right: list[bool], k: int) -> None:
    points = [float(each) for each in right]
    found = pass_at([points], k)
    if k > len(right):
        assert found is None
    else:
        choices = list(combinations(points, k))
        assert found == pytest.approx(sum(max(choice) for choice in choices) / len(choices))


def test_partial_credit_passes_nothing_and_counts_in_the_mean() -> None:
    assert pass_at([[0.5, 0.75], [1.0, 0.0]], 1) == 0.25
    assert item_mean([[0.5, 0.75], [1.0, 0.0]]).value == 0.5625


def test_one_sample_each_has_wilsons_interval_and_more_have_a_bootstrap() -> None:
    assert item_mean([[1.0]] * 3 + [[0.0]] * 7) == wilson_interval(3, 10)
    found = item_mean([[1.0, 0.0]] * 50 + [[1.0, 1.0]] * 50)
    assert found.method == "bootstrap"
    assert found.value == 0.75
    half = 1.96 * 0.25 / 10.0
    assert found.low == pytest.approx(0.75 - half, abs=0.01)
    assert found.high == pytest.approx(0.75 + half, abs=0.01)


def test_where_all_items_are_alike_the_interval_is_not_a_point() -> None:
    found = item_mean([[1.0, 1.0]] * 10)
    assert (found.low, found.high) == (pytest.approx(1.0 - wilson_interval(0, 10).high), 1.0)
    same = difference([1.0] * 10, [1.0] * 10)
    assert same.low < 0.0 < same.high
    assert same.value == 0.0


def test_intervals_of_paired_differences_cover_the_truth() -> None:
    draws, truth, held = np.random.default_rng(1), 0.1, 0
    for _ in range(100):
        first = draws.random(100) < 0.5
        second = np.where(draws.random(100) < 0.2, True, first)  # gains 0.2 of what was wrong: 0.1 in the mean
        found = difference([*first.astype(float)], [*second.astype(float)])
        held += found.low <= truth <= found.high
    assert 88 <= held <= 100


def test_the_same_data_give_the_same_interval() -> None:
    values = [0.0, 0.5, 1.0, 0.25, 0.0, 1.0]
    assert item_mean([[v, v] for v in values]) == item_mean([[v, v] for v in values])


def test_rank_correlation_has_the_textbook_value() -> None:
    """Σd² = 194 for n = 10, IQ against hours of television: ρ = 1 - 6·194/990 = -29/165."""
    iq = [106, 86, 100, 101, 99, 103, 97, 113, 112, 110]
    hours = [7, 0, 27, 50, 28, 29, 20, 12, 6, 17]
    found = rank_correlation(iq, hours)
    assert found is not None
    assert found.value == pytest.approx(-29 / 165)
    assert -1.0 <= found.low < found.value < found.high <= 1.0


@given(st.lists(st.floats(-1e6, 1e6), min_size=4, max_size=30, unique=True))
def test_rank_correlation_sees_the_order_alone(values: list[float]) -> None:
    up = rank_correlation(values, [v**3 for v in values]) if len({v**3 for v in values}) == len(values) else None
    if up is not None:
        assert up.value == pytest.approx(1.0)
        assert up.low < 1.0 == up.high
    down = rank_correlation(values, [-v for v in values])
    assert down is not None
    assert down.value == pytest.approx(-1.0)


def test_ties_share_their_rank_and_too_little_is_nothing() -> None:
    found = rank_correlation([1, 2, 2, 3], [1, 2, 3, 4])
    assert found is not None
    assert found.value == pytest.approx(0.9486832980505138)  # of the ranks 1, 2.5, 2.5, 4 with 1, 2, 3, 4
    assert rank_correlation([1, 2], [1, 2]) is None
    assert rank_correlation([1, 1, 1], [1, 2, 3]) is None
    three = rank_correlation([1, 2, 3], [1, 2, 3])
    assert three is not None
    assert (three.low, three.high) == (-1.0, 1.0)

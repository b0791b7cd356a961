"""Tests of duplicates and near duplicates, which depend on the items alone."""

from collections.abc import Callable
from itertools import pairwise
from math import log, log1p
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fake_makers import steady
from sim2reason.datasets import duplicates
from sim2reason.datasets.build import build, build_part
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.duplicates import Marks, find_duplicates, variant
from sim2reason.datasets.manifest import Manifest, read_refusals
from sim2reason.datasets.plan import Config
from sim2reason.generation.item import Item
from sim2reason.generation.request import Request

Make = Callable[..., Manifest]
Contents = Callable[[Path], dict[str, bytes]]
Row = tuple[int, tuple[float, ...], int, int]
"""A problem, the sizes of its numbers, the words and the question."""

SIZES = st.sampled_from([1.0, 1.02, 1.04, 1.049, 1.051, 1.1, 1.5, 2.0, 100.0])
ROWS = st.lists(
    st.integers(0, 2).flatmap(
        lambda problem: st.tuples(
            st.just(problem), st.tuples(*[SIZES] * problem), st.integers(0, 12), st.integers(0, 12)
        )
    ),
    max_size=40,
)
SCENE = """scene:
  name: scene
  entities:
  - name: box
    type: MassBoxPlane
    parameters:
      box: {{mass: {mass}, friction: 0.0}}
      blocks:
      - {{mass: 1.4}}
      right: {{mass: 1.2}}
      length: {length}
  world: {{gravity: 9.8}}
"""


def shard(rows: list[tuple[int, Row]]) -> Marks:
    table = [(at, problem, len(sizes), words, 100 + asked) for at, (problem, sizes, words, asked) in rows]
    logarithms = [log(size) for _, (_, sizes, _, _) in rows for size in sizes]
    return Marks(np.array(table, np.uint64).reshape(len(rows), 5), np.array(logarithms, np.float32))


def left_out(rows: list[Row], distance: float, places: list[int] | None = None) -> dict[int, tuple[int, bool]]:
    places = list(range(len(rows))) if places is None else places
    parts = [[(at, rows[at]) for at in places if at // 7 == number] for number in range(-(-len(rows) // 7))]
    found = find_duplicates(lambda number: shard(parts[number]), len(parts), len(rows), distance)
    return {each.position: (each.first, each.alike) for _, held in found for each in held}


def expected(rows: list[Row], distance: float) -> dict[int, tuple[int, bool]]:
    """Return the dropped rows when each is compared with all earlier rows that stay."""
    gone: dict[int, tuple[int, bool]] = {}
    for at, (problem, sizes, words, asked) in enumerate(rows):
        stay = [place for place in range(at) if place not in gone]
        same = [place for column in (2, 3) for place in stay if rows[place][column] == (words, asked)[column - 2]]
        close = [place for place in stay if rows[place][0] == problem and _close(rows[place][1], sizes, distance)]
        if same or close:
            gone[at] = (same[0], False) if same else (close[0], True)
    return gone


def _close(left: tuple[float, ...], right: tuple[float, ...], distance: float) -> bool:
    pairs = zip(np.float32([log(x) for x in left]), np.float32([log(x) for x in right]), strict=True)
    return distance > 0.0 and all(abs(a - b) < np.float32(log1p(distance)) for a, b in pairs)


@settings(max_examples=60)
@given(ROWS, st.sampled_from([0.0, 0.03, 0.05, 0.6]))
def test_the_pass_leaves_out_what_comparing_all_pairs_does(rows: list[Row], distance: float) -> None:
    assert left_out(rows, distance) == expected(rows, distance)


@settings(max_examples=30)
@given(ROWS, st.data())
def test_the_pass_may_be_repeated_after_some_are_gone_and_grows(rows: list[Row], data: st.DataObject) -> None:
    gone = left_out(rows, 0.05)
    already = data.draw(st.sets(st.sampled_from(sorted(gone)))) if gone else set[int]()
    rest = [at for at in range(len(rows)) if at not in already]
    assert left_out(rows, 0.05, rest) == {at: gone[at] for at in gone if at not in already}
    first = rows[: data.draw(st.integers(0, len(rows)))]
    assert left_out(first, 0.05) == {at: gone[at] for at in gone if at < len(first)}


def test_stretches_of_problems_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(4)
    rows: list[Row] = [(n % 5, tuple(np.round(rng.uniform(1, 2, size=n % 5), 2).tolist()), n, n) for n in range(600)]
    whole = left_out(rows, 0.1)
    monkeypatch.setattr(duplicates, "HELD", 50)
    assert left_out(rows, 0.1) == whole == expected(rows, 0.1)
    assert 100 < len(whole) < 500


def item(**changes: object) -> Item:
    made = steady(Request("pulley", "easy", "numeric", 0, 0)).item
    assert made is not None
    return made.model_copy(update={"scene": SCENE.format(mass=1.0, length=3.6), **changes})


def test_numbers_that_no_text_says_keep_no_two_apart() -> None:
    longer = item(scene=SCENE.format(mass=1.0, length=3.9))
    heavier = item(scene=SCENE.format(mass=1.1, length=3.6))
    assert variant(longer) == variant(item())
    assert variant(heavier).problem == variant(item()).problem
    assert variant(heavier).logarithms != variant(item()).logarithms


def test_the_unknown_is_no_given_and_what_is_given_is_one() -> None:
    asked = item().asked.model_copy(update={"unknown": "box.box.mass", "given": 2.0})
    heavier = item(scene=SCENE.format(mass=2.0, length=3.6), asked=asked)
    assert variant(heavier) == variant(item(asked=asked))
    assert variant(item(asked=asked.model_copy(update={"given": 2.1}))) != variant(item(asked=asked))


def test_a_sign_and_a_zero_make_another_problem() -> None:
    answers = [item().answer.model_copy(update={"value": value}) for value in (2.0, -2.0, 0.0)]
    assert len({variant(item(answer=answer)).problem for answer in answers}) == 3


def test_what_is_too_close_is_left_out_and_told(make: Make, tmp_path: Path) -> None:
    manifest = make(maker="fake_makers:masses", items=25)
    kept = sorted(item.answer.value for item in Dataset(tmp_path / "data"))
    assert all(b / a > 1.0499 for a, b in pairwise(kept))
    found = list(read_refusals(tmp_path / "data", "variants"))
    assert manifest.refused["variants"].total == len(found) > 10
    assert found[0].reason.startswith("like ")
    counted = sum(counts["distinct: alike"] for counts in manifest.rejected.values())
    assert counted == len(found)
    whole = make("all", maker="fake_makers:masses", distance=0.0, items=25)
    assert whole.rows == manifest.rows == 25
    assert whole.positions < manifest.positions
    assert not whole.refused["variants"].total


def test_close_variants_do_not_hang_on_parts_growth_or_repairs(
    make: Make, config: Config, tmp_path: Path, contents: Contents
) -> None:
    config = config.model_copy(update={"maker": "fake_makers:masses"})
    whole = make("whole", maker="fake_makers:masses", items=30)
    assert whole.refused["variants"].total
    assert whole.refused["duplicates"].total
    small = make("grown", maker="fake_makers:masses", items=20).shards
    (tmp_path / f"grown/data/train-00001-of-{small:05}.parquet").unlink()
    make("grown", maker="fake_makers:masses", items=30)
    larger = config.model_copy(update={"items": 30})
    for part in (1, 0):
        build_part(tmp_path / "parts", larger, (part, 2), workers=1)
    build(tmp_path / "parts", larger, workers=1)
    assert contents(tmp_path / "grown") == contents(tmp_path / "parts") == contents(tmp_path / "whole")

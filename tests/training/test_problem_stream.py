"""Tests of the stream of problems: shares, cells, its position in checkpoints, and held-out problems."""

import json
from collections import Counter
from typing import Any

import pytest

from sim2reason.errors import TrainingError
from sim2reason.evaluation.benchmarks import BenchmarkItem
from sim2reason.training.problem_stream import Curriculum, ProblemStream, prefetching
from sim2reason.training.sources import Problem, ProblemSource
from sim2reason.training.sources.problems import Fresh


class Counting(ProblemSource):
    """Source of problems that are their own coordinates; every seventh request finds none."""

    held: tuple[str, ...] = ("easy", "hard")
    empty: bool = False

    @property
    def cells(self) -> tuple[str, ...]:
        return self.held

    def at(self, cell: str, index: int) -> Problem | None:
        if self.empty or index % 7 == 6:
            return None
        name = f"{self.name}-{cell}-{index}"
        item = BenchmarkItem(id=name, prompt=f"{name}?", scoring="numeric", reference={})
        return Problem(item=item, source=self.name, cell=cell)


def ids(rows: list[dict[str, Any]]) -> list[str]:
    return [json.loads(row["problem"])["item"]["id"] for row in rows]


def test_shares_hold_in_any_stretch() -> None:
    stream = ProblemStream([Counting(name="a", weight=3.0), Counting(name="b", weight=1.0, held=("one",))])
    drawn = ids(stream.next_prompts(400))
    assert len(set(drawn)) == 400
    for start in range(0, 400, 40):
        counts = Counter(name[0] for name in drawn[start : start + 40])
        assert abs(counts["a"] - 30) <= 2


def test_the_next_prompt_after_a_restore_is_the_one_that_would_have_come() -> None:
    whole = ProblemStream([Counting(name="a"), Counting(name="b")], curriculum=Curriculum())
    first = ids(whole.next_prompts(13))
    whole.observe(whole.next_prompts(1)[0], [1.0, 0.0, 1.0])
    place = json.loads(json.dumps(whole.state()))
    after = ids(whole.next_prompts(50))
    again = ProblemStream([Counting(name="a"), Counting(name="b")], curriculum=Curriculum())
    again.restore(place)
    assert ids(again.next_prompts(50)) == after
    assert not set(first) & set(after)


def test_a_curriculum_prefers_what_is_solved_sometimes() -> None:
    stream = ProblemStream([Counting(name="a")], curriculum=Curriculum(memory=0.5))
    for _ in range(200):
        row = stream.next_prompts(1)[0]
        right = json.loads(row["problem"])["cell"] == "easy"
        stream.observe(row, [float(right)] * 4 if right else [0.0, 1.0, 0.0, 1.0])
    shares = stream.shares()
    assert shares["a/hard"] == pytest.approx(1.2 / 1.4, abs=0.01)  # 0.2 + 4·½·½ against 0.2 + 0
    counts = Counter(json.loads(row["problem"])["cell"] for row in stream.next_prompts(140))
    assert abs(counts["hard"] - 120) <= 3


def test_what_is_held_out_is_passed_over() -> None:
    source = Counting(name="a", held=("easy",))
    stream = ProblemStream([source], avoid=frozenset({"a-easy-0?", "a-easy-2?"}))
    assert ids(stream.next_prompts(3)) == ["a-easy-1", "a-easy-3", "a-easy-4"]


def test_prefetched_problems_are_the_same() -> None:
    source = Fresh(name="drawn", recipe="pulley", difficulty="easy", seed=5)
    alone = ids(ProblemStream([source]).next_prompts(4))
    with prefetching(2, 4) as store:
        stream = ProblemStream([source], store)
        stream.begin()
        assert stream.cpu_seconds == 0.0
        assert ids(stream.next_prompts(4)) == alone
        assert stream.cpu_seconds > 0.0


def test_a_barren_source_is_an_error_that_names_it() -> None:
    stream = ProblemStream([Counting(name="a", empty=True)])
    with pytest.raises(TrainingError, match=r"a/easy gave nothing in 200 draws"):
        stream.next_prompts(1)


def test_a_probe_finds_a_barren_cell_and_moves_nothing() -> None:
    stream = ProblemStream([Counting(name="a"), Counting(name="b", weight=0.01, empty=True)])
    before = stream.state()
    with pytest.raises(TrainingError, match=r"b/easy gave nothing in 200 draws"):
        stream.probe()
    assert stream.state() == before


def test_faults_of_sources_and_places() -> None:
    with pytest.raises(TrainingError, match="'a' stands twice"):
        ProblemStream([Counting(name="a"), Counting(name="a")])
    stream = ProblemStream([Counting(name="a")])
    with pytest.raises(TrainingError, match="drawn from 'b/easy'"):
        stream.restore({"drawn": 3, "next": {"b/easy": 3}})
    with pytest.raises(TrainingError, match="place among the problems"):
        stream.restore({"drawn": "many"})

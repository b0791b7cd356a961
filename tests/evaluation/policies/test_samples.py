"""Tests of the journal of samples, and of requests for the missing ones."""

import threading
from collections.abc import Sequence
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import PrivateAttr

from sim2reason.errors import EvaluationError, PolicyError
from sim2reason.evaluation.policies import Completion, Policy, SampleRequest
from sim2reason.evaluation.policies.journal import SampleJournal, read_finished
from sim2reason.evaluation.policies.samples import MAX_FAILURES, NoAnswerError, ask, requests_for, sample_seed


class Parrot(Policy):
    """Policy that repeats the prompt, or fails on given prompts."""

    fails: tuple[str, ...] = ()
    stops: tuple[str, ...] = ()
    counted: bool = True
    width: int = 1
    _seen: list[SampleRequest] = PrivateAttr(default_factory=list)
    _lock: threading.Lock = PrivateAttr(default_factory=threading.Lock)

    @property
    def in_flight(self) -> int:
        return self.width

    def complete(self, requests: Sequence[SampleRequest]) -> Sequence[Completion]:
        with self._lock:
            self._seen.extend(requests)
        if any(request.id in self.fails for request in requests):
            raise NoAnswerError("nobody is there")
        if any(request.id in self.stops for request in requests):
            raise PolicyError("no more")
        tokens = 10 if self.counted else None
        return [
            Completion(text=r.prompt, finish="stop", prompt_tokens=tokens, completion_tokens=tokens) for r in requests
        ]


def prompts(count: int) -> list[tuple[str, str]]:
    return [(f"item-{n}", f"prompt {n}") for n in range(count)]


def run(path: Path, policy: Parrot, count: int = 5, samples: int = 2) -> int:
    with SampleJournal(path) as journal:
        return ask(policy, requests_for(prompts(count), samples, 0), journal).finished_now


def test_a_second_run_asks_only_for_what_is_missing(tmp_path: Path) -> None:
    path, policy = tmp_path / "j.jsonl", Parrot(name="p")
    assert run(path, policy, 3) == 6
    assert run(path, policy, 5) == 4
    assert len(policy._seen) == 10
    assert run(path, policy, 5) == 0
    held = list(read_finished(path))
    assert sorted(found.key for found in held) == sorted((f"item-{n}", s) for n in range(5) for s in range(2))
    assert all(found.seed == sample_seed(0, *found.key) for found in held)


def test_a_text_that_begins_within_the_thinking_says_so(tmp_path: Path) -> None:
    run(tmp_path / "plain.jsonl", Parrot(name="p"), 1, 1)
    run(tmp_path / "within.jsonl", Parrot(name="p", thinking_opened=True), 1, 1)
    plain, within = (next(iter(read_finished(tmp_path / f"{name}.jsonl"))).completion for name in ("plain", "within"))
    assert plain.whole == plain.text
    assert within.whole == f"<think>{within.text}"


@settings(max_examples=30)
@given(cut=st.integers(1, 4000))
def test_wherever_a_kill_cuts_the_last_lines_no_sample_is_lost_or_asked_twice(
    cut: int, tmp_path_factory: pytest.TempPathFactory
) -> None:
    path = tmp_path_factory.mktemp("cut") / "j.jsonl"
    run(path, Parrot(name="p"), 6, 2)
    whole = path.read_bytes()
    path.write_bytes(whole[: max(0, len(whole) - cut)])
    left = path.read_bytes().count(b"\n")
    policy = Parrot(name="p")
    assert run(path, policy, 6, 2) == len(policy._seen) == 12 - left
    assert sorted(path.read_bytes().splitlines()) == sorted(whole.splitlines())


def test_a_long_torn_line_is_cut_off(tmp_path: Path) -> None:
    path = tmp_path / "j.jsonl"
    run(path, Parrot(name="p"), 1, 1)
    whole = path.read_bytes()
    path.write_bytes(whole + b"x" * 200_000)
    with SampleJournal(path) as journal:
        assert len(journal) == 1
    assert path.read_bytes() == whole


def test_a_damaged_line_is_named_and_a_line_twice_too(tmp_path: Path) -> None:
    path = tmp_path / "j.jsonl"
    run(path, Parrot(name="p"), 3, 1)
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(lines[0] + b"{}\n" + lines[2])
    with pytest.raises(EvaluationError, match=r"j\.jsonl:2: damaged"):
        SampleJournal(path)
    path.write_bytes(lines[0] + lines[0])
    with pytest.raises(EvaluationError, match="a second time"):
        SampleJournal(path)
    path.write_bytes(lines[0])
    SampleJournal(path).__exit__(None, None, None)


def test_two_runs_do_not_share_a_journal_and_other_prompts_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "j.jsonl"
    with SampleJournal(path), pytest.raises(EvaluationError, match="another run"):
        SampleJournal(path)
    run(path, Parrot(name="p"))
    with SampleJournal(path) as journal, pytest.raises(EvaluationError, match="in other words"):
        ask(Parrot(name="p"), requests_for([("item-0", "other")], 1, 0), journal)
    with SampleJournal(path) as journal, pytest.raises(EvaluationError, match="in other words"):
        ask(Parrot(name="p"), requests_for(prompts(1), 1, seed=1), journal)


def test_what_gets_no_answer_stays_open_and_the_rest_goes_on(tmp_path: Path) -> None:
    with SampleJournal(tmp_path / "j.jsonl") as journal:
        done = ask(Parrot(name="p", fails=("item-1",)), requests_for(prompts(4), 2, 0), journal)
    assert (done.finished_now, done.open) == (6, ["nobody is there"] * 2)


def test_an_endpoint_that_is_down_or_refuses_ends_the_run_with_all_that_was_finished(tmp_path: Path) -> None:
    down = Parrot(name="p", fails=tuple(name for name, _ in prompts(90)[3:]))
    with SampleJournal(tmp_path / "a.jsonl") as journal, pytest.raises(PolicyError, match="in a row"):
        ask(down, requests_for(prompts(90), 1, 0), journal)
    assert len(down._seen) == 3 + MAX_FAILURES
    with SampleJournal(tmp_path / "b.jsonl") as journal, pytest.raises(PolicyError, match="no more"):
        ask(Parrot(name="p", stops=("item-3",), width=2), requests_for(prompts(90), 1, 0), journal)
    assert 3 <= len(list(read_finished(tmp_path / "b.jsonl"))) <= 6


@pytest.mark.parametrize("width", [1, 4])
def test_the_limit_on_tokens_is_never_passed_and_counts_all_runs(tmp_path: Path, width: int) -> None:
    settings = {"name": "p", "width": width, "sampling": {"max_tokens": 10}, "limits": {"tokens": 200}}
    policy = Parrot.model_validate(settings)
    for _ in range(2):
        with pytest.raises(PolicyError, match="its limit is reached"):
            run(tmp_path / "j.jsonl", policy, 20, 1)
    used = 20 * len(policy._seen)  # of which each sets 82 aside before it is sent
    assert 100 < used <= 200


def test_the_limit_on_cost_counts_what_nobody_counted_as_the_most(tmp_path: Path) -> None:
    limits = {"cost": 1e-3, "price_in": 1.0, "price_out": 2.0}
    policy = Parrot.model_validate({"name": "p", "counted": False, "sampling": {"max_tokens": 100}, "limits": limits})
    with pytest.raises(PolicyError, match="its limit is reached"):
        run(tmp_path / "j.jsonl", policy, 20, 1)
    assert len(policy._seen) == 3  # each 72 + 2 · 100 millionths


def test_seeds_differ_between_items_samples_and_runs() -> None:
    seeds = {sample_seed(run, f"i{n}", s) for run in range(3) for n in range(50) for s in range(8)}
    assert len(seeds) == 1200
    assert all(0 <= seed < 2**31 for seed in seeds)

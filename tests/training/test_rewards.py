"""Tests of rewards: the grader, controls, and calls by trainers."""

import pytest

from sim2reason.datasets.items import item
from sim2reason.errors import TrainingError, UnknownNameError
from sim2reason.evaluation.benchmarks.own import benchmark_item
from sim2reason.training.rewards import REWARDS, Reward, build_reward, reward_function
from sim2reason.training.sources import Problem


@pytest.fixture(scope="module")
def problem() -> Problem:
    return Problem(item=benchmark_item(item("pulley", "easy", seed=3)), source="ours", cell="easy")


def rewards(kind: str, problem: Problem, texts: list[object]) -> list[float | None]:
    found = build_reward(kind)
    assert isinstance(found, Reward)
    rows = [problem.row(chat=False)["problem"]] * len(texts)
    return reward_function(found)([problem.item.prompt] * len(texts), texts, problem=rows)


def said(problem: Problem, factor: float = 1.0) -> str:
    answer = problem.item.reference["answer"]
    assert isinstance(answer, dict)
    value = answer["value"]
    assert isinstance(value, float)
    return rf"\boxed{{{factor * value:.6g}}}"


def test_accuracy_pays_what_is_right(problem: Problem) -> None:
    messages = [{"role": "assistant", "content": said(problem)}]
    assert rewards("accuracy", problem, [said(problem), said(problem, 2.0), "?", messages]) == [1.0, 0.0, 0.0, 1.0]


def test_format_pays_what_can_be_read(problem: Problem) -> None:
    assert rewards("format", problem, [said(problem), said(problem, 2.0), "?"]) == [1.0, 1.0, 0.0]


def test_random_is_a_fair_coin_that_falls_the_same_again(problem: Problem) -> None:
    thrown = rewards("random", problem, ["?"] * 2000)
    assert thrown == rewards("random", problem, [said(problem)] * 2000)
    assert abs(sum(map(float, filter(None, thrown))) - 1000) < 4 * 500**0.5  # four standard deviations


@pytest.mark.parametrize("kind", list(REWARDS))
@pytest.mark.parametrize("hostile", ["", "\x00" * 1000, r"\boxed{" * 500, r"\boxed{9**9**9**9}", "𝟙" * 10_000])
def test_no_reward_fails_on_hostile_text(kind: str, hostile: str, problem: Problem) -> None:
    (found,) = rewards(kind, problem, [hostile])
    assert found in {0.0, 1.0}


def test_a_reward_has_a_known_kind_and_settings() -> None:
    with pytest.raises(UnknownNameError, match="among rewards"):
        build_reward("acuracy")
    with pytest.raises(TrainingError, match=r"reward\.seed"):
        build_reward({"kind": "random", "seed": -1})
    with pytest.raises(TrainingError, match=r"reward\.kind"):
        build_reward({"seed": 1})

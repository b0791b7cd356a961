"""Tests of the messages about invalid settings."""

from typing import Annotated, Literal

import pytest
from annotated_types import Ge, Gt, Le
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sim2reason.base import registry
from sim2reason.base.registry import Registry
from sim2reason.base.settings import build_member, first_fault
from sim2reason.errors import EvaluationError, TrainingError, UnknownNameError
from sim2reason.evaluation.benchmarks.runs.config import build_evaluation
from sim2reason.training.rl.config import build_reinforcement_learning


class Inner(BaseModel):
    model_config = ConfigDict(extra="forbid")

    prompts: Annotated[int, Ge(1), Le(9)] = 1
    max_tokens: int = 5


class Outer(BaseModel):
    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)

    inner: Inner = Inner()
    rows: tuple[Inner, ...] = ()
    maybe: Inner | None = None
    rate: Annotated[float, Gt(0.0)] = 1.0
    precise: bool = False
    mode: Literal["fast", "slow"] = "fast"
    name: Annotated[str, Field(max_length=4)] = "name"
    needed: int


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"ned": 1}, "needed: is missing"),
        ({"inner": {"max_token": 1}}, "inner.max_token: no such setting; did you mean: max_tokens"),
        ({"rows": [{}, {"zzz": 1}]}, "rows.1.zzz: no such setting; there are: prompts, max_tokens"),
        ({"maybe": {"Prompt": 1}}, "maybe.Prompt: no such setting; did you mean: prompts"),
        ({"inner": {"prompts": "many"}}, "inner.prompts: must be an integer"),
        ({"inner": {"prompts": 1.5}}, "inner.prompts: must be an integer"),
        ({"inner": {"prompts": 0}}, "inner.prompts: must be at least 1"),
        ({"inner": {"prompts": 10}}, "inner.prompts: must be at most 9"),
        ({"inner": 3}, "inner: must be a mapping of names to values"),
        ({"rows": 3}, "rows: must be a list"),
        ({"rate": "x"}, "rate: must be a number"),
        ({"rate": float("inf")}, "rate: must be a finite number"),
        ({"rate": 0}, "rate: must be greater than 0.0"),
        ({"precise": "perhaps"}, "precise: must be true or false"),
        ({"mode": "quick"}, "mode: must be 'fast' or 'slow'"),
        ({"name": 3}, "name: must be a text"),
        ({"name": "a long one"}, "name: must have at most 4 characters"),
    ],
)
def test_a_fault_is_told_in_the_words_of_the_file(settings: dict[str, object], message: str) -> None:
    needed: dict[str, object] = {} if "ned" in settings else {"needed": 1}
    with pytest.raises(ValidationError) as refused:
        Outer.model_validate({**needed, **settings})
    assert first_fault(refused.value, Outer) == message


def test_without_a_model_no_names_are_listed() -> None:
    with pytest.raises(ValidationError) as refused:
        Outer.model_validate({"needed": 1, "other": 2})
    assert first_fault(refused.value) == "other: no such setting"


def test_an_unknown_kind_has_its_location(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "_further", [])  # workers of later tests need not know the member
    kinds: Registry[type[Inner]] = Registry("base")
    kinds.add("inner", Inner)
    with pytest.raises(
        UnknownNameError, match=r"^rows\[2\]\.kind: no such name among base: 'iner'; did you mean: inner$"
    ):
        build_member(kinds, {"kind": "iner"}, "rows[2]", EvaluationError)
    with pytest.raises(EvaluationError, match=r"^rows\[2\]\.promts: no such setting; did you mean: prompts$"):
        build_member(kinds, {"kind": "inner", "promts": 1}, "rows[2]", EvaluationError)


def test_configurations_name_the_settings_that_exist() -> None:
    problems = [{"kind": "fresh", "name": "ours", "seed": 1}]
    run = {"out": "run", "model": {"kind": "scratch"}, "problems": problems}
    with pytest.raises(TrainingError, match=r"^gspo\.max_tokens: no such setting; did you mean: .*max_prompt_tokens"):
        build_reinforcement_learning({**run, "reward": "accuracy", "gspo": {"max_tokens": 4}})
    with pytest.raises(UnknownNameError, match=r"^reward\.kind: no such name among rewards: 'acc'; "):
        build_reinforcement_learning({**run, "reward": "acc"})
    with pytest.raises(EvaluationError, match=r"^polices: no such setting; did you mean: policies$"):
        build_evaluation({"out": "run", "policies": [{"kind": "oracle"}], "benchmarks": [{"name": "b"}], "polices": []})

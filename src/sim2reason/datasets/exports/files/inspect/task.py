"""An Inspect task: physics problems, graded by sim2reason. `inspect eval task.py --model … -T split=test`."""

from pathlib import Path

from inspect_ai import Task, task
from inspect_ai.dataset import json_dataset
from inspect_ai.scorer import CORRECT, INCORRECT, Score, Scorer, Target, accuracy, grouped, scorer, stderr
from inspect_ai.solver import TaskState, generate

from sim2reason.rewards import score

DATA = Path(__file__).resolve().parent / "data"


@task
def sim2reason(split: str = "test") -> Task:
    """The problems of a split."""
    return Task(dataset=json_dataset(str(DATA / f"{split}.jsonl")), solver=generate(), scorer=physics())


@scorer(metrics=[accuracy(), stderr(), grouped(accuracy(), "recipe", all=False)])
def physics() -> Scorer:
    """Right or wrong by the boxed answer; the explanation says what was read and what was expected."""

    async def graded(state: TaskState, target: Target) -> Score:
        del target
        grade = score(state.metadata["ground_truth"], state.output.completion)
        value = CORRECT if grade.reward else INCORRECT
        return Score(value=value, answer=str(grade.parsed), explanation=grade.why, metadata={"outcome": grade.outcome})

    return graded

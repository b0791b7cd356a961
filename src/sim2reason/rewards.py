"""Reward functions for trainers and benchmarks, all of which use one grader.

Each row of an export holds the right answer as one JSON text, its *ground truth*: the answer of an item, or the
letter of a multiple choice. The functions here read it, and are pure: any thread or process may call them. A *solution*
is always a worked one, which no reward reads.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import cast
from warnings import warn

from pydantic import TypeAdapter, ValidationError

from sim2reason.datasets.exports.columns import Letter, answered, boxed, ground_truth
from sim2reason.datasets.grade import row_answer
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Answer, grade_answer
from sim2reason.grading import Score, choice, opened

__all__ = [
    "Letter",
    "accuracy",
    "accuracy_with",
    "answered",
    "boxed",
    "compute_score",
    "ground_truth",
    "partial_accuracy",
    "score",
]

SHOWN = 80  # characters of a text that is no ground truth


_GROUND_TRUTH: TypeAdapter[Answer | Letter] = TypeAdapter(Answer | Letter)


def score(ground_truth: str, response: object, *, partial: bool = False, thinking_opened: bool = False) -> Score:
    """Grade a response, which is a text or a list of messages, by a row's ground truth.

    With `partial`, a response to a problem of several parts is paid the share of the parts that are right. Where the
    prompt ended within the thinking, as by a chat template, `thinking_opened` says so.

    Raises:
        DatasetError: the ground truth is unreadable.
    """
    return _scored(_read(ground_truth), response, partial=partial, thinking_opened=thinking_opened)


def _scored(right: Answer | Letter, response: object, *, partial: bool, thinking_opened: bool) -> Score:
    said = opened(response) if thinking_opened else response
    if isinstance(right, Letter):
        return choice(said, right.letter, right.letters)
    return grade_answer(right, said, partial=partial)


Columns = Sequence[object] | None
Reward = Callable[..., list[float | None]]


def accuracy(
    prompts: Sequence[object],
    completions: Sequence[object],
    *,
    ground_truth: Columns = None,
    answer: Columns = None,
    **columns: object,
) -> list[float | None]:
    r"""Return a reward of 1 or 0 for each completion, as the trainers of TRL expect.

    The right answers are in the column `ground_truth` of an export, or in the column `answer` of a dataset. If no row
    of a batch has one, a warning says so.

    Args:
        prompts: Prompts of the batch (n,); not used.
        completions: Completions (n,), each a text or a list of messages.
        ground_truth: Right answers (n,) as JSON, as `sim2reason export` writes them.
        answer: Right answers (n,) as mappings, as `sim2reason generate` writes them.
        columns: Further columns of the batch; not used.

    Returns:
        The rewards (n,). A row without a right answer, as in another dataset of a mixture, has None, which TRL leaves
        out.

    Examples:
        >>> import sim2reason
        >>> from sim2reason.rewards import accuracy, ground_truth
        >>> problem = sim2reason.item("pulley", "easy")
        >>> right = ground_truth(problem)
        >>> accuracy([problem.prompt] * 2, [r"\boxed{4.41}", r"\boxed{0}"], ground_truth=[right] * 2)
        [1.0, 0.0]
    """
    del prompts, columns
    return _rewards(completions, ground_truth, answer, partial=False, thinking_opened=False)


def partial_accuracy(
    prompts: Sequence[object],
    completions: Sequence[object],
    *,
    ground_truth: Columns = None,
    answer: Columns = None,
    **columns: object,
) -> list[float | None]:
    """Return rewards like `accuracy`, but the share of right parts for a problem of several parts."""
    del prompts, columns
    return _rewards(completions, ground_truth, answer, partial=True, thinking_opened=False)


def accuracy_with(*, partial: bool = False, thinking_opened: bool = False) -> Reward:
    """Return a reward function for TRL with the settings of `score`."""

    def accuracy(prompts: Sequence[object], completions: Sequence[object], **columns: Columns) -> list[float | None]:
        del prompts
        rights = columns.get("ground_truth"), columns.get("answer")
        return _rewards(completions, *rights, partial=partial, thinking_opened=thinking_opened)

    return accuracy


def _rewards(
    completions: Sequence[object], ground_truth: Columns, answer: Columns, *, partial: bool, thinking_opened: bool
) -> list[float | None]:
    none: list[object] = [None] * len(completions)
    columns = zip(none if ground_truth is None else ground_truth, none if answer is None else answer, strict=True)
    rights = [_right(*row) for row in columns]
    if completions and not any(rights):
        warn(
            "no row of this batch says what is right: give the column ground_truth of sim2reason export, "
            "or the column answer of a dataset of sim2reason generate",
            stacklevel=3,
        )
    pairs = zip(rights, completions, strict=True)
    return [
        _scored(right, said, partial=partial, thinking_opened=thinking_opened).reward if right else None
        for right, said in pairs
    ]


def _right(*columns: object) -> Answer | Letter | None:
    """Return the reference answer in the columns of a row; None if they are not columns of this library."""
    for held in columns:
        try:
            if isinstance(held, str):
                return _read(held)
            if isinstance(held, Mapping):
                return row_answer({"answer": cast("Mapping[str, object]", held)})
        except DatasetError:
            continue
    return None


def compute_score(
    data_source: str,
    solution_str: str,
    ground_truth: str,
    extra_info: object = None,
    *,
    thinking_opened: bool = False,
    **settings: object,
) -> float:
    """Return a reward of 1 or 0 for one response, as verl expects; DatasetError if the ground truth is unreadable.

    `thinking_opened` comes from ``reward_kwargs``, and says that prompts end within the thinking.
    """
    del data_source, extra_info, settings
    return score(ground_truth, solution_str, thinking_opened=thinking_opened).reward


@lru_cache(maxsize=1024)
def _read(ground_truth: str) -> Answer | Letter:
    """Parse a ground truth, cached for all completions of a prompt; DatasetError if the text is unreadable."""
    try:
        return _GROUND_TRUTH.validate_json(ground_truth)
    except ValidationError:
        why = "is no ground truth of sim2reason; give the column that sim2reason export has written"
        raise DatasetError(f"{str(ground_truth)[:SHOWN]!r} {why}") from None

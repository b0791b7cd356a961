"""Tests of rows drawn from a stream, and of the errors for unusable rows."""

from typing import Any

import pytest

from gspo_run import Numbers
from sim2reason.errors import TrainingError
from sim2reason.training.gspo.settings import draw


class Given(Numbers):
    """Stream of the given rows."""

    def __init__(self, *rows: dict[str, Any]) -> None:
        super().__init__(len(rows))
        self.rows = rows

    def row(self, number: int) -> dict[str, Any]:
        return self.rows[number]


def test_prompts_that_do_not_fit_are_passed_over_and_read() -> None:
    stream = Numbers()
    drawn = draw(stream, 4, lambda row: row["number"] % 2 == 0)
    assert [row["number"] for row in drawn.rows] == [0, 2, 4, 6]
    assert (drawn.read, stream.state(), drawn.exhausted) == (7, 7, False)


def test_the_end_of_a_stream_is_told() -> None:
    drawn = draw(Numbers(3), 4, lambda _: True)
    assert (len(drawn.rows), drawn.read, drawn.exhausted) == (3, 3, True)


def test_all_rows_get_all_columns() -> None:
    drawn = draw(Numbers(mixed=True), 2, lambda _: True)
    assert [(row["ground_truth"], row["other"]) for row in drawn.rows] == [(None, "even"), ("odd", None)]


def test_a_stream_none_of_whose_prompts_fit_is_an_error() -> None:
    with pytest.raises(TrainingError, match=r"only 0 of .* raise max_prompt_tokens"):
        draw(Numbers(), 2, lambda _: False)


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ([{"question": "?"}], "a row without a prompt, with the columns question"),
        ([{"prompt": ""}], "a row without a prompt"),
        ([{"prompt": "?", "image": 1}], "'image'"),
        ([{"prompt": "?"}, {"prompt": [{"role": "user", "content": "?"}]}], "in one form"),
    ],
)
def test_rows_that_cannot_be_used_are_named(rows: list[dict[str, Any]], said: str) -> None:
    with pytest.raises(TrainingError, match=said):
        draw(Given(*rows), 2, lambda _: True)


def test_a_stream_that_gives_more_than_asked_for_is_an_error() -> None:
    class Generous(Numbers):
        def next_prompts(self, count: int) -> list[dict[str, Any]]:
            return super().next_prompts(count + 1)

    with pytest.raises(TrainingError, match="3 rows where 2"):
        draw(Generous(), 2, lambda _: True)

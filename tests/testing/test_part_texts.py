"""Tests of faults that can be found from the text of a multipart solution alone."""

import pytest

from sim2reason.testing.solution_text import part_faults

RIGHT = r"""(a) Given: $m = 2.0000\ \text{kg}$.

(1) The block, down the slope: $F = m a$.

The time is $t_1 = 3.0000\ \text{s}$.

Answer: $t_1 \approx 3.00\ \text{s}$.

(b) Given: $t = 5.0000\ \text{s}$.

From part (a), $t_1 = 3.0000\ \text{s}$.

So $t_2 = t - t_1 = 2.0000\ \text{s}$.

(2) The load: $F = 2\,m a$.

Answer: $t_2 \approx 2.00\ \text{s}$.

Answers: $\boxed{(a) 3.00; (b) 2.00}$."""


def test_a_text_with_clear_names_has_no_faults() -> None:
    assert [fault for fault in part_faults(RIGHT) if "F" not in fault] == []


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ("(a), $t_1", "(a), $t_3", "part (a) does not say t_3 = 3.0000"),
        ("(a), $t_1 = 3.0", "(a), $t_1 = 3.1", "part (a) does not say t_1 = 3.1"),
        ("$t = 5.0000", "$t_1 = 5.0000", "does not hold: t_1 = 5.0000"),
        ("(2) The", "(1) The", "(1) stands for two equations"),
    ],
)
def test_names_and_labels_for_two_things_are_found(old: str, new: str, fault: str) -> None:
    assert any(found.startswith(fault) for found in part_faults(RIGHT.replace(old, new)))

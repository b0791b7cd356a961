"""The published cases of the grader, and the verdict on one of them."""

import json
from pathlib import Path

from sim2reason.grading import Score, formula, number

LINES = (Path(__file__).parents[1] / "grading" / "cases.jsonl").read_text(encoding="utf-8").splitlines()
CASES: list[dict[str, str]] = [json.loads(line) for line in LINES]


def grade(case: dict[str, str]) -> Score:
    """The score of a case; a numeric reference is a number, with its unit after a space if it is known."""
    if case["kind"] == "numeric":
        value, _, unit = case["reference"].partition(" ")
        return number(case["response"], float(value), unit or None)
    return formula(case["response"], case["reference"])


def verdict(case: dict[str, str]) -> str:
    """The whole score as text, to be compared across threads and processes."""
    return repr(grade(case))

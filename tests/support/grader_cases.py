"""The published cases of the grader, and the verdict on one of them."""

import json
from pathlib import Path

from sim2reason.grading import Score, formula, number

DATA = Path(__file__).parents[1] / "grading"
FILES = "cases.jsonl", "cases_attack.jsonl", "cases_own.jsonl"  # the policy, what attack and models taught, our own
CASES: list[dict[str, str]] = [
    json.loads(line) for name in FILES for line in (DATA / name).read_text(encoding="utf-8").splitlines()
]
REFUSALS: dict[str, str] = json.loads((DATA / "refusals.json").read_text(encoding="utf-8"))
"""Cases that are honest and not read all the same, by id, with the reason."""


def grade(case: dict[str, str]) -> Score:
    """The score of a case; a numeric reference is a number, with its unit after a space if it is known."""
    if case["kind"] == "numeric":
        value, _, unit = case["reference"].partition(" ")
        return number(case["response"], float(value), unit or None, positive=case.get("positive", ""))
    return formula(case["response"], case["reference"])


def verdict(case: dict[str, str]) -> str:
    """The whole score as text, to be compared across threads and processes."""
    return repr(grade(case))

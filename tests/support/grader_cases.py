"""Published cases of the grader, and the verdict on one of them."""

import json
from pathlib import Path

from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.grading import Outcome, Score, formula, number

DATA = Path(__file__).parents[1] / "grading"
FILES = "cases.jsonl", "cases_attack.jsonl", "cases_reports.jsonl", "cases_own.jsonl"
"""The policy, what attack and models taught, what public bug reports of other graders taught, our own."""
CASES: list[dict[str, str]] = [
    json.loads(line) for name in FILES for line in (DATA / name).read_text(encoding="utf-8").splitlines()
]
REFUSALS: dict[str, str] = json.loads((DATA / "refusals.json").read_text(encoding="utf-8"))
"""Cases that are honest and not read all the same, by id, with the reason."""


def grade(case: dict[str, str]) -> Score:
    """Return the score of a case; a numeric reference is a number, with its unit after a space if it is known.

    The kind *lenient* is numeric without a box; *scoring:RULE* is scored by a benchmark's rule.
    """
    kind, _, rule = case["kind"].partition(":")
    if kind in {"numeric", "lenient"}:
        value, _, unit = case["reference"].partition(" ")
        lenient, positive = kind == "lenient", case.get("positive", "")
        return number(case["response"], float(value), unit or None, positive=positive, lenient=lenient)
    if kind == "scoring":
        award = SCORINGS[rule].award(case["response"], json.loads(case["reference"]))
        outcome = Outcome.CORRECT if award.points == 1.0 else Outcome.WRONG
        return Score.of(outcome, award.parsed, award.why or f"by the rule {rule}")
    return formula(case["response"], case["reference"])


def verdict(case: dict[str, str]) -> str:
    """Return the whole score as text, for comparisons across threads and processes."""
    return repr(grade(case))

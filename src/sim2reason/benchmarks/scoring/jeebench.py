"""JEEBench: one option, several options with partial credit, an integer, a number.

Arora, Singh and Mausam, *Have LLMs Advanced Enough?* (EMNLP 2023), and their ``compute_metrics.py``. One point for
the right set of options; of several options a quarter for each right one, if none is wrong; an integer exactly; a
number within 0.01.
"""

from fractions import Fraction

from sim2reason.benchmarks.scoring import SCORINGS, Award, Reference, Scoring
from sim2reason.benchmarks.scoring.parts.answers import boxes, in_box
from sim2reason.benchmarks.scoring.parts.letters import chosen, said_without_box
from sim2reason.grading import number

__all__ = ["JEEBench"]

WITHIN = Fraction(1, 100)
QUARTER = 0.25
ROUNDING = Fraction(1, 10**9)  # of numbers that were computed from fractions and roots, in floats
ONE, SEVERAL, INTEGER, NUMERIC = "MCQ", "MCQ(multiple)", "Integer", "Numeric"
TYPES = ONE, SEVERAL, INTEGER, NUMERIC


class JEEBench(Scoring):
    """By JEEBench's own rule: its four types of question, partial credit among them."""

    def award(self, response: str, reference: Reference) -> Award:
        """By the reference's `type` and `answer`."""
        answer = str(reference["answer"])
        if reference["type"] in {ONE, SEVERAL}:
            return _options(response, frozenset(answer), partial=reference["type"] == SEVERAL)
        return _number(response, answer, exact=reference["type"] == INTEGER)


def _options(response: str, right: frozenset[str], *, partial: bool) -> Award:
    found = boxes(response)
    said = chosen(found[-1]) if found else said_without_box(response)
    if said is None:
        return Award.unreadable("no options in the box" if found else "no box and no answer in words")
    named = "".join(sorted(said))
    if said == right:
        return Award(1.0, parsed=named)
    if partial and said <= right:
        return Award(QUARTER * len(said), parsed=named, why=f"{len(said)} of {len(right)} right options, none wrong")
    return Award(0.0, parsed=named, why=f"the right options are {''.join(sorted(right))}")


def _number(response: str, answer: str, *, exact: bool) -> Award:
    found = boxes(response)
    score = number(in_box(found[-1]) if found else response, float(answer), lenient=True)
    if not isinstance(score.parsed, float):
        return Award.unreadable(score.why)
    # Decimals as they are written: in floats 0.76 is farther than 0.01 from 0.75.
    said, right = Fraction(repr(score.parsed)), Fraction(answer)
    good = abs(said - right) <= (ROUNDING * max(1, abs(right)) if exact else WITHIN + ROUNDING)
    return Award.all_or_nothing(good, f"{score.parsed:g}", "" if good else f"the right number is {answer}")


SCORINGS.add("jeebench", JEEBench())

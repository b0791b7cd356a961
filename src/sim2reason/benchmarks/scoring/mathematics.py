"""Answers of AIME and MATH: equal as mathematics.

Numbers and expressions that our grammar reads are compared here, by value; only the rest, such as sets, intervals and
matrices, goes to the library math-verify, in a process that can be killed. Alone it takes capital for small letters,
drops a unit's letter, and holds tiny numbers for equal.
"""

import re
from typing import Final

from sim2reason.benchmarks.scoring import SCORINGS, Award, Reference, Scoring
from sim2reason.benchmarks.scoring.parts.answers import boxes, in_box
from sim2reason.benchmarks.scoring.parts.expressions import equal_expressions, is_equation
from sim2reason.benchmarks.scoring.parts.killable import Killable
from sim2reason.benchmarks.scoring.parts.numbers import agrees, read
from sim2reason.benchmarks.scoring.parts.verify_math import verified
from sim2reason.lazy import cached_property

__all__ = ["MathVerify"]

PATIENCE = 10.0  # s for one answer
EQUAL = 1e-6  # relative, of two numbers

_COMMAND: Final = re.compile(r"\\[A-Za-z]+")
_NAMED: Final = re.compile(r"[A-Za-z]{3,}")  # an answer in words
_LETTER: Final = re.compile(r".*[0-9.)}\s][A-Za-z]")  # 3g is no three grams in mathematics
_UNSOLVED: Final = re.compile(r"[^=]*(?:[0-9+*/^]|\\(?:d?frac|sqrt)(?![A-Za-z])|-)[^=]*=")


class MathVerify(Scoring):
    """Scoring by value where our grammar reads both answers, else by math-verify. Needs: pip install math-verify."""

    needs = ("math_verify",)

    @cached_property
    def _verified(self) -> Killable[tuple[bool, bool, str]]:
        return Killable(verified, PATIENCE)

    def award(self, response: str, reference: Reference) -> Award:
        """By the reference's `answer`, a text in LaTeX."""
        self.check()
        found = boxes(response)
        if not found:
            return Award.unreadable("there is no box")
        answer = str(reference["answer"])
        ours = _equal(answer, found[-1])
        if ours is not None:
            return Award.all_or_nothing(ours, found[-1], "" if ours else f"the answer is {answer}")
        result = self._verified(in_box(answer), in_box(found[-1]))
        if result is None:
            return Award.unreadable(f"math-verify gave no answer within {PATIENCE:g} s")
        readable, equal, _ = result
        return Award(float(equal), readable, found[-1], "" if equal else f"the answer is {answer}")


def _equal(answer: str, said: str) -> bool | None:
    """Return whether two answers are equal by the project's own grammar; None if the grammar cannot tell."""
    if "%" in answer + said or _NAMED.search(_COMMAND.sub(" ", answer)):
        return None
    if read(answer) is None or _LETTER.fullmatch(answer):
        return None if is_equation(answer) else equal_expressions(answer, said)
    if read(said) is not None:
        return agrees(answer, said, EQUAL)
    return False if _UNSOLVED.match(said) else None


SCORINGS.add("math", MathVerify())

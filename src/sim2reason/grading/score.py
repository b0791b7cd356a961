"""Scores: the reward, the outcome, the parsed value, and an explanation."""

from dataclasses import dataclass
from enum import StrEnum

__all__ = ["Outcome", "Refused", "Score"]

MAX_SHOWN_LENGTH = 80  # characters of the parsed value in a repr


class Outcome(StrEnum):
    """The outcomes of grading; only `CORRECT`, or correct parts under partial credit, earn a reward."""

    CORRECT = "correct"
    WRONG = "wrong"
    WRONG_UNIT = "wrong unit"
    NO_ANSWER = "no answer"
    UNREADABLE = "unreadable"
    TOO_LONG = "too long"


@dataclass(frozen=True, slots=True)
class Score:
    r"""The result of grading one response.

    Attributes:
        reward: 1 for a right answer and 0 for any other; with partial credit, the share of the right parts.
        outcome: How the response ended: ``correct``, ``wrong``, ``wrong unit``, ``no answer``, ``unreadable`` or
            ``too long``.
        parsed: The value that was read: a number in the requested unit, the text of a formula, or None.
        why: The reason in words.
        parts: Scores of the parts of a problem with several; empty otherwise.

    Examples:
        >>> from sim2reason.grading import number
        >>> score = number(r"\boxed{9.81}", 9.8)
        >>> score
        <Score 1: correct, parsed=9.81>
        >>> print(score)
        correct (reward 1): the answer is 9.81; expected 9.8 within 5 %
    """

    reward: float
    outcome: Outcome
    parsed: float | str | None
    why: str
    parts: tuple["Score", ...] = ()

    @classmethod
    def of(cls, outcome: Outcome, parsed: float | str | None, why: str) -> "Score":
        """Return a score with reward 1 for a correct answer, else 0.

        Args:
            outcome: The outcome.
            parsed: The value that was read, or None.
            why: The reason in words.

        Returns:
            The score, without parts.
        """
        return cls(1.0 if outcome is Outcome.CORRECT else 0.0, outcome, parsed, why)

    def __repr__(self) -> str:
        """Return the reward, the outcome, the parsed value, and the number of parts if there are several."""
        parsed = repr(self.parsed)
        shown = parsed if len(parsed) <= MAX_SHOWN_LENGTH else f"{parsed[: MAX_SHOWN_LENGTH - 1]}…"
        parts = f", parts={len(self.parts)}" if self.parts else ""
        return f"<Score {self.reward:g}: {self.outcome}, parsed={shown}{parts}>"

    def __str__(self) -> str:
        """Return the outcome, the reward and the reason."""
        return f"{self.outcome} (reward {self.reward:g}): {self.why}"


class Refused(Exception):  # noqa: N818 - a verdict that travels up the parser, not an error of the library
    """An exception for an answer that earns reward 0 whatever else it contains, with its outcome and reason."""

    def __init__(self, outcome: Outcome, why: str) -> None:
        """Store the outcome and the reason for the `Score`."""
        self.outcome, self.why = outcome, why
        super().__init__(why)

    @property
    def score(self) -> Score:
        """Return the score of the refused response."""
        return Score.of(self.outcome, None, self.why)

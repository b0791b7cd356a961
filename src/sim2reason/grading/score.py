"""What a grade is: a reward, the outcome that explains it, what was read, and a sentence for people."""

from dataclasses import dataclass
from enum import StrEnum

__all__ = ["Outcome", "Refused", "Score"]

SHOWN = 80  # characters of what was read that a repr shows


class Outcome(StrEnum):
    """How a response ended; only `CORRECT` is paid, but for the right parts of a problem that is graded in part."""

    CORRECT = "correct"
    WRONG = "wrong"
    WRONG_UNIT = "wrong unit"
    NO_ANSWER = "no answer"
    UNREADABLE = "unreadable"
    TOO_LONG = "too long"


@dataclass(frozen=True, slots=True)
class Score:
    """The grade of one response.

    `parsed` is what was read: a number in the asked unit, the text of a formula, or None if nothing was. Where a
    problem has several parts, `parts` are their scores.
    """

    reward: float
    outcome: Outcome
    parsed: float | str | None
    why: str
    parts: tuple["Score", ...] = ()

    @classmethod
    def of(cls, outcome: Outcome, parsed: float | str | None, why: str) -> "Score":
        """Return a score with a reward of 1 for a correct answer and of 0 for any other."""
        return cls(1.0 if outcome is Outcome.CORRECT else 0.0, outcome, parsed, why)

    def __repr__(self) -> str:
        """Return the reward, the outcome, the value read, and the number of parts if there are several."""
        parsed = repr(self.parsed)
        shown = parsed if len(parsed) <= SHOWN else f"{parsed[: SHOWN - 1]}…"
        parts = f", parts={len(self.parts)}" if self.parts else ""
        return f"<Score {self.reward:g}: {self.outcome}, parsed={shown}{parts}>"

    def __str__(self) -> str:
        """Return the outcome, the reward and the reason."""
        return f"{self.outcome} (reward {self.reward:g}): {self.why}"


class Refused(Exception):  # noqa: N818 - a verdict that travels up the parser, not an error of the library
    """An answer that earns nothing however the rest of it reads."""

    def __init__(self, outcome: Outcome, why: str) -> None:
        """Keep the verdict that the caller turns into a `Score`."""
        self.outcome, self.why = outcome, why
        super().__init__(why)

    @property
    def score(self) -> Score:
        """The grade that this refusal stands for."""
        return Score.of(self.outcome, None, self.why)

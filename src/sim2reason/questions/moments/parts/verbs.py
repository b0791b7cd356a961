"""The words for what happens: a verb in its forms, the first time or a later one."""

from dataclasses import dataclass
from typing import ClassVar

from sim2reason.questions.moments import Clause, Happening
from sim2reason.questions.spoken import ordinal
from sim2reason.questions.words import Words


def when_phrases(statement: str) -> tuple[str, str, str]:
    """Return the phrases for the moment of a statement, as in *when it stops* and *at the moment when it stops*."""
    return f"when {statement}", f"at the moment when {statement}", f"at the instant at which {statement}"


@dataclass(frozen=True, slots=True)
class Verb:
    """What a subject does, as a statement and as a question: *goes slack*, *does … go slack*."""

    told: str
    asked: str
    auxiliary: str = "does"

    def phrases(self, subject: str, number: int | None) -> tuple[str, ...]:
        """*When …*; `number` counts the times, None is for what can happen but once."""
        if number == 1:
            first = f"{subject} first {self.told}"
            return (f"when {first}", f"at the moment when {first}", f"when {self._counted(subject, 1)}")
        happens = f"{subject} {self.told}" if number is None else self._counted(subject, number)
        return when_phrases(happens)

    def sided(self, subject: str, number: int | None, *, after: bool) -> tuple[str, ...]:
        """*Just before …* or *just after …*; `number` is None for what can happen but once."""
        side = "after" if after else "before"
        again = f"{subject} {self.told}" if number is None else self._counted(subject, number)
        return (
            f"just {side} {subject} first {self.told}" if number == 1 else f"at the moment just {side} {again}",
            f"just {side} {again}",
            f"immediately {side} {again}",
        )

    def clause(self, subject: str, number: int | None) -> Clause:
        """For *how long after …*."""
        if number == 1:
            return Clause(subject, self.auxiliary, f"first {self.asked}", f"first {self.told}")
        times = "" if number is None else f" for the {ordinal(number)} time"
        return Clause(subject, self.auxiliary, self.asked + times, self.told + times)

    def _counted(self, subject: str, number: int) -> str:
        return f"{subject} {self.told} for the {ordinal(number)} time"


class VerbHappening(Happening):
    """Something that happens to a subject, told by a verb.

    Class data:
        verb: what the subject does.
    """

    verb: ClassVar[Verb]

    def does(self, words: Words) -> Verb:
        """Return what it does, as a text says it."""
        del words
        return self.verb

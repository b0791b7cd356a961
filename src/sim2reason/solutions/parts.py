"""Worked solutions of multipart and multiple-choice problems."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace

from sim2reason.grading.parts import LABELS
from sim2reason.solutions.solution import Solution, Step

_BOX = re.compile(r"\\boxed\{([^{}]*(?:\{[^{}]*\}[^{}]*)*)\}")


@dataclass(frozen=True, slots=True)
class PartsSolution(Solution):
    """The combined solution of all parts; its goal and answer are those of the last part."""

    parts: tuple[Solution, ...] = ()

    @property
    def derived(self) -> bool:
        """Return whether the answers to all parts are derived in closed form."""
        return bool(self.parts) and all(part.derived for part in self.parts)

    @property
    def text(self) -> str:
        """Return the solutions of all parts with their labels, and all answers in one box."""
        told = [f"({label}) {_unboxed_text(part)}" for label, part in zip(LABELS, self.parts, strict=False)]
        if self.answer is not None:
            boxes = (_BOX.search(part.text) for part in self.parts)
            said = "; ".join(f"({label}) {box[1] if box else ''}" for label, box in zip(LABELS, boxes, strict=False))
            told.append(rf"Answers: $\boxed{{{said}}}$.")
        return "\n\n".join(told)


@dataclass(frozen=True, slots=True)
class ChosenSolution(Solution):
    """A solution of a multiple-choice question, whose answer is the letter of an option."""

    letter: str = ""

    @property
    def text(self) -> str:
        """Return the solution of the question without options, followed by the letter in a box."""
        text = _BOX.sub(r"\1", super(ChosenSolution, self).text)
        return f"{text}\n\n" + rf"That is option $\boxed{{\text{{{self.letter}}}}}$."


def chosen(solution: Solution, letter: str) -> Solution:
    """Return the solution of a multiple-choice question from the solution of the plain question."""
    held = {each.name: getattr(solution, each.name) for each in fields(Solution)}
    return ChosenSolution(**held, letter=letter)


def combine_parts(parts: Sequence[Solution]) -> Solution:
    """Return one solution of all parts; if a part has no answer, one without an answer whose reason names this part."""
    for label, part in zip(LABELS, parts, strict=False):
        if part.answer is None:
            return Solution("", reason=f"part ({label}): {part.reason}")
    names = dict.fromkeys(part.strategy for part in parts)
    last = parts[-1]
    return PartsSolution(
        "; ".join(names),
        tuple(_in_one_row(parts)),
        last.values,
        last.goal,
        answer=last.answer,
        unit=last.unit,
        parts=tuple(parts),
    )


def _unboxed_text(part: Solution) -> str:
    """Return the text of one part without the box around its answer."""
    return _BOX.sub(r"\1", part.text)


def _in_one_row(parts: Sequence[Solution]) -> Iterator[Step]:
    """Yield the steps of all parts with consecutive numbers from zero."""
    count = 0
    for part in parts:
        for step in part.steps:
            yield replace(step, id=step.id + count, needs=tuple(need + count for need in step.needs))
        count += len(part.steps)

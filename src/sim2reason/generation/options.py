"""The options of a multiple choice: the right answer among wrong ones to which slips lead."""

from collections.abc import Sequence
from hashlib import blake2b

from sim2reason.generation.grade_answer import grade_answer
from sim2reason.generation.item import Answer, Distractor, Item
from sim2reason.questions.choice_prompts import LETTERS, said

FEWEST = 3  # wrong answers
APART = 0.1  # relative: by how much an option differs from every other at least
ROUNDING = 0.01  # relative: half a per cent of each of two rounded numbers
LACKS = f"it needs a number as its answer, and {FEWEST} wrong ones, all a tenth apart"

OTHER, NAMES_OTHER = "other of two", "It names the other of the two."
RIGHT_NAME = "It names the right one of the two all the same."

Options = tuple[Distractor | None, ...]
"""In their order; None stands for the right one."""


def options(answer: Answer, wrong: Sequence[Distractor], name: str) -> Options | None:
    """Return the right answer and wrong ones in an order that hangs on a name, such as an item's id; None for too few.

    Told in three digits, the right one is right for the grader, no other is, and each differs from all others by a
    tenth of it or more. Each place is as likely for the right one as any other.
    """
    if answer.formula is not None or answer.parts:
        return None
    chosen: list[Distractor | None] = [None]
    for each in wrong:
        if len(chosen) < len(LETTERS) and _stands_apart(answer, each, chosen):
            chosen.append(each)
    if len(chosen) <= FEWEST or not _graded(answer, said(values(answer, chosen))):
        return None
    return _ordered(chosen, name)


def options_of_two(answer: Answer, wrong: Sequence[Distractor], name: str) -> Options | None:
    """Return four options: the right number and a wrong number, each with either of the two names.

    A negative number is of the second of the two. None where no wrong number stands apart from the right one.
    """
    size = answer.model_copy(update={"value": abs(answer.value)})
    sizes = (each.model_copy(update={"value": abs(each.value)}) for each in wrong)
    pairs = zip(wrong, sizes, strict=True)
    number = next((each for each, positive in pairs if _stands_apart(size, positive, [None])), None)
    if number is None:
        return None
    other = Distractor(value=-answer.value, simplification=OTHER, reason=NAMES_OTHER)
    twin = number.model_copy(update={"value": -number.value, "reason": f"{number.reason} {_beside(number, answer)}"})
    return _ordered((None, other, number, twin), name)


def _beside(number: Distractor, answer: Answer) -> str:
    """Return what is said of the name in the option with the number of `number` and the other name."""
    return NAMES_OTHER if number.value * answer.value > 0.0 else RIGHT_NAME


def _ordered(chosen: Sequence[Distractor | None], name: str) -> Options:
    """Return options in a random order that depends only on a seed string."""
    order = [blake2b(f"{name}\n{number}".encode()).digest() for number in range(len(chosen))]
    return tuple(chosen[number] for number in sorted(range(len(chosen)), key=lambda number: order[number]))


def options_of(item: Item) -> Options | None:
    """Return the options of a multiple choice, or those that an item could have; None for too few."""
    if not item.answer.letter:
        return options(item.answer, item.distractors, item.id)
    label, wrong = LETTERS.index(item.answer.letter), iter(item.distractors)
    return tuple(None if number == label else next(wrong) for number in range(len(item.answer.options)))


def values(answer: Answer, chosen: Sequence[Distractor | None]) -> list[float]:
    """Return the numbers of options."""
    return [answer.value if wrong is None else wrong.value for wrong in chosen]


def _stands_apart(answer: Answer, wrong: Distractor, chosen: Sequence[Distractor | None]) -> bool:
    """Return whether a wrong answer could not pass for another option."""
    least = max(APART, answer.tolerance) + ROUNDING
    others = values(answer, chosen)
    return all(abs(wrong.value - other) > least * max(abs(wrong.value), abs(other)) for other in others)


def _graded(answer: Answer, texts: list[str]) -> bool:
    """Return whether the one grader finds the first right, and no other."""
    rewards = [grade_answer(answer, rf"\boxed{{{text}}}").reward for text in texts]
    return rewards == [1.0, *(0.0 for _ in texts[1:])]

"""Multiple choice: the right answer among wrong ones that a slip leads to."""

from hashlib import blake2b
from math import floor, log10

from sim2reason.datasets.grade import grade_answer
from sim2reason.datasets.item import Distractor, Item
from sim2reason.dsl.measures import join_unit
from sim2reason.exports import Export, Place, Row, target
from sim2reason.exports.parts.messages import asked, facts
from sim2reason.questions.parse_prompt import without_form
from sim2reason.rewards import Letter, boxed, solution

LETTERS = "ABCDE"
FEWEST = 3  # wrong answers
DIGITS = 3  # significant ones, as prompts ask for
PLAIN = range(-3, 5)  # the powers of ten that are written out
ENDING = "Which answer is right? Give its letter inside \\boxed{}."
MINUS = "\N{MINUS SIGN}"


@target
class MultipleChoice(Export):
    """Multiple choice: up to five options, wrong ones with the slip behind each; for any library, and lm-eval."""

    name = "multiple-choice"
    lacks = f"it needs a number as its answer, and {FEWEST} wrong ones that differ beyond the tolerance"

    def row(self, item: Item, place: Place) -> Row | None:
        """The question, its options in an order that hangs on the item's id alone, and which one is right."""
        del place
        told = options(item)
        if told is None:
            return None
        letters = LETTERS[: len(told)]
        letter = letters[next(n for n, wrong in enumerate(told.values()) if wrong is None)]
        body, _ = without_form(item.prompt)
        listed = "\n".join(f"{name}. {text}" for name, text in zip(letters, told, strict=True))
        return {
            "id": item.id,
            "prompt": asked(f"{body}\n\n{listed}\n\n{ENDING}"),
            "question": body,
            "choices": list(told),
            "answer": letter,
            "label": letters.index(letter),
            "slips": ["" if wrong is None else wrong.simplification for wrong in told.values()],
            "reasons": ["" if wrong is None else wrong.reason for wrong in told.values()],
            "solution": solution(Letter(letter=letter, letters=letters)),
            **facts(item),
        }


def options(item: Item) -> dict[str, Distractor | None] | None:
    """The options as texts in their order, each with what is wrong about it; None without enough of them.

    Told in three digits, the right one is right for the grader, no other is, and all differ beyond the tolerance.
    """
    if item.answer.formula is not None:
        return None
    chosen: list[Distractor | None] = [None]
    for wrong in item.distractors:
        if len(chosen) < len(LETTERS) and _stands_apart(item, wrong, chosen):
            chosen.append(wrong)
    texts = said([_value(item, one) for one in chosen])
    unit = item.answer.unit
    if len(chosen) <= FEWEST or not _graded(item, texts):
        return None
    told = {join_unit(text.replace("-", MINUS), unit): wrong for text, wrong in zip(texts, chosen, strict=True)}
    return dict(sorted(told.items(), key=lambda pair: blake2b(f"{item.id}\n{pair[0]}".encode()).digest()))


def said(values: list[float]) -> list[str]:
    """Numbers in one style: whole ones as they are, others in three digits, in powers of ten if any needs that."""
    if all(value == round(value) and abs(value) < 10**DIGITS for value in values):
        return [str(round(value)) for value in values]
    if all(_power(value) in PLAIN for value in values):
        return [f"{float(f'{value:.{DIGITS - 1}e}'):.{max(0, DIGITS - 1 - _power(value))}f}" for value in values]
    parted = (f"{value:.{DIGITS - 1}e}".split("e") for value in values)
    return [f"{mantissa} × 10^{int(power)}" for mantissa, power in parted]


def _power(value: float) -> int:
    """The power of ten of a number that was rounded."""
    rounded = abs(float(f"{value:.{DIGITS - 1}e}"))
    return floor(log10(rounded)) if rounded else 0


def _value(item: Item, wrong: Distractor | None) -> float:
    return item.answer.value if wrong is None else wrong.value


def _stands_apart(item: Item, wrong: Distractor, chosen: list[Distractor | None]) -> bool:
    """Whether a wrong answer could not pass for another option; rounding takes half a per cent of each."""
    least = item.answer.tolerance + 0.01
    others = (_value(item, other) for other in chosen)
    return all(abs(wrong.value - other) > least * max(abs(wrong.value), abs(other)) for other in others)


def _graded(item: Item, texts: list[str]) -> bool:
    """Whether the one grader finds the first right, and no other."""
    rewards = [grade_answer(item.answer, boxed(text)).reward for text in texts]
    return rewards == [1.0, *(0.0 for _ in texts[1:])]

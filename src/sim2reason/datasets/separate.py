"""Splitting of a multi-part problem into separate problems, each with the answers to earlier parts."""

from sim2reason.generation.item import Answer, Item, QuestionPart
from sim2reason.grading.parts import LABELS
from sim2reason.questions.prompt_formats import MINUS, PartPrompt, said
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.solutions.algebra.digits import DIGITS


def split_parts(item: Item) -> tuple[Item, ...]:
    """Return each part as an item whose prompt contains the answers to earlier parts; other items unchanged.

    The id of each is that of the item with the label of the part: ``pulley-easy-multipart-0-4-a``.
    """
    if not item.parts:
        return (item,)
    prompt = PartPrompt.read(item.prompt)
    told = [_told(answer) for answer in item.answer.parts]
    return tuple(_single(item, number, prompt.after(number, told)) for number in range(len(item.parts)))


def _single(item: Item, number: int, prompt: str) -> Item:
    part: QuestionPart = item.parts[number]
    return item.model_copy(
        update={
            "id": f"{item.id}-{LABELS[number]}",
            "prompt": prompt,
            "answer": item.answer.parts[number],
            "kind": part.kind,
            "asked": part.asked,
            "parts": (),
            "distractors": part.distractors,
            "solution": part.solution,
            "unsolved": part.unsolved,
            "certificate": part.certificate,
        }
    )


def _told(answer: Answer) -> str:
    """Return a number with its unit, to the digits that solutions of later parts use."""
    return join_unit(said([answer.value], DIGITS)[0].replace("-", MINUS), answer.unit)

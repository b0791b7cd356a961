"""A problem with several parts as several problems, each with the answers to the parts before it."""

from sim2reason.generation.item import Answer, Item, QuestionPart
from sim2reason.grading.parts import LABELS
from sim2reason.questions.choice_prompts import MINUS, said
from sim2reason.questions.part_prompts import PartPrompt
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.solutions.algebra.digits import DIGITS


def separated(item: Item) -> tuple[Item, ...]:
    """Each part as an item of its own, whose prompt gives the answers to the parts before; any other item by itself.

    Their ids are that of the item with the label of the part: ``pulley-easy-multipart-0-4-a``.
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
    """Return a number with its unit, to the digits with which the solutions of later parts use it."""
    return join_unit(said([answer.value], DIGITS)[0].replace("-", MINUS), answer.unit)

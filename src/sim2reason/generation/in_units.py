"""An item told in another system of units; its scene stays in the SI."""

from dataclasses import replace

from sim2reason.generation.item import Answer, Distractor, Item, QueryRecord, QuestionPart
from sim2reason.questions.choice_prompts import ChoicePrompt, amounts
from sim2reason.questions.part_prompts import PartPrompt
from sim2reason.questions.prompt import unit_in_words
from sim2reason.questions.spoken_units import SpokenUnits, spoken_in


def told_in(system: SpokenUnits, item: Item) -> Item:
    """Return the same problem with all numbers of its text, its answer and its wrong answers in a system of units.

    One in symbols stays as it is: its formula holds in any.
    """
    if item.answer.formula is not None:
        return item
    answers = item.answer.parts or (item.answer,)
    system = system.beside(item.prompt, *((answer.value, answer.unit) for answer in answers))
    if item.parts:
        return _parts_told_in(system, item)
    if item.answer.letter:
        return _options_told_in(system, item)
    unit = system.spelled(item.answer.unit)[0]
    begin, asked, end = item.prompt.rpartition(f" in {unit_in_words(item.answer.unit)}")
    if asked and item.answer.unit and ". " not in end:  # the last sentence
        asked = f" in {unit_in_words(unit)}"
    return item.model_copy(
        update={
            "prompt": spoken_in(system, f"{begin}{asked}{end}"),
            "answer": _answer(system, item.answer),
            "distractors": tuple(_distractor(system, wrong, item.answer.unit) for wrong in item.distractors),
            "idle": tuple(spoken_in(system, part) for part in item.idle),
            "asked": _asked(system, item.asked),
        }
    )


def _options_told_in(system: SpokenUnits, item: Item) -> Item:
    """Return the same of a multiple choice, whose options are in the unit of the answer."""
    answer, told = _answer(system, item.answer), ChoicePrompt.read(item.prompt)
    question = spoken_in(system, told.question)
    return item.model_copy(
        update={
            "prompt": ChoicePrompt(question, answer.texts or amounts(answer.options, answer.unit)).text,
            "answer": answer,
            "distractors": tuple(_distractor(system, wrong, item.answer.unit) for wrong in item.distractors),
            "idle": tuple(spoken_in(system, part) for part in item.idle),
            "asked": _asked(system, item.asked),
        }
    )


def _parts_told_in(system: SpokenUnits, item: Item) -> Item:
    """Return the same of a problem with several parts, whose last line names the units of all answers."""
    units = [system.spelled(answer.unit)[0] for answer in item.answer.parts]
    told = PartPrompt.read(item.prompt)
    said = tuple(unit_in_words(unit) if unit else old for unit, old in zip(units, told.units, strict=True))
    questions = tuple(spoken_in(system, question) for question in told.questions)
    parts = zip(item.parts, questions, item.answer.parts, strict=True)
    return item.model_copy(
        update={
            "prompt": replace(told, scene=spoken_in(system, told.scene), questions=questions, units=said).text,
            "answer": _answer(system, item.answer),
            "parts": tuple(_part(system, part, question, answer.unit) for part, question, answer in parts),
            "idle": tuple(spoken_in(system, part) for part in item.idle),
            "asked": _asked(system, item.asked),
        }
    )


def _part(system: SpokenUnits, part: QuestionPart, question: str, unit: str) -> QuestionPart:
    wrong = tuple(_distractor(system, each, unit) for each in part.distractors)
    return part.model_copy(update={"text": question, "distractors": wrong, "asked": _asked(system, part.asked)})


def _answer(system: SpokenUnits, answer: Answer) -> Answer:
    unit, factor = system.spelled(answer.unit)
    parts = tuple(_answer(system, part) for part in answer.parts)
    options = tuple(value * float(factor) for value in answer.options)
    texts = tuple(spoken_in(system, text) for text in answer.texts)
    told = {"unit": unit, "value": answer.value * float(factor), "parts": parts, "options": options, "texts": texts}
    return answer.model_copy(update=told)


def _distractor(system: SpokenUnits, wrong: Distractor, unit: str) -> Distractor:
    value = wrong.value * float(system.spelled(unit)[1])
    return wrong.model_copy(update={"value": value, "reason": spoken_in(system, wrong.reason)})


def _asked(system: SpokenUnits, asked: QueryRecord) -> QueryRecord:
    if asked.given is None or asked.given_unit is None:
        return asked
    unit, factor = system.spelled(asked.given_unit)
    return asked.model_copy(update={"given": asked.given * float(factor), "given_unit": unit})

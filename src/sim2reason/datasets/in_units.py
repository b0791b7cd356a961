"""An item told in another system of units; its scene stays in the SI."""

from sim2reason.datasets.item import Answer, Distractor, Item, QueryRecord
from sim2reason.questions.prompt import unit_in_words
from sim2reason.questions.spoken_units import SpokenUnits, spoken_in


def told_in(system: SpokenUnits, item: Item) -> Item:
    """The same problem with all numbers of its text, its answer and its wrong answers in a system of units.

    One in symbols stays as it is: its formula holds in any.
    """
    if item.answer.formula is not None:
        return item
    system = system.beside(item.prompt, (item.answer.value, item.answer.unit))
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


def _answer(system: SpokenUnits, answer: Answer) -> Answer:
    unit, factor = system.spelled(answer.unit)
    return answer.model_copy(update={"unit": unit, "value": answer.value * float(factor)})


def _distractor(system: SpokenUnits, wrong: Distractor, unit: str) -> Distractor:
    value = wrong.value * float(system.spelled(unit)[1])
    return wrong.model_copy(update={"value": value, "reason": spoken_in(system, wrong.reason)})


def _asked(system: SpokenUnits, asked: QueryRecord) -> QueryRecord:
    if asked.given is None or asked.given_unit is None:
        return asked
    unit, factor = system.spelled(asked.given_unit)
    return asked.model_copy(update={"given": asked.given * float(factor), "given_unit": unit})

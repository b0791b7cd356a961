"""Export of multiple-choice items: the correct answer among distractors."""

from sim2reason.datasets.exports import Export, Place, Row, target
from sim2reason.datasets.exports.parts.messages import asked, facts
from sim2reason.datasets.ground_truth import Letter, ground_truth
from sim2reason.generation.item import Item
from sim2reason.generation.options import LACKS, options_of, values
from sim2reason.questions.prompt import without_form
from sim2reason.questions.prompt_formats import LETTERS, ChoicePrompt


@target
class MultipleChoice(Export):
    """Multiple choice: up to five options, distractors with their misconceptions; for any library, and lm-eval."""

    name = "multiple-choice"
    also = ("choice", "mcq")
    lacks = LACKS

    def row(self, item: Item, place: Place) -> Row | None:
        """Return the question, its options in an order that depends only on the item's id, and the correct one."""
        del place
        chosen = options_of(item)
        if chosen is None:
            return None
        told = _prompt(item, values(item.answer, chosen))
        letters, label = LETTERS[: len(chosen)], chosen.index(None)
        return {
            "id": item.id,
            "prompt": asked(told.text),
            "question": told.question,
            "choices": list(told.options),
            "answer": letters[label],
            "label": label,
            "slips": ["" if wrong is None else wrong.simplification for wrong in chosen],
            "reasons": ["" if wrong is None else wrong.reason for wrong in chosen],
            "ground_truth": ground_truth(Letter(letter=letters[label], letters=letters)),
            **facts(item),
        }


def _prompt(item: Item, numbers: list[float]) -> ChoicePrompt:
    """Return the prompt of a multiple-choice item, or the prompt of another item with options added."""
    if item.answer.letter:
        return ChoicePrompt.read(item.prompt)
    return ChoicePrompt.of(without_form(item.prompt)[0], numbers, item.answer.unit)

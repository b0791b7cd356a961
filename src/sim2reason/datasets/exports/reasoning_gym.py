"""Export for Reasoning Gym."""

from sim2reason.datasets.exports import Export, Place, Row, target
from sim2reason.datasets.exports.parts.messages import facts
from sim2reason.datasets.ground_truth import answered, ground_truth
from sim2reason.generation.item import Item


@target
class ReasoningGym(Export):
    """Reasoning Gym: a dataset that registers itself when its file is imported."""

    name = "reasoning-gym"
    also = ("reasoning_gym",)

    def row(self, item: Item, place: Place) -> Row:
        """Return a question with a correct answer and the data for grading."""
        del place
        told = {"id": item.id, "ground_truth": ground_truth(item), **facts(item)}
        return {"question": item.prompt, "answer": answered(item), "metadata": told}

"""Export for Prime Intellect's verifiers, used by prime-rl."""

from sim2reason.datasets.exports import Export, Place, Row, target
from sim2reason.datasets.exports.parts.messages import facts
from sim2reason.datasets.ground_truth import answered, ground_truth
from sim2reason.generation.item import Item


@target
class VerifiersTaskset(Export):
    """verifiers: a v1 taskset as an installable package."""

    name = "verifiers"
    also = ("prime-rl", "prime")
    data = "sim2reason_problems/data/{split}.jsonl"

    def row(self, item: Item, place: Place) -> Row:
        """Return the task data of an item."""
        del place
        told = {"answer": answered(item), "ground_truth": ground_truth(item), **facts(item)}
        return {"id": item.id, "prompt": item.prompt, **told}

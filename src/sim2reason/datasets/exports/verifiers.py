"""Prime Intellect's verifiers, whose environments prime-rl trains in."""

from sim2reason.datasets.exports import Export, Place, Row, target
from sim2reason.datasets.exports.parts.messages import facts
from sim2reason.datasets.ground_truth import answered, ground_truth
from sim2reason.generation.item import Item


@target
class VerifiersTaskset(Export):
    """verifiers: a v1 taskset, as a package to be installed."""

    name = "verifiers"
    also = ("prime-rl", "prime")
    data = "sim2reason_problems/data/{split}.jsonl"

    def row(self, item: Item, place: Place) -> Row:
        """Return the data of a task."""
        del place
        told = {"answer": answered(item), "ground_truth": ground_truth(item), **facts(item)}
        return {"id": item.id, "prompt": item.prompt, **told}

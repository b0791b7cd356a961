"""Export for Inspect, the evaluation framework of the UK AI Security Institute."""

from sim2reason.datasets.exports import Export, Place, Row, target
from sim2reason.datasets.exports.parts.messages import facts
from sim2reason.datasets.ground_truth import ground_truth
from sim2reason.generation.item import Item


@target
class InspectTask(Export):
    """Inspect: a task with its samples and a scorer."""

    name = "inspect"
    also = ("inspect-ai", "inspect_evals")

    def row(self, item: Item, place: Place) -> Row:
        """Return the sample of an item; its target is for readers, the scorer uses the ground truth."""
        del place
        told = {"ground_truth": ground_truth(item), **facts(item)}
        return {"id": item.id, "input": item.prompt, "target": item.answer.told, "metadata": told}

"""Inspect, the evaluation framework of the UK AI Security Institute."""

from sim2reason.datasets.item import Item
from sim2reason.exports import Export, Place, Row, target
from sim2reason.exports.parts.messages import facts
from sim2reason.rewards import solution


@target
class InspectTask(Export):
    """Inspect: a task with its samples and a scorer."""

    name = "inspect"

    def row(self, item: Item, place: Place) -> Row:
        """A sample; its target is for people, the scorer reads the solution."""
        del place
        told = {"solution": solution(item), **facts(item)}
        return {"id": item.id, "input": item.prompt, "target": item.answer.told, "metadata": told}

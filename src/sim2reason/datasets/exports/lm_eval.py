"""Export for EleutherAI's evaluation harness, lm-eval."""

from sim2reason.datasets.exports import Export, Place, Row, target
from sim2reason.datasets.exports.parts.messages import facts
from sim2reason.datasets.ground_truth import answered, boxed, ground_truth
from sim2reason.generation.item import Item


@target
class HarnessTask(Export):
    """lm-eval: a task in YAML with its Python file."""

    name = "lm-eval"
    also = ("lm_eval", "harness", "lm-evaluation-harness")

    def row(self, item: Item, place: Place) -> Row:
        """Return the document of an item; few-shot examples show the target, and the grader reads `ground_truth`."""
        del place
        shown = boxed(answered(item))
        return {
            "id": item.id,
            "prompt": item.prompt,
            "target": shown,
            "ground_truth": ground_truth(item),
            **facts(item),
        }

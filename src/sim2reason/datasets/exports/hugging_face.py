"""Export for Hugging Face `datasets` and TRL."""

from collections.abc import Mapping
from typing import ClassVar

from sim2reason.datasets.exports import Column, Export, Place, Row, target
from sim2reason.datasets.exports.parts.messages import asked, facts, worked
from sim2reason.datasets.ground_truth import answered, ground_truth
from sim2reason.generation.item import Item


@target
class HuggingFace(Export):
    """Hugging Face datasets and TRL: prompts as messages; the reward is sim2reason.rewards.accuracy."""

    name = "hf"
    also = ("huggingface", "hugging-face", "datasets", "trl")
    data = "data/{split}-00000-of-00001.parquet"  # as the Hub names a split of any name
    columns: ClassVar[Mapping[str, Column]] = {
        "prompt": [{"role": str, "content": str}],
        "ground_truth": str,
        "answer": str,
        "solution": str,
        "id": str,
        "mode": str,
        "kind": str,
        "recipe": str,
        "difficulty": str,
    }

    def row(self, item: Item, place: Place) -> Row:
        """Return the row of an item: the prompt, columns for rewards, a readable solution, and facts to group by."""
        del place
        told = {"ground_truth": ground_truth(item), "answer": answered(item), "solution": worked(item)}
        return {"prompt": asked(item.prompt), **told, "id": item.id, **facts(item)}

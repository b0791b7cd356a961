"""Hugging Face `datasets`, and TRL above it."""

from collections.abc import Mapping
from typing import ClassVar

from sim2reason.datasets.item import Item
from sim2reason.exports import Column, Export, Place, Row, target
from sim2reason.exports.parts.messages import asked, facts
from sim2reason.rewards import solution


@target
class HuggingFace(Export):
    """Hugging Face datasets and TRL: prompts as messages; the reward is sim2reason.rewards.accuracy."""

    name = "hf"
    data = "data/{split}-00000-of-00001.parquet"  # as the Hub names a split of any name
    columns: ClassVar[Mapping[str, Column]] = {
        "prompt": [{"role": str, "content": str}],
        "solution": str,
        "id": str,
        "mode": str,
        "kind": str,
        "recipe": str,
        "difficulty": str,
    }

    def row(self, item: Item, place: Place) -> Row:
        """What TRL hands to a reward by name, and what curves are drawn by."""
        del place
        return {"prompt": asked(item.prompt), "solution": solution(item), "id": item.id, **facts(item)}

"""Export for the trainer verl."""

from collections.abc import Mapping
from typing import ClassVar

from sim2reason.datasets.exports import Column, Export, Place, Row, target
from sim2reason.datasets.exports.parts.messages import asked, facts
from sim2reason.datasets.ground_truth import ground_truth
from sim2reason.generation.item import Item


@target
class Verl(Export):
    """verl: Parquet files, and a Python file with compute_score."""

    name = "verl"
    data = "{split}.parquet"
    columns: ClassVar[Mapping[str, Column]] = {
        "data_source": str,
        "prompt": [{"role": str, "content": str}],
        "ability": str,
        "reward_model": {"style": str, "ground_truth": str},
        "extra_info": {
            "split": str,
            "index": int,
            "id": str,
            "mode": str,
            "kind": str,
            "recipe": str,
            "difficulty": str,
        },
    }

    def row(self, item: Item, place: Place) -> Row:
        """Return the row of an item; verl averages validation scores by `data_source`."""
        return {
            "data_source": "sim2reason",
            "prompt": asked(item.prompt),
            "ability": "physics",
            "reward_model": {"style": "rule", "ground_truth": ground_truth(item)},
            "extra_info": {"split": place.split, "index": place.number, "id": item.id, **facts(item)},
        }

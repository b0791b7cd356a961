"""NVIDIA's NeMo Gym."""

from sim2reason.datasets.item import Item
from sim2reason.exports import Export, Place, Row, target
from sim2reason.exports.parts.messages import asked, facts
from sim2reason.rewards import solution


@target
class NemoGym(Export):
    """NeMo Gym: JSON lines and a resources server that verifies."""

    name = "nemo-gym"
    data = "resources_servers/sim2reason/data/{split}.jsonl"

    def row(self, item: Item, place: Place) -> Row:
        """What a model is asked, and beside it what the server is handed to verify by."""
        del place
        return {
            "responses_create_params": {"input": asked(item.prompt)},
            "id": item.id,
            "solution": solution(item),
            **facts(item),
        }

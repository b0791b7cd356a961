"""Export for NVIDIA's NeMo Gym."""

from sim2reason.datasets.exports import Export, Place, Row, target
from sim2reason.datasets.exports.parts.messages import asked, facts
from sim2reason.datasets.ground_truth import ground_truth
from sim2reason.generation.item import Item

LICENSES = {
    "apache-2.0": "Apache 2.0",
    "mit": "MIT",
    "cc-by-4.0": "Creative Commons Attribution 4.0 International",
    "cc-by-sa-4.0": "Creative Commons Attribution-ShareAlike 4.0 International",
    "gpl-3.0": "GNU General Public License v3.0",
}
"""What NeMo Gym calls licences, by their names on the Hugging Face hub."""


@target
class NemoGym(Export):
    """NeMo Gym: JSON lines and a resources server that verifies responses."""

    name = "nemo-gym"
    also = ("nemo_gym", "nemo")
    data = "resources_servers/sim2reason/data/{split}.jsonl"

    def license(self, name: str) -> str:
        """Return NeMo Gym's name for a licence; ``TBD`` for a licence that NeMo Gym's configuration cannot name."""
        return LICENSES.get(name, "TBD")

    def row(self, item: Item, place: Place) -> Row:
        """Return the input of the model, with the data that the server needs to verify a response."""
        del place
        return {
            "responses_create_params": {"input": asked(item.prompt)},
            "id": item.id,
            "ground_truth": ground_truth(item),
            **facts(item),
        }

"""Functions that sim2reason.yaml refers to: loading of the problems, and grading of a response."""

from pathlib import Path

import datasets

from sim2reason.rewards import score

DATA = Path(__file__).resolve().parent / "data"


def problems(**settings: object) -> datasets.DatasetDict:
    """Return all splits of this folder."""
    del settings
    files = {path.stem: str(path) for path in sorted(DATA.glob("*.jsonl"))}
    return datasets.load_dataset("json", data_files=files)


def process_results(doc: dict[str, str], results: list[str]) -> dict[str, float]:
    """Return the reward for the response to one problem."""
    return {"accuracy": score(doc["ground_truth"], results[0]).reward}

"""What sim2reason_choice.yaml needs: the problems beside it, and the letters of their choices."""

from pathlib import Path

import datasets

DATA = Path(__file__).resolve().parent / "data"


def problems(**settings: object) -> datasets.DatasetDict:
    """All splits of this folder."""
    del settings
    files = {path.stem: str(path) for path in sorted(DATA.glob("*.jsonl"))}
    return datasets.load_dataset("json", data_files=files)


def letters(doc: dict[str, list[str]]) -> list[str]:
    """The letters of a problem's choices."""
    return list("ABCDE"[: len(doc["choices"])])

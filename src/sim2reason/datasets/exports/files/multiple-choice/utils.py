"""Functions that sim2reason_choice.yaml refers to: the problems, their prompts, and the letters of choices."""

from pathlib import Path
from typing import Any

import datasets

DATA = Path(__file__).resolve().parent / "data"


def problems(**settings: object) -> datasets.DatasetDict:
    """Return all splits of this folder."""
    del settings
    files = {path.stem: str(path) for path in sorted(DATA.glob("*.jsonl"))}
    return datasets.load_dataset("json", data_files=files)


def text(doc: dict[str, Any]) -> str:
    """Return the question with its options, after which the model writes a letter."""
    listed = "\n".join(f"{letter}. {choice}" for letter, choice in zip(letters(doc), doc["choices"], strict=True))
    return f"{doc['question']}\n\n{listed}\n\nAnswer:"


def letters(doc: dict[str, Any]) -> list[str]:
    """Return the letters of a problem's choices."""
    return list("ABCDE"[: len(doc["choices"])])

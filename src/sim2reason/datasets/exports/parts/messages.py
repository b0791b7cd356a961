"""Text shared by several exports: conversations, facts and solutions of items."""

from typing import TypedDict

from sim2reason.generation.item import Item
from sim2reason.grading.parts import LABELS

FACTS = "mode", "kind", "recipe", "difficulty"


class Message(TypedDict):
    """One message of a conversation."""

    role: str
    content: str


def asked(prompt: str) -> list[Message]:
    """Return a conversation with the problem as its first message, which includes the answer format."""
    return [{"role": "user", "content": prompt}]


def facts(item: Item) -> dict[str, str]:
    """Return the mode, kind, recipe and difficulty of an item, by which results are grouped."""
    return {name: getattr(item, name) for name in FACTS}


def worked(item: Item) -> str | None:
    """Return an item's worked solution, or the labelled solutions of all its parts; None if any is missing."""
    if not item.parts:
        return item.solution.text if item.solution is not None else None
    pairs = zip(LABELS, item.parts, strict=False)
    texts = [f"({label}) {part.solution.text}" for label, part in pairs if part.solution is not None]
    return "\n\n".join(texts) if len(texts) == len(item.parts) else None

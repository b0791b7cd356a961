"""What several exports say of an item in the same words."""

from typing import TypedDict

from sim2reason.datasets.item import Item

FACTS = "mode", "kind", "recipe", "difficulty"


class Message(TypedDict):
    """One message of a conversation."""

    role: str
    content: str


def asked(prompt: str) -> list[Message]:
    """A conversation that begins with the problem; the problem itself says how to answer."""
    return [{"role": "user", "content": prompt}]


def facts(item: Item) -> dict[str, str]:
    """What results are grouped by."""
    return {name: getattr(item, name) for name in FACTS}

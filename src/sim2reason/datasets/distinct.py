"""Leave out what a dataset already holds: the lower position stays.

An item never looks at another while it is made, so this is a pass over finished shards. Two items are the
same if they have the same words, or ask the same of the same scene. Only kept items count as seen, so the
pass gives the same if it is repeated over shards of which some went through it already.
"""

from collections.abc import Iterable
from hashlib import blake2b

from sim2reason.datasets.item import Item


def keys(item: Item) -> tuple[str, str]:
    """What no other item of a dataset may share: its words; its scene together with its question."""
    asked = item.asked.model_dump_json()
    return " ".join(item.prompt.split()).casefold(), f"{item.mode} {item.kind} {asked}\n{item.scene}"


def duplicates(items: Iterable[Item], seen: dict[bytes, str]) -> dict[str, str]:
    """The ids of those `items` that say what was seen before, each with the id that said it first.

    What is new is added to `seen`, which holds a hash of each key and the id that it came from.
    """
    found: dict[str, str] = {}
    for item in items:
        marks = [blake2b(key.encode(), digest_size=16).digest() for key in keys(item)]
        first = next((seen[mark] for mark in marks if mark in seen), None)
        if first is not None:
            found[item.id] = first
        else:
            seen.update(dict.fromkeys(marks, item.id))
    return found

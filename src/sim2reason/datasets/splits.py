"""Which split an item belongs to: by its problem up to numbers, so that none has relatives on both sides."""

import re
from collections.abc import Mapping
from hashlib import blake2b
from itertools import accumulate

from sim2reason.datasets.formula_fingerprint import fingerprint
from sim2reason.datasets.item import Item

_NUMBER = re.compile(r"(?<![\w.])[-−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.])")


def problem(item: Item) -> str:
    """What is asked about what kind of scene, without any number: the same for all that a teacher would call variants.

    It hangs on the scene's parts and how they are joined, and on what is asked of which of them; not on words. A
    problem whose answer is a formula is that formula, up to a factor and the names of its symbols, whatever the scene.
    """
    asked, formula = item.asked, item.answer.formula
    if formula is not None:
        return fingerprint(formula.latex, formula.symbols, formula.units)
    event = without_numbers(asked.event or "")
    left_open = ", ".join(dict.fromkeys(filter(None, (asked.unknown, asked.limit_of))))
    question = item.mode, item.kind, asked.quantity, asked.subject, left_open, event
    return "\n".join((*question, without_numbers(item.scene)))


def split_of(item: Item, shares: Mapping[str, float]) -> str:
    """The split of an item. Each holds its share of all problems up to numbers, and about its share of the items."""
    names = list(shares)
    if len(names) == 1:
        return names[0]
    digest = blake2b(problem(item).encode(), digest_size=8, person=b"split").digest()
    place = int.from_bytes(digest, "big") / 2.0**64
    bounds = zip(names, accumulate(shares.values()), strict=True)
    return next((name for name, bound in bounds if place < bound), names[-1])


def numbers_in(text: str) -> list[float]:
    """What `without_numbers` takes out of a text."""
    return [float(found.replace("−", "-")) for found in _NUMBER.findall(text)]


def without_numbers(text: str) -> str:
    """The same text for all numbers."""
    return _NUMBER.sub("#", text)

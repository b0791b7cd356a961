"""Which split an item belongs to: by its problem up to numbers, so that none has relatives on both sides."""

import re
from collections.abc import Mapping
from hashlib import blake2b
from itertools import accumulate

from sim2reason.generation.formula_fingerprint import fingerprint
from sim2reason.generation.item import Item, QueryRecord

_NUMBER = re.compile(r"(?<![\w.])[-−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.])")


def problem(item: Item) -> str:
    """What is asked about what kind of scene, without any number: the same for all that a teacher would call variants.

    It depends on the scene's entities and how they are joined, and on what is asked of which of them; not on words, nor
    on the order in which several parts are asked. A problem whose answer is a formula is that formula, up to a factor
    and the names of its symbols, whatever the scene.
    """
    formula = item.answer.formula
    if formula is not None and not item.parts:
        return fingerprint(formula.latex, formula.symbols, formula.units)
    asked = sorted(question(part.kind, part.asked) for part in item.parts) or [question(item.kind, item.asked)]
    return "\n".join((item.mode, *asked, without_numbers(item.scene)))


def question(kind: str, asked: QueryRecord) -> str:
    """Return what is asked, without any number."""
    event = without_numbers(asked.event or "")
    left_open = ", ".join(dict.fromkeys(filter(None, (asked.unknown, asked.limit_of))))
    return f"{kind}\n{asked.quantity}\n{asked.subject}\n{left_open}\n{event}"


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
    """Return what `without_numbers` takes out of a text."""
    return [float(found.replace("−", "-")) for found in _NUMBER.findall(text)]


def without_numbers(text: str) -> str:
    """Return the same text for all numbers."""
    return _NUMBER.sub("#", text)

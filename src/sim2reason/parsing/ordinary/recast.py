"""A text in ordinary English told again in the library's own sentences, as far as each says the same as one of them."""

import re
from collections.abc import Iterator, Sequence
from itertools import islice, product

from sim2reason.dsl.model import field_types
from sim2reason.dsl.scene import World
from sim2reason.parsing.ordinary.content import content
from sim2reason.parsing.ordinary.forms import Form
from sim2reason.parsing.ordinary.nearest import filled, same
from sim2reason.prose.closings import CLOSINGS

CHOICES = 3  # forms of a sentence that are tried
MOST = 24  # texts that are tried
PRESUMED = re.compile("g|room|.*pulleys? and room.*")
"""Closings that people leave out: the usual g, pulleys without friction, room to move."""
GRAVITY = re.compile(r"\bg = ")  # in the closing that always stands last

_RELEASED = re.compile(
    r"(?:,? and|, which|;)(?: it| they| the \w+| both \w+)? ?(?:is|are) (?:then )?(?:released|let go)(?: from rest)?(?= |\.)"
)
_RELEASED_SOMEWHERE = re.compile(r"(?: is| are) (?:released|let go) from rest(?= (?:on|at|from|with)\b)")
REST = "It is released from rest."


def clauses(sentence: str) -> list[str]:
    """Return the sentences into which one that also says that something is released comes apart."""
    if _RELEASED.search(sentence):
        return [_RELEASED.sub("", sentence, count=1), REST]
    if _RELEASED_SOMEWHERE.search(sentence):
        return [_RELEASED_SOMEWHERE.sub(" is", sentence, count=1), REST]
    return [sentence]


def unlike(said: Sequence[str]) -> int | None:
    """Return the index of the first sentence that says what no form of the library does; None if there is none."""
    return next((index for index, sentence in enumerate(said) if _forms(sentence) is None), None)


def recast(said: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Yield texts in the library's sentences that say the same, first in the order of the text, then in the usual one."""
    found = [_forms(sentence) for sentence in said]
    if not all(found):
        return
    options = [clause for each in found for clause in each or ()]
    for chosen in islice(product(*(each[:CHOICES] for each in options)), MOST):
        yield tuple(text for text, _ in chosen)
        usual = sorted(chosen, key=lambda told: told[1])
        if usual != list(chosen):
            yield tuple(text for text, _ in usual)


def with_presumed(said: Sequence[str], name: str) -> tuple[str, ...] | None:
    """Return a text with the closing of a name added in its place; None if people do not leave that out."""
    if not PRESUMED.fullmatch(name):
        return None
    found = next(closing for closing in CLOSINGS if closing.name == name)
    measure = field_types(World)["gravity"].measure
    usual = measure.say(World().gravity) if measure is not None else ""
    told = found.wordings[0].replace("{world.gravity}", usual)
    last = len(said) - 1 if name != "g" and GRAVITY.search(said[-1]) else len(said)
    return (*said[:last], told[:1].upper() + told[1:], *said[last:])


def _forms(sentence: str) -> list[list[tuple[str, float]]] | None:
    """For each clause the texts that say the same, with their places; None if one has none."""
    parts = [sentence] if same(sentence) else clauses(sentence)
    found = [[_told(form, part) for form in same(part)] for part in parts]
    return found if all(found) else None


def _told(form: Form, sentence: str) -> tuple[str, float]:
    return filled(form, content(sentence)), form.place

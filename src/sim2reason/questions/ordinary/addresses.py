"""Addresses of bodies in place of the text's phrases for them, where a list of names lacks a phrase."""

import re
from collections.abc import Mapping
from dataclasses import replace

from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.pairs import AND
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.targets import quantities_named
from sim2reason.questions.words import Words

EVERYTHING = "everything"  # all subjects of a quantity together


def addresses(words: Words) -> Mapping[str, str]:
    """Return the name of a body by each phrase of the text that means that body alone; a pulley by its carrier."""
    mechanism, found = words.mechanism, dict[str, str]()
    phrases = list(words.mentions.values())
    for address, said in words.mentions.items():
        held = {site.body for site in mechanism.site.values() if site.name.startswith(f"{address}.")}
        name = address if address in mechanism.body else next(iter(held)) if len(held) == 1 else None
        if name is not None and phrases.count(said) == 1:
            found[said] = name
    return found


def addressed(asked: StructuredQuestion, words: Words) -> StructuredQuestion:
    """Return a question with addresses in place of all phrases that mean one body; unchanged if it has none."""
    of, when = asked.of, asked.when
    for said, name in addresses(words).items():
        of = name if of == said else of
        when = re.sub(rf"(?<!\S){re.escape(said)}(?= )", name, when)
        if name not in words.called(Bodies()):
            when = re.sub(rf"(?<!\S){re.escape(name)} moved (?=[\d.])", f"displacement of {name} = ", when)
    return replace(asked, of=of, when=when)


def seen_from(asked: StructuredQuestion, words: Words) -> StructuredQuestion:
    """Return a relative speed of two bodies that never meet as the size of their relative velocity."""
    names = [addresses(words).get(said, said) for said in asked.of.split(" & ")]
    if asked.find != "relative speed" or len(names) != 2 or not set(names) <= words.mechanism.body.keys():
        return asked
    return replace(asked, find="relative velocity", of=AND.join(names))


def all_of(find: str, words: Words) -> tuple[str, ...]:
    """Return the names of all heavy bodies, or of all springs, that have a quantity."""
    quantity, mechanism = quantities_named(words.mechanism).get(find), words.mechanism
    if quantity is None:
        return ()
    light = {name for name, body in mechanism.body.items() if body.mass == 0.0}
    return tuple(name for name in quantity.subjects(mechanism) if name not in light)

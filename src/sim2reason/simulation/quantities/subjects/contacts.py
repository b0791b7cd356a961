"""Contacts with faces, and hands that pull strings, as kinds of subjects."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.quantities.subjects import Subject, is_stated_for_all

SURFACES = ("plane", "incline", "table", "floor", "track", "surface")  # fields of entities on which bodies may lie
ANY = "the surface beneath it"


@dataclass(frozen=True)
class Contacts(Subject):
    """Bodies on faces as subjects of contact forces."""

    name, slot = "contact", "body"
    extras = frozenset({"surface"})

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all bodies that lie on a face."""
        return tuple(mechanism.contacts)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases of the bodies that the text mentions."""
        return {name: mentions[name] for name in mechanism.contacts if name in mentions}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text states `need` for every body, since contact forces depend on all of them."""
        del name
        return is_stated_for_all(need, mechanism, said)

    def fills(self, mechanism: Mechanism, name: str, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrase of the surface on which the body lies, made unambiguous."""
        return {"surface": surface(mechanism, name, mentions)}


def surface(mechanism: Mechanism, name: str, mentions: Mapping[str, str]) -> str:
    """Return the text's name for the surface under a body, made unambiguous if several surfaces share it."""
    parent = mechanism.body[name].parent
    if parent is not None:
        return mentions.get(parent, ANY)
    owner = name
    while owner := owner.rpartition(".")[0]:
        found = [mentions[f"{owner}.{field}"] for field in SURFACES if f"{owner}.{field}" in mentions]
        if found:
            return found[0] if list(mentions.values()).count(found[0]) == 1 else f"{found[0]} beneath it"
    return ANY


@dataclass(frozen=True)
class Hands(Subject):
    """The hand of a scene as a subject, named by the part of a string that it pulls."""

    name, slot = "hand", "hand"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all string parts that a hand pulls."""
        return tuple(line.name for line in mechanism.pulls)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrase *the hand* by the name of its string; no phrase if several hands pull."""
        del mentions
        names = self.names(mechanism)
        return {names[0]: "the hand"} if len(names) == 1 else {}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return True, since a question about a hand needs no number of the text."""
        del need, mechanism, name, said
        return True

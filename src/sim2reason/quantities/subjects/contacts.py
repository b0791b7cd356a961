"""Contacts, by the bodies that rest."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects import Subject, all_said


@dataclass(frozen=True)
class Contacts(Subject):
    """Every resting body, for what its face does to it."""

    name, slot = "contact", "body"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """All bodies that lie on a face."""
        return tuple(mechanism.contacts)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Those of the text."""
        return {name: mentions[name] for name in mechanism.contacts if name in mentions}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """A force on a face comes from everything that is there."""
        del name
        return all_said(need, mechanism, said)

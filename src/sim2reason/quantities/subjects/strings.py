"""Parts of strings, by their ends."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects import Subject, all_said


@dataclass(frozen=True)
class Strings(Subject):
    """Every string part, pulls among them."""

    name = slot = "string"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """All parts, those among them that a constant force draws in."""
        return tuple(line.name for line in mechanism.lines)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Those that can be told by their ends."""
        return strings(mechanism, mentions)

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """What a string carries comes from everything that is there."""
        del name
        return all_said(need, mechanism, said)

    def label(self, phrase: str) -> str:
        """Its ends: *block A – pulley P*."""
        ends = phrase.partition(" between ")[2] or phrase
        said = ends.replace("the axle of ", "axle of ").replace("the ", "").replace(" and ", " – ")
        return f"{said} (part)" if phrase.startswith("the part") else said


def strings(mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
    """A phrase for every string part that can be told by its ends, by name."""
    wheels = pulleys(mechanism, mentions)
    found: dict[str, str] = {}
    for string in mechanism.strings:
        ends = [_end(mechanism, site, mentions, wheels) for site in (string.through[0], string.through[-1])]
        if all(ends):
            part = "the string" if string.name == string.whole else "the part of the string"
            found[string.name] = f"{part} between {ends[0]} and {ends[1]}"
    if len(mechanism.lines) == len(mechanism.strings) == 1:
        found = {mechanism.strings[0].name: "the string"}
    phrases = list(found.values())
    return {name: phrase for name, phrase in found.items() if phrases.count(phrase) == 1}


def pulleys(mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
    """The pulleys of the text by what carries them: the body, or for fixed ones their own address."""
    found: dict[str, str] = {}
    for address in mentions:
        site = mechanism.site.get(f"{address}.left")
        if site is not None and site.body is not None:
            found[site.body] = address
    return found


def _end(mechanism: Mechanism, name: str, mentions: Mapping[str, str], carriers: Mapping[str, str]) -> str:
    """What a string part ends at, in words; empty for an end that the text has no name for."""
    owner, site = name.rpartition(".")[0], mechanism.site[name]
    if owner in mentions:  # the rim of a pulley
        return mentions[owner]
    if site.body is None:
        return ""
    carried_pulley = carriers.get(site.body)
    return mentions.get(site.body) or (f"the axle of {mentions[carried_pulley]}" if carried_pulley else "")

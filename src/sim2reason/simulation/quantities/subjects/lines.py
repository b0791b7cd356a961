"""Strings and springs as kinds of subjects."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass

from sim2reason.scenes.dsl.mechanism import ZERO, ConstantTension, Elastic, Inextensible, Line, Mechanism
from sim2reason.simulation.quantities.subjects import Sense, Subject, is_stated, is_stated_for_all


def line_phrases(
    mechanism: Mechanism, mentions: Mapping[str, str], lines: Iterable[Line], noun: str, *, alone: bool
) -> dict[str, str]:
    """Return a phrase for every line that the text can distinguish from others of its kind, by name.

    A line that is a body of the text has its mention as phrase; the only one of its kind, if `alone`, has its noun.
    """
    wheels = pulleys(mechanism, mentions)
    found: dict[str, str] = {}
    kept = list(lines)
    for line in kept:
        whole = noun if line.name == line.whole else f"part of the {noun}"
        ends = [_end(mechanism, site, mentions, wheels) for site in (line.through[0], line.through[-1])]
        if line.name in mentions:
            found[line.name] = mentions[line.name]
        elif alone and len(kept) == 1:
            found[line.name] = f"the {noun}"
        elif all(ends):
            found[line.name] = f"the {whole} between {ends[0]} and {ends[1]}"
    phrases = list(found.values())
    return {name: phrase for name, phrase in found.items() if phrases.count(phrase) == 1}


def pulleys(mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
    """Return the address of each pulley that the text mentions and a body carries, by the name of that body."""
    found: dict[str, str] = {}
    for address in mentions:
        site = mechanism.site.get(f"{address}.left")
        if site is not None and site.body is not None:
            found[site.body] = address
    return found


def _end(mechanism: Mechanism, name: str, mentions: Mapping[str, str], carriers: Mapping[str, str]) -> str:
    """Return the phrase of the body at one end of a line; empty if the text has no name for it."""
    owner, site = name.rpartition(".")[0], mechanism.site[name]
    if owner in mentions:  # the rim of a pulley
        return mentions[owner]
    if site.body is None:
        return ""
    carried_pulley = carriers.get(site.body)
    return mentions.get(site.body) or (f"the axle of {mentions[carried_pulley]}" if carried_pulley else "")


def ends_label(phrase: str) -> str:
    """Return the legend label of a line, made of its ends: *block A – pulley P*."""
    ends = phrase.partition(" between ")[2] or phrase
    said = ends.replace("the axle of ", "axle of ").replace("the ", "").replace(" and ", " – ")
    return f"{said} (part)" if phrase.startswith("the part") else said


STRETCHED = "stretched"


@dataclass(frozen=True)
class Springs(Subject):
    """Springs as subjects of quantities."""

    name = slot = "spring"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all springs."""
        return tuple(line.name for line in mechanism.lines if isinstance(line.law, Elastic))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases of springs with names of their own or with distinguishable ends."""
        return springs(mechanism, mentions)

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text states a property of the spring, its ``stiffness`` or its natural ``length``."""
        return is_stated(need, mechanism.line[name].whole, said)

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return *stretched*, the direction in which extensions, their rates and forces count as positive."""
        del mechanism, name
        return [Sense(STRETCHED, ZERO)]

    def label(self, phrase: str) -> str:
        """Return the name of the spring, or its ends."""
        return ends_label(phrase)


def springs(mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
    """Return a phrase for every spring that the text can distinguish from others, by name."""
    elastic = [line for line in mechanism.lines if isinstance(line.law, Elastic)]
    return line_phrases(mechanism, mentions, elastic, "spring", alone=True)


@dataclass(frozen=True)
class Strings(Subject):
    """Parts of strings as subjects of quantities, including those that a hand pulls."""

    name = slot = "string"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all string parts, including those that a constant force pulls."""
        return tuple(line.name for line in mechanism.lines if isinstance(line.law, Inextensible | ConstantTension))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases of strings with distinguishable ends."""
        return strings(mechanism, mentions)

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text states `need` for every body: a tension depends on all of them."""
        del name
        return is_stated_for_all(need, mechanism, said)

    def label(self, phrase: str) -> str:
        """Return the ends of the string: *block A – pulley P*."""
        return ends_label(phrase)


def strings(mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
    """Return a phrase for every string part that may go slack and is distinguishable, by name."""
    return line_phrases(mechanism, mentions, mechanism.strings, "string", alone=not mechanism.pulls)

"""Interactions as kinds of subjects: strings, springs, contacts with faces, and pairs of bodies."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from itertools import permutations

from sim2reason.scenes.dsl.mechanism import ZERO, ConstantTension, Elastic, Inextensible, Line, Mechanism
from sim2reason.simulation.quantities.subjects import Sense, Subject, is_stated, is_stated_for_all
from sim2reason.simulation.quantities.subjects.bodies import Bodies, can_move


def line_phrases(
    mechanism: Mechanism, mentions: Mapping[str, str], lines: Iterable[Line], noun: str, *, alone: bool
) -> dict[str, str]:
    """Return a phrase for every line that the text can distinguish from others of its kind, by name.

    A line that is a body of the text has its mention as phrase; the only one of its kind, if `alone`, has its noun.
    """
    wheels = pulleys(mechanism, mentions)
    phrase_by_name: dict[str, str] = {}
    kept = list(lines)
    for line in kept:
        noun_phrase = noun if line.name == line.whole else f"part of the {noun}"
        ends = [_end(mechanism, site, mentions, wheels) for site in (line.through[0], line.through[-1])]
        if line.name in mentions:
            phrase_by_name[line.name] = mentions[line.name]
        elif alone and len(kept) == 1:
            phrase_by_name[line.name] = f"the {noun}"
        elif all(ends):
            phrase_by_name[line.name] = f"the {noun_phrase} between {ends[0]} and {ends[1]}"
    phrases = list(phrase_by_name.values())
    return {name: phrase for name, phrase in phrase_by_name.items() if phrases.count(phrase) == 1}


def pulleys(mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
    """Return the address of each pulley that the text mentions and a body carries, by the name of that body."""
    addresses: dict[str, str] = {}
    for address in mentions:
        site = mechanism.site.get(f"{address}.left")
        if site is not None and site.body is not None:
            addresses[site.body] = address
    return addresses


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
    label = ends.replace("the axle of ", "axle of ").replace("the ", "").replace(" and ", " – ")
    return f"{label} (part)" if phrase.startswith("the part") else label


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


SURFACES = ("plane", "incline", "table", "floor", "track", "surface")  # fields of entities on which bodies may lie
UNNAMED_SURFACE = "the surface beneath it"


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
        return mentions.get(parent, UNNAMED_SURFACE)
    owner = name
    while owner := owner.rpartition(".")[0]:
        surfaces = [mentions[f"{owner}.{field}"] for field in SURFACES if f"{owner}.{field}" in mentions]
        if surfaces:
            return surfaces[0] if list(mentions.values()).count(surfaces[0]) == 1 else f"{surfaces[0]} beneath it"
    return UNNAMED_SURFACE


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


PAIR_SEPARATOR = " & "


@dataclass(frozen=True)
class Pairs(Subject):
    """Pairs of bodies that can collide or attract each other, as subjects named ``a & b``."""

    name = slot = "pair"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all collision pairs, then those of attracting pairs."""
        met = [PAIR_SEPARATOR.join(meeting.names) for meeting in mechanism.meetings if len(meeting.names) == 2]
        drawn = [PAIR_SEPARATOR.join((pull.a, pull.b)) for pull in mechanism.attractions]
        return tuple(dict.fromkeys([*met, *drawn]))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases of pairs, such as *pucks A and B*, if both are named and one can move."""
        phrase_by_name: dict[str, str] = {}
        for name in self.names(mechanism):
            a, b = members(name)
            if a in mentions and b in mentions and (can_move(mechanism, a) or can_move(mechanism, b)):
                phrase_by_name[name] = pair(mentions[a], mentions[b])
        return phrase_by_name

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text gives the number `need`, such as the mass, of both bodies."""
        return all(Bodies().gives(need, mechanism, body, said) for body in members(name))

    def point(self, mechanism: Mechanism, name: str, phrase: str) -> str:
        """Return the phrase of the centres of the bodies, if they have a size."""
        wide = any(PAIR_SEPARATOR.join(met.names) == name and met.distance > 0.0 for met in mechanism.meetings)
        return f"the centres of {phrase}" if wide else phrase


def members(name: str) -> tuple[str, str]:
    """Return the names of the two bodies in the name of a pair."""
    a, _, b = name.partition(PAIR_SEPARATOR)
    return a, b


def pair(one: str, other: str) -> str:
    """Return the joint phrase of two bodies: *pucks A and B*, *block A and wedge W*."""
    noun, _, letter = one.rpartition(" ")
    same, _, second = other.rpartition(" ")
    return f"{noun}s {letter} and {second}" if noun == same and noun != "the" else f"{one} and {other}"


@dataclass(frozen=True)
class RelativeBodies(Subject):
    """Ordered pairs of moving bodies as subjects named ``a & b``: the first relative to the second."""

    name, slot = "body relative to another", "relative"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all ordered pairs of bodies whose centres of mass move."""
        moving = [name for name in mechanism.body if can_move(mechanism, name)]
        return tuple(PAIR_SEPARATOR.join(pair) for pair in permutations(moving, 2))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return no phrases, since only structured questions are about relative quantities."""
        del mechanism, mentions
        return {}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text gives the number `need`, such as the mass, of both bodies."""
        return all(Bodies().gives(need, mechanism, body, said) for body in members(name))

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return the directions that the text can name for both bodies."""
        one, other = (Bodies().senses(mechanism, body) for body in members(name))
        return [sense for sense in one if sense in other]

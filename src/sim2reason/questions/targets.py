"""What can be asked about in a scene: quantities of bodies, strings and contacts, each with its phrase."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import State
from sim2reason.dsl.vectors import Vector
from sim2reason.quantities import QUANTITIES

EVEN = 1e-9


@dataclass(frozen=True, slots=True)
class Sense:
    """A direction in the words of the text, and in room coordinates.

    `axis` names a component (``x``, ``horizontal``); empty where the body moves along one line anyway.
    """

    positive: str
    vector: Vector
    axis: str = ""


@dataclass(frozen=True, slots=True)
class Target:
    """A quantity of a subject: a magnitude, or the component along a sense."""

    quantity: str
    subject: str
    sense: Sense | None = None

    @property
    def unit(self) -> str:
        """The unit of the answer."""
        return QUANTITIES[self.quantity].unit

    @property
    def signed(self) -> bool:
        """Whether a minus sign can be right."""
        return self.sense is not None

    def value(self, state: State) -> float:
        """The value at the first instant of a state."""
        found = QUANTITIES[self.quantity].evaluate(state, self.subject)[0]
        if np.ndim(found) == 0:
            return float(found) if self.signed else abs(float(found))
        if self.sense is None:
            return float(np.linalg.norm(found))
        return float(np.dot(found, self.sense.vector))


GAIN = Sense("a gain", (0.0, 0.0, 1.0))
UP = "up"
PLAIN: Mapping[str, str] = {
    "displacement": "the distance of {body} from its starting point",
    "velocity": "the speed of {body}",
    "acceleration": "the magnitude of the acceleration of {body}",
    "momentum": "the magnitude of the momentum of {body}",
    "net force": "the magnitude of the net force on {body}",
    "kinetic energy": "the kinetic energy of {body}",
    "tension": "the tension in {string}",
    "normal force": "the normal force on {body} from the surface that it rests on",
    "friction force": "the magnitude of the friction force on {body} from the surface that it rests on",
}
SIGNED: Mapping[str, str] = {
    "displacement": "the {component}displacement of {body} from its starting point",
    "velocity": "the {component}velocity of {body}",
    "acceleration": "the {component}acceleration of {body}",
    "momentum": "the {component}momentum of {body}",
    "net force": "the {component}net force on {body}",
    "potential energy": "the gain in gravitational potential energy of {body} since the start (negative for a loss)",
}
GROUND = frozenset({"displacement", "velocity", "acceleration", "momentum"})


def targets(mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, Target]:
    """Everything that can be asked about, by the phrase that asks for it; ambiguous phrases are left out."""
    found: dict[str, Target] = {}
    twice: set[str] = set()
    for phrase, target in _phrased(mechanism, mentions):
        if phrase in found:
            twice.add(phrase)
        found[phrase] = target
    return {phrase: target for phrase, target in found.items() if phrase not in twice}


def _phrased(mechanism: Mechanism, mentions: Mapping[str, str]) -> Iterator[tuple[str, Target]]:
    for name in mechanism.body:
        if name in mentions and _moves(mechanism, name) and mechanism.body[name].mass > 0.0:
            yield from _of_body(mechanism, name, mentions[name])
    for name, contact in mechanism.contacts.items():
        if name in mentions:
            yield PLAIN["normal force"].format(body=mentions[name]), Target("normal force", name)
            if contact.friction > 0.0:
                yield PLAIN["friction force"].format(body=mentions[name]), Target("friction force", name)
    for name, phrase in strings(mechanism, mentions).items():
        yield PLAIN["tension"].format(string=phrase), Target("tension", name)


def _of_body(mechanism: Mechanism, name: str, mention: str) -> Iterator[tuple[str, Target]]:
    ground = " relative to the ground" if len(axes(mechanism, name)) > 1 and rides(mechanism, name) else ""
    for quantity, phrase in PLAIN.items():
        if "{body}" in phrase and QUANTITIES[quantity].of == "body":
            yield phrase.format(body=mention) + (ground if quantity in GROUND else ""), Target(quantity, name)
    for sense in senses(mechanism, name):
        component = f"{sense.axis} component of the " if sense.axis else ""
        for quantity, phrase in SIGNED.items():
            if QUANTITIES[quantity].vector:
                said = phrase.format(component=component, body=mention) + (ground if quantity in GROUND else "")
                yield said, Target(quantity, name, sense)
    if any(abs(axis[2]) > EVEN for axis in axes(mechanism, name)):
        yield SIGNED["potential energy"].format(body=mention), Target("potential energy", name, GAIN)


def axes(mechanism: Mechanism, name: str) -> list[Vector]:
    """The directions in which a body can move in the room, its own first."""
    found: list[Vector] = []
    step: str | None = name
    while step is not None:
        body = mechanism.body[step]
        found.extend(c.axis for c in body.coordinates if c.kind == "slide")
        step = body.parent
    return found


def rides(mechanism: Mechanism, name: str) -> bool:
    """Whether a body rides on another one that moves."""
    parent = mechanism.body[name].parent
    return parent is not None and _moves(mechanism, parent)


def _moves(mechanism: Mechanism, name: str) -> bool:
    return bool(axes(mechanism, name)) and not any(mechanism.body[name].inertia)


def senses(mechanism: Mechanism, name: str) -> list[Sense]:
    """The directions that the text gives words for: up, up the slope, the axes of a table.

    Left and right are only used where the text fixes them, which a prism with two faces does.
    """
    found, body = axes(mechanism, name), mechanism.body[name]
    if len(body.coordinates) == 2 and name not in mechanism.contacts:
        return [Sense(f"the {c.name[-1]} axis", c.axis, c.name[-1]) for c in body.coordinates]
    if len(found) == 1:
        return [] if abs(found[0][2]) < EVEN else [Sense(_uphill(found[0]), found[0])]
    return [Sense(UP, (0.0, 0.0, 1.0), "vertical")] if any(abs(axis[2]) > EVEN for axis in found) else []


def _uphill(axis: Vector) -> str:
    return UP if abs(axis[2]) > 1.0 - EVEN else "up the slope"


def strings(mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
    """A phrase for every string part that can be told by its ends, by name."""
    wheels = pulleys(mechanism, mentions)
    found: dict[str, str] = {}
    for string in mechanism.strings:
        ends = [_end(mechanism, site, mentions, wheels) for site in (string.through[0], string.through[-1])]
        if all(ends):
            part = "the string" if string.name == string.whole else "the part of the string"
            found[string.name] = f"{part} between {ends[0]} and {ends[1]}"
    if len(mechanism.lines) == 1 and mechanism.strings:
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

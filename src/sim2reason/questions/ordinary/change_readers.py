"""Readers of main clauses that ask how much a quantity changes, or how much energy is stored or lost."""

import re
from collections.abc import Iterator

from sim2reason.questions.ordinary.hearing import ALL, TokenizedSentence
from sim2reason.questions.ordinary.readers import CHANGE, GAIN, JUMP, LOSS, STRETCH, Main, each
from sim2reason.questions.ordinary.vocabulary import QUANTITIES, matching_entry
from sim2reason.questions.posing import PLUS

CHANGING = {GAIN: "gain increase rise grow", LOSS: "lose decrease drop fall diminish", CHANGE: "change"}


IMPULSE = "impulse of a collision"
ENERGIES = "kinetic energy", "translational kinetic energy", "rotational kinetic energy", "spring energy"


UNDIRECTED = {name: name for name in (*ENERGIES, "speed", "spring length", "extension", "fuel left")}


def stored(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the energy stored in a spring, or in several springs together."""
    yield Main("spring energy", PLUS.join(each(heard, found["s"])))


def changed(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the gain, the loss or the change of a quantity that has no direction."""
    name, verb = matching_entry(QUANTITIES, found["q"]), found["verb"]
    needs = next((needs for needs, row in CHANGING.items() if verb in row.split()), GAIN)
    who = heard.subject(found.groupdict().get("s"))
    if name in UNDIRECTED and not (who.startswith(ALL) and needs != CHANGE):  # where one gains what the other loses
        yield from (Main(UNDIRECTED[name], of, needs=needs) for of in each(heard, found.groupdict().get("s")))


def exchanged(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the momentum that a body gains or loses in a collision with another body: the impulse of that collision."""
    of = heard.subject(found["s"])
    if not of.startswith(f"{ALL} "):  # the momenta of both change by nothing together
        yield Main(IMPULSE, of, needs=JUMP)


def lost_in_impact(found: re.Match[str], heard: TokenizedSentence) -> Iterator[Main]:
    """Yield the kinetic energy that a body loses in an impact: all the mechanical energy that it loses there."""
    for of in each(heard, found.groupdict().get("s")):
        yield Main("kinetic energy", of, needs=JUMP)
        yield Main("energy dissipated by friction", needs=STRETCH, ways=((f"{ALL} {of}", ALL),) if of else ())

"""A light inextensible string: one path, one constraint, one sentence, however many pulleys it passes."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any, ClassVar, Self

from sim2reason.bodies.pulley import FixedPulley
from sim2reason.dsl.body import Body
from sim2reason.dsl.builder import Builder
from sim2reason.dsl.connection import Connection, Link, Told, connection
from sim2reason.dsl.layout import FREE, opposite
from sim2reason.dsl.measures import FreeLength
from sim2reason.dsl.mechanism import ZERO
from sim2reason.dsl.ports import End, Port, Stop, StringPort
from sim2reason.dsl.vectors import add, scale
from sim2reason.errors import SceneError

if TYPE_CHECKING:
    from sim2reason.dsl.reading.heard import Heard
    from sim2reason.dsl.reading.hearer import Hearer
    from sim2reason.dsl.reading.trails import Leg, Trail
    from sim2reason.dsl.telling.speaker import Speaker

OPENINGS = (
    "{string} tied to {tied} {verbs}.",
    "{string} is tied to {tied}; it {verbs}.",
    "from {tied} {string} {verbs}.",
)
LIGHT_STRING = "light string"
OVER, ROUND = "passes over ", "passes round "
ONWARD = {
    (OVER, OVER): "then over ",
    (ROUND, OVER): "goes straight up, over ",
    (OVER, ROUND): "goes straight down, round ",
}
"""How it goes on from one pulley to the next: above the one that turns it hangs another, on which it pulls straight."""


@connection
class String(Connection):
    """A string through ports, from end to end. Where neighbours' directions need a fixed pulley it brings one."""

    key: ClassVar[str] = "tendon"
    joins: ClassVar[type[Port]] = StringPort
    free: FreeLength = FREE

    @classmethod
    def between(cls, *stops: tuple[str, StringPort]) -> Self:
        """A string through ports of named entities: ``between(("a", Ramp.right), ("b", Hook.end))``."""
        return cls(links=tuple(Link(entity=name, port=port.name) for name, port in stops))

    @classmethod
    def owned(cls, name: str, stops: list[Stop], builder: Builder) -> dict[str, Body]:
        """The light fixed pulleys that it brings, in the order of travel."""
        count = sum(turn is not None for turn in turns(stops, builder))
        return {f"{name}.pulley{number}": FixedPulley() for number in range(1, count + 1)}

    @classmethod
    def stretch(cls, name: str, stops: list[Stop], builder: Builder, values: dict[str, Any]) -> None:
        """Lead it through the sites of its stops and over its own pulleys; a hand at its end pulls it."""
        frame = builder.room(name)
        path: list[str] = []
        number = 0
        for stop, turn in zip(stops, [*turns(stops, builder), None], strict=True):
            path.extend(travelled_sites(stop, first=not path))
            if turn is not None:
                number += 1
                for site, mark in zip(turn, ("in", "out"), strict=True):
                    away = scale(values.get("free", FREE), builder.faces[site] or ZERO)
                    frame.site(f"pulley{number}.{mark}", at=add(builder.position(site), away))
                    path.append(f"{name}.pulley{number}.{mark}")
        if all(builder.carrier(site) is None for site in path):
            raise SceneError(name, "nothing hangs on this string", "tie at least one end to a body")
        force = builder.hands.get(path[-1])
        if force is None and path[0] in builder.hands:
            path, force = path[::-1], builder.hands[path[0]]
        if path[0] in builder.hands:
            raise SceneError(name, "two hands pull at the two ends of one string", "fix or load one of its ends")
        if force is None:
            builder.add_string(name, path, 0.0)
        else:
            builder.add_pull(name, path, force)

    @classmethod
    def hear(cls, name: str, place: int, heard: "Heard", hearer: "Hearer", trail: "Trail") -> Iterator[Told]:
        """Read its sentence back: the opening, what it is tied to, then verb by verb."""
        return Ear(name, hearer, trail).sentence(place, heard)

    @classmethod
    def tell(cls, name: str, stops: list[Stop], speaker: "Speaker") -> str:
        """Its one sentence: what it is tied to, what it passes, where it ends."""
        stops = max(stops, reversed_path(stops), key=lambda path: _worth(path[0]))
        first = stops[0]
        if not isinstance(first.port, End) or not _worth(first):
            raise SceneError(name, "nothing hangs on this string", "tie at least one end to a body")
        opening = speaker.choose(OPENINGS)
        tied = speaker.render(first.port.tied, first.owner)
        verbs = [speaker.render(first.port.leaves, first.owner)] if first.port.leaves else []
        gaps = turns(stops, speaker.scene.builder)
        order = [f"{name}.pulley{n}" for n in range(1, 1 + sum(turn is not None for turn in gaps))]
        if stops[0] != speaker.scene.strings[name][1][0]:
            order.reverse()
        for stop, turn in zip(stops[1:], gaps, strict=True):
            if turn is not None:
                verbs.append(winding(turn, speaker.scene.builder) + speaker.at(order.pop(0)))
            port = stop.port
            verbs.append(speaker.render(port.arrives if isinstance(port, End) else port.passes, stop.owner))
        string = called(again=speaker.heard(LIGHT_STRING))
        return opening.replace("{string}", string).replace("{tied}", tied).replace("{verbs}", joined(verbs))


def called(*, again: bool) -> str:
    """What a string is called, the first one or one after others."""
    return f"another {LIGHT_STRING}" if again else f"a {LIGHT_STRING}"


def _worth(stop: Stop) -> int:
    """How well a sentence begins here: best at what moves, not at all at a hand."""
    port = stop.port
    return bool(port.tied) + bool(port.leaves) if isinstance(port, End) else 0


def travelled_sites(stop: Stop, *, first: bool) -> tuple[str, ...]:
    """The sites of a stop in the order of travel; an end is listed from the inside out."""
    return stop.sites if first or not isinstance(stop.port, End) else stop.sites[::-1]


def reversed_path(stops: list[Stop]) -> list[Stop]:
    """The same path from its other end."""
    return [Stop(s.owner, s.port, s.flipped if isinstance(s.port, End) else not s.flipped) for s in reversed(stops)]


def turns(stops: list[Stop], builder: Builder) -> list[tuple[str, str] | None]:
    """For each gap between stops the two sites on its sides if a fixed pulley must turn the string there."""
    found: list[tuple[str, str] | None] = []
    for index, (one, other) in enumerate(pairwise(stops)):
        leaves = travelled_sites(one, first=index == 0)[-1]
        reaches = travelled_sites(other, first=False)[0]
        straight = opposite(builder.faces[leaves], builder.faces[reaches])
        found.append(None if straight else (leaves, reaches))
    return found


def winding(turn: tuple[str, str], builder: Builder) -> str:
    """Over a pulley goes a string that comes up to it from both sides; else it goes round it."""
    rises = all((builder.faces[site] or ZERO)[2] >= 0.0 for site in turn)
    return OVER if rises else ROUND


def joined(verbs: list[str]) -> str:
    """V, V and V; a repeated verb becomes *then*, and a way that the next verb tells whole is not told twice."""
    verbs = verbs[1:] if len(verbs) > 1 and verbs[1].startswith(verbs[0]) else verbs
    said = [verbs[0], *(after(before, verb) for before, verb in pairwise(verbs))]
    return said[0] if len(said) == 1 else ", ".join(said[:-1]) + " and " + said[-1]


def after(before: str, verb: str) -> str:
    """A verb phrase as it is said after another one."""
    for (one, other), onward in ONWARD.items():
        if before.startswith(one) and verb.startswith(other):
            return onward + verb.removeprefix(other)
    return verb


class Ear:
    """Follows one sentence of a string through all that it can mean."""

    def __init__(self, name: str, hearer: "Hearer", trail: "Trail") -> None:
        """`trail` knows where the string may begin and go on."""
        self._name, self._hearer, self._trail = name, hearer, trail
        self._text = self._end = ""

    def sentence(self, place: int, heard: "Heard") -> Iterator[Told]:
        """All readings of the piece at `place`."""
        if place >= len(self._hearer.pieces):
            return
        self._text = self._hearer.pieces[place]
        again = any(LIGHT_STRING in piece for piece in self._hearer.pieces[:place])
        for number, opening in enumerate(OPENINGS):
            start, rest = opening.replace("{string}", called(again=again)).split("{tied}")
            between, self._end = rest.split("{verbs}")
            at = self._hearer.literal(self._text, 0, start)
            for told in self._tied(at, between, heard.chose(number)) if at is not None else ():
                self._hearer.reach = max(self._hearer.reach, place + 1)
                yield told

    def _tied(self, at: int, between: str, heard: "Heard") -> Iterator[Told]:
        """What it is tied to, and how it leaves there."""
        for leg in self._trail.legs(heard, ()):
            stop = leg.stops[0]
            if not isinstance(stop.port, End) or not stop.port.tied:
                continue
            for end, then in self._hearer.template(self._text, at, stop.port.tied, stop.owner, leg.heard):
                begin = self._hearer.literal(self._text, end, between)
                rest = replace(leg, stops=leg.stops[1:])
                if begin is not None and stop.port.leaves:
                    for here, left in self._hearer.template(self._text, begin, stop.port.leaves, stop.owner, then):
                        yield from self._on(here, replace(rest, heard=left), (leg.link,), (), stop.port.leaves)
                if begin is not None:  # how it leaves may be left to the verb after it
                    yield from self._on(begin, replace(rest, heard=then), (leg.link,), (), "")

    def _on(self, at: int, leg: "Leg", links: tuple[Link, ...], owned: tuple[str, ...], before: str) -> Iterator[Told]:
        """The verbs from `at` on: the other stops of this leg, then of the legs to come."""
        if leg.stops:
            yield from self._next(at, leg, links, owned, before)
        elif not leg.last:
            for new in self._trail.legs(leg.heard, links):
                yield from self._on(at, new, (*links, new.link), owned, before)
        elif self._text[at:] == self._end:
            yield Told(leg.heard, links, owned)

    def _next(
        self, at: int, leg: "Leg", links: tuple[Link, ...], owned: tuple[str, ...], before: str
    ) -> Iterator[Told]:
        """The next stop, perhaps behind a pulley that the string brings."""
        stop, rest = leg.stops[0], leg.stops[1:]
        verb = stop.port.arrives if isinstance(stop.port, End) else stop.port.passes
        final = leg.last and not rest
        for end, then in self._verb(at, verb, before, leg.heard, stop.owner, final=final):
            yield from self._on(end, replace(leg, stops=rest, heard=then), links, owned, verb)
        if owned and before.endswith(f"{{{owned[-1]}}}"):
            return  # there is one pulley in a gap at most
        address = f"{self._name}.pulley{len(owned) + 1}"
        own = replace(leg.heard.knowing(address, FixedPulley), values={**leg.heard.values, f"{address}.mass": 0.0})
        for word in (OVER, ROUND):  # which of them is right, telling it again will show
            passed = f"{word}{{{address}}}"
            for end, then in self._verb(at, passed, before, own, "", final=False):
                yield from self._next(end, replace(leg, heard=then), links, (*owned, address), passed)

    def _verb(
        self, at: int, verb: str, before: str, heard: "Heard", owner: str, *, final: bool
    ) -> Iterator[tuple[int, "Heard"]]:
        """One verb phrase with what joins it to the one before."""
        said, comma = (after(before, verb), " and " if final else ", ") if before else (verb, "")
        begin = self._hearer.literal(self._text, at, comma)
        if begin is None:
            return
        yield from self._hearer.template(self._text, begin, said, owner, heard)

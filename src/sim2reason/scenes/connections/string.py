"""The light inextensible string: one path, one constraint and one sentence, with any number of pulleys."""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import ClassVar, Generic, Self

from sim2reason.errors import SceneError
from sim2reason.scenes.bodies.simple_machines import FixedPulley
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import (
    FREE_LENGTH,
    Connection,
    Joint,
    Leg,
    Link,
    ParsedSentence,
    Routes,
    S,
    SentenceMatcher,
    SentenceWriter,
    connection,
)
from sim2reason.scenes.dsl.defaults import opposite_direction
from sim2reason.scenes.dsl.measures import FreeLength
from sim2reason.scenes.dsl.mechanism import ZERO, Inextensible
from sim2reason.scenes.dsl.ports import Pass, Port, SitePort, Stop, StringEnd, StringPort
from sim2reason.scenes.dsl.vectors import add, scale

OPENINGS = (
    "{string} tied to {tied} {verbs}.",
    "{string} is tied to {tied}; it {verbs}.",
    "from {tied} {string} {verbs}.",
)
HANGING = (
    "{tied} hangs on {string} that {verbs}.",
    "{tied} hangs from {string}, which {verbs}.",
)
"""Openings for a string tied to a hanging body, without a clause for its direction there."""
ORDINAL_PHRASES = (
    ("a light string",),
    ("another light string", "a second light string"),
    *((f"a {which} light string",) for which in ("third", "fourth", "fifth", "sixth", "seventh", "eighth")),
)
"""Phrases for the first, second, … string of a text."""
FURTHER_PHRASES = ("one more light string", "a further light string")
"""Phrases for a further string that is not numbered."""
_ONE = re.compile(r"light string(?!s)|(?:another|one more) (?:joins|runs|leads)")
OVER, UNDER, ROUND = "passes over ", "passes under ", "passes round "
WAYS = (OVER, UNDER, ROUND)
VERTICAL_COMPONENT_TOL = 1e-9  # smaller vertical components of a direction are round-off
CONTINUATIONS = {
    (OVER, OVER): "then over ",
    (ROUND, OVER): "goes straight up and over ",
    (UNDER, OVER): "goes straight up and over ",
    (OVER, ROUND): "goes straight down and round ",
    (OVER, UNDER): "goes straight down and under ",
}
"""Phrases for the next pulley after another: the string continues straight to a pulley above."""


@connection
class String(Connection):
    """A string through ports, from end to end. Where neighbours' directions need a fixed pulley it brings one."""

    key: ClassVar[str] = "tendon"
    joins: ClassVar[type[Port]] = StringPort
    free: FreeLength = FREE_LENGTH

    @classmethod
    def between(cls, *stops: tuple[str, StringPort]) -> Self:
        """Return a string through ports of named entities: ``between(("a", Ramp.right), ("b", Hook.end))``."""
        return cls(links=tuple(Link(entity=name, port=port.name) for name, port in stops))

    @property
    def spacing(self) -> float:
        """Return the initial length between neighbouring stops, m."""
        return self.free

    def brings(self, joint: Joint, builder: Builder) -> dict[str, Body]:
        """Return the light fixed pulleys that belong to the string, in the order of travel."""
        count = sum(turn is not None for turn in redirections(joint.stops, builder))
        return {f"{joint.name}.pulley{number}": FixedPulley() for number in range(1, count + 1)}

    def build(self, joint: Joint, builder: Builder) -> None:
        """Build the line through the sites of its stops and over its own pulleys; a hand at its end pulls it."""
        name, stops = joint.name, joint.stops
        frame = builder.room(name)
        path: list[str] = []
        number = 0
        for stop, turn in zip(stops, [*redirections(stops, builder), None], strict=True):
            path.extend(travelled_sites(stop, first=not path))
            if turn is not None:
                number += 1
                for site, mark in zip(turn, ("in", "out"), strict=True):
                    away = scale(self.free, builder.faces[site] or ZERO)
                    frame.site(f"pulley{number}.{mark}", at=add(builder.position(site), away))
                    path.append(f"{name}.pulley{number}.{mark}")
        if all(builder.carrier(site) is None for site in path):
            raise SceneError(name, "nothing hangs on this string", "tie at least one end to a body")
        if path[0] in builder.drawing:
            path.reverse()
        if path[0] in builder.drawing:
            raise SceneError(name, "both ends of one string are drawn in", "fix or load one of its ends")
        builder.add_line(name, path, Inextensible(), last=builder.drawing.get(path[-1]))

    @classmethod
    def parse(
        cls, name: str, place: int, state: S, matcher: SentenceMatcher[S], routes: Routes[S]
    ) -> Iterator[ParsedSentence[S]]:
        """Yield all parses of the sentence: the opening, the tied body, then verb by verb."""
        return SentenceParser(name, matcher, routes).sentence(place, state)

    def describe(self, joint: Joint, writer: SentenceWriter) -> str:
        """Return the sentence of the string: its tied body, the pulleys that it passes, and its end."""
        name = joint.name
        stops = max(joint.stops, reversed_path(joint.stops), key=lambda path: _opening_rank(path[0]))
        first = stops[0]
        if not isinstance(first.port, StringEnd) or not _opening_rank(first):
            raise SceneError(name, "nothing hangs on this string", "tie at least one end to a body")
        opening = writer.choose((*HANGING, *OPENINGS) if first.port.hangs else OPENINGS)
        string = writer.choose(string_names(writer.finished))
        tied = writer.render(first.port.tied, first.owner)
        leaves = first.port.leaves and opening not in HANGING
        verbs = [writer.render(first.port.leaves, first.owner)] if leaves else []
        gaps = redirections(stops, writer.builder)
        order = [f"{name}.pulley{n}" for n in range(1, 1 + sum(turn is not None for turn in gaps))]
        if stops[0] != joint.stops[0]:
            order.reverse()
        for index, (stop, turn) in enumerate(zip(stops[1:], gaps, strict=True), start=1):
            if turn is not None:
                verbs.append(winding(turn, writer.builder) + writer.at(order.pop(0)))
            verbs.append(
                writer.render(clause(stop.port, passing_preposition(stops, index, writer.builder)), stop.owner)
            )
        return opening.replace("{string}", string).replace("{tied}", tied).replace("{verbs}", join_verbs(verbs))


def clause(port: SitePort, preposition: str = OVER) -> str:
    """Return the verb phrase for a string arriving at a port; `preposition` is the preposition for a fixed pulley."""
    if isinstance(port, Pass):
        return preposition + port.passes.removeprefix(OVER) if port.passes.startswith(OVER) else port.passes
    return port.arrives if isinstance(port, StringEnd) else ""


def passing_preposition(stops: Sequence[Stop], index: int, builder: Builder) -> str:
    """Return the preposition (over, under, round) for a pulley, from its neighbours if its sides have no direction."""
    if not isinstance(stops[index].port, Pass) or any(builder.faces[site] for site in stops[index].sites):
        return OVER
    turn = travelled_sites(stops[index - 1], first=index == 1)[-1], travelled_sites(stops[index + 1], first=False)[0]
    return winding(turn, builder) if all(builder.faces[site] for site in turn) else OVER


def string_names(sentences: Iterable[str]) -> tuple[str, ...]:
    """Return the phrases that may introduce the next string, such as *a third light string*, after these sentences.

    Strings in a row of blocks do not count.
    """
    text = " ".join(sentences)
    count = len(_ONE.findall(text))
    return FURTHER_PHRASES if "light strings" in text or count >= len(ORDINAL_PHRASES) else ORDINAL_PHRASES[count]


def _opening_rank(stop: Stop) -> int:
    """Return a rank of a stop as the beginning of a sentence: highest for a movable body, zero for a hand."""
    port = stop.port
    return bool(port.tied) + bool(port.leaves) if isinstance(port, StringEnd) else 0


def travelled_sites(stop: Stop, *, first: bool) -> tuple[str, ...]:
    """Return a stop's sites in the order in which the string runs; an end lists them from the inside out."""
    return stop.sites if first or not isinstance(stop.port, StringEnd) else stop.sites[::-1]


def reversed_path(stops: Sequence[Stop]) -> tuple[Stop, ...]:
    """Return the same path, travelled from its other end."""
    return tuple(
        Stop(s.owner, s.port, s.flipped if isinstance(s.port, StringEnd) else not s.flipped) for s in reversed(stops)
    )


def redirections(stops: Sequence[Stop], builder: Builder) -> list[tuple[str, str] | None]:
    """Return, for each gap between stops, the two adjacent sites if a fixed pulley must redirect the string there."""
    pairs: list[tuple[str, str] | None] = []
    for index, (one, other) in enumerate(pairwise(stops)):
        leaves = travelled_sites(one, first=index == 0)[-1]
        reaches = travelled_sites(other, first=False)[0]
        straight = opposite_direction(builder.faces[leaves], builder.faces[reaches])
        pairs.append(None if straight else (leaves, reaches))
    return pairs


def winding(turn: tuple[str, str], builder: Builder) -> str:
    """Return the preposition for a fixed pulley between two sites: over, under or round, by the bend of the string.

    The string passes over if it rises to the pulley on a side and on none descends to it, whatever the angles are: the
    preposition does not reveal them. If it rises and continues upward, or stays horizontal, it passes round.
    """
    rises = [(builder.faces[site] or ZERO)[2] for site in turn]
    over, under = (
        any(rise > VERTICAL_COMPONENT_TOL for rise in rises),
        any(rise < -VERTICAL_COMPONENT_TOL for rise in rises),
    )
    return ROUND if over == under else OVER if over else UNDER


def join_verbs(verbs: list[str]) -> str:
    """Return verb phrases as one list *V, V and V*; a repeated verb becomes *then*."""
    verbs = verbs[1:] if len(verbs) > 1 and verbs[1].startswith(verbs[0]) else verbs
    phrases = [verbs[0], *(verb_after(before, verb) for before, verb in pairwise(verbs))]
    return phrases[0] if len(phrases) == 1 else ", ".join(phrases[:-1]) + " and " + phrases[-1]


def verb_after(before: str, verb: str) -> str:
    """Return a verb phrase as it follows another: *passes over* after *passes over* becomes *then over*."""
    for (one, other), onward in CONTINUATIONS.items():
        if before.startswith(one) and verb.startswith(other):
            return onward + verb.removeprefix(other)
    return verb


class SentenceParser(Generic[S]):
    """Parser of one sentence of a string that follows all its possible meanings."""

    def __init__(self, name: str, matcher: SentenceMatcher[S], routes: Routes[S]) -> None:
        """Store the name of the connection and the `routes`, the ports where the string may begin or continue."""
        self._name, self._matcher, self._routes = name, matcher, routes
        self._text = self._end = ""

    def sentence(self, place: int, state: S) -> Iterator[ParsedSentence[S]]:
        """Yield all readings of the sentence at index `place`."""
        if place >= len(self._matcher.pieces):
            return
        self._text = self._matcher.pieces[place]
        names = string_names(self._matcher.pieces[:place])
        for hangs, openings in ((False, OPENINGS), (True, (*HANGING, *OPENINGS))):
            for number, opening in enumerate(openings):
                for which, string in enumerate(names):
                    chosen = state.with_choice(number).with_choice(which)
                    for parsed in self._opened(opening.replace("{string}", string), chosen, hangs=hangs):
                        self._matcher.reach = max(self._matcher.reach, place + 1)
                        yield parsed

    def _opened(self, opening: str, state: S, *, hangs: bool) -> Iterator[ParsedSentence[S]]:
        """Yield all readings of a sentence with this opening, for ends with a hanging body (`hangs`) or for others."""
        start, rest = opening.split("{tied}")
        between, self._end = rest.split("{verbs}")
        at = self._matcher.literal(self._text, 0, start)
        if at is not None and between in self._text and self._text.endswith(self._end):
            yield from self._tied(at, between, state, hangs=hangs)

    def _tied(self, at: int, between: str, state: S, *, hangs: bool) -> Iterator[ParsedSentence[S]]:
        """Yield the readings of the tied body and of the direction in which the string leaves it."""
        for leg in self._routes.legs(String, state, ()):
            stop = leg.stops[0]
            if not isinstance(stop.port, StringEnd) or not stop.port.tied or stop.port.hangs is not hangs:
                continue
            for end, then in self._matcher.template(self._text, at, stop.port.tied, stop.owner, leg.state):
                begin = self._matcher.literal(self._text, end, between)
                rest = replace(leg, stops=leg.stops[1:])
                if begin is not None and stop.port.leaves:
                    for here, left in self._matcher.template(self._text, begin, stop.port.leaves, stop.owner, then):
                        yield from self._parse_continuation(
                            here, replace(rest, state=left), (leg.link,), (), stop.port.leaves
                        )
                if begin is not None:  # how it leaves may be left to the verb after it
                    yield from self._parse_continuation(begin, replace(rest, state=then), (leg.link,), (), "")

    def _parse_continuation(
        self, at: int, leg: Leg[S], links: tuple[Link, ...], owned: tuple[str, ...], before: str
    ) -> Iterator[ParsedSentence[S]]:
        """Yield the readings of the text from index `at` on, for a string that continues through the stops of `leg`."""
        if leg.stops:
            yield from self._next(at, leg, links, owned, before)
        elif not leg.last:
            for new in self._routes.legs(String, leg.state, links):
                yield from self._parse_continuation(at, new, (*links, new.link), owned, before)
        elif self._text[at:] == self._end:
            yield ParsedSentence(leg.state, links, owned)

    def _next(
        self, at: int, leg: Leg[S], links: tuple[Link, ...], owned: tuple[str, ...], before: str
    ) -> Iterator[ParsedSentence[S]]:
        """Yield the readings of the next stop, perhaps after a pulley that belongs to the string."""
        stop, rest = leg.stops[0], leg.stops[1:]
        final = leg.last and not rest
        for verb in dict.fromkeys(clause(stop.port, preposition) for preposition in WAYS):
            for end, then in self._verb(at, verb, before, leg.state, stop.owner, final=final):
                yield from self._parse_continuation(end, replace(leg, stops=rest, state=then), links, owned, verb)
        if owned and before.endswith(f"{{{owned[-1]}}}"):
            return  # there is one pulley in a gap at most
        address = f"{self._name}.pulley{len(owned) + 1}"
        own = leg.state.with_kind(address, FixedPulley).with_value(f"{address}.mass", 0.0) or leg.state
        for word in WAYS:  # which of them is right, telling it again will show
            passed = f"{word}{{{address}}}"
            for end, then in self._verb(at, passed, before, own, "", final=False):
                yield from self._next(end, replace(leg, state=then), links, (*owned, address), passed)

    def _verb(self, at: int, verb: str, before: str, state: S, owner: str, *, final: bool) -> Iterator[tuple[int, S]]:
        """Yield the readings of one verb phrase, with the comma or *and* that joins it to the phrase before."""
        phrase, comma = (verb_after(before, verb), " and " if final else ", ") if before else (verb, "")
        begin = self._matcher.literal(self._text, at, comma)
        if begin is None:
            return
        yield from self._matcher.template(self._text, begin, phrase, owner, state)

"""Connections between exactly two ports, described by one sentence."""

import re
from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any, ClassVar, Self

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import (
    Connection,
    Joint,
    Leg,
    Link,
    ParsedSentence,
    Routes,
    S,
    SentenceMatcher,
    SentenceWriter,
)
from sim2reason.scenes.dsl.entity import phrase_of
from sim2reason.scenes.dsl.model import field_types
from sim2reason.scenes.dsl.ports import SitePort, StringEnd
from sim2reason.scenes.dsl.template import Wordings, paths

NO_LINK = (Link(entity="", port=""),)
"""Placeholder for the first end while only the last one is known."""

_SLOTS = re.compile(r"\{(a|b|way)\}")


class TwoEnded(Connection):
    """Base class of connections with one sentence; ``{a}`` and ``{b}`` are the phrases of its first and last port.

    If a port declares the direction in which a connection leaves it, the sentence begins there, at ``{a}``, with
    ``{way}``.
    """

    says: ClassVar[Wordings] = Wordings(())
    leads: ClassVar[Wordings] = Wordings(())
    """The wordings that begin at an end with a direction; empty if the connection cannot join such ends."""

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:  # noqa: ANN401 - pydantic's hook
        """Raise TypeError if the sentence of a subclass omits a number or an end."""
        held = field_types(cls).items()
        numbers = {name for name, kind in held if (kind.measure is not None or kind.words) and not kind.hidden}
        for wordings, ends in ((cls.says.wordings, {"a", "b"}), (cls.leads.wordings, {"a", "way", "b"})):
            for template in wordings:
                missing = (ends | numbers) - _told(cls, template)
                if missing:
                    raise TypeError(f"{cls.__name__}: {template!r} leaves {', '.join(sorted(missing))} unsaid")

    @classmethod
    def between(cls, one: tuple[str, SitePort], other: tuple[str, SitePort], **numbers: float) -> Self:
        """Return a connection from a port of a named entity to a port of another."""
        links = tuple(Link(entity=name, port=port.name) for name, port in (one, other))
        return cls(links=links, **numbers)  # type: ignore[arg-type]  # each is a field of the class, validated by it

    def brings(self, joint: Joint, builder: Builder) -> dict[str, Body]:
        """Return no bodies, since the connection has none of its own."""
        del joint, builder
        return {}

    def describe(self, joint: Joint, writer: SentenceWriter) -> str:
        """Return the sentence of the connection, which begins at the first end with a direction."""
        if len(joint.stops) != 2:
            raise SceneError(joint.name, f"a {self.key} joins two ports", "lead it past nothing")
        first, last = sorted(joint.stops, key=lambda stop: not self.way(stop.port))
        way = self.way(first.port)
        said = {
            "a": (phrase_of(first.port), first.owner),
            "b": (phrase_of(last.port), last.owner),
            "way": (way, first.owner),
        }
        text = ""
        for piece, slot in _pieces(writer.choose((self.leads if way else self.says).wordings)):
            text += writer.render(piece, joint.name) if piece else ""
            text += writer.render(*said[slot]) if slot else ""
        return text

    @classmethod
    def way(cls, port: SitePort) -> str:
        """Return the verb phrase with which a line leaves a port that has a direction; empty for other ports."""
        return port.leaves if cls.leads.wordings and isinstance(port, StringEnd) else ""

    @classmethod
    def parse(
        cls, name: str, place: int, state: S, matcher: SentenceMatcher[S], routes: Routes[S]
    ) -> Iterator[ParsedSentence[S]]:
        """Yield all parses of the sentence: every wording, between every two ports that the connection can join."""
        if place >= len(matcher.pieces):
            return
        text = matcher.pieces[place]
        told = [*enumerate(cls.says.wordings), *enumerate(cls.leads.wordings)]
        for number, template in told:
            if not all(matcher.contains_fixed_words(place, piece) for piece, _ in _pieces(template)):
                continue
            begin = state.with_choice(number).with_kind(name, cls)
            for end, then, legs in cls._matched(text, 0, _pieces(template), {}, (name, begin, matcher, routes)):
                directed = any(cls.way(leg.stops[0].port) for leg in legs.values())
                if end == len(text) and len(legs) == 2 and directed == (template in cls.leads.wordings):
                    matcher.reach = max(matcher.reach, place + 1)
                    yield ParsedSentence(then, (legs["a"].link, legs["b"].link), ())

    @classmethod
    def _matched(
        cls,
        text: str,
        at: int,
        pieces: Sequence[tuple[str, str]],
        legs: dict[str, Leg[S]],
        known: tuple[str, S, SentenceMatcher[S], Routes[S]],
    ) -> Iterator[tuple[int, S, dict[str, Leg[S]]]]:
        name, state, matcher, routes = known
        if not pieces:
            yield at, state, legs
            return
        (piece, slot), *rest = pieces
        for after, then in matcher.template(text, at, piece, name, state) if piece else ((at, state),):
            if not slot:
                yield from cls._matched(text, after, rest, legs, (name, then, matcher, routes))
                continue
            for leg in (legs["a"],) if slot == "way" else cls._ends(slot, legs, routes, then):
                stop, known_by = leg.stops[0], then if slot == "way" else leg.state
                phrase = cls.way(stop.port) if slot == "way" else phrase_of(stop.port)
                for here, told in matcher.template(text, after, phrase, stop.owner, known_by) if phrase else ():
                    found = legs if slot == "way" else {**legs, slot: leg}
                    yield from cls._matched(text, here, rest, found, (name, told, matcher, routes))

    @classmethod
    def _ends(cls, slot: str, legs: dict[str, Leg[S]], routes: Routes[S], state: S) -> Iterator[Leg[S]]:
        """Yield the ports that fit the end `slot` of the connection, given the other end if known (`legs`)."""
        other = tuple(leg.link for key, leg in legs.items() if key != slot)
        for leg in routes.legs(cls, state, other or NO_LINK if slot == "b" else ()):
            if leg.link not in other and cls.admits(leg.stops[0].port, "ab".index(slot), 1):
                yield leg


def _told(cls: type[Connection], template: str) -> set[str]:
    """Return the placeholders of ends and numbers that a wording states, also in words that depend on a value."""
    found = set(paths(template))
    for word in (cls.words[name] for name in found & cls.words.keys()):
        found |= {path for text in (*word.special.values(), word.otherwise) for path in paths(text)}
    return found


@cache
def _pieces(template: str) -> tuple[tuple[str, str], ...]:
    """Split a template into texts, each with the placeholder of an end or direction that follows it, if any."""
    parts = _SLOTS.split(template)
    return tuple((parts[i], parts[i + 1] if i + 1 < len(parts) else "") for i in range(0, len(parts), 2))

"""Connections between two ports: pivots, welds, light rods and springs, and their base classes."""

import re
from collections.abc import Iterator, Sequence
from functools import cache
from math import dist
from typing import Annotated, Any, ClassVar, Literal, Self

from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import (
    FREE_LENGTH,
    Connection,
    Joint,
    Leg,
    Link,
    Look,
    ParsedSentence,
    Routes,
    S,
    SentenceMatcher,
    SentenceWriter,
    connection,
)
from sim2reason.scenes.dsl.defaults import opposite_direction
from sim2reason.scenes.dsl.entity import port_phrase
from sim2reason.scenes.dsl.measures import Chance, FreeLength, Measure, Range, Stiffness, Strain
from sim2reason.scenes.dsl.mechanism import Rigid
from sim2reason.scenes.dsl.model import field_types
from sim2reason.scenes.dsl.ports import Attachment, Base, Mount, Port, SitePort, StringEnd
from sim2reason.scenes.dsl.template import Word, Wordings, either, paths

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
        fields = field_types(cls).items()
        numbers = {name for name, kind in fields if (kind.measure is not None or kind.words) and not kind.hidden}
        for wordings, ends in ((cls.says.wordings, {"a", "b"}), (cls.leads.wordings, {"a", "way", "b"})):
            for template in wordings:
                missing = (ends | numbers) - _stated_paths(cls, template)
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
        direction = self.way(first.port)
        phrases = {
            "a": (port_phrase(first.port), first.owner),
            "b": (port_phrase(last.port), last.owner),
            "way": (direction, first.owner),
        }
        text = ""
        for piece, slot in _pieces(writer.choose((self.leads if direction else self.says).wordings)):
            text += writer.render(piece, joint.name) if piece else ""
            text += writer.render(*phrases[slot]) if slot else ""
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
        templates = [*enumerate(cls.says.wordings), *enumerate(cls.leads.wordings)]
        for number, template in templates:
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
                phrase = cls.way(stop.port) if slot == "way" else port_phrase(stop.port)
                for here, next_state in matcher.template(text, after, phrase, stop.owner, known_by) if phrase else ():
                    all_legs = legs if slot == "way" else {**legs, slot: leg}
                    yield from cls._matched(text, here, rest, all_legs, (name, next_state, matcher, routes))

    @classmethod
    def _ends(cls, slot: str, legs: dict[str, Leg[S]], routes: Routes[S], state: S) -> Iterator[Leg[S]]:
        """Yield the ports that fit the end `slot` of the connection, given the other end if known (`legs`)."""
        other = tuple(leg.link for key, leg in legs.items() if key != slot)
        for leg in routes.legs(cls, state, other or NO_LINK if slot == "b" else ()):
            if leg.link not in other and cls.admits(leg.stops[0].port, "ab".index(slot), 1):
                yield leg


def _stated_paths(cls: type[Connection], template: str) -> set[str]:
    """Return the placeholders of ends and numbers that a wording states, also in words that depend on a value."""
    placeholders = set(paths(template))
    for word in (cls.words[name] for name in placeholders & cls.words.keys()):
        placeholders |= {path for text in (*word.special.values(), word.otherwise) for path in paths(text)}
    return placeholders


@cache
def _pieces(template: str) -> tuple[tuple[str, str], ...]:
    """Split a template into texts, each with the placeholder of an end or direction that follows it, if any."""
    parts = _SLOTS.split(template)
    return tuple((parts[i], parts[i + 1] if i + 1 < len(parts) else "") for i in range(0, len(parts), 2))


class Straight(TwoEnded):
    """Base class of light straight lines between two attachments, which the line can leave in opposite directions."""

    joins: ClassVar[type[Port]] = Attachment
    free: FreeLength = FREE_LENGTH

    @property
    def spacing(self) -> float:
        """Return the initial length, m."""
        return self.free

    def ends(self, joint: Joint, builder: Builder) -> list[str]:
        """Return the two joined sites; raise SceneError if the line between them would have to bend."""
        sites = [stop.sites[0] for stop in joint.stops]
        if not opposite_direction(*(builder.faces[site] for site in sites)):
            problem = f"{' and '.join(map(str, self.links))} do not face each other, and a {self.key} runs straight"
            raise SceneError(
                joint.name, problem, "join ends that it can leave in opposite directions, or lead a string"
            )
        return sites


class Carried(TwoEnded):
    """Base class of connections that mount the base of one entity on a mount of another, its carrier."""

    joins: ClassVar[type[Port]] = SitePort
    look: ClassVar[Look] = "pivot"
    carries: ClassVar[bool] = True

    @classmethod
    def admits(cls, port: Port, index: int, last: int) -> bool:
        """Return whether a port fits: a mount at the carrier's end, a base at the other end."""
        return isinstance(port, Base if index == last else Mount)

    def build(self, joint: Joint, builder: Builder) -> None:
        """Build nothing, since the carried entity was built on its carrier."""
        del joint, builder


@connection
class Pivot(Carried):
    """A frictionless axle between a point of one entity and the base of another."""

    key: ClassVar[str] = "pivot"

    says: ClassVar[Wordings] = either(
        "{b} turns without friction about an axle on {a}.",
        "{b} is attached to {a} by a frictionless axle.",
        "a frictionless axle joins {b} to {a}.",
    )


@connection
class Weld(Carried):
    """A rigid joint between a point of one entity and the base of another."""

    key: ClassVar[str] = "weld"
    stiff: ClassVar[bool] = True
    look: ClassVar[Look] = "weld"

    says: ClassVar[Wordings] = either(
        "{b} is fixed rigidly to {a}.",
        "{b} is welded to {a}.",
        "a rigid joint holds {b} fast to {a}.",
    )


@connection
class Rod(Straight):
    """A light rigid rod, hinged at both ends, along the line of the two points that it joins."""

    key: ClassVar[str] = "rod"
    look: ClassVar[Look] = "rod"

    says: ClassVar[Wordings] = either(
        "a light rigid rod, hinged at both ends, joins {a} to {b}.",
        "{a} is joined to {b} by a light rigid rod that is hinged at both ends.",
        "between {a} and {b} runs a light rigid rod, hinged at both ends.",
    )
    leads: ClassVar[Wordings] = either(
        "from {a} a light rigid rod, hinged at both ends, {way} to {b}.",
        "a light rigid rod is hinged to {a} and {way} to {b}, to which it is hinged as well.",
        "a light rigid rod, hinged to {a}, {way} to {b} and is hinged there, too.",
    )

    def build(self, joint: Joint, builder: Builder) -> None:
        """Add a rigid line from site to site, which pulls or pushes."""
        builder.add_line(joint.name, self.ends(joint, builder), Rigid())


Dashpot = Annotated[float, Ge(0), Le(1e6), Measure("damping constant", "N*s/m", "b"), Range(0.2, 3.0), Chance(0.25)]


@connection
class SpringConnection(Straight):
    """A light spring along the line of the two points that it joins, strained at the start or not, damped or not."""

    key: ClassVar[str] = "spring"
    look: ClassVar[Look] = "spring"
    stiffness: Stiffness
    strained: Annotated[Literal["stretched", "compressed"], Chance(1.0)] = "stretched"
    by: Annotated[Strain, Chance(0.5)] = 0.0
    damping: Dashpot = 0.0

    words: ClassVar[dict[str, Word]] = {
        "strain": Word("by", {0.0: "relaxed"}, "{strained} by {by}"),
        "dashpot": Word("damping", {0.0: ""}, " with a light dashpot of damping constant {damping} beside it"),
        "damped": Word("damping", {0.0: ""}, ", and beside it acts a light dashpot of damping constant {damping}"),
    }
    says: ClassVar[Wordings] = either(
        "a light spring of stiffness {stiffness}{dashpot}, initially {strain}, joins {a} to {b}.",
        "{a} is joined to {b} by a light spring of stiffness {stiffness}, initially {strain}{damped}.",
        "between {a} and {b} runs a light spring of stiffness {stiffness}{dashpot}; at the start the spring is {strain}.",
    )
    leads: ClassVar[Wordings] = either(
        "from {a} a light spring of stiffness {stiffness}{dashpot}, initially {strain}, {way} to {b}.",
        "a light spring of stiffness {stiffness} is fastened to {a}; initially {strain}, it {way} to {b}{damped}.",
        "a light spring of stiffness {stiffness}{dashpot}, fastened to {a}, {way} to {b} and is {strain} at the start.",
    )

    @model_validator(mode="after")
    def _strained_or_not(self) -> Self:
        if self.by == 0.0 and self.strained != "stretched":
            raise ValueError("strained: a spring strained by 0 is relaxed; leave it out, or say by how much")
        return self

    @property
    def spacing(self) -> float:
        """Return the free length at the start, m: the smaller of initial and natural length, both being positive."""
        return self.free + (self.by if self.strained == "stretched" else 0.0)

    def build(self, joint: Joint, builder: Builder) -> None:
        """Add a spring from site to site; its natural length follows from their distance and the strain."""
        ends = self.ends(joint, builder)
        strain = self.by if self.strained == "stretched" else -self.by
        length = dist(*map(builder.position, ends)) - strain
        builder.add_spring(joint.name, ends, self.stiffness, length, self.damping)

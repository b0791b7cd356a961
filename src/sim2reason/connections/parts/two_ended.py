"""Connections between two ports and no more: one sentence, its numbers and what it joins."""

import re
from collections.abc import Iterator
from typing import Any, ClassVar, Self

from sim2reason.dsl.body import Body
from sim2reason.dsl.builder import Builder
from sim2reason.dsl.connection import (
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
from sim2reason.dsl.entity import phrase_of
from sim2reason.dsl.model import field_types
from sim2reason.dsl.ports import SitePort
from sim2reason.dsl.template import Wordings, paths
from sim2reason.errors import SceneError

_ENDS = re.compile(r"\{([ab])\}")


class TwoEnded(Connection):
    """A connection with one sentence, in which ``{a}`` and ``{b}`` are what its first and its last port call themselves."""

    says: ClassVar[Wordings] = Wordings(())

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:  # noqa: ANN401 - pydantic's hook
        """Refuse a class whose sentence leaves a number or an end unsaid; TypeError says which."""
        numbers = {name for name, held in field_types(cls).items() if held.measure is not None and not held.hidden}
        for template in cls.says.wordings:
            missing = ({"a", "b"} | numbers) - set(paths(template))
            if missing:
                raise TypeError(f"{cls.__name__}: {template!r} leaves {', '.join(sorted(missing))} unsaid")

    @classmethod
    def between(cls, one: tuple[str, SitePort], other: tuple[str, SitePort], **numbers: float) -> Self:
        """A connection from a port of a named entity to one of another."""
        links = tuple(Link(entity=name, port=port.name) for name, port in (one, other))
        return cls(links=links, **numbers)  # type: ignore[arg-type]  # each is a field of the class, validated by it

    def brings(self, joint: Joint, builder: Builder) -> dict[str, Body]:
        """No bodies."""
        del joint, builder
        return {}

    def describe(self, joint: Joint, writer: SentenceWriter) -> str:
        """Its sentence."""
        if len(joint.stops) != 2:
            raise SceneError(joint.name, f"a {self.key} joins two ports", "lead it past nothing")
        template = writer.choose(self.says.wordings)
        text = ""
        for piece, end in _pieces(template):
            text += writer.render(piece, joint.name) if piece else ""
            if end:
                stop = joint.stops["ab".index(end)]
                text += writer.render(phrase_of(stop.port), stop.owner)
        return text

    @classmethod
    def parse(
        cls, name: str, place: int, state: S, matcher: SentenceMatcher[S], routes: Routes[S]
    ) -> Iterator[ParsedSentence[S]]:
        """Its sentence read back: every wording, between every two ports that it can join."""
        if place >= len(matcher.pieces):
            return
        text = matcher.pieces[place]
        for number, template in enumerate(cls.says.wordings):
            begin = state.with_choice(number).with_kind(name, cls)
            for end, then, legs in cls._matched(text, 0, _pieces(template), {}, (name, begin, matcher, routes)):
                if end == len(text) and len(legs) == 2:
                    matcher.reach = max(matcher.reach, place + 1)
                    yield ParsedSentence(then, (legs["a"].link, legs["b"].link), ())

    @classmethod
    def _matched(
        cls,
        text: str,
        at: int,
        pieces: list[tuple[str, str]],
        legs: dict[str, Leg[S]],
        known: tuple[str, S, SentenceMatcher[S], Routes[S]],
    ) -> Iterator[tuple[int, S, dict[str, Leg[S]]]]:
        name, state, matcher, routes = known
        if not pieces:
            yield at, state, legs
            return
        (piece, end), *rest = pieces
        for after, then in matcher.template(text, at, piece, name, state) if piece else ((at, state),):
            if not end:
                yield from cls._matched(text, after, rest, legs, (name, then, matcher, routes))
                continue
            other = tuple(leg.link for key, leg in legs.items() if key != end)
            for leg in routes.legs(cls, then, other if end == "b" else ()):
                phrase = phrase_of(leg.stops[0].port)
                if leg.link in other or not cls.admits(leg.stops[0].port, "ab".index(end), 1):
                    continue
                for here, told in matcher.template(text, after, phrase, leg.stops[0].owner, leg.state):
                    yield from cls._matched(text, here, rest, {**legs, end: leg}, (name, told, matcher, routes))


def _pieces(template: str) -> list[tuple[str, str]]:
    """A template as texts, each with the end that follows it, or none."""
    parts = _ENDS.split(template)
    return [(parts[i], parts[i + 1] if i + 1 < len(parts) else "") for i in range(0, len(parts), 2)]

"""A light inextensible string: one path, one constraint, one sentence, however many pulleys it passes."""

from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from annotated_types import Gt, Le

from sim2reason.bodies.pulley import FixedPulley
from sim2reason.dsl.body import Body
from sim2reason.dsl.builder import Builder, add, scale
from sim2reason.dsl.connection import Connection, connection
from sim2reason.dsl.layout import opposite
from sim2reason.dsl.measures import Hidden, Measure, Range
from sim2reason.dsl.mechanism import ZERO
from sim2reason.dsl.ports import End, Stop
from sim2reason.errors import SceneError

if TYPE_CHECKING:
    from sim2reason.dsl.speaker import Speaker

OPENINGS = (
    "{string} tied to {tied} {verbs}.",
    "{string} is tied to {tied}; it {verbs}.",
    "one end of {string} is tied to {tied}; from there the string {verbs}.",
)
OVER = "passes over "
FREE = 2.5  # m of string between a site that moves and the pulley that the string brings


@connection
class String(Connection):
    """A string through ports, from end to end. Where neighbours' directions need a fixed pulley it brings one."""

    key: ClassVar[str] = "tendon"
    free: Annotated[float, Gt(0), Le(1e3), Measure("free length", "m", r"\ell"), Range(2.0, 4.0), Hidden()] = FREE

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
    def tell(cls, name: str, stops: list[Stop], speaker: "Speaker") -> str:
        """Its one sentence: what it is tied to, what it passes, where it ends."""
        stops = max(stops, reversed_path(stops), key=lambda path: _worth(path[0]))
        if not _worth(stops[0]):
            raise SceneError(name, "nothing hangs on this string", "tie at least one end to a body")
        opening = speaker.choose(OPENINGS)
        first = stops[0]
        assert isinstance(first.port, End)
        tied = speaker.render(first.port.tied, first.owner)
        verbs = [speaker.render(first.port.leaves, first.owner)] if first.port.leaves else []
        gaps = turns(stops, speaker.scene.builder)
        order = [f"{name}.pulley{n}" for n in range(1, 1 + sum(turn is not None for turn in gaps))]
        if stops[0] != speaker.scene.strings[name][1][0]:
            order.reverse()
        for stop, turn in zip(stops[1:], gaps, strict=True):
            if turn is not None:
                verbs.append(OVER + speaker.at(order.pop(0)))
            port = stop.port
            verbs.append(speaker.render(port.arrives if isinstance(port, End) else port.passes, stop.owner))
        string = "another light string" if speaker.heard("light string") else "a light string"
        return opening.replace("{string}", string).replace("{tied}", tied).replace("{verbs}", joined(verbs))


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
    for index, (one, other) in enumerate(zip(stops, stops[1:], strict=False)):
        leaves = travelled_sites(one, first=index == 0)[-1]
        reaches = travelled_sites(other, first=False)[0]
        straight = opposite(builder.faces[leaves], builder.faces[reaches])
        found.append(None if straight else (leaves, reaches))
    return found


def joined(verbs: list[str]) -> str:
    """V, V and V; a repeated verb becomes *then*."""
    said = [verbs[0]]
    for before, verb in zip(verbs, verbs[1:], strict=False):
        again = verb.startswith(OVER) and before.startswith(OVER)
        said.append("then over " + verb.removeprefix(OVER) if again else verb)
    return said[0] if len(said) == 1 else ", ".join(said[:-1]) + " and " + said[-1]

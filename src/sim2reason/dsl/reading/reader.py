"""All readings of a text, proven one by one."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from sim2reason.dsl.connection import CONNECTIONS, Connection, Link, Told
from sim2reason.dsl.entity import ENTITIES, Entity, outer_ports
from sim2reason.dsl.ports import Pass
from sim2reason.dsl.reading.assembly import assembled
from sim2reason.dsl.reading.heard import Heard, Strung
from sim2reason.dsl.reading.hearer import Hearer
from sim2reason.dsl.reading.likeness import Signature, signature
from sim2reason.dsl.reading.lines import entity_lines
from sim2reason.dsl.reading.proof import prove
from sim2reason.dsl.reading.tokens import pieces, shown
from sim2reason.dsl.reading.trails import Leg, free_legs
from sim2reason.dsl.scene import MAX_ENTITIES, Scene, World
from sim2reason.dsl.telling.closings import CLOSINGS
from sim2reason.errors import SceneError, TextError, UnsupportedError

MAX_READINGS = 200


@dataclass(frozen=True)
class Reading:
    """A scene as its text tells it; `names` maps what bodies are called (*block A*) to their addresses."""

    scene: Scene
    names: dict[str, str]


def read(text: str, rng: np.random.Generator | None = None) -> Reading:
    """The one scene that a text in the numeric voice tells; numbers that are never said are drawn with `rng`.

    Readings that move alike and call things alike are one; the first is returned.

    Raises:
        TextError: the text tells no scene, or more than one.
    """
    rng = rng if rng is not None else np.random.default_rng(0)
    said = pieces(text)
    hearer = Hearer(said)
    found: dict[Signature, Reading] = {}
    refused: list[TextError] = []
    for count, heard in enumerate(_Plot(hearer).scenes(0, Heard({"world": World}))):
        if count == MAX_READINGS:
            raise TextError("text", "it can be read in too many ways", "give the text of one scene")
        try:
            scene = assembled(heard, rng)
            prove(scene, heard, said)
            names = {address: heard.mention(address, full=True) for address in heard.letters}
            found.setdefault(signature(scene, names), Reading(scene, _by_name(names)))
        except TextError as error:
            refused.append(error)
        except (SceneError, UnsupportedError, ValueError) as error:
            refused.append(TextError("text", "it tells a scene that can not be", str(error)))
    return _only(list(found.values()), refused, hearer)


def _by_name(names: dict[str, str]) -> dict[str, str]:
    """Addresses by name; bodies without letters of their own may share a name, the first one has it."""
    found: dict[str, str] = {}
    for address, name in names.items():
        found.setdefault(name, address)
    return found


def _only(found: list[Reading], refused: list[TextError], hearer: Hearer) -> Reading:
    if len(found) == 1:
        return found[0]
    if found:
        one, other = (_described(reading.scene) for reading in found[:2])
        raise TextError("text", f"it tells two scenes: {one}; or {other}", "say more")
    if refused:
        raise refused[0]
    if hearer.reach == len(hearer.pieces):
        raise TextError("text", "it ends before all is told", "give the whole text of one scene")
    fits = f"{shown(hearer.pieces[hearer.reach])} fits nowhere"
    raise TextError(f"sentence {hearer.reach + 1}", fits, "say it in the words of the templates, or leave it out")


def _described(scene: Scene) -> str:
    """The entities of a scene and how they are joined, in one line."""
    kinds = ", ".join(f"{named.name} a {type(named.entity).__name__}" for named in scene.entities)
    joined = ", ".join("-".join(map(str, connection.links)) for connection in scene.connections)
    return f"{kinds}{' joined by ' if joined else ''}{joined}"


class _Plot:
    """The order of a text: entities' lines, each string after those of the entities on it, then the closings."""

    def __init__(self, hearer: Hearer) -> None:
        self._hearer = hearer
        self._silent = [kind for kind in ENTITIES.values() if any(self._unheard(Heard({}), "e", kind))]

    def _unheard(self, heard: Heard, address: str, kind: type[Entity]) -> Iterator[Heard]:
        """An entity of which no line is said: its bodies are met on a string."""
        here = replace(heard.knowing(address, kind), entities=(*heard.entities, address))
        for _, then in entity_lines(self._hearer, address, len(self._hearer.pieces), here):
            yield then

    def scenes(self, place: int, heard: Heard) -> Iterator[Heard]:
        """All readings of the pieces from `place` on."""
        yield from self._entities(place, heard)
        yield from self._strings(place, heard)
        yield from self._closings(place, 0, heard)

    def _entities(self, place: int, heard: Heard) -> Iterator[Heard]:
        address = f"e{len(heard.entities) + 1}"
        for kind in ENTITIES.values() if len(heard.entities) < MAX_ENTITIES else ():
            here = heard.knowing(address, kind)
            here = replace(here, entities=(*heard.entities, address), waiting=(*heard.waiting, address))
            for after, then in entity_lines(self._hearer, address, place, here):
                if after > place:
                    yield from self.scenes(after, then)

    def _strings(self, place: int, heard: Heard) -> Iterator[Heard]:
        for kind in CONNECTIONS.values():
            name = f"{kind.key}_{len(heard.strung) + 1}"
            for told in kind.hear(name, place, heard, self._hearer, self):
                then = _strung(kind, told)
                if then is not None:
                    yield from self.scenes(place + 1, then)

    def _closings(self, place: int, number: int, heard: Heard) -> Iterator[Heard]:
        """The closings from a number on, each of which may be needed or not."""
        if place == len(self._hearer.pieces):
            yield heard
            return
        for index, closing in enumerate(CLOSINGS[number:], start=number):
            for choice, wording in enumerate(closing.wordings):
                here = replace(heard.chose(choice), closings=(*heard.closings, closing.name))
                for then in self._hearer.sentence(place, wording, "", here):
                    yield from self._closings(place + 1, index + 1, then)

    def legs(self, heard: Heard, links: tuple[Link, ...]) -> Iterator[Leg]:
        """Free ports of entities that were read, or of new ones that have no lines."""
        passed = {link.entity for link in links}
        for address in heard.entities:
            if address not in passed:
                yield from free_legs(heard, address, first=not links)
        address = f"e{len(heard.entities) + 1}"
        for kind in self._silent if len(heard.entities) < MAX_ENTITIES else ():
            for then in self._unheard(heard, address, kind):
                yield from free_legs(then, address, first=not links)


def _strung(kind: type[Connection], told: Told) -> Heard | None:
    """What was heard, with a connection; None if lines that wait for it came in another order than it goes.

    The Speaker tells the lines of entities in the order of the links, but a string from the end that makes
    the better sentence; so if the lines came the other way round, the links are the other way round.
    """
    heard, links = told.heard, told.links
    on = [link.entity for link in links if link.entity in heard.waiting]
    if sorted(on) != sorted(heard.waiting):
        return None
    if list(heard.waiting) != on:
        if list(heard.waiting) != on[::-1]:
            return None
        heard = heard.renamed(told.owned, told.owned[::-1])
        links = tuple(_turned(heard, link) for link in reversed(links))
    return replace(heard, waiting=(), strung=(*heard.strung, Strung(kind, links)))


def _turned(heard: Heard, link: Link) -> Link:
    """A link as it is passed from the other side."""
    passed = isinstance(outer_ports(heard.kind(link.entity, Entity))[link.port], Pass)
    return Link(entity=link.entity, port=link.port, flipped=link.flipped != passed)

"""Growing a scene: entities are connected port by port until every string has two ends."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from sim2reason.dsl.connection import CONNECTIONS, Connection, Link
from sim2reason.dsl.entity import ENTITIES, Entity, Named, outer_ports
from sim2reason.dsl.measures import Count, Range
from sim2reason.dsl.model import Choice, draw
from sim2reason.dsl.ports import Pass
from sim2reason.dsl.scene import Scene
from sim2reason.errors import SceneError
from sim2reason.prose.writer import describe

REVERSE = "MassWithReverseMovablePulley"
MOVABLE = "MassWithMovablePulley"
TRIES = 30
LONGEST_SENTENCE = 40  # words
HAND, HOOK = "ConstantForcePuller", "FixedSupport"
PREFIX = {
    "MassWithFixedPulley": "fixed",
    MOVABLE: "movable",
    REVERSE: "bight",
    "TwoSideMassPlane": "ramp",
    "MassPrismPlane": "prism",
    HAND: "hand",
    HOOK: "hook",
}


@dataclass(frozen=True)
class Tier:
    """How hard: how many entities, of which types and how often, and where numbers come from.

    `rough` is the chance that faces have friction, `massive` that pulleys have mass, `more` that an
    optional port is used.
    """

    size: Count
    pool: Mapping[str, float]  # entity type to weight
    choices: Mapping[str, Choice]
    rough: float = 0.0
    friction: Range = field(default=Range(0.2, 0.7))
    massive: float = 0.3
    more: float = 0.4
    speed: float = 0.0  # the chance that a plane without strings starts with a speed
    words: int = 200  # the longest text


class Grower:
    """One scene in the making."""

    def __init__(self, tier: Tier, rng: np.random.Generator) -> None:
        """Friction and massive pulleys are decided once for the whole scene."""
        self.tier, self.rng = tier, rng
        rough, massive = self._chance(tier.rough), self._chance(tier.massive)
        self.choices: dict[str, Choice] = {
            "friction": tier.friction if rough else 0.0,
            "FixedPulley.mass?": float(massive),
            "MovablePulley.mass?": float(massive),
            **tier.choices,
        }
        self.left = int(rng.integers(tier.size.low, tier.size.high + 1))
        self.entities: list[Named] = []
        self.paths: list[tuple[Link, ...]] = []
        self.used: set[tuple[str, str]] = set()

    def scene(self) -> Scene:
        """Grow until no port that must be used is open."""
        first = self._add(self._pick(self.tier.pool))
        self._open_ports(first)
        string = CONNECTIONS["tendon"]
        return Scene(
            entities=tuple(self.entities), connections=tuple(self._strung(string, path) for path in self.paths)
        )

    def _strung(self, kind: type[Connection], path: tuple[Link, ...]) -> Connection:
        return draw(kind, self.rng, {}, given={"links": path})

    def _chance(self, chance: float) -> bool:
        return bool(self.rng.random() < chance)

    def _pick(self, pool: Mapping[str, float]) -> str:
        names, weights = list(pool), np.array(list(pool.values()))
        return names[int(self.rng.choice(len(names), p=weights / weights.sum()))]

    def _add(self, kind: str) -> Named:
        """A drawn entity of a type, under a name of its own."""
        self.left -= kind not in (HAND, HOOK)
        count = sum(named.name.rstrip("0123456789") == PREFIX[kind] for named in self.entities)
        choices = dict(self.choices)
        if kind == REVERSE:  # with nothing on its axle a light pulley would be held by nothing
            choices["load?"] = 0.75 if self.left > 0 else 1.0
        if kind == "TwoSideMassPlane" and not self.entities and self.left == 0:
            choices["speed?"] = self.tier.speed
        entity = draw(ENTITIES[kind], self.rng, choices)
        named = Named(name=f"{PREFIX[kind]}{count + 1 if count else ''}", entity=entity)
        self.entities.append(named)
        return named

    def _open_ports(self, named: Named) -> None:
        """Give every port of a new entity its string, if it must or happens to have one."""
        ports = outer_ports(type(named.entity))
        for port, declared in sorted(
            ports.items(), key=lambda item: item[0] != "bottom"
        ):  # while there is room for a load
            if (named.name, port) in self.used:
                continue
            if not declared.required and not self._wants(named.entity, port):
                continue
            link = Link(entity=named.name, port=port)
            self.used.add((named.name, port))
            if isinstance(declared, Pass):
                start = self._far_end((), loose=False)
                self._string((start, link, self._far_end((start,), loose=True)))
            else:
                self._string(self._path(link))

    def _wants(self, entity: Entity, port: str) -> bool:
        if getattr(entity, "speed", None) is not None:
            return False
        if port == "bottom":
            return getattr(entity, "load", None) is None
        return (self.left > 0 and (not self.paths or self._chance(0.8))) or self._chance(self.tier.more)

    def _path(self, start: Link) -> tuple[Link, ...]:
        """A string from an open end: perhaps under a movable pulley, and on to another end."""
        links = [start]
        if self.left > 0 and start.port != "bottom" and REVERSE in self.tier.pool and self._chance(0.3):
            bight = self._add(REVERSE)
            self.used.add((bight.name, "under"))
            links.append(Link(entity=bight.name, port="under"))
        loose = len(links) > 1 or start.port == "top"
        return (*links, self._far_end(tuple(links), loose=loose))

    def _far_end(self, links: tuple[Link, ...], *, loose: bool) -> Link:
        """The other end of a string: a new entity while there is room, else what closes it.

        A hook only where something can still move (`loose`), a hand only where none pulls already.
        """
        pulled = any(link.port == "end" for link in links)
        hangs = bool(links) and links[-1].port == "bottom"  # straight down, where only an axle can be met
        pool = {kind: w for kind, w in self.tier.pool.items() if kind == MOVABLE or (kind != REVERSE and not hangs)}
        if pool and self.left > 0 and (not loose or self._chance(0.75)):
            named = self._add(self._pick(pool))
            ends = [port for port, held in outer_ports(type(named.entity)).items() if not isinstance(held, Pass)]
            port = ends[int(self.rng.integers(len(ends)))]
            self.used.add((named.name, port))
            return Link(entity=named.name, port=port)
        kind = HOOK if loose and (pulled or self._chance(0.6)) else HAND
        return Link(entity=self._add(kind).name, port="end")

    def _string(self, path: tuple[Link, ...]) -> None:
        """Enter a string, then give the new entities on it their other strings."""
        self.paths.append(path)
        for link in path:
            self.used.add((link.entity, link.port))
        for link in path:
            self._open_ports(next(named for named in self.entities if named.name == link.entity))


def grow(tier: Tier, rng: np.random.Generator) -> Scene:
    """A random scene of a tier, drawn again while it takes too many words to tell.

    Raises:
        SceneError: its parts do not fit together, or nothing short enough was drawn.
    """
    for _ in range(TRIES):
        scene = Grower(tier, rng).scene()
        if _is_short(scene, tier.words):
            return scene
    raise SceneError("recipe", f"no scene of {TRIES} can be told in {tier.words} words", "draw again")


def _is_short(scene: Scene, words: int) -> bool:
    """Whether the whole text and every sentence about a string keep within their bounds."""
    lengths = [len(sentence.split()) for sentence in describe(scene).sentences]
    return sum(lengths) <= words and max(lengths) <= LONGEST_SENTENCE

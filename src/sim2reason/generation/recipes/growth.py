"""Random growth of scenes: entities are connected port by port until no port is open."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from math import exp, log

import numpy as np

from sim2reason.base.draws import draw_index
from sim2reason.errors import SceneError
from sim2reason.generation.recipes.ports import (
    OpenPort,
    ends_for,
    is_down,
    is_downhill,
    is_motionless,
    is_passed,
    open_ports,
    takes,
)
from sim2reason.scenes.dsl.addresses import without_idle_fields
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.connection import CONNECTIONS, Connection, Joint, Link
from sim2reason.scenes.dsl.entity import ENTITIES, Named
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.mechanism import GRAVITY
from sim2reason.scenes.dsl.model import Choice, draw
from sim2reason.scenes.dsl.ports import Pass, Stop, StringEnd
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.structure import is_weightless, stuck_bodies
from sim2reason.text.prose.description import write_description, write_draft

DIRECTION_TOL = 1e-9  # of a direction, or m; smaller values are rounding errors


def leads_below_floor(scene: Scene, joint: Joint) -> bool:
    """Return whether a string runs horizontally from the foot of a slope on a floor to the top of another slope.

    Then the other slope would be below the floor. Hanging bodies are allowed there, as beyond the edge of a table.
    """
    ends = [stop for stop in joint.stops if isinstance(stop.port, StringEnd)]
    return any(_leaves_at_foot(scene, end) for end in ends) and any(_leaves_upwards(scene, end) for end in ends)


def _leaves_at_foot(scene: Scene, end: Stop) -> bool:
    """Return whether a string descends to a corner of its own entity and leaves it horizontally."""
    return _climb(scene, end) < -DIRECTION_TOL and abs(_steepness(scene, end)) < DIRECTION_TOL


def _leaves_upwards(scene: Scene, end: Stop) -> bool:
    """Return whether a string ascends a slope, to a corner of its entity or away from it."""
    return _climb(scene, end) > DIRECTION_TOL or DIRECTION_TOL < _steepness(scene, end) < 1.0 - DIRECTION_TOL


def _climb(scene: Scene, end: Stop) -> float:
    """Return the height at which a string leaves an entity above the point where it is tied, m."""
    alone = _build_end_entity(scene, end)
    return alone.position(end.sites[-1])[2] - alone.position(end.sites[0])[2]


def _steepness(scene: Scene, end: Stop) -> float:
    """Return the sine of the angle at which a string leaves an entity; zero if its direction is free."""
    face = _build_end_entity(scene, end).faces.get(end.sites[-1])
    return face[2] if face is not None else 0.0


def _build_end_entity(scene: Scene, end: Stop) -> Builder:
    """Return the mechanism builder of the entity at one end of a string, built without the other entities."""
    return next(named.alone for named in scene.entities if named.name == end.owner.partition(".")[0])


MAX_SCENE_TRIES = 100
LONGEST_SENTENCE = 40  # words
CONTINUE_PROBABILITY = 0.75  # probability that a string continues to another entity where it could end
UPHILL_FRACTION = (
    0.7  # fraction of scenes with strings down a slope only beside one up it, so that weights oppose each other
)
PASS_PROBABILITY = 0.3  # probability that a string passes an entity on its way
LOAD_PROBABILITY = 0.75  # probability of an optional load
MAX_MASS_RATIO = 2.5  # largest mass ratio if pulleys have mass
MIN_DISC_MASS_RATIO = 0.75  # of the lightest block: smallest mass of a massive pulley
CARRIERS = ("Wedge.mass", "Prism.mass", "Box.mass")  # masses that are not much smaller than those of the carried bodies
PULLEYS = ("FixedPulley.mass", "MovablePulley.mass")
STRINGS = {"tendon": 1.0}
ROWS = ("blocks", "left_blocks")
ROW_FRACTION = 0.25  # fraction of eligible scenes with blocks in rows, which move as one
HAND = "ConstantForcePuller"
CLOSERS = {HAND: 0.4, "FixedSupport": 0.6}


@dataclass(frozen=True)
class Tier:
    """The settings of random growth at one difficulty: number and types of entities, and ranges of numbers.

    `groups` are pools of entity types with weights; a scene has one entity of each. `rough` is the probability of
    friction, `massive` that of massive pulleys, and `more` that of using an optional port.
    """

    size: Count
    groups: tuple[Mapping[str, float], ...]
    choices: Mapping[str, Choice]
    alone: Mapping[str, Choice] = field(default_factory=dict[str, Choice])  # besides, where there is one entity
    connections: Mapping[str, float] = field(default_factory=lambda: STRINGS)  # what joins them, and how often
    closers: Mapping[str, float] = field(default_factory=lambda: CLOSERS)  # what closes an open end
    spread: float = 5.0  # the largest ratio of the masses of two blocks
    rough: float = 0.0
    massive: float = 0.3
    more: float = 0.4
    words: int = 200  # the longest text

    @property
    def pool(self) -> Mapping[str, float]:
        """Return all entity types with their weights."""
        return {kind: weight for group in self.groups for kind, weight in group.items()}


class Grower:
    """The state of one scene during random growth."""

    def __init__(self, tier: Tier, rng: np.random.Generator) -> None:
        """Draw what holds for the whole scene: number of entities, friction, massive pulleys and ranges of masses."""
        self.tier, self.rng = tier, rng
        self.left = int(rng.integers(tier.size.low, tier.size.high + 1))
        self.choices: dict[str, Choice] = {"load?": LOAD_PROBABILITY, **tier.choices, **self._masses()}
        if self.left == 1:
            self.choices.update(tier.alone)
        if not self._chance(tier.rough):
            self.choices["friction"] = 0.0
        rows = [name for name in ROWS if self.choices.get(name) == Count(1, 2)]
        if rows and not self._chance(ROW_FRACTION):
            self.choices |= dict.fromkeys(rows, Count(1, 1))
        self.entities: list[Named] = []
        self.joined: list[tuple[type[Connection], tuple[Link, ...]]] = []
        self.used: set[tuple[str, str]] = set()
        self.uphill = self._chance(UPHILL_FRACTION)
        self.pulled = False  # whether a hand pulls: two would do no more than one

    def _masses(self) -> dict[str, Choice]:
        """Draw the ranges of masses and forces: blocks of similar mass, lighter pulleys, pulls similar to weights."""
        blocks, pulleys = self.tier.choices["mass"], self.tier.choices["pulley mass"]
        assert isinstance(blocks, Range)
        assert isinstance(pulleys, Range)
        size = exp(self.rng.uniform(log(blocks.low), log(blocks.high)))
        lightest = float(f"{max(blocks.low, size / self.tier.spread):.2g}")
        heaviest = float(f"{min(blocks.high, lightest * self.tier.spread):.2g}")
        weight = GRAVITY * lightest
        massive = self._chance(self.tier.massive)
        if massive:  # so that they count
            heaviest = min(heaviest, float(f"{lightest * MAX_MASS_RATIO:.2g}"))
        return {
            "mass": Range(lightest, heaviest),
            **dict.fromkeys(CARRIERS, Range(float(f"{(lightest * heaviest) ** 0.5:.2g}"), heaviest)),
            "force": Range(float(f"{0.5 * weight:.2g}"), float(f"{self.tier.spread * weight:.2g}")),
            **dict.fromkeys(PULLEYS, Range(float(f"{max(pulleys.low, MIN_DISC_MASS_RATIO * lightest):.2g}"), lightest)),
            **{f"{name}?": float(massive and lightest > pulleys.low) for name in PULLEYS},
        }

    def scene(self) -> Scene:
        """Grow the scene until no mandatory port is open.

        Raises:
            SceneError: something in it can't move, or moves without inertia.
        """
        self._join_all(self._add(self._pick()))
        if self._missing():
            raise SceneError("scene", "an entity of one kind is missing", "draw again")
        connections = tuple(draw(kind, self.rng, {}, given={"links": links}) for kind, links in self.joined)
        entities = without_idle_fields(self.entities, (links for _, links in self.joined))
        scene = Scene(entities=entities, connections=connections)
        stuck = stuck_bodies(scene.mechanism)
        if stuck:
            raise SceneError(stuck[0], "nothing lets it move", "draw again")
        if is_weightless(scene.mechanism):
            raise SceneError("scene", "something light moves freely", "draw again")
        if low := next((name for name, joint in scene.joints.items() if leads_below_floor(scene, joint)), ""):
            raise SceneError(low, "a slope would lie below the floor on which another stands", "draw again")
        return scene

    def _chance(self, chance: float) -> bool:
        return bool(self.rng.random() < chance)

    def _draw_one(self, weights: Mapping[str, float]) -> str:
        return list(weights)[draw_index(self.rng, list(weights.values()))]

    def _pick(self) -> str:
        """Return a random entity type; one of a missing group when there is room for no other."""
        missing = self._missing()
        return self._draw_one(missing[0] if len(missing) >= self.left and missing else self.tier.pool)

    def _missing(self) -> list[Mapping[str, float]]:
        """Return the required groups of entity types of which the scene has no entity yet, with weights."""
        kinds = {type(named.entity).__name__ for named in self.entities}
        return [group for group in self.tier.groups if not kinds & group.keys()]

    def _add(self, kind: str) -> Named:
        """Return a random entity of a type, with a new name, after adding it to the scene."""
        named = self._named(kind)
        self._enter(named)
        return named

    def _named(self, kind: str) -> Named:
        base = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", kind).lower()
        count = sum(type(named.entity).__name__ == kind for named in self.entities)
        entity = draw(ENTITIES[kind], self.rng, self.choices)
        return Named(name=f"{base}{count + 1 if count else ''}", entity=entity)

    def _enter(self, named: Named) -> None:
        self.entities.append(named)
        self.left -= type(named.entity).__name__ in self.tier.pool

    # ---- ports

    def _join_all(self, named: Named) -> None:
        """Connect every mandatory port of a new entity, and optional ones by chance."""
        for here in sorted(open_ports(named), key=lambda port: self.uphill and is_downhill(port)):
            taken = (named.name, here.port.name) in self.used
            needed = here.port.required or here.port.unless  # where it is open, nothing hangs there yet
            if not taken and (needed or self._wants()):
                self._join(here)

    def _wants(self) -> bool:
        if self.left == 0 and self.pulled and not self.tier.closers.keys() - CLOSERS.keys():
            return False  # hardly anything but another hand could be there
        return (self.left > 0 and (not self.joined or self._chance(0.8))) or self._chance(self.tier.more)

    def _join(self, here: OpenPort) -> None:
        """Lead a connection from a port: to a new entity while there is room, else to a closing entity."""
        shares = {key: share for key, share in self.tier.connections.items() if takes(CONNECTIONS[key], here.port)}
        if not shares:
            return
        kind = CONNECTIONS[self._draw_one(shares)]
        if isinstance(here.port, Pass):
            first = self._end_port(kind, here, [])
            path = [first, here, self._end_port(kind, here, [first, here])]
        else:
            path = [here, *self._between(kind, here)]
            path.append(self._end_port(kind, path[-1], path))
            if not kind.admits(here.port, 0, len(path) - 1):
                path.reverse()
        for stop in path:
            self.used.add((stop.owner.name, stop.port.name))
        self.joined.append((kind, tuple(stop.link for stop in path)))
        for stop in path:
            self._join_all(stop.owner)

    def _between(self, kind: type[Connection], here: OpenPort) -> list[OpenPort]:
        """Return the ports of new entities that a connection passes on its way."""
        passed = {name: weight for name, weight in self.tier.pool.items() if is_passed(name, kind)}
        if not (passed and self.left > 0 and not is_down(here.direction) and self._chance(PASS_PROBABILITY)):
            return []
        named = self._add(self._draw_one(passed))
        return [stop for stop in open_ports(named) if isinstance(stop.port, Pass)][:1]

    def _end_port(self, kind: type[Connection], here: OpenPort, path: list[OpenPort]) -> OpenPort:
        """Return the port at which a connection ends; on a fixed support only if something on the way can move."""
        pool = {name: w for name, w in self.tier.pool.items() if not is_passed(name, kind)}
        moving = any(isinstance(stop.port, Pass) for stop in (here, *path))
        onward = not path or not moving or bool(self._missing()) or self._chance(CONTINUE_PROBABILITY)
        if pool and self.left > 0 and onward:
            for _ in range(3):
                picked = self._pick()
                named = self._named(picked if picked in pool else self._draw_one(pool))
                ends = ends_for(named, kind, here)
                ends = [end for end in ends if not (self.uphill and is_downhill(end))] or ends
                if ends:
                    self._enter(named)
                    return ends[int(self.rng.integers(len(ends)))]
        taken = {type(stop.owner.entity).__name__ for stop in path}
        barred = taken | {HAND} if self.pulled else taken
        closers = {name: weight for name, weight in self.tier.closers.items() if name not in barred}
        while closers:
            named = self._named(self._draw_one(closers))
            end = next(iter(ends_for(named, kind, here)), None)
            if end is not None and (moving or not is_motionless(named)):
                self._enter(named)
                self.pulled = self.pulled or type(named.entity).__name__ == HAND
                return end
            del closers[type(named.entity).__name__]
        raise SceneError(here.owner.name, f"nothing closes its {here.port.name}", "draw again")


def grow(tier: Tier, rng: np.random.Generator) -> Scene:
    """Return a random scene of a tier; invalid or too long ones are drawn again.

    Raises:
        SceneError: nothing that was drawn holds together and is short enough.
    """
    refused = SceneError("recipe", f"no scene of {MAX_SCENE_TRIES} can be told in {tier.words} words", "draw again")
    for _ in range(MAX_SCENE_TRIES):
        try:
            scene = Grower(tier, rng).scene()
        except SceneError as error:
            refused = error
            continue
        if _is_short(scene, tier.words):
            return scene
    raise refused


def _is_short(scene: Scene, words: int) -> bool:
    """Return whether the whole text and every sentence about a string are within their limits."""
    drafted, dry = write_draft(scene)
    if _total(drafted) > words:
        return False  # most do not, and show it at once
    sentences = write_description(dry).sentences
    return _total(sentences) <= words and max(map(_length, sentences)) <= LONGEST_SENTENCE


def _total(sentences: Iterable[str]) -> int:
    return sum(map(_length, sentences))


def _length(sentence: str) -> int:
    return len(sentence.split())

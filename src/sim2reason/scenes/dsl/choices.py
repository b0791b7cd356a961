"""Random choices and special values for tests and examples, and scenes that connect all ports of an entity."""

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.addresses import without_idle_fields
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.connection import CONNECTIONS, Connection, Link
from sim2reason.scenes.dsl.entity import ENTITIES, Entity, Named, Part, outer_ports
from sim2reason.scenes.dsl.model import Choice, Model, draw, field_types
from sim2reason.scenes.dsl.ports import Pass, Port
from sim2reason.scenes.dsl.scene import Scene

OPTIONAL_PROBABILITY = 0.5  # probability of an optional field
SPECIAL_PROBABILITY = 0.2  # probability of a value stated by a word, such as smooth or horizontal


def choices(cls: type[Model], rng: np.random.Generator) -> dict[str, Choice]:
    """Return random choices for optional fields and some special numbers of a class and of all classes inside."""
    chosen = chances(cls)
    for model in contained_classes(cls):
        for name, kind in field_types(model).items():
            special = specials(model, name)
            if kind.measure is not None and special and rng.random() < SPECIAL_PROBABILITY:
                chosen[f"{model.__name__}.{name}"] = special[int(rng.integers(len(special)))]
    return chosen


def chances(cls: type[Model]) -> dict[str, Choice]:
    """Return the probabilities of optional fields of a class and of all classes that it can contain."""
    return {
        f"{model.__name__}.{name}?": OPTIONAL_PROBABILITY
        for model in contained_classes(cls)
        for name, kind in field_types(model).items()
        if (kind.optional or not model.model_fields[name].is_required()) and (kind.drawn or kind.models or kind.words)
    }


def specials(model: type[Model], name: str) -> list[float]:
    """Return the values of a number that the text states by a word, such as 0 for *smooth*."""
    words = model.words.values() if issubclass(model, Body | Part) else ()
    return sorted(
        {value for word in words if word.parameter == name for value in word.special if isinstance(value, float)}
    )


def contained_classes(cls: type[Model]) -> list[type[Model]]:
    """Return a class and all classes that it can contain, each once."""
    classes: list[type[Model]] = []
    waiting = [cls]
    while waiting:
        model = waiting.pop()
        if model not in classes:
            classes.append(model)
            waiting.extend(_held(model))
    return classes


def _held(model: type[Model]) -> Iterator[type[Model]]:
    for kind in field_types(model).values():
        yield from kind.models


PORT_PROBABILITY = 0.5  # probability of a connection at an optional port


@dataclass(frozen=True, slots=True)
class Option:
    """A connection that can join an open port, with the other ports on its path before and after the open one."""

    kind: type[Connection]
    before: tuple[tuple[type[Entity], str], ...]
    behind: tuple[tuple[type[Entity], str], ...]

    @property
    def partners(self) -> tuple[type[Entity], ...]:
        """Return the classes of the entities at the other ports of the connection."""
        return tuple(cls for cls, _ in (*self.before, *self.behind))


def close_ports(named: Named, rng: np.random.Generator, *, widely: bool = False) -> Scene:
    """Return a random scene of an entity with its ports connected: all required ones, others with probability ½.

    `widely`: partners may be any entities, with bodies or without.

    Raises:
        SceneError: no connection fits a port, or the draw is invalid.
    """
    made = _Scene([named])
    for name, port in outer_ports(type(named.entity)).items():
        if not port.required and rng.random() > PORT_PROBABILITY:
            continue
        options = connections_for_port(type(named.entity), name, widely=widely)
        if options:
            made.close(Link(entity=named.name, port=name), options[int(rng.integers(len(options)))], rng)
        elif port.required:
            location = f"{type(named.entity).__name__}.{name}"
            raise SceneError(location, "no connection leads from it to any entity", "declare what it can be joined to")
    connections = tuple(made.connections)
    return Scene(entities=without_idle_fields(made.entities, (c.links for c in connections)), connections=connections)


@dataclass
class _Scene:
    """A scene under construction."""

    entities: list[Named]
    connections: list[Connection] = field(default_factory=list[Connection])

    def close(self, link: Link, option: Option, rng: np.random.Generator) -> None:
        """Add the connection `option` at the open port `link`, with random entities at its other ports."""
        before = [self._add(*partner, rng) for partner in option.before]
        behind = [self._add(*partner, rng) for partner in option.behind]
        given = {"links": (*before, link, *behind)}
        self.connections.append(draw(option.kind, rng, choices(option.kind, rng), given=given))

    def _add(self, cls: type[Entity], port: str, rng: np.random.Generator) -> Link:
        name = f"other{len(self.entities)}"
        self.entities.append(Named(name=name, entity=draw(cls, rng, choices(cls, rng))))
        return Link(entity=name, port=port)


def connections_for_port(cls: type[Entity], name: str, *, widely: bool = False) -> tuple[Option, ...]:
    """Return the connections, with their partner entities, that can close an entity's port.

    Preferred are partners that have bodies if the entity has none (a hand needs a block to pull), and partners without
    bodies if it has some; others are returned only if there are none of these, or with `widely`.
    """
    port = outer_ports(cls)[name]
    options = list(_passed(port) if isinstance(port, Pass) else _ended(port))
    wanted = not _has_bodies(cls)
    best = [option for option in options if all(_has_bodies(partner) == wanted for partner in option.partners)]
    return tuple(options if widely else best or options)


def _ended(port: Port) -> Iterator[Option]:
    """Yield the connections between a port and a partner, from the port or, if only that fits, from the partner."""
    for kind in CONNECTIONS.values():
        for partner, other in _ends():
            if kind.admits(port, 0, 1) and kind.admits(outer_ports(partner)[other], 1, 1):
                yield Option(kind, (), ((partner, other),))
            elif kind.admits(outer_ports(partner)[other], 0, 1) and kind.admits(port, 1, 1):
                yield Option(kind, ((partner, other),), ())


def _passed(port: Port) -> Iterator[Option]:
    """Yield the connections that run through a port, such as a string over a pulley, with a partner at each end."""
    for kind in CONNECTIONS.values():
        if kind.admits(port, 1, 2):
            first = [end for end in _ends() if kind.admits(outer_ports(end[0])[end[1]], 0, 2)]
            last = [end for end in _ends() if kind.admits(outer_ports(end[0])[end[1]], 2, 2)]
            yield from (Option(kind, (one,), (other,)) for one in first for other in last)


def _ends() -> Iterator[tuple[type[Entity], str]]:
    """Yield the ports of entities at which a connection can end and that need no other connection."""
    for cls in ENTITIES.values():
        ports = outer_ports(cls)
        for name, port in ports.items():
            needed = {other for other, other_port in ports.items() if other_port.required}
            if not isinstance(port, Pass) and needed <= {name}:
                yield cls, name


def _has_bodies(cls: type[Entity]) -> bool:
    return any(issubclass(model, Body) for model in contained_classes(cls))

"""Addresses of values in a scene, and optional fields that only a connection needs."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from typing import Any, TypeVar

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.connection import Link
from sim2reason.scenes.dsl.entity import Named, outer_ports
from sim2reason.scenes.dsl.model import Model, field_names, replace_validated

NO_SUCH_ADDRESS, LIST_PARAMETERS = "there is no such thing in the scene", "list the scene's parameters"
V = TypeVar("V")


def lookup(value: Any, path: str) -> Any:
    """Return the value at an address within a value; raise SceneError at the first invalid step."""
    walked: list[str] = []
    for step in path.split("."):
        walked.append(step)
        try:
            known = isinstance(value, Model) and step in field_names(type(value))
            value = getattr(value, step) if known else _members(value)[step]
        except KeyError:
            raise SceneError(".".join(walked), NO_SUCH_ADDRESS, LIST_PARAMETERS) from None
    return value


def _members(value: Any) -> dict[str, Any]:
    """Return the fields of a model by name, or the members of a tuple by index, as the next step of an address."""
    if isinstance(value, tuple):
        return {str(index): member for index, member in enumerate(value)}  # type: ignore[reportUnknownArgumentType]
    if not isinstance(value, Model):
        return {}
    known = value.__dict__
    return {name: known[name] for name in field_names(type(value))}


def with_values(value: V, news: Mapping[str, object]) -> V:
    """Return a copy of a value with the `news` at their addresses, validated once; None in a tuple removes a member."""
    here, below = dict[str, object](), dict[str, dict[str, object]]()
    for path, new in news.items():
        step, _, rest = path.partition(".")
        if rest:
            below.setdefault(step, {})[rest] = new
        else:
            here[step] = new
    members = _members(value)
    if unknown := {*here, *below} - members.keys():
        raise SceneError(min(unknown), NO_SUCH_ADDRESS, LIST_PARAMETERS)
    members |= {step: with_values(members[step], some) for step, some in below.items()} | here
    if isinstance(value, tuple):
        return tuple(member for member in members.values() if member is not None)  # type: ignore[return-value]
    return type(value)(**members)  # type: ignore[return-value]


def changes_numbers_alone(entities: Mapping[str, Named], changes: Mapping[str, Mapping[str, object]]) -> bool:
    """Return whether changes, by name and path, give numbers alone, and none where an entity has none.

    Which connections an entity admits depends only on its class and on which of its fields are absent.
    """
    return all(
        type(value) is float
        and ("." in path or head not in entities or getattr(entities[head].entity, path, None) is not None)
        for head, news in changes.items()
        for path, value in news.items()
    )


def used_ports(paths: Iterable[Sequence[Link]]) -> set[tuple[str, str]]:
    """Return the entity and port names to which the links of some connections lead."""
    return {(link.entity, link.port) for link in chain.from_iterable(paths)}


def idle_fields(named: Named, used: set[tuple[str, str]]) -> Iterator[tuple[str, str]]:
    """Yield the name of each given optional field that only open ports need, with the name of one of these ports."""
    needed: dict[str, list[str]] = {}
    for name, port in outer_ports(type(named.entity)).items():
        if port.needs:
            needed.setdefault(port.needs, []).append(name)
    for field, ports in needed.items():
        if getattr(named.entity, field) is not None and not any((named.name, port) in used for port in ports):
            yield field, ports[0]


def without_idle_fields(entities: Iterable[Named], paths: Iterable[Sequence[Link]]) -> tuple[Named, ...]:
    """Return the entities without fields that only open ports need, once the connections are known."""
    used = used_ports(paths)
    return tuple(_vacated(named, used) for named in entities)


def _vacated(named: Named, used: set[tuple[str, str]]) -> Named:
    idle = {field: None for field, _ in idle_fields(named, used)}
    return Named(name=named.name, entity=replace_validated(named.entity, **idle)) if idle else named

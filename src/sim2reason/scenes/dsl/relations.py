"""Relations between fields: dependent counts, ordered numbers, and indices of members."""

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, NamedTuple, Protocol


class Related(Protocol):
    """The relations of a field to others, a part of `sim2reason.scenes.dsl.model.FieldType`."""

    @property
    def models(self) -> tuple[type[Any], ...]:
        """Return the classes of models that the field may hold."""
        ...

    @property
    def member(self) -> str:
        """Return the field into which this field is an index; empty if it is no index."""
        ...

    @property
    def above(self) -> str:
        """Return the field whose number must be less than this field's number; empty if there is none."""
        ...

    @property
    def size(self) -> Callable[[Mapping[str, Any]], int] | None:
        """Return the function for the number of members, if other fields determine it."""
        ...


class Relations(NamedTuple):
    """The relations of one class: fields with dependent counts, ordered numbers, and indices with their targets."""

    sizes: tuple[tuple[str, Callable[[Mapping[str, Any]], int]], ...]
    greater: tuple[tuple[str, str], ...]  # a field, and the one with the smaller number
    indices: tuple[tuple[str, str, str], ...]  # the field with the index (empty for an own one), its name, its target


@cache
def relations(model: type[Any], types: Callable[[type[Any]], Mapping[str, Related]]) -> Relations:
    """Return the relations that a class of models declares; `types` analyses its fields."""
    kinds = types(model)
    own = [("", name, kind.member) for name, kind in kinds.items() if kind.member in kinds]
    inner = [
        (holder, name, kind.member)
        for holder, held in kinds.items()
        for part in held.models
        for name, kind in types(part).items()
        if kind.member in kinds
    ]
    sizes = tuple((name, kind.size) for name, kind in kinds.items() if kind.size is not None)
    greater = tuple((name, kind.above) for name, kind in kinds.items() if kind.above)
    return Relations(sizes, greater, (*own, *inner))


def violated_relation(value: Any, declared: Relations) -> str:
    """Return a message for a violated relation of a value; empty if all hold."""
    for name, demanded in declared.sizes:
        found, wanted = len(getattr(value, name)), demanded(value.__dict__)
        if found != wanted:
            return f"{name}: what stands beside them demands {wanted}, not {found}"
    for name, less in declared.greater:
        one, other = getattr(value, name), getattr(value, less)
        if one is not None and not 0.0 < other < one:
            return f"{name}: {one} is not greater than {less}, {other}, or that is zero; leave it out"
    for holder, name, field in declared.indices:
        count = len(getattr(value, field))
        for held in _each_of(getattr(value, holder)) if holder else (value,):
            index = getattr(held, name, None)
            if index is not None and not 0 <= index < count:
                place = f"{holder}.{name}" if holder else name
                return f"{place}: {field} has no member {index}, count from 0 to {count - 1}"
    return ""


def _each_of(held: Any) -> tuple[Any, ...]:
    """Return a value, or the members of a tuple."""
    return held if isinstance(held, tuple) else (held,)  # type: ignore[reportUnknownVariableType]

"""Data classes with very many instances, and attributes that are computed when first read."""

import functools
from collections.abc import Callable, Hashable
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeVar, cast, dataclass_transform, overload

T = TypeVar("T")


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def record(*, slots: bool = False, eq: bool = True, hashed_once: bool = False) -> Callable[[type[T]], type[T]]:
    """Return a decorator for data classes that type checkers treat as frozen, with a hash of their fields.

    A frozen data class assigns each field through `object.__setattr__`, which makes creation three times slower. At run
    time nothing prevents an assignment. With `hashed_once`, each object keeps its hash in its field `kept_hash`.
    """

    def decorated(cls: type[T]) -> type[T]:
        hashed = eq and "__hash__" not in vars(cls)
        made = dataclass(cls, slots=slots, eq=eq, unsafe_hash=hashed)
        if hashed and hashed_once:
            cast("Any", made).__hash__ = _kept_hash(made.__hash__)
        return made

    return decorated


class _KeepsHash(Protocol):
    """An object with a field for its hash, None until it is computed."""

    kept_hash: int | None


def _kept_hash(compute: Callable[[Any], int]) -> Callable[[_KeepsHash], int]:
    """Return a hash method that computes the hash of an object once."""

    def kept(self: _KeepsHash) -> int:
        if self.kept_hash is None:
            self.kept_hash = compute(self)
        return self.kept_hash

    return kept


def abridge(text: str, width: int = 60) -> str:
    """Return a text on one line, cut to at most `width` characters with an ellipsis at the end."""
    line = " ".join(text.split())
    return line if len(line) <= width else f"{line[: width - 1]}…"


def format_count(number: int, noun: str, plural: str = "") -> str:
    """Return a number with its noun in the singular or plural, such as ``1 body`` or ``2 bodies``."""
    return f"{number} {noun if number == 1 else plural or f'{noun}s'}"


class cached_property(functools.cached_property[T]):  # noqa: N801 - it stands for the one of the standard library
    """A `functools.cached_property` without the lock of Python 3.11 and earlier, which takes 4 % of an item's time.

    Two threads may compute the same value twice; either result is kept.
    """

    __module__ = functools.__name__  # by which pydantic tells it from a field

    @overload
    def __get__(self, instance: None, owner: type[Any] | None = None) -> "cached_property[T]": ...
    @overload
    def __get__(self, instance: object, owner: type[Any] | None = None) -> T: ...
    def __get__(self, instance: object, owner: type[Any] | None = None) -> "cached_property[T] | T":
        """Return the value and cache it, so that later reads bypass this method."""
        if instance is None:
            return self
        value = self.func(instance)
        instance.__dict__[self.func.__name__] = value
        return value


class Memo:
    """The base of objects that cache values computed from them, each under a name."""

    @cached_property
    def _known(self) -> dict[Hashable, object]:
        return {}

    def memoize(self, name: Hashable, make: Callable[[], T]) -> T:
        """Return the result cached under a name, after computing it with `make` if there is none."""
        cached = self._known.get(name, self)
        if cached is self:
            cached = self._known[name] = make()
        return cast("T", cached)

    def keep(self, name: Hashable, value: T) -> T:
        """Cache a result under a name, in place of any earlier one, and return the result."""
        self._known[name] = value
        return value

    def forget(self) -> None:
        """Discard all cached results."""
        self._known.clear()

    def is_cached(self, name: Hashable) -> bool:
        """Return whether a result is cached under a name."""
        return name in self._known

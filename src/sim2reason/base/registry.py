"""Registries of the members of one kind, such as entities or filters, and the list of all registries."""

import gc
import inspect
from collections.abc import Callable, ItemsView, Iterable, Iterator, Mapping, ValuesView
from dataclasses import fields, is_dataclass
from difflib import SequenceMatcher, get_close_matches
from importlib import import_module
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from pkgutil import iter_modules, walk_packages
from typing import Any, Generic, NamedTuple, TypeVar, overload

from sim2reason.errors import EntryPointError, UnknownNameError

MAX_NAME_LENGTH = 80  # characters of a name; similar names of longer ones are not searched
SIMILARITY_CUTOFF = 0.85  # similarity, relative to that of the most similar name, from which others are suggested too
MAX_LISTED_NAMES = 20  # names that an error message lists in full
LIBRARY = __name__.partition(".")[0]
_further: list[tuple[str, str, "Registry[Any]"]] = []
T = TypeVar("T")
M = TypeVar("M")


class Registry(Mapping[str, T], Generic[T]):
    """The members of one kind, by name; filled on first use from its package and from entry points.

    Third parties add members by an entry point in the group ``sim2reason.<kind>`` that names a module.
    """

    def __init__(
        self, kind: str, check: Callable[[str, object], None] | None = None, *, package: str | None = None
    ) -> None:
        """Define a registry: `kind` ends with its displayed plural and names its group of entry points.

        The modules of `package`, by default ``sim2reason.<kind>``, are imported to fill the registry.

        `check` receives the name and the member to add, and raises an error for an invalid member.
        """
        self.package = package or f"{LIBRARY}.{kind}"
        self.kind, self.called = kind, kind.rpartition(".")[2]
        self._check = check
        self._members: dict[str, T] = {}
        self._filled = self._ordered = False

    def add(self, name: str, member: M) -> M:
        """Register `member` under `name`; ValueError if the name is already taken."""
        known = self._members.get(name)
        if known is not None and _origin(known) != _origin(member):
            message = f"{self.kind}: {name!r} is registered twice, by {_origin(known)} and {_origin(member)}"
            raise ValueError(message)
        if self._check is not None:
            self._check(name, member)
        self._members = {**self._members, name: member}  # type: ignore[dict-item]
        module = getattr(member, "__module__", None) or LIBRARY
        if module.partition(".")[0] != LIBRARY:
            _further.append((module, name, self))
        self._ordered = False
        return member

    def has_added(self, name: str) -> bool:
        """Return whether a member is already registered, without filling the registry."""
        return name in self._members

    def register(self, name: str) -> Callable[[M], M]:
        """Return a decorator that registers a class or function under `name`."""
        return lambda member: self.add(name, member)

    def _fill(self) -> None:
        if self._filled:
            return
        self._filled = True  # before the imports: they may look a sibling up
        collects = gc.isenabled()
        gc.disable()  # imports make many objects and no garbage
        try:
            self._import_members()
        except BaseException:
            self._filled = False  # the next use reports the failure again, instead of working without some members
            raise
        finally:
            if collects:
                gc.enable()

    def _import_members(self) -> None:
        """Import the modules of the package and those of the entry points."""
        package = import_module(self.package)
        for module in sorted(module_info.name for module_info in iter_modules(package.__path__)):
            import_module(f"{package.__name__}.{module}")
        for point in entry_points(group=f"sim2reason.{self.kind}"):
            _load(point)

    def __getitem__(self, name: str) -> T:
        """Return the member with a name; UnknownNameError, with similar names, if there is none."""
        if not self._filled:
            self._fill()
        try:
            return self._members[name]
        except (KeyError, TypeError):  # a list, say, is no key at all
            raise UnknownNameError(f"no such name among {self.called}: {_shown(name)}; {self._hint(name)}") from None

    def __contains__(self, name: object) -> bool:
        """Return whether there is a member with a name, without the search for similar names of an error."""
        self._fill()
        return isinstance(name, str) and name in self._members

    @overload
    def get(self, key: str, /) -> T | None: ...
    @overload
    def get(self, key: str, default: T | M, /) -> T | M: ...
    def get(self, key: str, default: T | M | None = None, /) -> T | M | None:
        """Return the member with a name, or a default if there is none."""
        return self._members[key] if key in self else default

    def _hint(self, name: object) -> str:
        """Return a hint for an unknown name: similar names, all names, or the command that lists them."""
        canonical = {
            other: member_name for member_name, member in self._members.items() for other in getattr(member, "also", ())
        }
        names = [*self._members, *canonical]
        near = similar_names(name.lower(), names) if isinstance(name, str) else []
        near = list(dict.fromkeys(canonical.get(candidate, candidate) for candidate in near))
        if near:
            return f"did you mean: {', '.join(near)}"
        few = len(self._members) <= MAX_LISTED_NAMES
        return f"there are: {', '.join(self)}" if few else f"see: sim2reason list {self.called}"

    def name_of(self, value: object) -> str:
        """Return the registered name of the class of `value`; the name of the class if it is not registered."""
        return next((name for name, kind in self.items() if kind is type(value)), type(value).__name__)

    def _all(self) -> dict[str, T]:
        """Return all members in alphabetical order, so that random draws do not depend on import order."""
        self._fill()
        if not self._ordered:
            self._members, self._ordered = dict(sorted(self._members.items())), True
        return self._members

    def __iter__(self) -> Iterator[str]:
        """Iterate over the names of the registered members in alphabetical order."""
        return iter(self._all())

    def values(self) -> ValuesView[T]:
        """Return the members in alphabetical order of their names."""
        return self._all().values()

    def items(self) -> ItemsView[str, T]:
        """Return the names and members in alphabetical order."""
        return self._all().items()

    def __len__(self) -> int:
        """Return the number of members."""
        return len(self._all())


def further_members() -> dict[str, tuple[str, ...]]:
    """Return the names of members from outside the library, by module, in registration order.

    A worker process imports these modules first.
    """
    by_module: dict[str, tuple[str, ...]] = {}
    for module, name, registry in _further:
        if registry.has_added(name):
            by_module[module] = (*by_module.get(module, ()), name)
    return by_module


def similar_names(name: str, names: Iterable[str], most: int = 3) -> list[str]:
    """Return the names most similar to `name`, the best first, at most `most` of them."""
    matches = get_close_matches(name, names, n=most) if len(name) <= MAX_NAME_LENGTH else []
    return [other for other in matches if _likeness(name, other) >= SIMILARITY_CUTOFF * _likeness(name, matches[0])]


def _load(point: EntryPoint) -> None:
    """Import the module of an entry point; EntryPointError, with its distribution, if that fails."""
    try:
        point.load()
    except EntryPointError:
        raise  # another registry's, which names its own entry point
    except Exception as error:
        package = "?" if point.dist is None else point.dist.name
        cause = " ".join(f"{type(error).__name__}: {error}".split())
        message = (
            f"the entry point {point.name!r} ({point.value}) in the group {point.group} cannot be imported: {cause}; "
            f"fix the package {package} that declares it, or uninstall it: pip uninstall {package}"
        )
        raise EntryPointError(message) from error


def _likeness(name: str, other: str) -> float:
    return SequenceMatcher(None, other, name).ratio()


def _shown(name: object) -> str:
    """Return a name in quotes, shortened if long."""
    text = repr(name)
    return text if len(text) <= MAX_NAME_LENGTH else f"{text[:MAX_NAME_LENGTH]}…"


def _origin(member: object) -> str:
    return f"{getattr(member, '__module__', '?')}.{getattr(member, '__qualname__', repr(member))}"


FOLDER = Path(__file__).parents[1]


class Member(NamedTuple):
    """The name of a registered member, and a summary in one line."""

    name: str
    summary: str


def members(kind: str | None = None) -> dict[str, list[Member]]:
    """List the registered names of a kind, or of every kind.

    ``sim2reason.list`` is this function.

    Args:
        kind: ``entities``, ``recipes``, ``quantities``, ``engines``, ``modes`` and so on; by default all kinds.

    Returns:
        The members by kind, each with its name and its summary, in alphabetical order.

    Raises:
        UnknownNameError: There is no such kind.

    Examples:
        >>> import sim2reason
        >>> [member.name for member in sim2reason.list("engines")["engines"]]
        ['exact', 'mujoco']
    """
    known = registries()
    if kind is not None and kind not in known:
        near = similar_names(str(kind).lower(), known)
        hint = f"did you mean: {', '.join(near)}" if near else f"there are: {', '.join(known)}"
        raise UnknownNameError(f"no such kind: {kind!r}; {hint}")
    chosen = known if kind is None else {kind: known[kind]}
    return {name: [Member(n, _summary(member)) for n, member in registry.items()] for name, registry in chosen.items()}


def registries() -> dict[str, "Registry[object]"]:
    """Return every registry by the last word of its kind, without importing the members."""
    by_name: dict[str, Registry[object]] = {}
    for module in walk_packages([str(FOLDER)], "sim2reason."):
        if module.ispkg and not module.name.startswith("sim2reason.cli"):
            for value in vars(import_module(module.name)).values():
                if isinstance(value, Registry):
                    by_name[value.called] = value
    return dict(sorted(by_name.items()))


def _summary(member: object) -> str:
    """Return the summary of a member: its `summary`, the fields of a value, or the first line of its docstring."""
    summary = getattr(member, "summary", None)
    if isinstance(summary, str):
        return summary
    if is_dataclass(member) and not isinstance(member, type):
        facts = [(f.name, getattr(member, f.name)) for f in fields(member) if f.name != "name"]
        return ", ".join(f"{name} {value}" for name, value in facts if isinstance(value, str) and value)
    return (inspect.getdoc(member) or "").partition("\n")[0]

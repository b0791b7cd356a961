"""The registries of the library, found by importing its packages."""

import inspect
from dataclasses import fields, is_dataclass
from importlib import import_module
from pathlib import Path
from pkgutil import walk_packages
from typing import NamedTuple

from sim2reason.base.registry import Registry, nearest
from sim2reason.errors import UnknownNameError

LIBRARY = Path(__file__).parents[1]


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
        near = nearest(str(kind).lower(), known)
        hint = f"did you mean: {', '.join(near)}" if near else f"there are: {', '.join(known)}"
        raise UnknownNameError(f"no such kind: {kind!r}; {hint}")
    chosen = known if kind is None else {kind: known[kind]}
    return {name: [Member(n, _summary(held)) for n, held in found.items()] for name, found in chosen.items()}


def registries() -> dict[str, "Registry[object]"]:
    """Return every registry by the last word of its kind, without importing the members."""
    found: dict[str, Registry[object]] = {}
    for module in walk_packages([str(LIBRARY)], "sim2reason."):
        if module.ispkg and not module.name.startswith("sim2reason.cli"):
            for value in vars(import_module(module.name)).values():
                if isinstance(value, Registry):
                    found[value.called] = value
    return dict(sorted(found.items()))


def _summary(member: object) -> str:
    """Return the summary of a member: its `summary`, the fields of a value, or the first line of its docstring."""
    said = getattr(member, "summary", None)
    if isinstance(said, str):
        return said
    if is_dataclass(member) and not isinstance(member, type):
        facts = [(f.name, getattr(member, f.name)) for f in fields(member) if f.name != "name"]
        return ", ".join(f"{name} {value}" for name, value in facts if isinstance(value, str) and value)
    return (inspect.getdoc(member) or "").partition("\n")[0]

"""The registries of the library, found by walking it: nobody keeps a list of them."""

import inspect
from dataclasses import fields, is_dataclass
from importlib import import_module
from pathlib import Path
from pkgutil import walk_packages
from typing import NamedTuple

from sim2reason.errors import UnknownNameError
from sim2reason.registry import Registry, nearest

HERE = Path(__file__).parent


class Member(NamedTuple):
    """What is registered under a name, in one line."""

    name: str
    summary: str


def members(kind: str | None = None) -> dict[str, list[Member]]:
    """The members of a kind, or of every kind, in alphabetical order; UnknownNameError if there is no such kind.

    Kinds are ``entities``, ``recipes``, ``quantities``, ``engines``, ``modes`` and so on.
    """
    known = registries()
    if kind is not None and kind not in known:
        near = nearest(str(kind).lower(), known)
        hint = f"did you mean: {', '.join(near)}" if near else f"there are: {', '.join(known)}"
        raise UnknownNameError(f"no such kind: {kind!r}; {hint}")
    chosen = known if kind is None else {kind: known[kind]}
    return {name: [Member(n, _summary(held)) for n, held in found.items()] for name, found in chosen.items()}


def registries() -> dict[str, "Registry[object]"]:
    """Every registry under the last word of its kind; packages are imported for it, their members are not."""
    found: dict[str, Registry[object]] = {}
    for module in walk_packages([str(HERE)], "sim2reason."):
        if module.ispkg and not module.name.startswith("sim2reason.cli"):
            for value in vars(import_module(module.name)).values():
                if isinstance(value, Registry):
                    found[value.called] = value
    return dict(sorted(found.items()))


def _summary(member: object) -> str:
    """What a member says of itself: its summary, the facts of a value, the first line of what documents it."""
    said = getattr(member, "summary", None)
    if isinstance(said, str):
        return said
    if is_dataclass(member) and not isinstance(member, type):
        facts = [(f.name, getattr(member, f.name)) for f in fields(member) if f.name != "name"]
        return ", ".join(f"{name} {value}" for name, value in facts if isinstance(value, str) and value)
    return (inspect.getdoc(member) or "").partition("\n")[0]

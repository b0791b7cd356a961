"""The registries of the library, found by walking it: no command keeps a list of them."""

from importlib import import_module
from pkgutil import walk_packages

import sim2reason
from sim2reason.cli.console import words
from sim2reason.errors import UnknownNameError
from sim2reason.registry import Registry


def registries() -> dict[str, "Registry[object]"]:
    """Every registry under the last word of its kind; packages are imported for it, their members are not."""
    found: dict[str, Registry[object]] = {}
    for module in walk_packages(sim2reason.__path__, "sim2reason."):
        if module.ispkg and not module.name.startswith("sim2reason.cli"):
            for value in vars(import_module(module.name)).values():
                if isinstance(value, Registry):
                    found[value.kind.rpartition(".")[2]] = value
    return dict(sorted(found.items()))


def registry(kind: str) -> "Registry[object]":
    """The registry of `kind`; UnknownNameError with the known kinds if there is none."""
    known = registries()
    if kind not in known:
        raise UnknownNameError(f"no such kind: {kind!r}; there are: {', '.join(known)}")
    return known[kind]


def chosen(kind: str, option: str) -> tuple[str, ...]:
    """The members that an option names, separated by commas, or all; UnknownNameError for an unknown one."""
    members = registry(kind)
    names = tuple(members) if option == "all" else words(option)
    for name in names:
        members[name]  # says what is near to an unknown name
    return names

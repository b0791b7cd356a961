"""The result of a maker of items, and the versions of packages that determine it."""

import platform
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache
from importlib import import_module
from importlib.metadata import version
from typing import cast

from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item
from sim2reason.generation.request import Request

SHAPING = "sim2reason", "mujoco", "numpy", "pyarrow", "pydantic", "sympy"
"""The packages whose versions may change the bytes of a dataset."""


@dataclass(frozen=True, slots=True)
class Made:
    """What a maker gives back.

    `item` is None if no draw passed within the maker's budget, which is counted in steps, never in seconds.
    `rejected` counts the draws that were refused on the way, by filter or reason. `wanted` is the kind of question that
    was tried first, by the weights, among those that the scenes offer; empty for none.
    """

    item: Item | None
    rejected: dict[str, int] = field(default_factory=dict[str, int])
    wanted: str = ""


Maker = Callable[[Request], Made]


@cache
def versions() -> dict[str, str]:
    """Return all that may change the bytes beside the configuration: packages, Python and platform."""
    found = {"python": platform.python_version(), "platform": f"{sys.platform}-{platform.machine()}"}
    for package in SHAPING:
        found[package] = version(package)
    return dict(sorted(found.items()))


def load_maker(path: str) -> Maker:
    """Import a maker from ``package.module:function``; DatasetError if there is none."""
    module, _, name = path.partition(":")
    try:
        return cast("Maker", getattr(import_module(module), name))
    except (ImportError, AttributeError, ValueError) as error:
        raise DatasetError(f"{path}: no maker of items can be imported from here ({error})") from error

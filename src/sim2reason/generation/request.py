"""Requests for items, the results of makers, and the weights of question kinds."""

import hashlib
import json
import platform
import re
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from importlib import import_module
from importlib.metadata import version
from math import isfinite
from operator import index as as_index
from typing import Self, SupportsIndex, cast

import numpy as np

from sim2reason.errors import DatasetError, DrawError
from sim2reason.generation.item import Item
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import KINDS, MODES
from sim2reason.questions.accuracy import TOLERANCE, out_of_range

MAX_SEED = 2**63 - 1
"""The largest seed and index: columns of a shard hold no more."""
SI = "SI"
"""The system of units of which a text speaks by default."""
Weights = tuple[tuple[str, float], ...]
"""Pairs of a name and a weight."""
UNFILTERED = "unfiltered"
"""What stands in the id of an item that no filter has seen."""
_ID = re.compile(
    r"(?P<recipe>[^-].{0,80}?)-(?P<difficulty>[a-z]{1,20})-(?P<mode>[a-z]{1,20})-(?P<seed>\d{1,19})-(?P<index>\d{1,19})"
    rf"(?:-(?P<units>(?!{UNFILTERED})[a-z]{{1,20}}(?<![0-9a-f]{{8}})))?(?P<unfiltered>-{UNFILTERED})?"
    r"(?:-(?P<weights>[0-9a-f]{8}))?"
)


def nonnegative_integer(name: str, value: object) -> int:
    """Return a nonnegative integer coordinate (not a boolean); DrawError, with its name, otherwise."""
    try:
        integer = as_index(cast("SupportsIndex", value)) if not isinstance(value, bool) else -1
    except TypeError:
        integer = -1
    if not 0 <= integer <= MAX_SEED:
        raise DrawError(f"{name}: {value!r} is no whole number from 0 to {MAX_SEED}; give one")
    return integer


@dataclass(frozen=True, slots=True)
class Request:
    """A request for one item: recipe, difficulty, mode, seed and index, with settings."""

    recipe: str
    difficulty: str
    mode: str
    seed: int
    index: int
    weights: Weights = ()
    """Of kinds of question, by name, where they are not those that the library declares."""
    units: str = SI
    solutions: bool = False
    """Whether the item comes with its worked solution; it is the same problem either way."""
    unfiltered: bool = False
    """Whether any question that has an answer will do, whatever the filters say of it."""
    quantities: tuple[str, ...] = ()
    """Those that may be asked about; none: any."""
    tolerance: float = TOLERANCE
    """The relative error that an answer may have, and by which filters judge; a formula's values have their own."""
    needs: tuple[str, ...] = ()
    """What solutions may need, by label; none: elementary means, and for few items more."""

    def __post_init__(self) -> None:
        """Convert foreign integers to Python's; DrawError for invalid values."""
        if fault := out_of_range(self.tolerance):
            raise DrawError(f"tolerance: {fault}")
        for name in ("seed", "index"):
            object.__setattr__(self, name, nonnegative_integer(name, getattr(self, name)))

    @property
    def id(self) -> str:
        """Return the unique name of the request."""
        name = f"{self.recipe}-{self.difficulty}-{self.mode}-{self.seed}-{self.index}"
        tail = f"-{self.units}" if self.units != SI else ""
        tail += f"-{UNFILTERED}" if self.unfiltered else ""
        chosen: tuple[tuple[str | float, ...] | str, ...] = (*self.weights, *self.quantities)
        chosen += (("tolerance", self.tolerance),) if self.tolerance != TOLERANCE else ()
        chosen += (("needs", *self.needs),) if self.needs else ()
        return f"{name}{tail}-{_digest(chosen)}" if chosen else f"{name}{tail}"

    @classmethod
    def named(cls, name: str, weights: Weights = (), tolerance: float = TOLERANCE, needs: tuple[str, ...] = ()) -> Self:
        """Return the request with an id; weights, tolerance and needs are not part of an id and must be given."""
        match = _ID.fullmatch(name)
        if match is None:
            raise DrawError(f"{name!r} is no id; one looks like pulley-easy-numeric-0-4")
        seed, index, units = int(match["seed"]), int(match["index"]), match["units"] or SI
        request = cls(
            match["recipe"],
            match["difficulty"],
            match["mode"],
            seed,
            index,
            weights,
            units,
            unfiltered=bool(match["unfiltered"]),
            tolerance=tolerance,
            needs=needs,
        )
        if request.id != name:
            unsaid = "its weights, quantities, tolerance or needs do not stand in its id"
            raise DrawError(f"{name!r}: {unsaid}; see: sim2reason explain DATASET --id ID")
        return request

    @classmethod
    def of(cls, item: Item) -> Self:
        """Return the request that produced an item; DrawError for items without a recipe or with chosen quantities."""
        if not item.recipe:
            raise DrawError(f"{item.id}: it is asked about a scene; give that with a question instead of the item")
        solved = item.solution is not None or bool(item.unsolved)
        weights = tuple(sorted(item.provenance.weights.items()))
        return replace(cls.named(item.id, weights, item.answer.tolerance, item.provenance.needs), solutions=solved)


def _digest(chosen: tuple[tuple[str | float, ...] | str, ...]) -> str:
    """Return a short hash of the settings of a request beyond its coordinates."""
    return hashlib.sha256(json.dumps(chosen).encode()).hexdigest()[:8]


SHAPING = "sim2reason", "mujoco", "numpy", "pyarrow", "pydantic", "sympy"
"""The packages whose versions may change the bytes of a dataset."""
DISTRIBUTIONS = {"mujoco": "mujoco-core"}
"""The distribution that provides a package, where it has another name."""


def shaping_versions() -> dict[str, str]:
    """Return the versions of the packages that may change the bytes of a dataset."""
    return {package: version(DISTRIBUTIONS.get(package, package)) for package in SHAPING}


@dataclass(frozen=True, slots=True)
class Made:
    """The item made for one request, or None, with the counts of rejected draws.

    `item` is None if no draw passed within the maker's budget, which is counted in steps, never in seconds. `rejected`
    counts the rejected draws by filter or reason. `wanted` is the question kind that was tried first by the weights,
    among those that the scenes offer; empty for none.
    """

    item: Item | None
    rejected: dict[str, int] = field(default_factory=dict[str, int])
    wanted: str = ""


Maker = Callable[[Request], Made]


@cache
def versions() -> dict[str, str]:
    """Return the versions of all packages and platforms that may change the bytes of an item."""
    installed = {"python": platform.python_version(), "platform": f"{sys.platform}-{platform.machine()}"}
    return dict(sorted((installed | shaping_versions()).items()))


def load_maker(path: str) -> Maker:
    """Import the function that makes items from ``package.module:function``; DatasetError if it does not exist."""
    module, _, name = path.partition(":")
    try:
        return cast("Maker", getattr(import_module(module), name))
    except (ImportError, AttributeError, ValueError) as error:
        raise DatasetError(f"{path}: no maker of items can be imported from here ({error})") from error


REMEDY = "write KIND, MODE.KIND, RECIPE.KIND or RECIPE.MODE.KIND, as in reverse.period=0.5"


def weight(kind: str, mode: str, recipe: str, ordered: Mapping[str, float]) -> float:
    """Return the weight of a question kind: as requested, else as declared by its class, the mode and the recipe."""
    for name in (f"{recipe}.{mode}.{kind}", f"{recipe}.{kind}", f"{mode}.{kind}", kind):
        if name in ordered:
            return ordered[name]
    declared = RECIPES[recipe].weights
    own = declared.get(f"{mode}.{kind}", declared.get(kind, 1.0))
    return KINDS[kind].share * MODES[mode].weights.get(kind, 1.0) * own


def random_kind_order(mode: str, recipe: str, ordered: Weights, rng: np.random.Generator) -> list[str]:
    """Return all kinds of a mode with positive weight, in a random order by weight.

    If the first available kind is used, the available kinds occur in proportion to their weights.
    """
    given = dict(ordered)
    weights = {kind: weight(kind, mode, recipe, given) for kind in _kinds(mode)}
    kinds = [kind for kind, size in weights.items() if size > 0.0]
    sizes = np.array([weights[kind] for kind in kinds])
    order: list[int] = rng.choice(len(kinds), size=len(kinds), replace=False, p=sizes / sizes.sum()).tolist()
    return [kinds[number] for number in order]


def check(weights: Mapping[str, float], modes: tuple[str, ...], recipes: tuple[str, ...]) -> None:
    """Raise DatasetError for an invalid weight or name, or if no kind remains."""
    for name, size in weights.items():
        if not (isfinite(size) and size >= 0.0):
            raise _error(name, f"{size} is no weight", "give a number that is not negative; 0 is never asked")
        *before, kind = name.split(".")
        if kind not in KINDS:
            raise _error(name, f"there is no kind {kind!r}", f"there are: {', '.join(KINDS)}; {REMEDY}")
        known = (RECIPES, MODES) if len(before) > 1 else (RECIPES if before and before[0] in RECIPES else MODES,)
        asking = next((MODES[part] for part in before if part in MODES), None)
        if asking is not None and size > 0.0 and kind not in asking.kinds:
            raise _error(name, f"the mode {asking.name} has no {kind!r}", f"it has: {', '.join(_kinds(asking.name))}")
        if len(before) > 2 or any(part not in registry for part, registry in zip(before, known, strict=False)):
            raise _error(name, f"{'.'.join(before)!r} is no recipe, mode, or recipe and mode", REMEDY)
    for mode in dict.fromkeys(modes):
        for recipe in dict.fromkeys(recipes):
            if not any(weight(kind, mode, recipe, weights) > 0.0 for kind in _kinds(mode)):
                raise _error(f"{recipe}.{mode}", "all kinds have the weight 0", "leave one that can be asked")


def _kinds(mode: str) -> list[str]:
    return [kind for kind in KINDS if kind in MODES[mode].kinds]


def _error(name: str, problem: str, remedy: str) -> DatasetError:
    return DatasetError(f"weights: {name}: {problem}; {remedy}")

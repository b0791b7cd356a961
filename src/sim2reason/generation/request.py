"""An order for one item: its coordinates, and the id that they give it."""

import hashlib
import json
import re
from dataclasses import dataclass, replace
from operator import index as as_index
from typing import Self, SupportsIndex, cast

from sim2reason.errors import DrawError
from sim2reason.generation.item import Item
from sim2reason.questions.tolerance import TOLERANCE, out_of_range

LARGEST = 2**63 - 1
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


def whole(name: str, value: object) -> int:
    """Return a coordinate: a whole number from 0 on, but not True or False; DrawError names it."""
    try:
        found = as_index(cast("SupportsIndex", value)) if not isinstance(value, bool) else -1
    except TypeError:
        found = -1
    if not 0 <= found <= LARGEST:
        raise DrawError(f"{name}: {value!r} is no whole number from 0 to {LARGEST}; give one")
    return found


@dataclass(frozen=True, slots=True)
class Request:
    """An order for one item: the `index`-th of its recipe, difficulty, mode and seed."""

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
        """DrawError for what no item has; whole numbers of other packages become Python's."""
        if fault := out_of_range(self.tolerance):
            raise DrawError(f"tolerance: {fault}")
        for name in ("seed", "index"):
            object.__setattr__(self, name, whole(name, getattr(self, name)))

    @property
    def id(self) -> str:
        """A name that no other request has."""
        name = f"{self.recipe}-{self.difficulty}-{self.mode}-{self.seed}-{self.index}"
        tail = f"-{self.units}" if self.units != SI else ""
        tail += f"-{UNFILTERED}" if self.unfiltered else ""
        chosen: tuple[tuple[str | float, ...] | str, ...] = (*self.weights, *self.quantities)
        chosen += (("tolerance", self.tolerance),) if self.tolerance != TOLERANCE else ()
        chosen += (("needs", *self.needs),) if self.needs else ()
        return f"{name}{tail}-{_digest(chosen)}" if chosen else f"{name}{tail}"

    @classmethod
    def named(cls, name: str, weights: Weights = (), tolerance: float = TOLERANCE, needs: tuple[str, ...] = ()) -> Self:
        """Return the request of an id, made with these weights, tolerance and needs; DrawError for any other text."""
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
        """Return the request that an item answers; DrawError for an item without a recipe or of chosen quantities."""
        if not item.recipe:
            raise DrawError(f"{item.id}: it is asked about a scene; give that with a question instead of the item")
        solved = item.solution is not None or bool(item.unsolved)
        weights = tuple(sorted(item.provenance.weights.items()))
        return replace(cls.named(item.id, weights, item.answer.tolerance, item.provenance.needs), solutions=solved)


def _digest(chosen: tuple[tuple[str | float, ...] | str, ...]) -> str:
    """Return a short name for what an order says beside its coordinates."""
    return hashlib.sha256(json.dumps(chosen).encode()).hexdigest()[:8]

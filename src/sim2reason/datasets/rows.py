"""Rows of items as other packages have them: a dict of `datasets`, polars or pyarrow, a Series or a tuple of pandas.

The same item comes with Python's numbers or with NumPy's, with lists, tuples or arrays.
"""

from collections.abc import Iterable, Mapping
from math import isnan
from typing import Protocol, cast, runtime_checkable

from pydantic import ValidationError

from sim2reason.errors import DatasetError
from sim2reason.generation.item import Answer, unfolded

DEEPEST = 40  # groups, lists and wrappers in each other


@runtime_checkable
class ItemRow(Protocol):
    """Columns by name: a mapping, or a Series, which is none."""

    def keys(self) -> Iterable[object]:
        """Return the names of the columns."""
        ...

    def __getitem__(self, name: str, /) -> object:
        """Return what a column holds."""
        ...


class NamedRow(Protocol):
    """Columns by name in a named tuple, as ``itertuples`` of pandas gives them."""

    def _asdict(self) -> Mapping[str, object]:
        """Return what each column holds."""
        ...


def answer_of(given: ItemRow | NamedRow) -> Answer:
    """Return the answer of a row; DatasetError if it has none that can be read."""
    row = given if isinstance(given, ItemRow) else _unnamed(given)
    if not isinstance(row, ItemRow):
        raise DatasetError(f"{type(given).__name__} is no item; give an Item, or a row of a dataset")
    if "answer" not in set(row.keys()):
        raise DatasetError(f"a row without the column 'answer'; it has: {', '.join(map(str, row.keys()))[:200]}")
    try:
        return Answer.model_validate(unfolded(plain(row["answer"])))
    except ValidationError as error:
        fault = error.errors()[0]
        where, problem = ".".join(map(str, ("answer", *fault["loc"]))), fault["msg"]
    except ValueError as error:
        where, problem = "answer", f"no JSON: {error}"
    raise DatasetError(f"{where}: {problem}; give a row of a dataset as it was read")


def _unnamed(row: object) -> object:
    """Return the mapping that a named tuple is, once; of anything else itself."""
    names = None if isinstance(row, type) else getattr(row, "_asdict", None)
    return names() if callable(names) else row


def plain(value: object, depth: int = DEEPEST) -> object:
    """Return a value of any of these packages as Python's own; a group of which nothing is known is None.

    What lies deeper than any item's column is left as it is.
    """
    if not depth:
        return value
    for conversion in ("as_py", "tolist", "to_list"):  # a scalar of pyarrow; an array or a number; a Series of polars
        found = getattr(value, conversion, None)
        if callable(found):
            return plain(found(), depth - 1)
    if isinstance(value, Mapping):
        held = {str(key): plain(member, depth - 1) for key, member in cast("Mapping[object, object]", value).items()}
        return held if any(member is not None for member in held.values()) else None
    if isinstance(value, list | tuple):
        return [plain(member, depth - 1) for member in cast("Iterable[object]", value)]
    return None if isinstance(value, float) and isnan(value) else value

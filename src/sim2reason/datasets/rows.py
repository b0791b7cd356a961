"""Rows of items as other packages have them: a dict of `datasets`, a Series of pandas, a dict of polars or pyarrow.

The same item comes with Python's numbers or with NumPy's, with lists, tuples or arrays.
"""

from collections.abc import Iterable, Mapping
from math import isnan
from typing import Protocol, cast, runtime_checkable

from pydantic import ValidationError

from sim2reason.datasets.item import Answer, unfolded
from sim2reason.errors import DatasetError


@runtime_checkable
class ItemRow(Protocol):
    """Columns by name: a mapping, or a Series, which is none."""

    def keys(self) -> Iterable[object]:
        """The names of the columns."""
        ...

    def __getitem__(self, name: str, /) -> object:
        """What a column holds."""
        ...


def answer_of(row: ItemRow) -> Answer:
    """The answer of a row; DatasetError if it has none that can be read."""
    if not isinstance(row, ItemRow):  # type: ignore[reportUnnecessaryIsInstance]  # callers need not be typed
        raise DatasetError(f"{type(row).__name__} is no item; give an Item, or a row of a dataset")
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


def plain(value: object) -> object:
    """A value of any of these packages as Python's own; a group of which nothing is known is None."""
    for conversion in ("as_py", "tolist", "to_list"):  # a scalar of pyarrow; an array or a number; a Series of polars
        found = getattr(value, conversion, None)
        if callable(found):
            return plain(found())
    if isinstance(value, Mapping):
        held = {str(key): plain(member) for key, member in cast("Mapping[object, object]", value).items()}
        return held if any(member is not None for member in held.values()) else None
    if isinstance(value, list | tuple):
        return [plain(member) for member in cast("Iterable[object]", value)]
    return None if isinstance(value, float) and isnan(value) else value

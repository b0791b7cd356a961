"""Rows for a trainer whose problems are generated on request, optionally mixed with stored rows."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Annotated, Any, Protocol

import numpy as np
from annotated_types import Ge, Gt, Le, MinLen
from pydantic import Field, ValidationError

from sim2reason.base.settings import first_fault, read_settings
from sim2reason.datasets.contamination import Benchmarks
from sim2reason.datasets.exports import EXPORTS, Export, RowPosition
from sim2reason.datasets.fresh import INDEX_STRIDE, LazyProblems
from sim2reason.datasets.generate import build_config
from sim2reason.datasets.plan import ALL_NAMES, MAKER, TRAIN
from sim2reason.errors import DatasetError, EvaluationError, Sim2ReasonError
from sim2reason.generation.item import Record
from sim2reason.generation.request import MAX_SEED, SI

__all__ = ["LazyRows", "LazySettings", "Rows"]

MAX_SHARE_DENOMINATOR = 1000
"""The share of drawn rows is taken as a fraction with a denominator of at most this."""
Names = str | Annotated[tuple[str, ...], MinLen(1)]


class Rows(Protocol):
    """Stored rows: a list, or a Hugging Face dataset."""

    def __len__(self) -> int:
        """Return the number of rows."""
        ...

    def __getitem__(self, number: int, /) -> Mapping[str, Any]:
        """Return one row."""
        ...


class LazySettings(Record):
    """The settings of generated rows, as in a YAML file, named like the options of `generate`."""

    items: Annotated[int, Ge(1), Le(INDEX_STRIDE)]
    """The number of rows, drawn and stored together."""
    share: Annotated[float, Gt(0.0), Le(1.0)] = 1.0
    """Of the rows that are drawn; the others are stored ones."""
    recipe: Names = ALL_NAMES
    difficulty: Names = ALL_NAMES
    mode: Names = "numeric"
    seed: Annotated[int, Ge(0), Le(MAX_SEED)] = 0
    weights: dict[str, float] = Field(default_factory=dict[str, float])
    units: str = SI
    split: dict[str, float] = Field(default_factory=lambda: {TRAIN: 1.0})
    take: str = TRAIN
    """The split whose problems are drawn."""
    decontaminate: tuple[str, ...] = ()
    maker: str = MAKER

    @classmethod
    def read(cls, path: Path | str) -> "LazySettings":
        """Read settings from a file; DatasetError, in one line, if they are invalid."""
        try:
            return cls.model_validate(read_settings(Path(path)))
        except ValidationError as error:
            raise DatasetError(f"{path}: {first_fault(error, cls)}") from None
        except EvaluationError as error:
            raise DatasetError(str(error)) from None

    def problems(self) -> LazyProblems:
        """Return the problems that the settings describe, generated on request."""
        config = build_config(
            items=self.items,
            recipe=self.recipe,
            difficulty=self.difficulty,
            mode=self.mode,
            seed=self.seed,
            weights=self.weights,
            units=self.units,
            split=self.split,
            decontaminate=self.decontaminate,
            maker=self.maker,
        )
        return LazyProblems(config, self.take, Benchmarks(self.decontaminate) if self.decontaminate else None)


class LazyRows:
    """The generated and stored rows described by a file of `LazySettings`, by number, in an export's format.

    Of any n consecutive rows, n · `share` are generated, within one. The others are the `stored` ones, all of them in
    an order drawn by the seed, then all in another order, and so on. A row is a pure function of the file, the stored
    rows and its number, in any process.

    Args:
        path: the file.
        to: the name of an export.
        stored: rows of others with the same columns; further columns are left out.

    Raises:
        DatasetError: a file that can't be used, or stored rows that don't fit to its share.
        UnknownNameError: a name in it that there is not.
    """

    def __init__(self, path: Path | str, to: str, stored: Rows | Sequence[Mapping[str, Any]] = ()) -> None:
        """Read the file without generating a problem."""
        self._export: Export = EXPORTS[to]
        self._settings = LazySettings.read(path)
        self._share = Fraction(self._settings.share).limit_denominator(MAX_SHARE_DENOMINATOR)
        try:
            self._problems = self._settings.problems()
        except Sim2ReasonError as error:
            error.args = (f"{path}: {error}", *error.args[1:])
            raise
        if (self._share < 1) != (len(stored) > 0):
            reason = "but there are no stored rows" if self._share < 1 else "so that stored rows would never be shown"
            raise DatasetError(f"{path}: share is {self._settings.share}, {reason}; give both or neither")
        self._stored = stored
        self._order: tuple[int, np.ndarray[Any, np.dtype[np.int64]]] = (-1, np.zeros(0, np.int64))

    def __len__(self) -> int:
        """Return the number of rows."""
        return self._settings.items

    def __getitem__(self, number: int) -> dict[str, Any]:
        """Return a row; IndexError beyond the last, DrawError if no problem is found."""
        if not 0 <= number < len(self):
            raise IndexError(f"row {number} of {len(self)}")
        drawn = number * self._share.numerator // self._share.denominator
        if (number + 1) * self._share.numerator // self._share.denominator == drawn:
            return self._stored_row(number - drawn)
        row = self._export.row(self._problems[drawn], RowPosition(self._settings.take, number))
        if row is None:
            raise DatasetError(f"row {number}: {self._export.lacks}")
        return dict(row)

    def _stored_row(self, number: int) -> dict[str, Any]:
        lap, index = divmod(number, len(self._stored))
        if self._order[0] != lap:
            self._order = lap, np.random.default_rng([self._settings.seed, lap]).permutation(len(self._stored))
        row = self._stored[int(self._order[1][index])]
        lacking = [name for name in self._export.columns if name not in row]
        if lacking:
            raise DatasetError(f"a stored row has no column {lacking[0]!r}; it has {', '.join(row)}")
        return {name: row[name] for name in self._export.columns}

"""Problems that are drawn as a trainer asks for them, in the rows of an export, without end."""

from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from itertools import chain
from pathlib import Path
from typing import Any

from sim2reason.datasets.contamination import Benchmarks
from sim2reason.datasets.generate import Order, configured, files_to_avoid
from sim2reason.datasets.lazy import MOST, LazyProblems
from sim2reason.datasets.plan import ALL, MAKER, TRAIN, Names
from sim2reason.datasets.request import SI, whole
from sim2reason.errors import DatasetError, MissingExtraError
from sim2reason.exports import EXPORTS, Column, Place
from sim2reason.questions.tolerance import TOLERANCE

__all__ = ["FreshRows", "iterable"]


def iterable(  # noqa: PLR0913 - what is drawn, by name
    to: str = "hf",
    *,
    items: int | None = None,
    recipe: Names = ALL,
    difficulty: Names = ALL,
    mode: Names = "numeric",
    seed: int = 0,
    start: int = 0,
    weights: Mapping[str, float] | None = None,
    units: str = SI,
    tolerance: float = TOLERANCE,
    needs: Names = (),
    solutions: bool = False,
    decontaminate: Path | str | Sequence[Path | str] = (),
    maker: str = MAKER,
) -> "FreshRows":
    """Draw fresh problems for a trainer: rows as the export `to` has them, from position `start` on.

    There is no end to them unless `items` says how many. What is drawn is as in `generate`; give another `seed` than to
    the problems that you evaluate on. The same arguments give the same rows, on any machine.

    Raises:
        UnknownNameError: no such export, recipe, difficulty, mode, units or need.
        DatasetError: what makes no sense.
        DrawError: a negative number of items or start, or one that is far too large.
    """
    order = Order(recipe=recipe, difficulty=difficulty, mode=mode, seed=seed, weights=weights, units=units)
    order |= {"tolerance": tolerance, "needs": needs, "solutions": solutions, "maker": maker}
    order["decontaminate"] = decontaminate
    begin, files = whole("start", start), files_to_avoid(order)
    end = MOST if items is None else begin + whole("items", items)
    order["items"] = max(begin, end)
    problems = LazyProblems(configured(**order), TRAIN, Benchmarks(files) if files else None)
    return FreshRows(problems, to, range(begin, end))


class FreshRows:
    """Rows of problems that are made when they are asked for: by their position, or one after the other.

    Each iteration begins anew. The row at a position is always the same; a small object that can be pickled makes it.

    Args:
        problems: what is drawn.
        to: the name of the export whose rows they are.
        positions: those of the problems that an iteration goes over.
    """

    def __init__(self, problems: LazyProblems, to: str, positions: range) -> None:
        """Draw nothing yet."""
        self._export, self.to = EXPORTS[to], to
        self._problems, self._positions = problems, positions

    def __repr__(self) -> str:
        """What they are for, and from which position on."""
        return f"<FreshRows for {self.to!r} from position {self._positions.start} on>"

    def __iter__(self) -> Iterator[dict[str, Any]]:
        """Each row in turn; an item that the export can't hold is passed over."""
        return (row for position in self._positions if (row := self._row(position)) is not None)

    def __getitem__(self, number: int) -> dict[str, Any]:
        """The row of that number, from 0 on.

        Raises:
            IndexError: there are fewer.
            DatasetError: the export can't hold the item.
            DrawError: none of many draws gives a problem.
        """
        row = self._row(self._positions[number])
        if row is None:
            raise DatasetError(f"row {number}: {self._export.lacks}")
        return row

    def shards(self, number: int) -> "list[FreshRows]":
        """So many parts, which take turns over the positions: one for each process that draws."""
        every = whole("shards", number)
        if not every:
            raise DatasetError("shards: 0 of them hold nothing; give one or more")
        return [FreshRows(self._problems, self.to, self._positions[part::every]) for part in range(every)]

    def to_hugging_face(self, shards: int = 1) -> Any:  # noqa: ANN401 - datasets is no package that the library needs
        """An `IterableDataset` of Hugging Face's datasets, as TRL's trainers take it.

        Processes of a data loader, and machines, share its `shards`: give as many as there are of them. One that has
        several goes over one after the other, and an endless one never ends.

        Raises:
            MissingExtraError: datasets is not installed.
        """
        try:
            datasets: Any = import_module("datasets")
        except ImportError as error:
            raise MissingExtraError("datasets") from error
        features = {name: _feature(datasets, column) for name, column in self._export.columns.items()}
        return datasets.IterableDataset.from_generator(
            _all_rows,
            features=datasets.Features(features) if features else None,
            gen_kwargs={"shards": self.shards(shards)},
        )

    def _row(self, position: int) -> dict[str, Any] | None:
        row = self._export.row(self._problems[position], Place(TRAIN, position))
        return None if row is None else dict(row)


def _all_rows(shards: Sequence[FreshRows]) -> Iterator[dict[str, Any]]:
    """The rows of one shard after the other."""
    return chain.from_iterable(shards)


def _feature(datasets: Any, column: Column) -> Any:  # noqa: ANN401 - a module and what it gives
    """What `datasets` calls a column of an export."""
    if isinstance(column, list):
        return datasets.List(_feature(datasets, column[0]))
    if isinstance(column, dict):
        return {name: _feature(datasets, part) for name, part in column.items()}
    return datasets.Value({str: "string", int: "int64", float: "float64"}[column])

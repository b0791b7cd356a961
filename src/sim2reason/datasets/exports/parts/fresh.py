"""Endless fresh problems as rows of an export, generated when a trainer requests them."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import Any

from sim2reason.base.optional import optional
from sim2reason.datasets.contamination import Benchmarks
from sim2reason.datasets.exports import EXPORTS, Column, Place
from sim2reason.datasets.generate import Order, configured, files_to_avoid
from sim2reason.datasets.lazy import INDEX_STRIDE, LazyProblems
from sim2reason.datasets.plan import ALL, MAKER, TRAIN, Names
from sim2reason.errors import DatasetError
from sim2reason.generation.request import SI, nonnegative_integer
from sim2reason.questions.accuracy import TOLERANCE

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
    """Return fresh problems for a trainer, as rows in the format of an export.

    Problems are drawn on request, as in `generate`, and endless unless `items` limits them. The same arguments give the
    same rows on any machine. Give another `seed` than to the problems that you evaluate on.

    Args:
        to: Name of the format; ``sim2reason.list("exports")`` returns all of them.
        items: Number of positions; by default unlimited.
        recipe: Kinds of scenes: one name, several, or ``all``.
        difficulty: ``easy``, ``medium``, ``hard``, several of these, or ``all``.
        mode: Modes of questions: one name, several, or ``all``.
        seed: Seed of the problems, 0 or greater.
        start: Position at which to start, from 0.
        weights: Relative frequencies of kinds of question, as in ``{"period": 2, "reverse.count": 0}``.
        units: System of units of the texts: ``SI``, ``cgs`` or ``mixed``.
        tolerance: Relative error that an answer may have, from 0.005 to 0.05; the filters apply it, too.
        needs: Mathematics that solutions may need, as in `item`.
        solutions: Whether problems have worked solutions.
        decontaminate: Files of benchmarks with which no problem may share a run of words.
        maker: Function that makes items, as a dotted path.

    Returns:
        The rows: iterate over them, index them, or convert them with `to_hugging_face`.

    Raises:
        UnknownNameError: There is no such export, recipe, difficulty, mode, system of units or need.
        DatasetError: An argument is invalid.
        DrawError: `items` or `start` is negative or far too large.

    Examples:
        >>> import sim2reason
        >>> rows = sim2reason.iterable("hf", recipe="pulley", difficulty="easy", seed=1)
        >>> rows[0]["id"]
        'pulley-easy-numeric-1-0'
        >>> rows
        <FreshRows for 'hf' from position 0 on>
    """
    order = Order(recipe=recipe, difficulty=difficulty, mode=mode, seed=seed, weights=weights, units=units)
    order |= {"tolerance": tolerance, "needs": needs, "solutions": solutions, "maker": maker}
    order["decontaminate"] = decontaminate
    begin, files = nonnegative_integer("start", start), files_to_avoid(order)
    end = INDEX_STRIDE if items is None else begin + nonnegative_integer("items", items)
    order["items"] = max(begin, end)
    problems = LazyProblems(configured(**order), TRAIN, Benchmarks(files) if files else None)
    return FreshRows(problems, to, range(begin, end))


class FreshRows:
    """Rows of problems generated on request, by number or in order.

    Each iteration begins anew. The row at a position is always the same. The object is small and can be pickled.

    Args:
        problems: the problems to draw.
        to: the name of the export whose rows they are.
        positions: the positions of the problems in the rows.
    """

    def __init__(self, problems: LazyProblems, to: str, positions: range) -> None:
        """Store the problems, the export and the positions without drawing a problem."""
        self._export, self.to = EXPORTS[to], to
        self._problems, self._positions = problems, positions

    def __repr__(self) -> str:
        """Return a text with the name of the export and the first position."""
        return f"<FreshRows for {self.to!r} from position {self._positions.start} on>"

    def __iter__(self) -> Iterator[dict[str, Any]]:
        """Return an iterator over the rows in order, without items that the export cannot represent."""
        return (row for position in self._positions if (row := self._row(position)) is not None)

    def __getitem__(self, number: int) -> dict[str, Any]:
        """Return the row with a number, counted from 0.

        Raises:
            IndexError: there are fewer rows.
            DatasetError: the export can't hold the item.
            DrawError: none of many draws gives a problem.
        """
        row = self._row(self._positions[number])
        if row is None:
            raise DatasetError(f"row {number}: {self._export.lacks}")
        return row

    def shards(self, number: int) -> "list[FreshRows]":
        """Split the rows into `number` interleaved parts, one for each process."""
        every = nonnegative_integer("shards", number)
        if not every:
            raise DatasetError("shards: 0 of them hold nothing; give one or more")
        return [FreshRows(self._problems, self.to, self._positions[part::every]) for part in range(every)]

    def to_hugging_face(self, shards: int = 1) -> Any:  # noqa: ANN401 - datasets is no package that the library needs
        """Return the rows as an `IterableDataset` of Hugging Face's datasets, for TRL's trainers.

        Processes of a data loader, and machines, share the `shards`: give as many shards as processes. A process with
        several shards reads them one after the other, and never comes to the end of an endless shard.

        Raises:
            MissingExtraError: datasets is not installed.
        """
        datasets = optional("datasets")
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
    """Return an iterator over the rows of all shards, shard after shard."""
    return chain.from_iterable(shards)


def _feature(datasets: Any, column: Column) -> Any:  # noqa: ANN401 - a module and what it gives
    """Return the feature of `datasets` for a column of an export."""
    if isinstance(column, list):
        return datasets.List(_feature(datasets, column[0]))
    if isinstance(column, dict):
        return {name: _feature(datasets, part) for name, part in column.items()}
    return datasets.Value({str: "string", int: "int64", float: "float64"}[column])

"""Access to a finished dataset: iteration, lookup by id, samples, upload, and verification."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import islice
from os import PathLike
from pathlib import Path
from typing import Any, overload

from sim2reason.base.optional import optional
from sim2reason.base.records import cached_property, format_count
from sim2reason.datasets import shard_files
from sim2reason.datasets.manifest import Manifest, ShardFile, load_sealed, shard, shards
from sim2reason.datasets.plan import ALL_NAMES, Names, several
from sim2reason.datasets.shard_files import Findings, ItemFiles, check_folder
from sim2reason.datasets.store import Row
from sim2reason.errors import DatasetError, DrawError
from sim2reason.generation.item import Item

# huggingface_hub is an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false


MAX_MESSAGE_LENGTH = 300  # characters of an error message of the Hub's library
IGNORED = "**/.*", ".*"
"""What is of this machine alone."""


def push(path: Path, repository: str, *, private: bool, token: str | None, message: str) -> str:
    """Upload the dataset at `path` and return its address on the Hub, with the errors of `Dataset.push_to_hub`."""
    hub, errors = optional("huggingface_hub", "eval"), optional("huggingface_hub.errors", "eval")
    if faults := check_folder(path).faults:
        raise DatasetError(f"{path}: {faults[0]}; a damaged dataset is not uploaded: see sim2reason verify {path}")
    api = hub.HfApi(token=token)
    try:
        address = api.create_repo(repository, repo_type="dataset", private=private, exist_ok=True)
        api.upload_folder(
            folder_path=path,
            repo_id=address.repo_id,
            repo_type="dataset",
            commit_message=message,
            ignore_patterns=list(IGNORED),
        )
    except (errors.HfHubHTTPError, errors.HFValidationError, errors.LocalTokenNotFoundError, OSError) as error:
        why = " ".join(str(error).split())[:MAX_MESSAGE_LENGTH]
        remedy = "check the name, and log in with: hf auth login"
        raise DatasetError(f"{repository}: the hub did not take the dataset: {why}; {remedy}") from None
    return str(address)


MAX_NAME_LENGTH = 80  # characters of an unknown id that are shown
SAMPLE_STRIDE = 7919  # a prime, so that samples do not correlate with the cycle of recipes and difficulties
WantedTexts = Mapping[str, Collection[str]]
"""The texts that a column may hold, by its name: ``{"recipe": ["pulley"], "asked.quantity": ["speed"]}``."""


class Dataset:
    """A finished dataset on disk: a sequence of items, which are read one file at a time.

    Every file is checked against its checksum before it is read; a damaged file raises a DatasetError that names it.
    ``sim2reason.open`` is this class.

    Args:
        path: The folder that `generate` has finished.

    Raises:
        DatasetError: The folder is not a finished dataset, or its manifest was changed.

    Attributes:
        path: The folder.
        manifest: Configuration, counts and checksums of the dataset.

    Examples:
        >>> import sim2reason
        >>> sim2reason.generate("problems", items=2, recipe="pulley", difficulty="easy", workers=1)
        <Dataset 'problems': 2 train>
        >>> data = sim2reason.open("problems")
        >>> len(data), data.splits()
        (2, ('train',))
        >>> data[0] == data.item(data[0].id)
        True
        >>> [problem.id for problem in data.items("train")]
        ['pulley-easy-numeric-0-0', 'pulley-easy-numeric-0-...']
    """

    def __init__(self, path: PathLike[str] | str) -> None:
        """Open the dataset in a folder; DatasetError if there is none, or its manifest was changed."""
        self.path = Path(path)
        self.manifest: Manifest = load_sealed(self.path)

    def __fspath__(self) -> str:
        """Return the folder, so that every function that takes a folder accepts a dataset, too."""
        return str(self.path)

    def __repr__(self) -> str:
        """Return the folder, and the number of items in each split."""
        splits = ", ".join(f"{count} {name}" for name, count in self.manifest.counts.get("split", {}).items())
        return f"<Dataset {str(self.path)!r}: {splits or 'empty'}>"

    def __str__(self) -> str:
        """Return the folder, the number of items, and a line with the counts by recipe, difficulty, mode and split."""
        lines = [f"Dataset {str(self.path)!r}: {format_count(len(self), 'item')}"]
        for column in ("split", "recipe", "difficulty", "mode"):
            counts = self.manifest.counts.get(column, {})
            lines.extend([f"  {column}: {', '.join(f'{name} {n}' for name, n in counts.items())}"] if counts else [])
        return "\n".join(lines)

    def __len__(self) -> int:
        """Return the number of items."""
        return self.manifest.rows

    def __iter__(self) -> Iterator[Item]:
        """Return an iterator over all items, shard by shard."""
        return self.items()

    @overload
    def __getitem__(self, key: int) -> Item: ...
    @overload
    def __getitem__(self, key: slice) -> list[Item]: ...
    @overload
    def __getitem__(self, key: str) -> ItemFiles: ...
    def __getitem__(self, key: int | slice | str) -> Item | list[Item] | ItemFiles:
        """Return the item at an index, a list of the items in a slice, or the sequence of items in a named split.

        Raises:
            IndexError: there is no such place.
            DatasetError: there is no such split; `item` takes an id.
            TypeError: any other key.
        """
        if isinstance(key, str):
            if key not in self.splits():
                available = ", ".join(self.splits())
                raise DatasetError(
                    f"{self.path}: has no split {quote_id(key)}; there is {available}; for an id: .item(ID)"
                )
            return ItemFiles(self.path, tuple(self._files((key,))), key)
        if isinstance(key, slice) or hasattr(key, "__index__"):
            return self._all[key]
        raise TypeError(f"{key!r} is no place, slice or split of a dataset")

    def to_pandas(self) -> Any:  # noqa: ANN401 - pandas is no package that the library needs
        """Return a pandas DataFrame with a row for each item and the columns of the dataset's files.

        Raises:
            MissingExtraError: pandas is not installed.
        """
        return self._all.to_pandas()

    def push_to_hub(
        self,
        repository: str,
        *,
        private: bool = False,
        token: str | None = None,
        message: str = "Upload problems of sim2reason",
    ) -> str:
        """Upload the folder with its card to the Hugging Face Hub, and return the address of the dataset there.

        Args:
            repository: the name of the dataset, as in ``user/problems``; it is created if it does not exist.
            private: whether a new repository is visible to its owner alone.
            token: the user's token; by default the one that ``hf auth login`` has stored.
            message: the commit message.

        Raises:
            DatasetError: a damaged dataset, or one that the hub does not take.
            MissingExtraError: huggingface_hub is not installed.
        """
        return push(self.path, repository, private=private, token=token, message=message)

    def items(self, split: str | None = None) -> Iterator[Item]:
        """Return an iterator over all items, or over those of a split, in the order of the files.

        Args:
            split: Name of the split; by default all.

        Returns:
            An iterator that keeps one file in memory.

        Raises:
            DatasetError: There is no such split.
        """
        if split is not None:
            self.splits(split)
        return (item for shard in shards(self.path) for item in shard_files.items(self.path, shard, split))

    def splits(self, names: Names = ALL_NAMES) -> tuple[str, ...]:
        """Return the names of the splits, or of some of them, in the order of the dataset.

        Args:
            names: One name, several, or ``all``.

        Returns:
            The names.

        Raises:
            DatasetError: There is no such split.
        """
        available = tuple(self.manifest.config.split)
        chosen = available if names == ALL_NAMES else several("split", names)
        for name in chosen:
            if name not in available:
                raise DatasetError(f"{self.path}: has no split {name!r}; there is {', '.join(available)}")
        return tuple(name for name in available if name in chosen)

    def item(self, name: str) -> Item:
        """Return the item with an id, for which a single file is read.

        Args:
            name: The id.

        Returns:
            The item.

        Raises:
            DatasetError: There is no such item.
        """
        number = self._shard_of(name) if isinstance(name, str) else None  # type: ignore[reportUnnecessaryIsInstance]
        for file in shard(self.path, number).files if number is not None else ():
            places = self._matching_positions(file, {"id": [name]})
            if places:
                return shard_files.read(self.path, file, places)[0]
        raise DatasetError(f"{self.path}: holds no problem {quote_id(name)}; see: sim2reason show {self.path}")

    def some(self, count: int, wanted: WantedTexts | None = None, split: Names = ALL_NAMES) -> Iterator[Item]:
        """Yield items spread over the dataset, or over those that match.

        Args:
            count: Greatest number of items.
            wanted: The texts that a column may have, by its name:
                ``{"recipe": ["pulley"], "asked.quantity": ["speed"]}``; by default all items match.
            split: Splits to take items from: one name, several, or ``all``.

        Yields:
            The items in the order of the dataset. Their distances are irregular, so that not all belong to one recipe.

        Raises:
            DatasetError: There is no such split.
        """
        wanted, splits = wanted or {}, self.splits(split)
        some = bool(wanted) or splits != self.splits()
        rows = sum(len(self._matching_positions(file, wanted)) for file in self._files(splits)) if some else len(self)
        wide = rows // max(count, 1)  # one is taken from each stretch of so many
        chosen = (n * rows // count + n * SAMPLE_STRIDE % wide for n in range(count)) if wide else iter(range(rows))
        position, behind = next(chosen, None), 0
        for file in self._files(splits):
            if position is None:
                return
            matches, taken = self._matching_positions(file, wanted), list[int]()
            while position is not None and position < behind + len(matches):
                taken.append(matches[position - behind])
                position = next(chosen, None)
            behind += len(matches)
            if taken:
                yield from shard_files.read(self.path, file, taken)

    def rows(self, *columns: str) -> Iterator[Row]:
        """Return an iterator over some columns of all items.

        Args:
            columns: Names of columns, such as ``recipe`` or, within another column, ``asked.quantity``.

        Returns:
            An iterator over mappings of plain values; a nested column is a mapping in a mapping.
        """
        return (row for file in self._files() for row in shard_files.rows(self.path, file, columns))

    def rows_of(self, names: Collection[str], *columns: str) -> dict[str, Row]:
        """Return some columns of the items with the given ids; each file is read once.

        Args:
            names: The ids; unknown ones are skipped.
            columns: Names of columns, as in `rows`.

        Returns:
            The rows by id. Each row also has ``split``, which is not a column of a file.
        """
        numbers = {self._shard_of(name) for name in names} - {None}
        last, rows_by_id = max((n for n in numbers if n is not None), default=-1), dict[str, Row]()
        for shard_record in islice(shards(self.path), last + 1):
            for file in shard_record.files if shard_record.number in numbers else ():
                places = self._matching_positions(file, {"id": names})
                rows = shard_files.rows(self.path, file, ("id", *columns), places) if places else ()
                rows_by_id.update({row["id"]: row | {"split": file.split} for row in rows})
        return rows_by_id

    def _files(self, splits: Collection[str] | None = None) -> Iterator[ShardFile]:
        return (f for shard in shards(self.path) for f in shard.files if splits is None or f.split in splits)

    @cached_property
    def _all(self) -> ItemFiles:
        return ItemFiles(self.path, tuple(self._files()))

    def _shard_of(self, name: str) -> int | None:
        """Return the number of the shard with the item of an id; None if the dataset cannot have it."""
        config = self.manifest.config
        try:
            position = config.position(config.named(name))
        except DrawError:
            return None
        return position // config.shard if position < self.manifest.positions else None

    def _matching_positions(self, file: ShardFile, wanted: WantedTexts) -> Sequence[int]:
        """Return the positions in a file of the items whose columns have the wanted texts."""
        if not wanted:
            return range(file.rows)
        rows = enumerate(shard_files.rows(self.path, file, tuple(wanted)))
        return [n for n, row in rows if all(_value(row, name) in texts for name, texts in wanted.items())]


def quote_id(name: object) -> str:
    """Return an id in quotes, shortened if very long; the repr of any other object."""
    text = str(name)
    return repr(name) if len(text) <= MAX_NAME_LENGTH else repr(f"{text[:MAX_NAME_LENGTH]}…")


def _value(row: Row, name: str) -> object:
    """Return the value of a column of a row; a dot separates nested names."""
    head, _, rest = name.partition(".")
    return _value(row[head], rest) if rest else row[head]


def verify(dataset: Dataset | Path | str) -> Findings:
    """Check the files of a dataset against its manifest.

    The check detects a changed byte in any file, missing and extra shards, a wrong number of rows, and combinations of
    mode, kind and recipe that were requested but have no item.

    Args:
        dataset: A dataset, or its folder.

    Returns:
        The numbers of rows and shards in the manifest, and a line for each fault.

    Raises:
        DatasetError: `dataset` is not a finished dataset.

    Examples:
        >>> import sim2reason
        >>> data = sim2reason.generate("problems", items=2, recipe="pulley", difficulty="easy", workers=1)
        >>> print(sim2reason.verify(data))
        2 rows in 1 shard: 0 faults
    """
    return check_folder(dataset.path if isinstance(dataset, Dataset) else Path(dataset))

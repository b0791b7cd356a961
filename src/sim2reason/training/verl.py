"""A verl dataset whose problems are generated on request; verl loads it in its own environment.

In verl's configuration: ``data.custom_cls.path=pkg://sim2reason.training.verl data.custom_cls.name=LazyDataset``.
"""

from importlib import import_module
from typing import Any

from sim2reason.errors import DatasetError
from sim2reason.training.lazy_rows import LazyRows

__all__ = ["LazyDataset"]

_verl: Any = import_module("verl.utils.dataset.rl_dataset")


class LazyDataset(_verl.RLHFDataset):
    """A verl dataset that generates problems for YAML files of `LazySettings`, and reads Parquet as verl does.

    Parquet files beside a YAML file are mixed in by its `share`. Without a YAML file this is verl's `RLHFDataset`, as
    for validation, since verl uses one class for both datasets.
    """

    data_files: list[str]
    dataframe: Any
    max_samples: int

    def _read_files_and_tokenize(self) -> None:
        """Set `dataframe`, the source of rows, when verl creates or resumes the dataset."""
        files = self.data_files
        described = [path for path in files if path.endswith((".yaml", ".yml"))]
        if len(described) > 1:
            raise DatasetError(f"{', '.join(described)}: more than one file of what to draw; give one")
        self.data_files = [path for path in files if path not in described]
        self.dataframe = ()
        if self.data_files:
            _verl.RLHFDataset._read_files_and_tokenize(self)  # noqa: SLF001 - the one step that is split in two
        self.data_files = files
        if described:
            self.dataframe = LazyRows(described[0], "verl", self.dataframe)

    def __len__(self) -> int:
        """Return the number of rows, limited by `data.train_max_samples`."""
        count = len(self.dataframe)
        return min(count, self.max_samples) if self.max_samples > 0 else count

    def __getstate__(self) -> dict[str, Any]:
        """Return the complete state, since verl's own omits the rows in processes that are not forked."""
        return dict(self.__dict__)

"""verl's dataset with problems that are drawn when it asks for them; verl loads it, in its own environment.

In verl's configuration: ``data.custom_cls.path=pkg://sim2reason.training.verl data.custom_cls.name=LazyDataset``.
"""

from importlib import import_module
from typing import Any

from sim2reason.errors import DatasetError
from sim2reason.training.lazy_rows import LazyRows

__all__ = ["LazyDataset"]

_verl: Any = import_module("verl.utils.dataset.rl_dataset")


class LazyDataset(_verl.RLHFDataset):
    """A YAML file of `LazySettings` among `data.train_files` is drawn from; Parquet files are read as verl reads them.

    Parquet files beside a YAML file are mixed in by its `share`. Without one this is verl's `RLHFDataset`, as for
    validation, since verl makes both datasets of one class.
    """

    data_files: list[str]
    dataframe: Any
    max_samples: int

    def _read_files_and_tokenize(self) -> None:
        """What verl calls when the dataset is made or resumed; `dataframe` is where its rows are taken from."""
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
        """As many as there are, or as `data.train_max_samples` allows."""
        count = len(self.dataframe)
        return min(count, self.max_samples) if self.max_samples > 0 else count

    def __getstate__(self) -> dict[str, Any]:
        """Return all of it, so that a process that is not forked has the rows too; verl's own leaves them out."""
        return dict(self.__dict__)

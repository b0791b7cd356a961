"""Find what is wrong with a dataset on disk."""

from pathlib import Path

from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.findings import Findings, found

__all__ = ["Findings", "verify"]


def verify(dataset: Dataset | Path | str) -> Findings:
    """Check a dataset against its manifest.

    Finds a flipped byte in any file of the dataset, a missing and an extra shard, a wrong count of rows, and a mode,
    kind and recipe that was asked for, but of which none was kept.
    DatasetError if `dataset` is no finished dataset at all.
    """
    return found(dataset.path if isinstance(dataset, Dataset) else Path(dataset))

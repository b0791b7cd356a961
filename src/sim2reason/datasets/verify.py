"""Verification of a dataset on disk."""

from pathlib import Path

from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.findings import Findings, found

__all__ = ["Findings", "verify"]


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
    return found(dataset.path if isinstance(dataset, Dataset) else Path(dataset))

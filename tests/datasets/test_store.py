"""Tests of the reading of item files."""

from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from threading import get_ident
from typing import Any
from unittest.mock import Mock

import pytest

from fake_makers import steady
from sim2reason.datasets import store
from sim2reason.evaluation.benchmarks import files
from sim2reason.generation.request import Request


class Watched(BytesIO):
    """File that records the threads that read it."""

    threads: set[int]

    def read(self, size: int | None = -1, /) -> bytes:
        """Record the current thread, and return the bytes."""
        self.threads.add(get_ident())
        return super().read(size)


@pytest.fixture
def content(tmp_path: Path) -> bytes:
    items = [item for index in range(5) if (item := steady(Request("pulley", "easy", "numeric", 0, index)).item)]
    store.write(tmp_path / "items.parquet", items)
    return (tmp_path / "items.parquet").read_bytes()


@pytest.mark.parametrize("read", [store.read, lambda path: list(store.rows(path, ["id", "prompt"]))])
def test_no_thread_of_a_library_holds_a_file_when_python_ends(
    content: bytes, monkeypatch: pytest.MonkeyPatch, read: Callable[[Path], Any]
) -> None:
    """Arrow's threads release the file only after the read, which crashes an interpreter that is shutting down."""
    file = Watched(content)
    file.threads = set()
    monkeypatch.setattr(Path, "open", Mock(return_value=file))
    assert len(read(Path("items.parquet"))) == 5
    assert file.threads == {get_ident()}


def test_nor_does_one_hold_a_benchmark_s(content: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = Watched(content)
    file.threads = set()
    monkeypatch.setattr(files, "BytesIO", Mock(return_value=file))
    (tmp_path / "rows.parquet").write_bytes(content)
    assert len(files.rows(tmp_path / "rows.parquet")) == 5
    assert file.threads == {get_ident()}

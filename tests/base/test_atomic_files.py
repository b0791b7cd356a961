"""Tests of atomic files, written whole or not at all, and of the locks of folders in which something is made."""

from pathlib import Path

import pytest

from sim2reason.base.atomic_files import lock_work_folder, put_text
from sim2reason.errors import DatasetError


def test_what_can_not_be_written_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(UnicodeEncodeError):
        put_text(tmp_path / "file", "half of a pair: \udcff", tmp_path)
    assert not list(tmp_path.iterdir())


def test_a_folder_that_stays_empty_goes_again(tmp_path: Path) -> None:
    (tmp_path / "old").mkdir()
    for place in (tmp_path / "a/b/c", tmp_path / "old"):
        with pytest.raises(KeyError), lock_work_folder(place):
            raise KeyError
    assert [path.name for path in tmp_path.iterdir()] == ["old"]


def test_what_is_made_in_it_stays_and_one_works_there_at_a_time(tmp_path: Path) -> None:
    with lock_work_folder(tmp_path / "a/b"):
        (tmp_path / "a/b/file").touch()
        with pytest.raises(DatasetError, match="another run is writing here"), lock_work_folder(tmp_path / "a/b"):
            pass
    assert (tmp_path / "a/b/file").is_file()

"""Tests of the names of places, and of the errors, before any folder is made, where no worker is available."""

import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from sim2reason.datasets.build import build
from sim2reason.datasets.places import PLACES
from sim2reason.datasets.plan import Config
from sim2reason.errors import DatasetError, MissingExtraError, Sim2ReasonError, UnknownNameError

CONFIG = Config(items=1, recipes=("pulley",), maker="fake_makers:steady")


def refusal(out: Path, on: str) -> Sim2ReasonError:
    with pytest.raises(Sim2ReasonError) as found:
        build(out, CONFIG, on=on)
    assert not out.exists()
    assert "\n" not in str(found.value)
    return found.value


def test_there_is_here_and_ray() -> None:
    assert list(PLACES) == ["here", "ray"]


def test_an_unknown_place_and_an_address_that_is_none(tmp_path: Path) -> None:
    error = refusal(tmp_path / "out", "moon://1")
    assert isinstance(error, UnknownNameError)
    assert str(error).endswith("there are: here, ray")
    assert "needs no address" in str(refusal(tmp_path / "out", "here://host:1"))


def test_without_ray_it_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ray", None)
    error = refusal(tmp_path / "out", "ray")
    assert isinstance(error, MissingExtraError)
    assert str(error) == (
        "ray is not installed; install it with: pip install 'ray[client]>=2.40', or in a clone: pip install '.[ray]'"
    )


@pytest.mark.parametrize("address", ["127.0.0.1:1", "nowhere", "host:port", "127.0.0.1:99999"])
def test_where_nobody_answers(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, address: str) -> None:
    monkeypatch.setitem(sys.modules, "ray", SimpleNamespace())
    error = refusal(tmp_path / "out", f"ray://{address}")
    assert isinstance(error, DatasetError)
    assert str(error).startswith(f"--on ray://{address}: no cluster answers (")
    assert str(error).endswith("and say --on ray://HOST:PORT")

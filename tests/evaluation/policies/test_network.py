"""Tests of the check that the hub can be reached, without requests to it."""

import time
from collections.abc import Callable
from pathlib import Path

import pytest

from sim2reason.evaluation.policies.network import loading_arguments, out_of_reach

hub = pytest.importorskip("huggingface_hub")


def told(error: Exception | None) -> Callable[..., None]:
    def repo_info(*_: object, **__: object) -> None:
        if error is not None:
            raise error

    return repo_info


@pytest.fixture
def unreachable(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("huggingface_hub.HfApi.repo_info", told(ConnectionError("no such host")))


@pytest.mark.usefixtures("unreachable")
def test_a_hub_out_of_reach_is_said_at_once() -> None:
    begun = time.monotonic()
    with pytest.raises(FileNotFoundError, match="no such folder, and the hub cannot be reached"):
        loading_arguments("nobody/nothing")
    assert time.monotonic() - begun < 5.0


@pytest.mark.usefixtures("unreachable")
def test_what_is_kept_here_and_a_folder_need_no_hub(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert loading_arguments(str(tmp_path), "v1") == {"revision": "v1"}
    monkeypatch.setattr("huggingface_hub.try_to_load_from_cache", lambda *_, **__: str(tmp_path))
    assert loading_arguments("somebody/something") == {"revision": None, "local_files_only": True}


def test_what_the_hub_answers_is_left_to_the_library(monkeypatch: pytest.MonkeyPatch) -> None:
    from httpx2 import Request, Response
    from huggingface_hub.errors import RepositoryNotFoundError

    monkeypatch.setattr("huggingface_hub.HfApi.repo_info", told(None))
    assert not out_of_reach("somebody/something", "dataset")
    refused = RepositoryNotFoundError("no", response=Response(404, request=Request("GET", "https://a")))
    monkeypatch.setattr("huggingface_hub.HfApi.repo_info", told(refused))
    assert loading_arguments("somebody/something") == {"revision": None}


def test_a_path_of_no_folder_is_no_name() -> None:
    with pytest.raises(ValueError, match="no such folder, and no name that the hub could have"):
        loading_arguments("a/b/c")

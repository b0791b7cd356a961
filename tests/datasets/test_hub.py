"""Tests of uploads to the Hugging Face hub, by its own library to a local server."""

import base64
import json
import shutil
import sys
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any

import pytest

from sim2reason.datasets.dataset import Dataset
from sim2reason.errors import DatasetError, MissingExtraError

pytest.importorskip("huggingface_hub")
TOKEN = "hf_secret"


class FakeHub(ThreadingHTTPServer):
    """Hub that keeps what a client with the token commits."""

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), _Asked)
        self.made: list[dict[str, Any]] = []
        self.files: dict[str, bytes] = {}
        self.message = ""

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.server_port}"


class _Asked(BaseHTTPRequestHandler):
    server: FakeHub

    def log_message(self, *_: object) -> None:
        """Suppress the log."""

    def do_GET(self) -> None:
        self._tell({"sha": "0" * 40, "id": "user/problems", "siblings": []})

    def do_POST(self) -> None:
        body = self.rfile.read(int(self.headers["Content-Length"] or 0))
        if self.headers.get("Authorization") != f"Bearer {TOKEN}":
            self._tell({"error": "Invalid username or password."}, 401)
        elif self.path == "/api/repos/create":
            self.server.made.append(json.loads(body))
            self._tell({"url": f"{self.server.address}/datasets/user/problems"})
        elif self.path == "/api/validate-yaml":
            self._tell({"errors": [], "warnings": []})
        elif "/preupload/" in self.path:
            named = [file["path"] for file in json.loads(body)["files"]]
            told = {"uploadMode": "regular", "shouldIgnore": False, "oid": None}
            self._tell({"files": [{"path": path, **told} for path in named]})
        elif "/commit/" in self.path:
            self._commit(body)
        else:
            self._tell({}, 404)

    def _commit(self, body: bytes) -> None:
        for line in map(json.loads, body.splitlines()):
            if line["key"] == "header":
                self.server.message = line["value"]["summary"]
            elif line["key"] == "file":
                self.server.files[line["value"]["path"]] = base64.b64decode(line["value"]["content"])
        address = f"{self.server.address}/datasets/user/problems/commit/{'1' * 40}"
        self._tell({"success": True, "commitUrl": address, "commitOid": "1" * 40, "hookOutput": ""})

    def _tell(self, answer: object, status: int = 200) -> None:
        content = json.dumps(answer).encode()
        self.send_response(status)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)


@pytest.fixture
def hub(monkeypatch: pytest.MonkeyPatch) -> Iterator[FakeHub]:
    import huggingface_hub.hf_api

    server = FakeHub()
    thread = Thread(target=server.serve_forever, daemon=True)
    thread.start()
    monkeypatch.setattr("huggingface_hub.constants.ENDPOINT", server.address)
    monkeypatch.setattr(huggingface_hub.hf_api.constants, "ENDPOINT", server.address)
    monkeypatch.setenv("HF_ENDPOINT", server.address)
    monkeypatch.setattr("huggingface_hub.constants.HF_HUB_OFFLINE", False)
    yield server
    server.shutdown()
    thread.join()
    server.server_close()


def test_the_folder_stands_there_as_it_is(data: Path, hub: FakeHub, tmp_path: Path) -> None:
    (data / ".DS_Store").touch()
    address = Dataset(data).push_to_hub("user/problems", private=True, token=TOKEN, message="First")
    assert address == f"{hub.address}/datasets/user/problems"
    assert hub.message == "First"
    made = {"type": "dataset", "name": "problems", "organization": "user", "visibility": "private"}
    assert made.items() <= hub.made[0].items()
    wanted = {str(path.relative_to(data)): path.read_bytes() for path in data.rglob("*") if path.is_file()}
    del wanted[".DS_Store"]
    assert hub.files == wanted
    for name, content in hub.files.items():
        (tmp_path / "down" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "down" / name).write_bytes(content)
    assert list(Dataset(tmp_path / "down")) == list(Dataset(data))


def test_what_the_hub_refuses_is_one_line_without_the_token(data: Path, hub: FakeHub) -> None:
    with pytest.raises(DatasetError, match=r"the hub did not take the dataset: .*log in with: hf auth login") as error:
        Dataset(data).push_to_hub("user/problems", token="hf_wrong")
    assert "\n" not in str(error.value)
    assert "hf_wrong" not in str(error.value)
    with pytest.raises(DatasetError, match=r"^not a name: the hub did not take the dataset"):
        Dataset(data).push_to_hub("not a name", token=TOKEN)
    assert not hub.files


def test_a_damaged_dataset_is_not_uploaded(data: Path, hub: FakeHub) -> None:
    dataset = Dataset(data)
    shutil.copy(data / "README.md", next(data.glob("data/*.parquet")))
    with pytest.raises(DatasetError, match=r"parquet: damaged.*; a damaged dataset is not uploaded: see"):
        dataset.push_to_hub("user/problems", token=TOKEN)
    assert not hub.made


def test_without_its_library_that_is_told(data: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "huggingface_hub", None)
    with pytest.raises(MissingExtraError, match="huggingface_hub is not installed; install it with: pip install"):
        Dataset(data).push_to_hub("user/problems")

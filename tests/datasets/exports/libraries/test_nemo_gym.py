"""Tests that NeMo Gym accepts the configuration and all rows, and that its server verifies replies over HTTP."""

import json
import runpy
from collections.abc import Callable, Iterator
from pathlib import Path
from unittest.mock import MagicMock

import pytest

from sim2reason.generation.item import Item

nemo_gym = pytest.importorskip("nemo_gym", reason="make test-exports")


def responded(text: str) -> dict[str, object]:
    """Return a model's response in the format of the Responses API."""
    content = {"type": "output_text", "text": text, "annotations": []}
    message = {"id": "m", "type": "message", "role": "assistant", "status": "completed", "content": [content]}
    whole = {"id": "r", "object": "response", "created_at": 0.0, "model": "told", "output": [message]}
    return {**whole, "parallel_tool_calls": True, "tool_choice": "auto", "tools": []}


def test_the_server_verifies_every_row(
    exported: Callable[[str], Path],
    items: dict[str, Item],
    right: Callable[[Item], str],
    wrong: Callable[[Item], Iterator[str]],
) -> None:
    from fastapi.testclient import TestClient
    from nemo_gym.base_resources_server import BaseResourcesServerConfig
    from nemo_gym.openai_utils import NeMoGymResponseCreateParamsNonStreaming
    from nemo_gym.server_utils import ServerClient

    server = exported("nemo-gym") / "resources_servers/sim2reason"
    cls = runpy.run_path(str(server / "app.py"))["Sim2ReasonResourcesServer"]
    config = BaseResourcesServerConfig(host="localhost", port=1, entrypoint="app.py", name="sim2reason", domain="math")
    app = cls(config=config, server_client=MagicMock(spec=ServerClient)).setup_webserver()
    seen = set()
    with TestClient(app) as client:

        def reward(row: dict[str, object], text: str) -> float:
            answer = client.post("/verify", json={**row, "response": responded(text)})
            assert answer.status_code == 200, answer.text
            return answer.json()["reward"]

        for path in sorted((server / "data").glob("*.jsonl")):
            for row in map(json.loads, path.read_text().splitlines()):
                item = items[row["id"]]
                seen.add(item.id)
                params = NeMoGymResponseCreateParamsNonStreaming.model_validate(row["responses_create_params"])
                assert params.input[0].content == item.prompt
                assert reward(row, right(item)) == 1.0
                assert [reward(row, said) for said in wrong(item)] == [0.0] * len(item.distractors)
    assert seen == set(items)


def test_the_configuration_is_valid_and_rows_pass_its_own_checks(
    exported: Callable[[str], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    from nemo_gym.train_data_utils import TrainDataProcessor
    from omegaconf import OmegaConf

    folder = exported("nemo-gym")
    monkeypatch.chdir(folder)
    config = OmegaConf.load("resources_servers/sim2reason/configs/sim2reason.yaml")
    TrainDataProcessor().run(
        OmegaConf.merge(config, {"output_dirpath": str(folder / "out"), "mode": "train_preparation"})
    )
    prepared = (folder / "out/train.jsonl").read_text().splitlines()
    rows = (folder / "resources_servers/sim2reason/data/train.jsonl").read_text().splitlines()
    assert [json.loads(line)["id"] for line in prepared] == [json.loads(line)["id"] for line in rows]
    assert all(json.loads(line)["agent_ref"]["name"] == "sim2reason_simple_agent" for line in prepared)


def test_the_page_is_true(follow: Callable[[str], None]) -> None:
    follow("nemo-gym")

"""Tests that libraries needed by a run are looked up before anything else is done."""

from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

import short_run
from sim2reason.errors import MissingExtraError
from sim2reason.training.rl.run import train_rl
from sim2reason.training.sft.run import train_sft
from sim2reason.training.study.run import train_study

CHOSEN = {
    "vllm": {"vllm": {}},
    "wandb": {"report_to": ["wandb"]},
    "tensorboard": {"report_to": ["tensorboard"]},
    "peft": {"lora": {}},
}


def without(missing: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulate an environment with all libraries but one."""
    spec = find_spec("json")
    monkeypatch.setattr("sim2reason.training.extras.find_spec", lambda name: None if name == missing else spec)


def settings(out: Path, chosen: dict[str, Any]) -> dict[str, Any]:
    found = short_run.settings(out)
    return found | {"gspo": found["gspo"] | chosen}


@pytest.mark.parametrize("missing", CHOSEN)
def test_what_the_settings_need_is_looked_for_first(
    missing: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    without(missing, monkeypatch)
    message = rf"{missing} is not installed; install it with: pip install .*{missing}"
    given = settings(tmp_path / "run", CHOSEN[missing])
    with pytest.raises(MissingExtraError, match=message):
        train_rl(given)
    with pytest.raises(MissingExtraError, match=message):
        train_study({"out": str(tmp_path / "study"), "base": given, "arms": {"ours": {}}})
    assert not list(tmp_path.iterdir())


def test_fine_tuning_looks_for_tensorboard(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    without("tensorboard", monkeypatch)
    given = short_run.settings(tmp_path)["warm_start"] | {"out": str(tmp_path / "run"), "tensorboard": True}
    with pytest.raises(MissingExtraError, match="tensorboard is not installed"):
        train_sft(given)

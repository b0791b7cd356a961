"""Tests of rollouts by vLLM in the training process on CPUs, run by ``make test-vllm``."""

from collections.abc import Generator
from importlib.util import find_spec
from pathlib import Path

import pytest

from gspo_run import Numbers, Thing, tiny_model, trainer
from gspo_told import check_groups
from sim2reason.training.gspo.settings import VllmSettings

pytest.importorskip("trl")
pytestmark = [
    pytest.mark.skipif(find_spec("vllm") is None, reason="vLLM is not installed; make test-vllm runs these"),
    pytest.mark.filterwarnings("ignore"),
]


@pytest.fixture(scope="module")
def model(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a tiny model whose attention head is as wide as vLLM's kernels for CPUs need."""
    return tiny_model(tmp_path_factory.mktemp("vllm") / "model", heads=1)


@pytest.fixture(autouse=True)
def _on_cpus(monkeypatch: pytest.MonkeyPatch) -> Generator[None]:
    monkeypatch.setenv("VLLM_ENABLE_V1_MULTIPROCESSING", "0")
    monkeypatch.setenv("VLLM_CPU_KVCACHE_SPACE", "1")  # GiB
    yield
    import torch

    if torch.distributed.is_initialized():  # by vLLM, for one process
        torch.distributed.destroy_process_group()


def test_what_vllm_samples_has_the_probabilities_of_the_model_that_is_trained(model: Path, tmp_path: Path) -> None:
    """vLLM has the weights of the last update, since the model has moved much further from its initial ones."""
    given = {"max_prompt_tokens": 32, "max_completion_tokens": 6, "steps": 4, "learning_rate": 1e-3}
    found = trainer(model, tmp_path, Numbers(), ["parity"], vllm=VllmSettings(), **given)
    held, told = list[Thing](), found._batch
    found._batch = lambda filled: held.append(told(filled)) or held[-1]
    found.train()
    assert [record.groups for record in found.step_log.read()] == [4] * 4
    check_groups(tmp_path, 4, 4, 1)
    apart = [largest(batch, "sampling_per_token_logps") for batch in held]
    moved = [largest(batch, "ref_per_token_logps") for batch in held]
    assert max(apart) < 0.05
    assert max(moved[1:]) > 0.5


def largest(batch: Thing, other: str) -> float:
    """Return the largest difference between log-probabilities by the trained model and by another."""
    return ((batch["old_per_token_logps"] - batch[other]) * batch["completion_mask"]).abs().max().item()

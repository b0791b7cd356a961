"""Fixtures for GSPO: a tiny model, and runs in this process and in others."""

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from gspo_run import Thing, tiny_model

ROOT = Path(__file__).parents[3]
SCRIPT = ROOT / "tests/support/gspo_run.py"


@pytest.fixture(scope="session")
def model(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a Qwen2 of two layers with random weights."""
    return tiny_model(tmp_path_factory.mktemp("gspo") / "model")


@pytest.fixture
def launch(model: Path, tmp_path: Path) -> Callable[..., subprocess.Popen[str]]:
    """Return a function that starts a run in separate processes on CPUs."""

    def start(name: str, processes: int = 1, **given: Thing) -> subprocess.Popen[str]:
        folder = tmp_path / name
        folder.mkdir(exist_ok=True)
        given["model"] = str(model)
        alone = [sys.executable, str(SCRIPT)]
        several = ["-m", "torch.distributed.run", "--standalone", "--nproc-per-node", str(processes), str(SCRIPT)]
        command = [*(alone if processes == 1 else [sys.executable, *several]), str(folder), json.dumps(given)]
        path = os.pathsep.join([str(ROOT / "src"), os.environ.get("PYTHONPATH", "")])
        environment = os.environ | {"OMP_NUM_THREADS": "1", "CUDA_VISIBLE_DEVICES": "", "PYTHONPATH": path}
        return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    return start


@pytest.fixture
def run(launch: Callable[..., subprocess.Popen[str]]) -> Callable[..., str]:
    """Return a function that runs to the end and returns the output."""

    def finish(name: str, processes: int = 1, **given: Thing) -> str:
        with launch(name, processes, **given) as process:
            try:
                said = process.communicate(timeout=240)[0]
            finally:
                process.kill()
        assert process.returncode == 0, said[-4000:]
        return said

    return finish

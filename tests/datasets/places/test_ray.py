"""Tests on a local Ray cluster of two one-core machines: after any crash the bytes are those of one process."""

import os
import signal
import socket
import subprocess
import sys
import uuid
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sim2reason.datasets.build import build
from sim2reason.datasets.manifest import Manifest, read_refusals
from sim2reason.datasets.plan import Config
from sim2reason.errors import DatasetError
from sim2reason.generation.request import versions

pytest.importorskip("ray", reason="Ray is not installed; make test-ray runs these tests in an environment that has it")
SUPPORT = Path(__file__).parents[2] / "support"
pytestmark = [  # Ray leaves its log files open
    pytest.mark.filterwarnings("ignore::ResourceWarning"),
    pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning"),
]
CONFIG = Config(items=300, recipes=("incline", "pulley"), difficulties=("easy",), shard=20, maker="fake_makers:slow")
PARTS = 4
Contents = Callable[[Path], dict[str, bytes]]


@pytest.fixture(scope="module")
def cluster() -> Iterator[tuple[str, str]]:
    """Yield the address for ``--on``, and a mark in the environment of all processes of the cluster."""
    from ray.cluster_utils import Cluster

    with pytest.MonkeyPatch.context() as patch, socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port, mark = probe.getsockname()[1], uuid.uuid4().hex
        probe.close()
        patch.setenv("MARK", mark)
        patch.setenv("RAY_USAGE_STATS_ENABLED", "0")
        patch.setenv("PYTHONPATH", os.pathsep.join((str(SUPPORT), os.environ.get("PYTHONPATH", ""))))
        started = Cluster(
            initialize_head=True,
            head_node_args={"num_cpus": 1, "include_dashboard": False, "ray_client_server_port": port},
        )
        started.add_node(num_cpus=1)
        patch.setenv("RAY_ADDRESS", started.address)
        yield f"ray://127.0.0.1:{port}", mark
        started.shutdown()


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("whole") / "data"
    build(out, CONFIG, workers=1)
    return out


def working(mark: str) -> list[int]:
    """Return the ids of the cluster's processes that are making items now."""
    found: list[int] = []
    for path in Path("/proc").glob("[0-9]*"):
        try:
            if (path / "cmdline").read_bytes().startswith(b"ray::attempts"):
                found += [int(path.name)] * (f"MARK={mark}".encode() in (path / "environ").read_bytes())
        except OSError:  # gone, or not ours
            continue
    return found


@pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="looks processes up in /proc")
def test_a_killed_worker_changes_nothing(
    tmp_path: Path, cluster: tuple[str, str], whole: Path, contents: Contents
) -> None:
    _, mark = cluster
    killed: list[int] = []

    def advance(_: int) -> None:
        for pid in working(mark)[: 2 - len(killed)]:
            os.kill(pid, signal.SIGKILL)
            killed.append(pid)

    build(tmp_path / "data", CONFIG, on="ray", advance=advance)
    assert len(killed) == 2
    assert contents(tmp_path / "data") == contents(whole)


def test_a_cluster_is_joined_by_its_address(
    tmp_path: Path, cluster: tuple[str, str], whole: Path, contents: Contents
) -> None:
    address, _ = cluster
    build(tmp_path / "data", CONFIG, workers=2, on=address)
    assert contents(tmp_path / "data") == contents(whole)


def test_four_parts_at_once(tmp_path: Path, cluster: tuple[str, str], whole: Path, contents: Contents) -> None:
    del cluster
    out = tmp_path / "data"
    options = ["--items", "300", "--recipe", "incline,pulley", "--difficulty", "easy", "--shard-size", "20"]
    code = "from sim2reason.cli import main; main()"
    command = [sys.executable, "-c", code, "generate", str(out), *options, "--maker", CONFIG.maker]
    runs = [
        subprocess.Popen([*command, "--on", "ray", "--shard", f"{k + 1}/{PARTS}"], stderr=subprocess.PIPE)
        for k in range(PARTS)
    ]
    told = [run.communicate(timeout=120)[1].decode() for run in runs]
    assert [run.returncode for run in runs] == [0] * PARTS, told
    build(out, CONFIG, workers=1)
    assert contents(out) == contents(whole)


def test_what_always_crashes_is_found_and_the_rest_kept(tmp_path: Path, cluster: tuple[str, str]) -> None:
    del cluster
    config = CONFIG.model_copy(update={"items": 40, "maker": "fake_makers:crashing"})
    manifest: Manifest = build(tmp_path / "data", config, on="ray")
    found = [problem.reason for problem in read_refusals(tmp_path / "data", "quarantined")]
    assert found == ["crashed its worker, twice"]
    assert manifest.rows == 38


def test_a_maker_that_is_not_there(tmp_path: Path, cluster: tuple[str, str]) -> None:
    del cluster
    with pytest.raises(DatasetError, match="no maker of items can be imported"):
        build(tmp_path / "data", CONFIG.model_copy(update={"maker": "fake_makers:none"}), on="ray")


def test_machines_of_a_cluster_need_the_same_packages(
    tmp_path: Path, cluster: tuple[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    del cluster
    other = versions() | {"numpy": "1.0"}
    monkeypatch.setattr("sim2reason.datasets.places.ray.versions", lambda: other)
    with pytest.raises(DatasetError, match=r"numpy \S+ ≠ 1\.0; all machines of a cluster need the same"):
        build(tmp_path / "data", CONFIG, on="ray")

"""Tests that verifiers finds the installed taskset by its id, makes its tasks, and scores traces of replies."""

import asyncio
import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sim2reason.generation.item import Item
from sim2reason.rewards import boxed

vf = pytest.importorskip("verifiers.v1", reason="make test-exports")


def reward(task: object, reply: str) -> float:
    """Return a task's reward for a model's reply."""
    trace = vf.Trace(
        task=vf.TraceTask(type=type(task).__name__, data=task.data, key=task.key),
        agent=vf.AgentInfo(config=vf.AgentConfig()),
    )
    trace.root_reply = reply
    asyncio.run(task.score(trace))
    assert trace.rewards.keys() == {"accuracy"}
    return trace.reward


def test_tasks_are_loaded_and_scored(
    exported: Callable[[str], Path],
    items: dict[str, Item],
    right: Callable[[Item], str],
    wrong: Callable[[Item], Iterator[str]],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from verifiers.v1.utils.loaders import load_taskset, taskset_config_type

    monkeypatch.syspath_prepend(exported("verifiers"))
    seen = set()
    for split in ("train", "test"):
        config = taskset_config_type("sim2reason-problems")(id="sim2reason-problems", split=split)
        for number, task in enumerate(load_taskset(config)):
            item = items[task.data.id]
            seen.add(task.key)
            assert task.data.idx == number
            assert task.data.prompt_text == item.prompt
            assert reward(task, right(item)) == 1.0
            assert [reward(task, said) for said in wrong(item)] == [0.0] * len(item.distractors)
    assert seen == set(items)
    shuffled = load_taskset(config).shuffle(seed=1).take(5)
    assert len({task.key for task in shuffled}) == 5


def test_fresh_tasks_are_drawn_without_end(exported: Callable[[str], Path], monkeypatch: pytest.MonkeyPatch) -> None:
    from verifiers.v1.utils.loaders import load_taskset, taskset_config_type

    monkeypatch.syspath_prepend(exported("verifiers"))
    easy = {"recipe": "pulley", "difficulty": "easy"}
    config = taskset_config_type("sim2reason-problems")(id="sim2reason-problems", fresh=True, seed=1, **easy)
    taskset = load_taskset(config)
    assert not taskset.bounded
    tasks = list(taskset.take(5))
    assert [reward(task, boxed(task.data.answer)) for task in tasks] == [1.0] * 5
    assert [reward(task, boxed("1e9")) for task in tasks] == [0.0] * 5
    assert [task.key for task in taskset.take(5)] == [task.key for task in tasks]
    assert len({task.key for task in tasks}) == 5
    with pytest.raises(ValueError, match="is infinite"):
        taskset.shuffle(seed=1)


def test_its_own_validation_passes(exported: Callable[[str], Path], tmp_path: Path) -> None:
    """In verifiers' own validation right answers pass and untouched tasks fail."""
    command = ["vf-validate", "sim2reason-problems", "--runtime.type", "subprocess", "--rich", "False"]
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    environ = {**os.environ, "PATH": path, "PYTHONPATH": str(exported("verifiers"))}
    done = subprocess.run(command, cwd=tmp_path, env=environ, capture_output=True, text=True, check=False, timeout=900)
    assert done.returncode == 0, done.stdout + done.stderr
    (found,) = tmp_path.rglob("summary.json")
    summary = json.loads(found.read_text())
    for check in ("gold", "noop"):
        assert summary["checks"][check]["valid"] == summary["total"] > 0


def test_the_page_is_true(follow: Callable[[str], None]) -> None:
    follow("verifiers")

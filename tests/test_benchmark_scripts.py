"""Tests that benchmark scripts which take numbers describe them."""

import subprocess
import sys
from pathlib import Path

import pytest

FOLDER = Path(__file__).parent.parent / "benchmarks"


@pytest.mark.parametrize("name", ["chaos", "scale", "splits"])
def test_help_is_text_and_no_traceback(name: str) -> None:
    run = subprocess.run([sys.executable, FOLDER / f"{name}.py", "--help"], check=False, capture_output=True, text=True)
    assert (run.returncode, run.stderr) == (0, "")
    assert "how many" in run.stdout or "default: 5" in run.stdout

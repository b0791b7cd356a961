"""Tests of installed packages whose entry points cannot be imported."""

import subprocess
import sys
from pathlib import Path

import pytest

from sim2reason.base.registry import Registry
from sim2reason.errors import EntryPointError


def install(folder: Path, kind: str, module: str) -> None:
    """Write a distribution `broken-kit` that declares an entry point, as an installer leaves it."""
    (folder / "broken_kit.py").write_text(module, encoding="utf-8")
    info = folder / "broken_kit-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: broken-kit\nVersion: 1.0\n", encoding="utf-8")
    (info / "entry_points.txt").write_text(f"[sim2reason.{kind}]\nown = broken_kit\n", encoding="utf-8")


def test_the_error_names_entry_point_package_cause_and_remedy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    install(tmp_path, "testing.broken", "import no_such_module\n")
    monkeypatch.syspath_prepend(tmp_path)
    registry: Registry[object] = Registry("testing.broken", package="sim2reason.base")
    for _ in range(2):  # the second use reports it too, instead of working without the package's members
        with pytest.raises(EntryPointError) as refused:
            _ = registry["anything"]
        assert str(refused.value) == (
            "the entry point 'own' (broken_kit) in the group sim2reason.testing.broken cannot be imported: "
            "ModuleNotFoundError: No module named 'no_such_module'; "
            "fix the package broken-kit that declares it, or uninstall it: pip uninstall broken-kit"
        )


@pytest.mark.parametrize("arguments", [("list", "entities"), ("describe", "examples/scenes/block_and_load.yaml")])
def test_commands_report_it_in_one_line(tmp_path: Path, arguments: tuple[str, ...]) -> None:
    install(tmp_path, "entities", "raise RuntimeError('out of\\norder')\n")
    start = f"import sys; sys.path.append({str(tmp_path)!r}); from sim2reason.cli import main; main()"
    root = Path(__file__).parents[2]
    done = subprocess.run(
        [sys.executable, "-c", start, *arguments], cwd=root, capture_output=True, text=True, check=False, timeout=60
    )
    assert done.returncode == 2, done.stderr
    assert done.stderr.startswith("sim2reason: the entry point 'own' (broken_kit) in the group sim2reason.entities ")
    assert "RuntimeError: out of order; fix the package broken-kit" in done.stderr
    assert done.stderr.count("\n") == 1

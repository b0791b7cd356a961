"""Tests that every export has a page with its own command, and that the index lists all of them."""

import re
from pathlib import Path

import pytest

from sim2reason.datasets.exports import EXPORTS

PAGES = Path(__file__).parents[3] / "docs/integrations"
REQUIREMENTS = Path(__file__).parent / "requirements"


@pytest.mark.parametrize("name", list(EXPORTS))
def test_each_export_has_its_page(name: str) -> None:
    assert f"$ sim2reason export problems --to {name} --out problems-{name}\n" in (PAGES / f"{name}.md").read_text()
    assert f"| `{name}` |" in (PAGES / "README.md").read_text()


def test_the_example_of_a_further_export_works(tmp_path: Path, problems: Path) -> None:
    """The example runs in a separate process, since it registers an export."""
    import subprocess
    import sys

    blocks = re.findall(r"```python\n(.*?)```", (PAGES / "README.md").read_text(), re.DOTALL)
    (block,) = [block for block in blocks if "@target" in block]
    try_it = f"import sim2reason\nsim2reason.export({str(problems)!r}, 'out', to='plain')\n"
    (tmp_path / "plain.py").write_text(f"{block}\n{try_it}")
    done = subprocess.run(
        [sys.executable, "-W", "error", "plain.py"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert len((tmp_path / "out/data/train.jsonl").read_text().splitlines()) > 20


def test_each_library_is_locked() -> None:
    tests = {path.stem.removeprefix("test_") for path in (REQUIREMENTS.parent / "libraries").glob("test_*.py")}
    assert tests == {path.stem for path in REQUIREMENTS.glob("*.txt")}
    for path in REQUIREMENTS.glob("*.txt"):
        lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
        assert all(re.fullmatch(r"[A-Za-z0-9_.-]+==[A-Za-z0-9.!]+", line) for line in lines)


ROOT = PAGES.parents[1]
FOLDERS = "src", "docs", "examples", "experiments", "benchmarks"
SHOWN = *FOLDERS, "README.md", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md", "llms.txt"
INDEX = re.compile(r"(?:pip3? install|uv add|uv pip install)[^\n`]*?(?<![/\w.-])sim2reason(?![/\w-])")
NAMED = re.compile(r"^sim2reason\b|^dependencies = .*[\"']sim2reason\b(?!-)", re.MULTILINE)
"""A requirement that pip would look up by the name."""


def test_nothing_tells_users_to_install_a_package_of_our_name_from_an_index() -> None:
    """There is no such package, and anyone who registers the name could run code on the users' machines."""
    texts = [
        path for place in SHOWN for path in ([ROOT / place] if (ROOT / place).is_file() else (ROOT / place).rglob("*"))
    ]
    told = [path for path in texts if path.suffix in {".md", ".py", ".toml", ".txt", ".yaml", ".sh", ".ipynb"}]
    assert len(told) > 500
    assert not [str(path) for path in told if INDEX.search(path.read_text(encoding="utf-8"))]
    required = [path for path in told if path.name in {"pyproject.toml", "requirements.txt"}]
    assert len(required) == 2
    assert not [str(path) for path in required if NAMED.search(path.read_text(encoding="utf-8"))]

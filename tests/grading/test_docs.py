"""Tests that the page on the reward agrees with the grader."""

import re
import subprocess
import sys
from pathlib import Path

DOCS = Path(__file__).parents[2] / "docs"


def test_the_examples_are_current() -> None:
    done = subprocess.run([sys.executable, str(DOCS / "grading_examples.py"), "--check"], check=False)
    assert done.returncode == 0, "run: python docs/grading_examples.py"


def test_the_code_on_the_page_gives_what_its_comments_say() -> None:
    code = re.search(r"```python\n(.*?)```", (DOCS / "grading.md").read_text(encoding="utf-8"), re.DOTALL)
    assert code is not None
    scope: dict[str, object] = {}
    checked = 0
    for line in code[1].splitlines():
        statement, _, comment = line.partition("  # ")
        if not comment:
            exec(statement, scope)
            continue
        assert eval(statement, scope) == eval(comment, {}), line
        checked += 1
    assert checked == 3

"""Run the commands and programs of Markdown pages in order, and compare their output with the page.

``python tests/support/readme.py README.md`` fails if an output differs from the page; with ``--write`` it writes
the output of commands into the page. Several pages, as ``docs/integrations/*``, are run one after the other in one
new folder.

A command is a line that begins with ``$ `` inside a block fenced as ``console``; the lines after it are its output,
in which ``…`` stands for anything, on a line of its own for any lines. A command without output is only run.
Lines of set-up (pip, git, make, cd) are left out, as they have been run before.
A block fenced as ``python`` is run as a program. One with lines that begin with ``>>>`` is run as a doctest that
ignores differences in whitespace, so that a long line of output can be wrapped. A block whose libraries are not all
installed is left out with a message; so are commands fenced as ``console LIBRARY`` without it.
"""

import argparse
import importlib.util
import os
import re
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

SET_UP = ("pip", "git", "make", "cd", "python3 -m venv", "source")
ROOT = Path(__file__).resolve().parents[2]
SHARED = "examples", "experiments"  # which pages name as they stand in the repository
EXAMPLES = """
import doctest, sys
examples = doctest.DocTestParser().get_doctest(sys.argv[1], {}, "page", None, 0)
sys.exit(doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(examples).failed > 0)
"""
CORRECTED = """
import doctest, sys, textwrap
examples = doctest.DocTestParser().get_doctest(sys.argv[1], {}, "page", None, 0)
changes = []
class Corrector(doctest.DocTestRunner):
    def report_failure(self, out, test, example, got):
        changes.append((example, got))
failed = Corrector(optionflags=doctest.NORMALIZE_WHITESPACE).run(examples, out=sys.stderr.write).failed
lines = sys.argv[1].splitlines()
for example, got in reversed(changes):
    first = example.lineno + example.source.count("\\n")
    wrapped = [part for line in got.splitlines() for part in textwrap.wrap(line, 100) or ["<BLANKLINE>"]]
    lines[first : first + example.want.count("\\n")] = wrapped
print(*lines, sep="\\n")
sys.exit(failed > len(changes))
"""
IMPORTED = re.compile(r"^\s*(?:>>> )?(?:from|import) (\w+)", re.MULTILINE)


@dataclass(frozen=True)
class Shown:
    """Command with its output on the page and the lines between which that stands."""

    command: str
    output: tuple[str, ...]
    start: int
    stop: int


def shown(text: str, *, write: bool = False) -> Iterator[Shown]:
    """Yield the commands and programs of `text` in order; with `write` a doctest is replaced by its actual output."""
    for language, lines, start in _blocks(text):
        kind, _, library = language.partition(" ")
        if kind == "console" and library and importlib.util.find_spec(library) is None:
            yield Shown(_left_out([library]), (), start, start)
        elif kind == "console":
            yield from _commands(lines, start)
        elif kind == "python" and write and ">>> " in "\n".join(lines) and not _missing(lines):
            command = shlex.join(("python", "-c", CORRECTED, "\n".join(lines)))
            yield Shown(command, tuple(lines), start, start + len(lines))
        elif kind == "python":
            yield Shown(_program(lines), (), start, start)


def _blocks(text: str) -> Iterator[tuple[str, list[str], int]]:
    """Yield the fenced blocks: language, lines, and the number of the first line."""
    lines = text.splitlines()
    fences = [number for number, line in enumerate(lines) if line.startswith("```")]
    for begin, end in zip(fences[::2], fences[1::2], strict=False):
        yield lines[begin].removeprefix("```"), lines[begin + 1 : end], begin + 1


def _commands(lines: list[str], start: int) -> Iterator[Shown]:
    begins = [number for number, line in enumerate(lines) if line.startswith("$ ")]
    for begin, end in zip(begins, [*begins[1:], len(lines)], strict=True):
        command = lines[begin][2:]
        if not command.startswith(SET_UP):
            yield Shown(command, tuple(lines[begin + 1 : end]), start + begin + 1, start + end)


def _program(lines: list[str]) -> str:
    """Return the command that runs a block in Python."""
    if missing := _missing(lines):
        return _left_out(missing)
    source = "\n".join(lines)
    arguments = (EXAMPLES, source) if ">>> " in source else (source,)
    return shlex.join(("python", "-c", *arguments))


def _missing(lines: list[str]) -> list[str]:
    """Return the libraries that a block in Python imports and that are not installed."""
    names = set(IMPORTED.findall("\n".join(lines)))
    return sorted(name for name in names if importlib.util.find_spec(name) is None)


def _left_out(missing: list[str]) -> str:
    return f"echo left out, for want of {' and '.join(missing)}"


def commands(text: str) -> Iterator[str]:
    """Return the commands of `text` in order, without their output."""
    return (found.command for found in shown(text))


def fits(output: tuple[str, ...], printed: str) -> bool:
    """Return whether the output of a program is that on the page."""
    pattern = "".join(r"(?:.*\n)*?" if line == "…" else _line(line) for line in output)
    return (
        not output or re.fullmatch(pattern, "".join(line.rstrip() + "\n" for line in printed.splitlines())) is not None
    )


def _line(line: str) -> str:
    return ".*".join(map(re.escape, line.rstrip().split("…"))) + r"\n"


def main(*paths: str, write: bool = False) -> int:
    """Run the pages and return the exit code of the first that fails or has another output, or 0."""
    environ = os.environ | {"PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}", "COLUMNS": "100"}
    with tempfile.TemporaryDirectory() as folder:
        for name in SHARED:
            Path(folder, name).symlink_to(ROOT / name)
        return next((code for path in paths if (code := _page(path, folder, environ, write=write))), 0)


def _page(path: str, folder: str, environ: dict[str, str], *, write: bool) -> int:
    text = Path(path).read_text(encoding="utf-8")
    lines = text.splitlines()
    runs = _run(text, folder, environ, write=write)
    for found in reversed(list(runs)) if write else runs:
        seen, code, printed = found
        sys.stdout.write(f"$ {seen.command}\n")
        sys.stdout.flush()
        if code:
            sys.stdout.write(f"{printed}{path}: this failed with exit code {code}: {seen.command}\n")
            return code
        if write and seen.output and "…" not in "".join(seen.output):
            lines[seen.start : seen.stop] = [line.rstrip() for line in printed.splitlines()]
        elif not write and not fits(seen.output, printed):
            sys.stdout.write(f"{path}: this command prints something else now: {seen.command}\n{printed}")
            return 1
    if write:
        Path(path).write_text("\n".join(lines) + "\n", encoding="utf-8")
    return 0


def _run(text: str, folder: str, environ: dict[str, str], *, write: bool) -> Iterator[tuple[Shown, int, str]]:
    for found in shown(text, write=write):
        done = _called(found.command, folder, environ)
        yield found, done.returncode, done.stdout + (done.stderr if done.returncode else "")


def _called(command: str, folder: str, environ: dict[str, str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, shell=True, cwd=folder, env=environ, check=False, capture_output=True, text=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", nargs="+")
    parser.add_argument("--write", action="store_true")
    given = parser.parse_args()
    sys.exit(main(*given.paths, write=given.write))

"""Make the gallery, a problem of each recipe and difficulty: ``python docs/gallery.py [--check]``."""  # noqa: INP001

import sys
import tempfile
import warnings
from collections.abc import Iterator
from pathlib import Path

from sim2reason.errors import FigureWarning
from sim2reason.figures import canvas
from sim2reason.figures.drawing import drawing
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.make import build_item
from sim2reason.generation.recipes import RECIPES
from sim2reason.generation.request import Request
from sim2reason.questions.difficulty import DIFFICULTIES

PAGE, FIGURES = "gallery.md", "gallery"
SEED, LAST = 2026, 4
SHOWN = ("numeric", "reverse", "symbolic")  # modes whose problems have one question and no options
HEAD = """# Gallery

One problem of each recipe and difficulty, the modes in turn, as `python docs/gallery.py` makes them from seed {seed}:
none was chosen by hand. `sim2reason explain` tells more of any.
"""


def requests(recipe: str, difficulty: str, mode: str) -> Iterator[Request]:
    """The orders by which the problem is looked for, in turn."""
    return (Request(recipe, difficulty, mode, SEED, index, solutions=True) for index in range(LAST))


def entry(recipe: str, difficulty: str, mode: str, figures: Path) -> str:
    """The part of the page on one problem, whose figure is drawn into a folder."""
    for request in requests(recipe, difficulty, mode):
        found = ItemSearch(request).find()
        if found is not None:
            item = build_item(request, found)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", FigureWarning)
                canvas.draw(drawing(found.description.scene, found.description), figures / f"{item.id}.svg")
            solution = item.solution.text if item.solution is not None else f"No worked solution: {item.unsolved}."
            title = f"### {difficulty}, {mode}: {item.kind.replace('_', ' ')}"
            image = f"![The scene of {item.id}]({FIGURES}/{item.id}.svg)"
            told = "\n".join(f"> {line}".rstrip() for line in item.prompt.splitlines())
            answer = f"Answer: {item.answer.told}"
            hidden = ("<details><summary>Worked solution</summary>", solution, "</details>")
            return "\n\n".join((title, image, told, answer, *hidden))
    return f"### {difficulty}, {mode}\n\nNone of {LAST} requests gives such a problem."


def write(folder: Path) -> None:
    """The page and its figures, into a folder."""
    figures = folder / FIGURES
    figures.mkdir()
    parts = [HEAD.format(seed=SEED)]
    turn = 0
    for recipe in sorted(RECIPES):
        parts.append(f"## {recipe}\n")
        for difficulty in DIFFICULTIES:
            parts.append(entry(recipe, difficulty, SHOWN[turn % len(SHOWN)], figures) + "\n")
            turn += 1
        turn += 1  # so that each difficulty meets each mode
    (folder / PAGE).write_text("\n".join(parts), encoding="utf-8")


def contents(folder: Path) -> dict[str, bytes]:
    """What the page and its figures hold, by name."""
    paths = (folder / PAGE, *(folder / FIGURES).glob("*"))
    return {path.name: path.read_bytes() for path in paths if path.is_file()}


def main(*, check: bool) -> int:
    """Write the page; or only compare it with what would be written, and return 1 where they differ."""
    here = Path(__file__).parent
    with tempfile.TemporaryDirectory() as name:
        write(Path(name))
        made, stood = contents(Path(name)), contents(here)
    if check:
        differ = sorted(key for key in made.keys() | stood.keys() if made.get(key) != stood.get(key))
        if differ:
            sys.stderr.write(f"docs/{PAGE} is not what the code makes now: {', '.join(differ)}; run: make docs\n")
        return 1 if differ else 0
    (here / FIGURES).mkdir(exist_ok=True)
    for stale in stood.keys() - made.keys() - {PAGE}:
        (here / FIGURES / stale).unlink()
    for key, data in made.items():
        (here / PAGE if key == PAGE else here / FIGURES / key).write_bytes(data)
    return 0


if __name__ == "__main__":
    sys.exit(main(check="--check" in sys.argv[1:]))

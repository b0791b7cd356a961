"""The dataset card: a README.md in the format of the Hugging Face Hub.

The front matter follows https://huggingface.co/docs/hub/datasets-cards, with the Hub's names of sizes, tasks and
licences.
"""

import json
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from shlex import quote

from sim2reason.datasets.card_content import SHOWN, Example, example_file, histogram_file
from sim2reason.datasets.manifest import MANIFEST, SHARDS, Manifest
from sim2reason.datasets.plan import DATA, DEFAULT_DISTANCE, LICENSE, TRAIN, Config
from sim2reason.generation.request import SI
from sim2reason.questions.accuracy import TOLERANCE

SIZES = (
    *((10**3, "n<1K"), (10**4, "1K<n<10K"), (10**5, "10K<n<100K"), (10**6, "100K<n<1M"), (10**7, "1M<n<10M")),
    *((10**8, "10M<n<100M"), (10**9, "100M<n<1B"), (10**10, "1B<n<10B"), (10**11, "10B<n<100B")),
)
LARGEST_SIZE = "n>1T"
FRONT = """\
pretty_name: Physics problems by sim2reason
language:
- en
task_categories:
- question-answering
- text-generation
annotations_creators:
- machine-generated
language_creators:
- machine-generated
source_datasets:
- original
tags:
- physics
- mechanics
- reasoning
- simulation
- synthetic
- reinforcement-learning"""
USE = """
## Use

Replace `OUT` by this folder, or by the name of the dataset on the hub where there is one.

```python
import datasets

problems = datasets.load_dataset("OUT", split="{split}")
print(problems[0]["prompt"])
```

```python
from pathlib import Path

import pandas

files = sorted(Path("OUT/{data}").glob("{split}-*.parquet"))
problems = pandas.concat(map(pandas.read_parquet, files))
```

A response is graded by its last box, within the tolerance of the answer and in any unit that fits:

```python
import sim2reason

for item in sim2reason.open("OUT"):
    response = "… so the answer is \\\\boxed{{1.0}}."  # what a model says to item.prompt
    print(item.id, sim2reason.grade(item, response).reward)
```"""
FIELDS = [
    ("id", "names the request that makes the item again"),
    ("prompt", "the problem, as a solver sees it"),
    ("shape", "in which order the prompt says what it says"),
    ("answer", "value, unit, sense that counts as positive, relative tolerance; or a formula with bindings; or parts"),
    ("mode, kind, recipe, difficulty", "what sort of problem it is"),
    ("entities", "the types of the scene's parts"),
    (
        "parts",
        "of a problem with several parts: question, kind, parts that lead to it, wrong answers, solution, certificate",
    ),
    ("distractors", "wrong answers, each with the slip that leads to it"),
    ("idle, idle_numbers", "parts of the scene without bearing on the answer, and addresses of such numbers"),
    ("asked", "subject, quantity, time in s or event"),
    ("needs", "the most advanced mathematics of its shortest solution, from arithmetic to integration"),
    ("measured", "laws, phases, unknowns found together and score of that solution, or null: docs/difficulty.md"),
    ("solution", "with --solutions: the worked solution as strategy, text and steps with their equations, or null"),
    ("unsolved", "with --solutions: why there is no worked solution"),
    ("scene", "the scene as YAML, in SI units, which `sim2reason simulate` reads"),
    ("certificate", "JSON: how well the engines agree"),
    ("provenance", "request, weights and versions (JSON), units of the text, hash of the maker's settings"),
]


def text(manifest: Manifest, examples: Sequence[Example], pictures: Collection[str]) -> str:
    """Return the whole card from the manifest (without its `files`), examples, and the names of pictures."""
    parts = _front(manifest), _body(manifest), _shown(manifest, pictures), _counts(manifest), _refused(manifest)
    lines = [line for part in parts for line in part]
    lines += [line for number, example in enumerate(examples, start=1) for line in _example(number, example, pictures)]
    return "\n".join([*lines, *_table("Fields", ("field", "meaning"), FIELDS), *_end(manifest)]) + "\n"


def _front(manifest: Manifest) -> Iterator[str]:
    size = next((name for limit, name in SIZES if manifest.rows < limit), LARGEST_SIZE)
    yield from ("---", f"license: {manifest.config.license}", FRONT, "size_categories:", f"- {size}")
    yield from ("configs:", "- config_name: default", "  data_files:")
    for split in _splits(manifest):
        yield from (f"  - split: {split}", f"    path: {DATA}/{split}-*.parquet")
    yield from ("---", "")


def _splits(manifest: Manifest) -> list[str]:
    """Return the names of the splits that have files, or of all splits if none has any."""
    rows = manifest.counts.get("split", {})
    return [split for split in manifest.config.split if rows.get(split)] or [*manifest.config.split]


def _body(manifest: Manifest) -> Iterator[str]:
    config = manifest.config
    yield from ("# Physics problems by sim2reason", "")
    yield f"{manifest.rows} problems, each with an answer that two independent simulations of its scene agree on."
    yield f"Asked for: {config.items}; seed {config.seed}; configuration `{manifest.config_hash[:16]}`."
    if manifest.positions > config.items:
        yield f"In place of positions without a problem, {manifest.positions - config.items} more were tried."
    yield f"Licence of the data: {config.license}."
    if len(config.split) > 1:
        yield "No two splits share a scene, or a problem up to its numbers."
    if config.distance:
        yield f"Two problems that differ in numbers only differ in one of them by {config.distance:.3g} or more of it."
    for file in config.decontaminate:
        yield f"No problem shares a run of words with the benchmark {_cell(file.name)} (SHA-256 `{file.sha256}`)."
    splits = _splits(manifest)
    yield USE.format(split=TRAIN if TRAIN in splits else splits[0], data=DATA)


def _shown(manifest: Manifest, pictures: Collection[str]) -> Iterator[str]:
    if not pictures:
        yield from ("", "This card has no pictures: matplotlib was missing (pip install matplotlib).")
    for name, shown in SHOWN.items():
        if histogram_file(name) in pictures:
            yield from (
                "",
                f"![{shown.title}]({histogram_file(name)})",
                "",
                f"*{shown.title}: {manifest.rows} problems.*",
            )


def _counts(manifest: Manifest) -> Iterator[str]:
    for by, counts in manifest.counts.items():
        yield from _table(f"By {by}", (by, "problems"), [(key, str(n)) for key, n in counts.items()])
    cells = [(c.mode, c.kind, c.recipe, str(c.asked), str(c.kept)) for c in manifest.cells]
    title = "Asked for by the weights, and kept"
    yield from _table(title, ("mode", "kind", "recipe", "asked for", "kept"), cells, folded=True)


def _refused(manifest: Manifest) -> Iterator[str]:
    by_filter = sum((Counter(counts) for counts in manifest.rejected.values()), Counter[str]())
    rows = [(name, str(n)) for name, n in sorted(by_filter.items(), key=lambda pair: (-pair[1], pair[0]))]
    yield from _table("Refused draws and items, by filter", ("filter", "refused"), rows)
    rows = [(r, name, str(n)) for r, counts in manifest.rejected.items() for name, n in counts.items()]
    yield from _table("By recipe and filter", ("recipe", "filter", "refused"), rows, folded=True)
    for kind, refused in manifest.refused.items():
        positions = [(str(p.position), p.recipe, p.difficulty, p.mode, str(p.index), p.reason) for p in refused.first]
        head = "position", "recipe", "difficulty", "mode", "index", "reason"
        yield from _table(f"Positions without a problem: {kind}", head, positions, folded=True)
        if refused.total > len(positions):
            yield from ("", f"… and {refused.total - len(positions)} more: see `{SHARDS}`.")


def _example(number: int, example: Example, pictures: Collection[str]) -> Iterator[str]:
    item = example.item
    sign = f" (positive: {item.answer.sign})" if item.answer.sign else ""
    yield from (
        "",
        f"## Example {number}",
        "",
        f"`{item.id}`: {item.recipe}, {item.difficulty}, {item.kind}, {item.mode}",
    )
    yield from ("", *_quoted(item.prompt))
    if example_file(number) in pictures:
        yield from ("", f"![The scene of example {number}]({example_file(number)})")
    yield from ("", f"Answer: {item.answer.told}{sign}")
    yield from ("", "<details><summary>Worked solution</summary>", "", *_quoted(example.solution), "", "</details>")
    yield from ("", "<details><summary>Its scene</summary>", "", "```yaml", item.scene.rstrip("\n"), "```")
    yield from ("", "</details>")


def _end(manifest: Manifest) -> Iterator[str]:
    made = f"with `{json.dumps(manifest.versions)}`; pictures by {manifest.pictures or 'nobody'}."
    yield from ("", "## Made by", "", "```console", f"$ {command(manifest.config)}", "```", "", made)
    yield f"`sim2reason verify OUT` compares every file with `{MANIFEST}`."


def command(config: Config) -> str:
    """Return the command that regenerates a dataset of a configuration."""
    options = [
        f"--items {config.items} --recipe {','.join(config.recipes)} --difficulty {','.join(config.difficulties)}",
        f"--mode {','.join(config.modes)} --seed {config.seed} --shard-size {config.shard}",
        f"--weights {_pairs(config.weights)}" * bool(config.weights),
        f"--units {config.units}" * (config.units != SI),
        f"--tolerance {config.tolerance:g}" * (config.tolerance != TOLERANCE),
        f"--needs {quote(','.join(config.needs))}" * bool(config.needs),
        "--solutions" * config.solutions,
        "--unfiltered" * config.unfiltered,
        f"--split {_pairs(config.split)}" * (list(config.split) != [TRAIN]),
        f"--distance {config.distance!r}" * (config.distance != DEFAULT_DISTANCE),
        *(f"--decontaminate {quote(file.name)}" for file in config.decontaminate),
        f"--license {config.license}" * (config.license != LICENSE),
    ]
    return " ".join(["sim2reason generate OUT", *filter(None, options)])


def _pairs(sizes: Mapping[str, float]) -> str:
    return ",".join(f"{name}={size!r}" for name, size in sizes.items())


def _quoted(text: str) -> Iterator[str]:
    return (f"> {line}".rstrip() for line in text.splitlines())


def _table(title: str, head: Sequence[str], rows: Sequence[Sequence[str]], *, folded: bool = False) -> Iterator[str]:
    """Yield a Markdown table under its title, or collapsed; nothing if there are no rows."""
    if not rows:
        return
    yield from ("", f"<details><summary>{title}</summary>" if folded else f"## {title}", "")
    yield from (_line(head), _line(["---"] * len(head)))
    yield from (_line([_cell(cell) for cell in row]) for row in rows)
    if folded:
        yield from ("", "</details>")


def _cell(text: str) -> str:
    """Return a text escaped for a Markdown table."""
    return " ".join(text.split()).replace("|", "\\|").replace("<", "&lt;")


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"

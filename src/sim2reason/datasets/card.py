"""The dataset card: a README.md that people read and the Hugging Face hub understands."""

import json
from collections.abc import Iterator, Mapping, Sequence

from sim2reason.datasets.item import Item
from sim2reason.datasets.manifest import SHARDS, Manifest
from sim2reason.datasets.plan import DATA, SI, TRAIN

SIZES = (1_000, "n<1K"), (10_000, "1K<n<10K"), (100_000, "10K<n<100K"), (1_000_000, "100K<n<1M")


def text(manifest: Manifest, example: Item | None) -> str:
    """The whole card; a pure function of the manifest (its `files` aside) and an example."""
    lines = [*_front(manifest), *_body(manifest), *_example(example), *_fields(), *_remake(manifest)]
    return "\n".join(lines) + "\n"


def _front(manifest: Manifest) -> Iterator[str]:
    size = next((name for limit, name in SIZES if manifest.rows < limit), "n>1M")
    yield from ("---", "pretty_name: sim2reason physics problems", "language: [en]")
    yield from ("task_categories: [question-answering]", "tags: [physics, reasoning, simulation, synthetic]")
    yield from (f"size_categories: [{size}]", "configs:", "- config_name: default", "  data_files:")
    for split in manifest.config.split:
        yield from (f"  - split: {split}", f"    path: {DATA}/{split}-*.parquet")
    yield from ("---", "")


def _body(manifest: Manifest) -> Iterator[str]:
    config = manifest.config
    yield from ("# Physics problems by sim2reason", "")
    yield f"{manifest.rows} problems, each with an answer that two independent simulations of its scene agree on."
    yield f"Asked for: {config.items}; seed {config.seed}; configuration `{manifest.config_hash[:16]}`."
    for by, counts in manifest.counts.items():
        yield from _table(f"By {by}", (by, "problems"), [(key, str(n)) for key, n in counts.items()])
    cells = [(c.mode, c.kind, c.recipe, str(c.asked), str(c.kept)) for c in manifest.cells]
    yield from _table("Asked for by the weights, and kept", ("mode", "kind", "recipe", "asked for", "kept"), cells)
    rows = [(r, name, str(n)) for r, counts in manifest.rejected.items() for name, n in counts.items()]
    yield from _table("RefusedPositions draws", ("recipe", "filter", "draws"), rows)
    for kind, refused in manifest.refused.items():
        found = [(str(p.position), p.recipe, p.difficulty, p.mode, str(p.index), p.reason) for p in refused.first]
        head = "position", "recipe", "difficulty", "mode", "index", "reason"
        yield from _table(f"{kind.capitalize()} positions", head, found)
        if refused.total > len(found):
            yield from ("", f"… and {refused.total - len(found)} more: see `{SHARDS}`.")


def _example(item: Item | None) -> Iterator[str]:
    if item is None:
        return
    sign = f" (positive: {item.answer.sign})" if item.answer.sign else ""
    yield from ("", "## An example", "", *(f"> {line}".rstrip() for line in item.prompt.splitlines()), "")
    yield from (f"Answer: {item.answer.told}{sign}", "", "Its scene:", "", "```yaml")
    yield from (item.scene.rstrip("\n"), "```")


def _fields() -> Iterator[str]:
    rows = [
        ("id", "names the request that makes the item again"),
        ("prompt", "the problem, as a solver sees it"),
        ("shape", "in which order the prompt says what it says"),
        ("answer", "value, unit, sense that counts as positive, relative tolerance; or a formula with bindings"),
        ("mode, kind, recipe, difficulty", "what sort of problem it is"),
        ("entities", "the types of the scene's parts"),
        ("distractors", "wrong answers, each with the slip that leads to it"),
        ("idle, idle_numbers", "parts of the scene without bearing on the answer, and addresses of such numbers"),
        ("asked", "subject, quantity, time in s or event"),
        ("solution", "with --solutions: the worked solution as strategy, text and steps with their equations, or null"),
        ("unsolved", "with --solutions: why there is no worked solution"),
        ("scene", "the scene as YAML, in SI units, which `sim2reason simulate` reads"),
        ("certificate", "JSON: how well the engines agree"),
        ("provenance", "request, weights and versions (JSON), units of the text, hash of the maker's settings"),
    ]
    yield from _table("Fields", ("field", "meaning"), rows)


def _remake(manifest: Manifest) -> Iterator[str]:
    config = manifest.config
    yield from ("", "## Made by", "", "```console")
    yield (
        f"$ sim2reason generate OUT --items {config.items} --recipe {','.join(config.recipes)} "
        f"--difficulty {','.join(config.difficulties)} --mode {','.join(config.modes)} "
        f"--seed {config.seed} --shard-size {config.shard}"
        f"{_weights(config.weights)}{f' --units {config.units}' * (config.units != SI)}"
        f"{' --solutions' * config.solutions}{_split(config.split)}"
    )
    yield from ("```", "", f"with `{json.dumps(manifest.versions)}`.")


def _weights(weights: Mapping[str, float]) -> str:
    """The option that gives them; none where there are none."""
    return f" --weights {','.join(f'{name}={size!r}' for name, size in weights.items())}" if weights else ""


def _split(shares: Mapping[str, float]) -> str:
    """The option that gives them; none where all is for training."""
    option = f" --split {','.join(f'{name}={share!r}' for name, share in shares.items())}"
    return option if list(shares) != [TRAIN] else ""


def _table(title: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    """A Markdown table under its title; nothing if there are no rows."""
    if rows:
        yield from ("", f"## {title}", "", _line(head), _line(["---"] * len(head)))
        yield from (_line([cell.replace("|", "\\|") for cell in row]) for row in rows)


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"

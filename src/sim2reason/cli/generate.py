"""Generate a dataset: problems with certified answers, in a folder."""

from pathlib import Path

import click

from sim2reason.cli import console
from sim2reason.cli.registries import chosen
from sim2reason.datasets.build import PATIENCE, build
from sim2reason.datasets.cells import empty
from sim2reason.datasets.manifest import Manifest
from sim2reason.datasets.plan import LARGEST, MAKER, SHARD, SI, Config
from sim2reason.recipes import DIFFICULTIES, all_recipes, known

EXAMPLE = """\b
Example:
    sim2reason generate problems --items 1000 --recipe pulley,incline --seed 7

An interrupted run goes on when the same command is given again, and ends in the same bytes.

Exit code 0: done; 1: done, but a mode, kind and recipe is empty that should not be; 2: wrong input.
"""


@click.command("generate", epilog=EXAMPLE)
@click.argument("out", type=click.Path(file_okay=False, path_type=Path))
@click.option("--items", type=click.IntRange(0), default=1000, show_default=True, help="How many problems.")
@click.option("--recipe", default="all", show_default=True, help="Recipes, separated by commas.")
@click.option("--difficulty", default="all", show_default=True, help="easy, medium, hard, or several by commas.")
@click.option("--modes", default="numeric", show_default=True, help="Question modes, separated by commas, or all.")
@click.option(
    "--seed", type=click.IntRange(0, LARGEST), default=0, show_default=True, help="Another seed, other problems."
)
@click.option(
    "--weights",
    default="",
    help="How often kinds of question are asked, as in period=2,reverse.count=0,springs.numeric.sum=0.5. [default: "
    "as the kinds and recipes declare]",
)
@click.option(
    "--units", default=SI, show_default=True, help="In which texts speak: SI, cgs, or mixed (cm, g and km/h, else SI)."
)
@click.option("--solutions", is_flag=True, help="With a worked solution of each problem, where there is one.")
@click.option(
    "--workers", type=click.IntRange(1), help="Processes; they never change the result. [default: one per core]"
)
@click.option("--shard-size", type=click.IntRange(1), default=SHARD, show_default=True, help="Problems in one file.")
@click.option("--json", "to_json", is_flag=True, help="Print the manifest for a program to read.")
@click.option("--patience", type=click.FloatRange(0.1), default=PATIENCE, hidden=True)
@click.option("--maker", default=MAKER, hidden=True)
def command(
    out: Path,
    items: int,
    recipe: str,
    difficulty: str,
    modes: str,
    seed: int,
    weights: str,
    units: str,
    workers: int | None,
    shard_size: int,
    to_json: bool,
    patience: float,
    maker: str,
    *,
    solutions: bool,
) -> int:
    """Generate problems into the folder OUT: Parquet shards, manifest.json and a dataset card."""
    config = Config(
        items=items,
        recipes=all_recipes() if recipe == "all" else _names("recipes", recipe, maker),
        difficulties=_difficulties(difficulty),
        modes=_names("modes", modes, maker),
        seed=seed,
        shard=shard_size,
        maker=maker,
        weights=_weights(weights),
        units=_units(units),
        solutions=solutions,
    )
    remedy = f"what is finished stays in {out}; give the same command again to go on"
    with console.resumable(remedy), console.progress("problems", items) as advance:
        manifest = build(out, config, workers=workers, patience=patience, advance=advance)
    if to_json:
        console.as_json(manifest.model_dump(mode="json"))
    else:
        _tell(out, manifest)
    for line in (lines := list(empty(manifest.cells))):
        console.explain(f"an empty cell: {line}")
    return 1 if lines else 0


def _names(kind: str, option: str, maker: str) -> tuple[str, ...]:
    """The names that an option gives; a maker of one's own may know names that the registries don't."""
    return console.words(option) if maker != MAKER else chosen(kind, option)


def _units(name: str) -> str:
    """The name of a system of units; UnknownNameError if there is none."""
    from sim2reason.questions.spoken_units import system_named

    return system_named(name).name


def _weights(option: str) -> dict[str, float]:
    """The pairs of a name and a number that an option gives."""
    found: dict[str, float] = {}
    for pair in console.words(option) if option else ():
        name, equals, number = pair.partition("=")
        try:
            found[name.strip()] = float(number)
        except ValueError:
            raise click.UsageError(f"--weights: {pair!r} is no pair; write NAME{equals or '='}NUMBER.") from None
    return found


def _difficulties(option: str) -> tuple[str, ...]:
    return DIFFICULTIES if option == "all" else tuple(known(name) for name in console.words(option))


def _tell(out: Path, manifest: Manifest) -> None:
    counts = manifest.counts.get("recipe", {})
    refused = {recipe: sum(found.values()) for recipe, found in manifest.rejected.items()}
    names = sorted(counts.keys() | refused.keys())
    console.table(["recipe", "problems", "refused draws"], [(n, counts.get(n, 0), refused.get(n, 0)) for n in names])
    click.echo(f"{manifest.rows} problems in {out} (counts by filter: {out}/README.md)")
    for kind in ("quarantined", "unfilled"):
        if found := manifest.problems(kind):
            first = found[0]
            where = f"{first.recipe} {first.difficulty} {first.mode}, seed {first.seed}, index {first.index}"
            console.explain(f"{len(found)} {kind}, the first at position {first.position} ({where}): {first.reason}")

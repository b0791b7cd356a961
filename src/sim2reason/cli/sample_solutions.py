"""Have a policy solve problems, and keep its right responses to learn from."""

from pathlib import Path

import click

from sim2reason.cli import console, options

EXAMPLE = """\b
Example:
    sim2reason sample-solutions problems --policy policy.yaml --k 8 -o solutions

policy.yaml has the settings of one policy, as a configuration of sim2reason eval has them. The file
solutions/solutions.jsonl has the responses that earn the whole reward; a corpus {kind: sampled, folder: solutions} of
sim2reason train sft learns from them. The same command goes on where it was broken off, and asks nothing twice.
"""
FOLDER = click.Path(file_okay=False, path_type=Path)


@click.command("sample-solutions", epilog=EXAMPLE)
@options.dataset()
@click.option("--policy", type=click.Path(path_type=Path), required=True, help="A YAML file with its settings.")
@click.option("--k", type=click.IntRange(1, 4096), default=8, show_default=True, help="Tries at each problem.")
@click.option("--keep", type=click.IntRange(1, 4096), default=4, show_default=True, help="Solutions of one, at most.")
@options.split()
@options.seed("Of the tries: each has a seed of its own that follows from it.")
@click.option("-o", "--out", type=FOLDER, required=True, help="The folder of the result.")
@options.verbose()
@options.to_json("Print the result for a program to read.")
def command(
    dataset: Path, policy: Path, k: int, keep: int, split: options.Names, seed: int, out: Path, to_json: bool
) -> None:
    """Ask a policy for solutions of the problems of DATASET, and keep those that the grader finds right."""
    from sim2reason.datasets.dataset import Dataset
    from sim2reason.training.sample_solutions import sample_solutions

    counts = Dataset(dataset).manifest.counts.get("split", {})
    total = k * sum(counts.values() if split == options.ALL else (counts.get(name, 0) for name in split))
    remedy = f"what is finished stays in {out}; give the same command again to go on"
    with console.resumable(remedy), console.progress("answers", total) as advance:
        found = sample_solutions(dataset, out, policy, k=k, keep=keep, split=split, seed=seed, advance=advance)
    if to_json:
        console.as_json(found.model_dump(mode="json"))
    else:
        console.table(["answers", "number"], [["kept", found.kept], *map(list, found.left_out.items())])
        where = out / "solutions.jsonl"
        click.echo(f"{found.kept} solutions of {found.solved} of {found.items} problems: {where}")

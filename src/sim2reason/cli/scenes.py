"""Commands on single scenes and problems: words, drawings, plots, random scenes, and problems by coordinates."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sim2reason.cli import files, options

if TYPE_CHECKING:
    from sim2reason.text.prose.voices import VoiceName
from sim2reason.cli import console
from sim2reason.cli.options import Names

DESCRIBE_EXAMPLE = """\b
Example:
    sim2reason describe scene.yaml
    sim2reason describe scene.yaml --hide ramp.blocks.0.mass
    sim2reason sample --recipe pulley | sim2reason describe - --voice symbolic
"""


@click.command("describe", epilog=DESCRIBE_EXAMPLE)
@options.scene()
@click.option("--voice", type=click.Choice(["numeric", "symbolic"]), default="numeric", show_default=True)
@click.option("--hide", multiple=True, metavar="ADDRESS", help="Say a symbol for this number; may be repeated.")
@options.seed("Another seed, other words.")
def describe_command(scene: Path, voice: "VoiceName", hide: tuple[str, ...], seed: int) -> None:
    """Tell the scene in the file SCENE, or on standard input if it is -."""
    from sim2reason.text.prose.description import describe

    click.echo(describe(files.scene(scene), seed, voice, hide=hide).text)


FIGURE_EXAMPLE = """\b
Example:
    sim2reason figure scene.yaml -o scene.svg
    sim2reason figure scene.yaml -o scene.png --numbers

Angles are right; of machines of strings and planes lengths are not. Lengths and angles for which the text has symbols
are drawn with other values. Needs: pip install matplotlib
"""


@click.command("figure", epilog=FIGURE_EXAMPLE)
@options.scene()
@options.out("Where to: a .svg, .png or .pdf file.", required=True, printing=False)
@click.option("--numbers", is_flag=True, help="Write masses too.")
@options.wording()
def figure_command(scene: Path, out: Path, numbers: bool, seed: int | None) -> None:
    """Draw the initial state of the scene in the file SCENE (- is standard input) as a line drawing."""
    from sim2reason.figures.canvas import check
    from sim2reason.figures.drawing import figure
    from sim2reason.scenes.files import read_wording

    check(out)
    content = files.text(scene)
    loaded, wording = files.scene(scene, content), read_wording(content)
    with files.warnings_told(), files.written(out) as path:
        figure(loaded, path, numbers=numbers, seed=seed, wording=wording)


PLOT_EXAMPLE = """\b
Example:
    sim2reason plot scene.yaml -o traces.png
    sim2reason plot scene.yaml -o traces.svg --duration 1 --engine exact

Events are marked, and what is cut off is shaded. Needs: pip install matplotlib
"""


@click.command("plot", epilog=PLOT_EXAMPLE)
@options.scene()
@options.out("Where to: a .svg, .png or .pdf file.", required=True, printing=False)
@click.option(
    "--duration",
    type=console.Seconds(0.0, 60.0, min_open=True),
    default=None,
    help="How long; as long as the scene is worth by default.",
)
@click.option("--engine", default="both", show_default=True, help="exact, mujoco, or both: exact, cut where they part.")
@options.wording()
def plot_command(scene: Path, out: Path, duration: float | None, engine: str, seed: int | None) -> None:
    """Plot the motion of the scene in the file SCENE (- is standard input)."""
    from sim2reason.figures.canvas import check
    from sim2reason.figures.drawing import plot
    from sim2reason.scenes.files import read_wording

    check(out)
    content = files.text(scene)
    loaded, wording = files.scene(scene, content), read_wording(content)
    with files.written(out) as path:
        plot(loaded, path, duration=duration, engine=engine, seed=seed, wording=wording)


SAMPLE_EXAMPLE = """\b
Example:
    sim2reason sample --recipe pulley --difficulty medium --seed 7 --index 0 -o scene.yaml

It is the scene of: sim2reason item --recipe pulley --difficulty medium --seed 7 --index 0
"""


@click.command("sample", epilog=SAMPLE_EXAMPLE)
@options.one_recipe()
@options.one_difficulty()
@options.one_mode()
@options.seed("Which series of scenes.")
@options.index("Which scene of the series.")
@options.weights()
@options.tolerance()
@options.needs()
@options.out("Where to write it; standard output if left out.")
def sample_command(
    recipe: str,
    difficulty: str,
    mode: str,
    seed: int,
    index: int,
    weights: dict[str, float],
    tolerance: float,
    needs: Names,
    out: Path | None,
) -> None:
    """Draw a random scene: that of the problem of the same recipe, difficulty, mode, seed and index."""
    from sim2reason.datasets.items import sample
    from sim2reason.scenes.files import dump

    scene = sample(recipe, difficulty, mode, seed=seed, index=index, weights=weights, tolerance=tolerance, needs=needs)
    files.tell(dump(scene), out)


ITEM_EXAMPLE = """\b
Example:
    sim2reason item --recipe pulley --difficulty medium --mode reverse --seed 7 --index 3
    sim2reason item --recipe springs --difficulty hard --index 12 --solutions --figure scene.svg
    sim2reason item --recipe pulley --json
"""


@click.command("item", epilog=ITEM_EXAMPLE)
@options.one_recipe()
@options.one_difficulty()
@options.one_mode()
@options.seed("Which series of problems.")
@options.index("Which problem of the series.")
@options.weights()
@options.units()
@options.tolerance()
@options.needs()
@click.option("--solutions", is_flag=True, help="With its worked solution, where there is one.")
@options.figure(printing=True)
@click.option("--scene", "with_scene", is_flag=True, cls=options.Printing, help="Print the scene too.")
@options.to_json("For a program to read: one item, as the lists of show and ask have it.")
def item_command(
    recipe: str,
    difficulty: str,
    mode: str,
    seed: int,
    index: int,
    weights: dict[str, float],
    units: str,
    tolerance: float,
    needs: Names,
    solutions: bool,
    figure: Path | None,
    with_scene: bool,
    to_json: bool,
) -> None:
    """Make one problem of a recipe, difficulty and mode: the same one that a dataset has."""
    from sim2reason.datasets.items import build_request, make_item
    from sim2reason.figures import canvas
    from sim2reason.figures.drawing import drawing

    if figure is not None:
        canvas.check(figure)
    how = weights, units
    request = build_request(
        recipe, difficulty, mode, seed, index, *how, tolerance=tolerance, needs=needs, solutions=solutions
    )
    item, found = make_item(request)
    if figure is not None:
        with files.warnings_told(), files.written(figure) as path:
            canvas.draw(drawing(found.description.scene, found.description), path)
    if to_json:
        console.as_json(item.model_dump(mode="json"))
    else:
        console.tell_problem(item, scene=with_scene, solution=solutions)

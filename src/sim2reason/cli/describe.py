"""Tell a scene in words, with numbers or with symbols."""

from pathlib import Path

import click

from sim2reason.cli import source
from sim2reason.dsl.scene import Scene
from sim2reason.errors import SceneError
from sim2reason.prose.voices import voice_named
from sim2reason.prose.writer import describe

EXAMPLE = """\b
Example:
    sim2reason describe scene.yaml
    sim2reason describe scene.yaml --hide ramp.blocks.0.mass
    sim2reason sample --recipe pulley | sim2reason describe - --voice symbolic
"""


@click.command("describe", epilog=EXAMPLE)
@click.argument("path", metavar="SCENE", type=click.Path(path_type=Path, allow_dash=True))
@click.option("--voice", type=click.Choice(["numeric", "symbolic"]), default="numeric", show_default=True)
@click.option("--hide", multiple=True, metavar="ADDRESS", help="Say a symbol for this number; may be repeated.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Another seed, other words.")
def command(path: Path, voice: str, hide: tuple[str, ...], seed: int) -> None:
    """Tell the scene in the file SCENE, or on standard input if it is -."""
    scene = source.scene(path)
    _check(scene, hide)
    click.echo(describe(scene, seed, voice_named(voice, hide)).text)


def _check(scene: Scene, hide: tuple[str, ...]) -> None:
    """Every address leads to a number that the text can say."""
    known = [parameter.path for parameter in scene.parameters if not parameter.hidden and parameter.value is not None]
    for address in hide:
        if address not in known:
            raise SceneError(f"--hide {address}", "no such number is told", f"there are: {', '.join(known)}")

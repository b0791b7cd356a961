"""Tell a scene in words, with numbers or with symbols."""

from pathlib import Path

import click

from sim2reason.cli import options, source
from sim2reason.text.prose.voices import VoiceName

EXAMPLE = """\b
Example:
    sim2reason describe scene.yaml
    sim2reason describe scene.yaml --hide ramp.blocks.0.mass
    sim2reason sample --recipe pulley | sim2reason describe - --voice symbolic
"""


@click.command("describe", epilog=EXAMPLE)
@options.scene()
@click.option("--voice", type=click.Choice(["numeric", "symbolic"]), default="numeric", show_default=True)
@click.option("--hide", multiple=True, metavar="ADDRESS", help="Say a symbol for this number; may be repeated.")
@options.seed("Another seed, other words.")
def command(scene: Path, voice: VoiceName, hide: tuple[str, ...], seed: int) -> None:
    """Tell the scene in the file SCENE, or on standard input if it is -."""
    from sim2reason.text.prose.description import describe

    click.echo(describe(source.scene(scene), seed, voice, hide=hide).text)

"""List what there is: entities, recipes, quantities, engines and so on."""

import click

from sim2reason.cli import console, options

EXAMPLE = """\b
Example:
    sim2reason list
    sim2reason list recipes
    sim2reason list entities --json
"""


@click.command("list", epilog=EXAMPLE)
@click.argument("kind", required=False)
@options.to_json("For a program to read: {kind: [{name, summary}]}.")
def command(kind: str | None, to_json: bool) -> None:
    """List the members of KIND, or of every kind: entities, bodies, recipes, quantities, engines, modes and so on."""
    from sim2reason.base.registry import members

    found = members(kind)
    if to_json:
        console.as_json({name: [member._asdict() for member in held] for name, held in found.items()})
        return
    for name, held in found.items():
        console.table([f"{name} ({len(held)})", ""], held)
        click.echo()

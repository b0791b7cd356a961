"""List what there is: entities, recipes, quantities, engines and so on."""

import inspect

import click

from sim2reason.cli import console
from sim2reason.cli.kinds import registries, registry
from sim2reason.registry import Registry

EXAMPLE = """\b
Example:
    sim2reason list
    sim2reason list recipes
    sim2reason list entities --json
"""


@click.command("list", epilog=EXAMPLE)
@click.argument("kind", required=False)
@click.option("--json", "to_json", is_flag=True, help="For a program to read: {kind: [{name, summary}]}.")
def command(kind: str | None, to_json: bool) -> None:
    """List the members of KIND, or of every kind: entities, bodies, recipes, quantities, engines, modes and so on."""
    kinds = registries() if kind is None else {kind: registry(kind)}
    rows = {name: _rows(members) for name, members in kinds.items()}
    if to_json:
        console.as_json({name: [{"name": n, "summary": s} for n, s in found] for name, found in rows.items()})
        return
    for name, found in rows.items():
        console.table([f"{name} ({len(found)})", ""], found)
        click.echo()


def _rows(registry: "Registry[object]") -> list[tuple[str, str]]:
    return [(name, (inspect.getdoc(member) or "").partition("\n")[0]) for name, member in registry.items()]

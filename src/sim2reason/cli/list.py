"""List what there is: entities, recipes, quantities, engines and so on."""

import inspect
from dataclasses import fields, is_dataclass

import click

from sim2reason.cli import console, registries
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
    chosen = registries.registries() if kind is None else {kind: registries.registry(kind)}
    rows = {name: _rows(members) for name, members in chosen.items()}
    if to_json:
        console.as_json({name: [{"name": n, "summary": s} for n, s in found] for name, found in rows.items()})
        return
    for name, found in rows.items():
        console.table([f"{name} ({len(found)})", ""], found)
        click.echo()


def _rows(registry: "Registry[object]") -> list[tuple[str, str]]:
    return [(name, _summary(member)) for name, member in registry.items()]


def _summary(member: object) -> str:
    """What a member says of itself: its summary, the facts of a value, the first line of what documents it."""
    said = getattr(member, "summary", None)
    if isinstance(said, str):
        return said
    if is_dataclass(member) and not isinstance(member, type):
        facts = [(f.name, getattr(member, f.name)) for f in fields(member) if f.name != "name"]
        return ", ".join(f"{name} {value}" for name, value in facts if isinstance(value, str) and value)
    return (inspect.getdoc(member) or "").partition("\n")[0]

"""List what there is: entities, recipes, quantities, engines and so on."""

import inspect
from collections.abc import Iterator
from importlib import import_module
from pkgutil import walk_packages

import click

import sim2reason
from sim2reason.cli import console
from sim2reason.errors import UnknownNameError
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
    kinds = dict(_registries())
    if kind is not None and kind not in kinds:
        raise UnknownNameError(f"no such kind: {kind!r}; there are: {', '.join(sorted(kinds))}")
    chosen = {name: _rows(kinds[name]) for name in sorted(kinds) if kind in {None, name}}
    if to_json:
        console.as_json({name: [{"name": n, "summary": s} for n, s in rows] for name, rows in chosen.items()})
        return
    for name, rows in chosen.items():
        click.echo(f"{name} ({len(rows)})")
        console.table(["name", "what it is"], rows)
        click.echo()


def _registries() -> Iterator[tuple[str, "Registry[object]"]]:
    """Every registry of the library under the last word of its kind; only packages are imported, not members."""
    for module in walk_packages(sim2reason.__path__, "sim2reason."):
        if module.ispkg and not module.name.startswith("sim2reason.cli"):
            for value in vars(import_module(module.name)).values():
                if isinstance(value, Registry):
                    yield value.kind.rpartition(".")[2], value


def _rows(registry: "Registry[object]") -> list[tuple[str, str]]:
    return [(name, (inspect.getdoc(member) or "").partition("\n")[0]) for name, member in registry.items()]

"""Commands for reference: what is registered, and the format of scene files."""

import json
from pathlib import Path

import click

from sim2reason.cli import console, files, options

LIST_EXAMPLE = """\b
Example:
    sim2reason list
    sim2reason list recipes
    sim2reason list entities --json
"""


@click.command("list", epilog=LIST_EXAMPLE)
@click.argument("kind", required=False)
@options.to_json("For a program to read: {kind: [{name, summary}]}.")
def list_command(kind: str | None, to_json: bool) -> None:
    """List the members of KIND, or of every kind: entities, bodies, recipes, quantities, engines, modes and so on."""
    from sim2reason.base.registry import members

    found = members(kind)
    if to_json:
        console.as_json({name: [member._asdict() for member in held] for name, held in found.items()})
        return
    for name, held in found.items():
        console.table([f"{name} ({len(held)})", ""], held)
        click.echo()


SCHEMA_EXAMPLE = """\b
Example:
    sim2reason schema -o scene.schema.json
    sim2reason schema --page -o docs/scene-format.md
    sim2reason schema --reference -o docs/questions.md

\b
Put this line on top of a scene file, and editors that know YAML check and complete it:
    # yaml-language-server: $schema=scene.schema.json
"""


@click.command("schema", epilog=SCHEMA_EXAMPLE)
@click.option("--page", is_flag=True, cls=options.Printing, help="The same for people, as Markdown.")
@click.option(
    "--reference", is_flag=True, cls=options.Printing, help="All that can be asked, with examples, as Markdown."
)
@options.out("Where to write it; standard output if left out.")
def schema_command(page: bool, reference: bool, out: Path | None) -> None:
    """Write the JSON schema of scene files: entities, parameters, ranges of validity and units."""
    from sim2reason.generation.question_page import format_page as format_questions
    from sim2reason.scenes.files.page import format_page
    from sim2reason.scenes.files.schema import schema

    if page and reference:
        raise click.UsageError("give --page or --reference, one of the two.")
    if reference:
        files.tell(format_questions(), out)
        return
    files.tell(format_page() if page else json.dumps(schema(), indent=2, ensure_ascii=False) + "\n", out)

"""Write the JSON schema of scene files, a page that explains the format, or a reference of questions."""

import json
from pathlib import Path

import click

from sim2reason.cli import options, results

EXAMPLE = """\b
Example:
    sim2reason schema -o scene.schema.json
    sim2reason schema --page -o docs/scene-format.md
    sim2reason schema --reference -o docs/questions.md

\b
Put this line on top of a scene file, and editors that know YAML check and complete it:
    # yaml-language-server: $schema=scene.schema.json
"""


@click.command("schema", epilog=EXAMPLE)
@click.option("--page", is_flag=True, cls=options.Printing, help="The same for people, as Markdown.")
@click.option(
    "--reference", is_flag=True, cls=options.Printing, help="All that can be asked, with examples, as Markdown."
)
@options.out("Where to write it; standard output if left out.")
def command(page: bool, reference: bool, out: Path | None) -> None:
    """Write the JSON schema of scene files: entities, parameters, ranges of validity and units."""
    from sim2reason.generation.question_page import format_page as format_questions
    from sim2reason.scenes.files.page import format_page
    from sim2reason.scenes.files.schema import schema

    if page and reference:
        raise click.UsageError("give --page or --reference, one of the two.")
    if reference:
        results.tell(format_questions(), out)
        return
    results.tell(format_page() if page else json.dumps(schema(), indent=2, ensure_ascii=False) + "\n", out)

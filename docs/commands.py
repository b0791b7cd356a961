"""Write the reference of the commands: ``python docs/commands.py [--check]``."""  # noqa: INP001

import re
import sys
from collections.abc import Iterator
from pathlib import Path

import click

from sim2reason.cli import main

PAGE = Path(__file__).parent / "reference" / "commands.md"
HEAD = """# Commands

`python docs/commands.py` writes this page from the definitions of the commands. `sim2reason COMMAND --help` prints the
same text. The exit code is 0 for success, 1 for a negative result such as a damaged dataset, 2 for invalid input and
130 after an interrupt.
"""


def commands(command: click.Command, parent: click.Context | None, name: str) -> Iterator[click.Context]:
    """Yield the context of a command and of its subcommands, in alphabetical order."""
    context = click.Context(command, parent=parent, info_name=name, **command.context_settings)
    if parent is not None:
        yield context
    if isinstance(command, click.Group):
        for member in sorted(command.list_commands(context)):
            child = command.get_command(context, member)
            if child is not None and not child.hidden:
                yield from commands(child, context, member)


def paragraphs(text: str | None) -> str:
    """Return the text of a help page as Markdown; lines after a backspace character keep their breaks."""
    parts = re.split(r"\n\s*\n", (text or "").strip("\n"))
    return "\n\n".join(_block(part) if part.lstrip().startswith("\b") else _joined(part) for part in parts)


def _block(part: str) -> str:
    lines = part.replace("\b\n", "").replace("\b", "").splitlines()
    title, body = (lines[0], lines[1:]) if lines[0].rstrip().endswith(":") else ("", lines)
    code = "\n".join(line.removeprefix("    ") for line in body)
    return "\n\n".join(filter(None, (title.strip(), f"```text\n{code}\n```")))


def _joined(part: str) -> str:
    return _escaped(" ".join(part.split()))


def _escaped(text: str) -> str:
    """Return the text with the characters that Markdown would interpret escaped."""
    return re.sub(r"([<>*_|\[\]])", r"\\\1", text)


def section(context: click.Context) -> str:
    """Return the section of one command: its description, usage, options and examples."""
    command = context.command
    level = "##" if context.parent is not None and context.parent.parent is None else "###"
    title = context.command_path.split(" ", 1)[1]
    usage = " ".join(("sim2reason", title, *command.collect_usage_pieces(context)))
    listed = [parameter for parameter in command.params if isinstance(parameter, click.Option)]
    records = [record for option in listed if (record := option.get_help_record(context))]
    rows = [f"| `{_cell(names)}` | {_escaped(' '.join(text.split()))} |" for names, text in records]
    table = "\n".join(("| option | effect |", "| --- | --- |", *rows)) if rows else ""
    parts = [f"{level} {title}", paragraphs(command.help), f"```text\n{usage}\n```", table, paragraphs(command.epilog)]
    return "\n\n".join(filter(None, parts))


def _cell(names: str) -> str:
    return names.replace("|", r"\|")


def page() -> str:
    """Return the whole page."""
    sections = [section(context) for context in commands(main, None, "sim2reason")]
    return "\n\n".join((HEAD.strip(), *sections)) + "\n"


if __name__ == "__main__":
    if sys.argv[1:] != ["--check"]:
        PAGE.write_text(page(), encoding="utf-8")
    elif PAGE.read_text(encoding="utf-8") != page():
        sys.exit("docs/reference/commands.md is out of date; run: python docs/commands.py")

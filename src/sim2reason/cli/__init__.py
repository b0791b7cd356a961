"""The command line: one file per command, found by walking this package.

A command file is named as its command, defines it as the function `command`, and its docstring's first line is what
``sim2reason --help`` says of it. That line is read without importing the file, so help loads nothing heavy.

Exit codes: 0 all is well; 1 the answer is "no" (a damaged dataset, a wrong answer); 2 wrong input;
130 interrupted, by SIGINT or SIGTERM. A command that ends with another code than 0 returns it.
"""

import ast
import sys
from importlib import import_module
from pathlib import Path
from typing import Any, NoReturn

import click

from sim2reason.base.registry import nearest
from sim2reason.cli import console, interrupts, streams

HERE = Path(__file__).parent
EXIT_INPUT, EXIT_INTERRUPTED, EXIT_PIPE = 2, 130, 141


class Commands(click.Group):
    """A click group of the command files in this package, each imported only when called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of the commands in alphabetical order."""
        del ctx
        return sorted(path.stem.replace("_", "-") for path in HERE.glob("[a-z]*.py") if _summary(path) is not None)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import the file of a command; None if there is none."""
        del ctx
        path = HERE / f"{cmd_name.replace('-', '_')}.py"
        if path not in HERE.glob("[a-z]*.py") or _summary(path) is None:  # a path as the name leads nowhere else
            return None
        return import_module(f"{__name__}.{path.stem}").command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the named command with its arguments; the error for an unknown name suggests the nearest names."""
        if args and self.get_command(ctx, args[0]) is None and (near := nearest(args[0], self.list_commands(ctx))):
            ctx.fail(f"No such command {args[0]!r}. Did you mean: {', '.join(near)}?")
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list of commands from the first lines of their files, without importing them."""
        rows = [(name, _summary(HERE / f"{name.replace('-', '_')}.py") or "") for name in self.list_commands(ctx)]
        with formatter.section("Commands"):
            formatter.write_dl(rows)

    def invoke(self, ctx: click.Context) -> object:
        """Run the command; exit quietly if the reader of its output has closed the pipe."""
        try:
            result = super().invoke(ctx)
            sys.stdout.flush()
        except BrokenPipeError:
            streams.hush()
            ctx.exit(EXIT_PIPE)
        return result

    def main(self, *args: Any, **extra: Any) -> NoReturn:  # noqa: ANN401 - click's own signature
        """Run the command and exit with a code; known errors become one line on stderr."""
        extra["standalone_mode"] = False
        streams.prepare()
        try:
            with interrupts.handled_interrupts():
                code = super().main(*args, **extra)
        except (click.Abort, KeyboardInterrupt) as error:
            console.explain(console.explained(error.__cause__ or error))
            raise SystemExit(EXIT_INTERRUPTED) from None
        except click.exceptions.NoArgsIsHelpError as error:
            console.explain(error.format_message())
            raise SystemExit(EXIT_INPUT) from None
        except Exception as error:
            line = console.explained(error)
            if line is None:
                raise
            console.explain(line)
            if isinstance(error, OSError) and streams.name(error) == streams.STDOUT:
                streams.hush()
            raise SystemExit(EXIT_INPUT) from None
        raise SystemExit(code if isinstance(code, int) else 0)


def _summary(path: Path) -> str | None:
    """Return the first line of a command file's docstring; None if the file defines no command."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    if not any(isinstance(node, ast.FunctionDef) and node.name == "command" for node in tree.body):
        return None
    return (ast.get_docstring(tree) or "").partition("\n")[0]


@click.command(
    cls=Commands,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110},
    epilog="Each command's --help shows an example: sim2reason generate --help",
)
@click.version_option(package_name="sim2reason")
def main() -> None:
    """Turn physics simulators into verified problems for language models."""

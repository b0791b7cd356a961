"""The command line: commands grouped by theme, each module imported only when one of its commands is called.

The table `COMMANDS` has the module and the summary of each command, so that ``sim2reason --help`` imports no module.

Exit codes: 0 all is well; 1 the answer is "no" (a damaged dataset, a wrong answer); 2 wrong input;
130 interrupted, by SIGINT or SIGTERM. A command that ends with another code than 0 returns it.
"""

import sys
from importlib import import_module
from typing import Any, NoReturn

import click

from sim2reason.base.registry import similar_names
from sim2reason.cli import console, process

EXIT_INPUT, EXIT_INTERRUPTED, EXIT_PIPE = 2, 130, 141
COMMANDS = {
    "ask": ("sim2reason.cli.questions", "Ask questions about a scene, with their answers."),
    "describe": ("sim2reason.cli.scenes", "Tell a scene in words, with numbers or with symbols."),
    "eval": ("sim2reason.cli.evaluation", "Evaluate policies on benchmarks: ours and those that others published."),
    "explain": (
        "sim2reason.cli.datasets",
        "Tell all about one problem: where it comes from, what vouches for it, and why it was kept.",
    ),
    "export": ("sim2reason.cli.datasets", "Export a dataset for a library that trains or evaluates models."),
    "figure": ("sim2reason.cli.scenes", "Draw the initial state of a scene, labelled as its text names things."),
    "generate": ("sim2reason.cli.generate", "Generate a dataset: problems with certified answers, in a folder."),
    "grade": ("sim2reason.cli.evaluation", "Grade responses to the problems of a dataset."),
    "item": ("sim2reason.cli.scenes", "Make one problem by its coordinates, with its answer."),
    "list": ("sim2reason.cli.reference", "List what there is: entities, recipes, quantities, engines and so on."),
    "plot": (
        "sim2reason.cli.scenes",
        "Plot the motion of a scene: displacement, velocity, acceleration and tension over time.",
    ),
    "sample": ("sim2reason.cli.scenes", "Draw a random scene and write it as a file."),
    "sample-solutions": (
        "sim2reason.cli.evaluation",
        "Have a policy solve problems, and keep its right responses to learn from.",
    ),
    "schema": (
        "sim2reason.cli.reference",
        "Write the JSON schema of scene files, a page that explains the format, or a reference of questions.",
    ),
    "show": ("sim2reason.cli.datasets", "Show problems of a dataset with their answers."),
    "simulate": ("sim2reason.cli.simulation", "Simulate a scene by one engine or by both, and sum up what happens."),
    "solve": ("sim2reason.cli.questions", "Solve a problem in steps, as a teacher would write them."),
    "stats": (
        "sim2reason.cli.datasets",
        "Count what a dataset holds: recipes, modes, kinds, quantities, refused draws, lengths and answers.",
    ),
    "train": ("sim2reason.cli.train", "Train models: supervised fine-tuning, and reinforcement learning."),
    "verify": ("sim2reason.cli.datasets", "Verify a dataset on disk against its manifest."),
}
"""Module and summary of each command; the command ``show``, for example, is the function `show_command`."""


class Commands(click.Group):
    """A click group of the commands in `COMMANDS`, whose modules are imported when they are called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of the commands in alphabetical order."""
        del ctx
        return sorted(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import the module of a command; None if there is none. Underscores stand for dashes, too."""
        del ctx
        module, _ = COMMANDS.get(cmd_name.replace("_", "-"), (None, None))
        return None if module is None else getattr(import_module(module), f"{cmd_name.replace('-', '_')}_command")

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the named command with its arguments; the error for an unknown name suggests the nearest names."""
        if (
            args
            and self.get_command(ctx, args[0]) is None
            and (near := similar_names(args[0], self.list_commands(ctx)))
        ):
            ctx.fail(f"No such command {args[0]!r}. Did you mean: {', '.join(near)}?")
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list of commands with their summaries, without importing their modules."""
        rows = [(name, COMMANDS[name][1]) for name in self.list_commands(ctx)]
        with formatter.section("Commands"):
            formatter.write_dl(rows)

    def invoke(self, ctx: click.Context) -> object:
        """Run the command; exit quietly if the reader of its output has closed the pipe."""
        try:
            result = super().invoke(ctx)
            sys.stdout.flush()
        except BrokenPipeError:
            process.silence_stdout()
            ctx.exit(EXIT_PIPE)
        return result

    def main(self, *args: Any, **extra: Any) -> NoReturn:  # noqa: ANN401 - click's own signature
        """Run the command and exit with a code; known errors become one line on stderr."""
        extra["standalone_mode"] = False
        process.prepare_streams()
        try:
            with process.handled_interrupts():
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
            if isinstance(error, OSError) and process.file_of(error) == process.STDOUT:
                process.silence_stdout()
            raise SystemExit(EXIT_INPUT) from None
        raise SystemExit(code if isinstance(code, int) else 0)


@click.command(
    cls=Commands,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110},
    epilog="Each command's --help shows an example: sim2reason generate --help",
)
@click.version_option(package_name="sim2reason")
def main() -> None:
    """Turn physics simulators into verified problems for language models."""

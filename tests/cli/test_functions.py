"""Tests that each command has a public function of the same name, with the same parameters."""

import ast
import inspect
from collections.abc import Callable, Iterator
from pathlib import Path

import click
import pytest

import sim2reason
from sim2reason.cli import main, options
from sim2reason.cli.options import Printing

COMMANDS = main.list_commands(click.Context(main))
ONE_ROW = {"dataset", "responses", "split"}, {"item", "response"}
"""A file of responses to a dataset, or to its splits; or one response to one item."""
OTHERWISE: dict[str, tuple[set[str], set[str]]] = {
    "grade": ONE_ROW,
    # parts and files are for shells, where the size of shards has a longer name; a maker is hidden
    "generate": ({"shard_size", "shard", "config"}, {"shard", "advance", "maker"}),
    "export": (set(), {"advance"}),
    "sample-solutions": (set(), {"advance"}),
    "eval": (set(), {"config", "out", "begun", "advance"}),  # a group, whose command without a name takes them
    "train": (set(), {"method", "config", "out", "begun", "advance"}),  # the same; a method is a command of its own
    "describe": (set(), {"without"}),  # topics, which are no words of a shell
    "figure": (set(), {"wording"}),  # which a command reads in the scene's file, as well as the scene
    "plot": (set(), {"wording"}),  # the same
}
"""What only a command takes, and only its function."""
COORDINATES = {"recipe", "difficulty", "mode", "seed", "index", "weights"}


def command(name: str) -> click.Command:
    found = main.get_command(click.Context(main), name)
    assert found is not None
    return found


def named(param: click.Parameter) -> str:
    """Return the name of the function parameter that corresponds to an option."""
    return max(param.opts, key=len).removeprefix("--").replace("-", "_")


def taken(found: click.Command) -> Iterator[str]:
    """Yield the parameters of a command, except those about printing or writing its result."""
    for param in found.params:
        if isinstance(param, click.Option):
            if not (param.hidden or isinstance(param, Printing) or "--json" in param.opts):
                yield named(param)
        else:
            yield str(param.name)


def parameters(function: Callable[..., object]) -> Iterator[str]:
    for name, parameter in inspect.signature(function).parameters.items():
        assert parameter.kind is not parameter.VAR_KEYWORD, "help() shows every option"
        yield name


@pytest.mark.parametrize("name", COMMANDS)
def test_a_public_function_has_its_name_and_its_options(name: str) -> None:
    called = name.replace("-", "_")
    assert called in dir(sim2reason), f"a function sim2reason.{called}, beside the command"
    function = getattr(sim2reason, called)
    only_command, only_function = OTHERWISE.get(name, (set(), set()))
    assert set(taken(command(name))) - only_command == set(parameters(function)) - only_function


@pytest.mark.parametrize("name", COMMANDS)
def test_defaults_are_the_same(name: str) -> None:
    signature = inspect.signature(getattr(sim2reason, name.replace("-", "_"))).parameters
    only_command = OTHERWISE.get(name, (set(), set()))[0]
    for param in command(name).params:
        held = signature.get(named(param)) if named(param) not in only_command else None
        if held is None or held.default in (held.empty, None, ()) or param.required or isinstance(param, Printing):
            continue
        default = param.get_default(click.Context(command(name)))
        assert default in (held.default, getattr(held.default, "__name__", "")), param.name


def all_options() -> Iterator[tuple[str, click.Option]]:
    for name in COMMANDS:
        for param in command(name).params:
            if isinstance(param, click.Option):
                yield name, param


@pytest.mark.parametrize(
    ("short", "long"), [("-o", "--out"), ("-n", "--items"), ("-h", "--help")], ids=["out", "items", "help"]
)
def test_a_letter_means_one_word(short: str, long: str) -> None:
    for name, param in all_options():
        if {short, long} & set(param.opts):
            assert {short, long} == set(param.opts), name


def test_a_word_has_one_meaning() -> None:
    """Options of one name have the same type in all commands, apart from bounds and choices."""
    kinds: dict[str, set[tuple[str, bool, int]]] = {}
    for _, param in all_options():
        if not param.hidden and param.opts != ["--shard-size"]:
            kind = type(param.type).__name__, param.is_flag, param.nargs
            kinds.setdefault(max(param.opts, key=len), set()).add(kind)
    assert {name: found for name, found in kinds.items() if len(found) > 1} == {}


def test_synonyms_are_no_options() -> None:
    words = {max(param.opts, key=len).removeprefix("--") for _, param in all_options()}
    for synonyms in ({"items", "item", "count", "number"}, {"out", "output", "o"}, {"solutions", "solution", "solved"}):
        assert len(words & synonyms) <= 1
    assert not [word for word in words if f"{word}s" in words], "one is the plural of another"
    assert {"out", "items", "mode", "recipe", "split", "solutions"} <= words


def test_the_coordinates_of_one_problem_are_given_alike() -> None:
    def coordinates(name: str) -> dict[str, tuple[type, object, bool]]:
        found = {str(param.name): param for param in command(name).params}
        return {each: (type(p), p.default, p.required) for each, p in found.items() if each in COORDINATES}

    assert coordinates("item") == coordinates("sample")
    assert not any(required for _, _, required in coordinates("item").values())
    assert set(coordinates("item")) == COORDINATES


def test_where_several_names_may_stand_all_may() -> None:
    """All options of this kind take several names, except in `item` and `sample`, which make a single problem."""
    found = {(name, str(param.name)) for name, param in all_options() if param.callback is options.names}
    named = {(name, str(param.name)) for name, param in all_options() if param.name in ("recipe", "difficulty", "mode")}
    one = {(name, each) for name, each in named if name in ("item", "sample")}
    assert named - one <= found
    assert not one & found
    assert options.names(click.Context(main), click.Option(["--mode"]), "all") == "all"
    assert options.names(click.Context(main), click.Option(["--mode"]), " a, b,a") == ("a", "b")


def test_the_import_stays_light() -> None:
    """The public names are imported when they are first used."""
    tree = ast.parse(Path(sim2reason.__file__).read_text(encoding="utf-8"))
    imports = [node for node in tree.body if isinstance(node, ast.Import | ast.ImportFrom)]
    assert not [node for node in imports if "sim2reason" in ast.unparse(node)]

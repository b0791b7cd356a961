import json
from dataclasses import dataclass

import pytest
from click.testing import CliRunner

from sim2reason.base import registry
from sim2reason.base.registry import Registry
from sim2reason.cli import main


@dataclass
class Fact:
    name: str
    unit: str
    weight: float


def work() -> None:
    """Do some work.

    And more.
    """


@pytest.fixture
def fakes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "_further", [])  # workers of later tests need not know these
    things: Registry[object] = Registry("things")
    monkeypatch.setattr(things, "_filled", True)
    things.add("work", work)
    things.add("mass", Fact("mass", "kg", 1.0))
    monkeypatch.setattr(registry, "registries", lambda: {"things": things})


@pytest.mark.usefixtures("fakes")
def test_list_tells_names_and_what_they_are() -> None:
    result = CliRunner().invoke(main, ["list"])
    lines = [line.split() for line in result.stdout.splitlines() if line]
    assert lines[0] == ["things", "(2)"]
    assert lines[2:] == [["mass", "unit", "kg"], ["work", "Do", "some", "work."]]


@pytest.mark.usefixtures("fakes")
def test_list_speaks_to_programs() -> None:
    value = json.loads(CliRunner().invoke(main, ["list", "things", "--json"]).stdout)
    assert value == {"things": [{"name": "mass", "summary": "unit kg"}, {"name": "work", "summary": "Do some work."}]}


def test_an_unknown_kind_is_said_with_the_known() -> None:
    result = CliRunner().invoke(main, ["list", "nonsense"])
    assert result.exit_code == 2
    assert "no such kind: 'nonsense'; there are: " in result.stderr
    assert "quantities" in result.stderr


def test_every_registry_of_the_library_is_found_and_filled() -> None:
    result = CliRunner().invoke(main, ["list", "--json"])
    assert result.exit_code == 0, result.stderr
    value = json.loads(result.stdout)
    assert "quantities" in value
    assert all(members for members in value.values())
    assert all(member["summary"] for members in value.values() for member in members)


def test_each_line_says_something_of_its_own() -> None:
    value = json.loads(CliRunner().invoke(main, ["list", "--json"]).stdout)
    for kind in ("engines", "recipes", "modes", "filters"):
        said = [member["summary"] for member in value[kind]]
        assert len(set(said)) == len(said), kind


@pytest.mark.parametrize(
    ("command", "told"),
    [
        (["list", "recipe"], "no such kind: 'recipe'; did you mean: recipes"),
        (["list", "Entity"], "no such kind: 'Entity'; did you mean: entities"),
        (["exprt"], "No such command 'exprt'. Did you mean: export?"),
        (["export", "data", "--to", "huggingface", "-o", "new"], "among exports: 'huggingface'; did you mean: hf"),
        (["export", "data", "--to", "trl", "-o", "new"], "among exports: 'trl'; did you mean: hf"),
        (["export", "data", "--to", "reasoning_gym", "-o", "new"], "did you mean: reasoning-gym"),
    ],
)
def test_a_wrong_name_is_told_with_what_was_meant(command: list[str], told: str) -> None:
    result = CliRunner().invoke(main, command)
    assert result.exit_code == 2
    assert told in result.stderr

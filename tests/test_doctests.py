"""Tests that public objects are documented in full and that the examples in their docstrings run."""

import doctest
import inspect
import re
import shutil
from collections.abc import Iterator
from functools import cached_property
from importlib import import_module
from pathlib import Path
from types import FunctionType, ModuleType

import pytest

import sim2reason
from sim2reason import authoring
from sim2reason.base import registry
from sim2reason.scenes.dsl.entity import ENTITIES

FURTHER = {
    "sim2reason.rewards": ["accuracy"],
    "sim2reason.grading": ["number", "formula"],
    "sim2reason.testing": ["check_entity"],
    "sim2reason.authoring": [n for n in authoring.__all__ if isinstance(getattr(authoring, n), type | FunctionType)],
}
NAMES = [
    *(f"sim2reason.{name}" for name in (*sim2reason.__all__, "list", "eval")),  # open is Dataset
    *(f"{module}.{name}" for module, names in FURTHER.items() for name in names),
]
SECTION = re.compile(r"^(Args|Attributes|Returns|Yields|Raises|Examples):$", re.MULTILINE)
ENTRY = re.compile(r"^    \*{0,2}(\w+): ", re.MULTILINE)
VAGUE = re.compile(r"(?i)(what|whether|who|whose|of|by|as|its|it|those|where|the same)\b")
"""Words with which no summary begins, since it must be understood by itself."""


def public(name: str) -> object:
    module, _, attribute = name.rpartition(".")
    return getattr(import_module(module), attribute)


def classes(names: list[str]) -> list[str]:
    return [name for name in names if isinstance(public(name), type)]


def sections(documented: object) -> dict[str, str]:
    """Return the sections of a docstring by their titles; the text before the first one has an empty title."""
    first, *others = SECTION.split(inspect.getdoc(documented) or "")
    return {"": first, **dict(zip(others[::2], others[1::2], strict=True))}


def described(documented: object, *titles: str) -> set[str]:
    """Return the names that some sections of a docstring describe."""
    found = sections(documented)
    return {name for title in titles for name in ENTRY.findall(found.get(title, ""))}


def parameters(function: object) -> set[str]:
    """Return the names of the arguments that a caller can give."""
    try:
        found = inspect.signature(function)  # type: ignore[arg-type]
    except ValueError:  # an error class, whose constructor is that of Exception
        return set()
    return set(found.parameters) - {"self", "cls", "args", "kwargs"}


def fields(cls: type) -> set[str]:
    """Return the public fields and properties that a class defines itself."""
    properties = {name for name, member in vars(cls).items() if isinstance(member, property | cached_property)}
    return {name for name in properties | set(inspect.get_annotations(cls)) if not name.startswith("_")}


def functions(cls: type) -> Iterator[tuple[str, FunctionType]]:
    """Return the public methods and properties that a class defines itself."""
    declared = inspect.get_annotations(cls)
    for name, member in vars(cls).items():
        own = member.fget if isinstance(member, property) else getattr(member, "__func__", member)
        found = own.func if isinstance(own, cached_property) else own
        if isinstance(found, FunctionType) and not name.startswith("_") and name not in declared:
            yield name, found


@pytest.fixture(scope="module")
def problems(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Generate the dataset of the examples, so that each of them finds it finished."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sim2reason.datasets.build.put_pictures", lambda *_: ())
        out = tmp_path_factory.mktemp("doctests") / "problems"
        return sim2reason.generate(out, items=2, recipe="pulley", difficulty="easy", workers=1).path


@pytest.fixture
def _apart(problems: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run an example in a separate folder with the dataset, and remove the entities that it registers."""
    shutil.copytree(problems, tmp_path / "problems")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(ENTITIES, "_members", dict(ENTITIES.items()))
    monkeypatch.setattr(registry, "_further", list(registry._further))


@pytest.mark.usefixtures("_apart")
@pytest.mark.parametrize("name", NAMES)
def test_examples_give_what_they_show(name: str) -> None:
    runner, shown = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.REPORT_NDIFF), list[str]()
    for example in doctest.DocTestFinder().find(public(name), name, module=False, globs={"__name__": "__main__"}):
        assert not runner.run(example, out=shown.append).failed, "".join(shown)


@pytest.mark.parametrize("name", NAMES)
def test_a_docstring_is_complete(name: str) -> None:
    found = public(name)
    text = sections(found)
    assert not VAGUE.match(text[""])
    assert ">>> " in text["Examples"]
    assert parameters(found) <= described(found, "Args", "Attributes")
    if isinstance(found, type):
        assert fields(found) <= described(found, "Attributes")
    elif inspect.signature(found).return_annotation is not None:  # type: ignore[arg-type]
        assert text.keys() & {"Returns", "Yields"}


@pytest.mark.parametrize("name", classes(NAMES))
def test_the_methods_of_a_class_are_documented(name: str) -> None:
    cls = public(name)
    assert isinstance(cls, type)
    for member, function in functions(cls):
        assert function.__doc__, member
        assert not VAGUE.match(function.__doc__), member
        if not name.startswith("sim2reason.authoring"):
            assert parameters(function) <= described(function, "Args"), member


def test_the_other_names_of_authors_are_explained_by_their_module() -> None:
    text = authoring.__doc__ or ""
    assert not [name for name in authoring.__all__ if f"`{name}`" not in text]


@pytest.mark.parametrize("module", [sim2reason, authoring], ids=lambda module: module.__name__)
def test_the_examples_of_modules_run(module: ModuleType) -> None:
    for example in doctest.DocTestFinder(recurse=False).find(module):
        assert not doctest.DocTestRunner().run(example).failed

"""Public objects are documented in full, and the examples in their docstrings run."""

import doctest
import inspect
import re
import shutil
from collections.abc import Iterator
from functools import cached_property
from importlib import import_module
from pathlib import Path
from types import FunctionType

import pytest

import sim2reason
from sim2reason import authoring, registry
from sim2reason.dsl.entity import ENTITIES

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
SECTIONS = re.compile(r"^(Args|Attributes|Returns|Yields|Raises|Example):$", re.MULTILINE)
VAGUE = re.compile(r"(?i)(what|whether|who|whose|of|by|as|its|it|those|where|the same)\b")
"""How no summary begins: it must be understood by itself."""
Variadic = inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD


def public(name: str) -> object:
    module, _, attribute = name.rpartition(".")
    return getattr(import_module(module), attribute)


def sections(text: str) -> dict[str, str]:
    """The parts of a docstring by their titles; the first part, without a title, under an empty one."""
    first, *others = SECTIONS.split(text)
    return {"": first, **dict(zip(others[::2], others[1::2], strict=True))}


def entries(text: str) -> set[str]:
    """The names that a section explains."""
    return {
        name for names in re.findall(r"^    (\*{0,2}\w+(?:, \w+)*): ", text, re.MULTILINE) for name in names.split(", ")
    }


def parameters(function: object) -> set[str]:
    """The names of the arguments that a caller gives, with stars before those of any number."""
    try:
        found = inspect.signature(function).parameters.values()  # type: ignore[arg-type]
    except ValueError:  # a class whose constructor is that of Exception
        return set()
    return {f"*{each.name}" if each.kind is each.VAR_POSITIONAL else each.name for each in found}


def members(cls: type) -> Iterator[tuple[str, object]]:
    """The public methods, properties and fields that a class defines itself."""
    yield from ((name, member) for name, member in vars(cls).items() if not name.startswith("_"))
    yield from ((name, None) for name in vars(cls).get("__annotations__", {}) if not name.startswith("_"))


def attributes(cls: type) -> set[str]:
    return {name for name, member in members(cls) if isinstance(member, property | cached_property | None)}


@pytest.fixture(scope="module")
def problems(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The dataset that examples make, so that each of them finds it finished."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sim2reason.datasets.finish.put_pictures", lambda *_: ())
        out = tmp_path_factory.mktemp("doctests") / "problems"
        return sim2reason.generate(out, items=2, recipe="pulley", difficulty="easy", workers=1).path


@pytest.fixture
def _apart(problems: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder of its own, with the dataset; and a registry that forgets what an example enters."""
    shutil.copytree(problems, tmp_path / "problems")
    monkeypatch.chdir(tmp_path)
    _ = len(ENTITIES)
    monkeypatch.setattr(ENTITIES, "_members", dict(ENTITIES.items()))
    monkeypatch.setattr(registry, "_further", list(registry._further))


@pytest.mark.usefixtures("_apart")
@pytest.mark.parametrize("name", NAMES)
def test_examples_give_what_they_show(name: str) -> None:
    flags = doctest.ELLIPSIS | doctest.REPORT_NDIFF
    for example in doctest.DocTestFinder().find(public(name), name, module=False, globs={"__name__": "__main__"}):
        shown: list[str] = []
        result = doctest.DocTestRunner(optionflags=flags).run(example, out=shown.append)
        assert not result.failed, "".join(shown)


@pytest.mark.parametrize("name", NAMES)
def test_a_docstring_is_complete(name: str) -> None:
    found = public(name)
    parts = sections(inspect.getdoc(found) or "")
    assert ">>> " in parts.get("Example", "")
    assert not VAGUE.match(parts[""])
    explained = entries(parts.get("Args", "")) | entries(parts.get("Attributes", ""))
    assert parameters(found) - {"*args", "args", "kwargs"} <= explained
    if isinstance(found, type):
        assert attributes(found) <= explained
    elif inspect.signature(found).return_annotation is not None:  # type: ignore[arg-type]
        assert {"Returns", "Yields"} & parts.keys()


@pytest.mark.parametrize("name", [name for name in NAMES if isinstance(public(name), type)])
def test_methods_are_documented(name: str) -> None:
    cls = public(name)
    assert isinstance(cls, type)
    for member, function in members(cls):
        if isinstance(function, FunctionType | classmethod) and member not in attributes(cls):
            parts = sections(inspect.getdoc(function) or "")
            assert parts[""], member
            assert not VAGUE.match(parts[""]), member

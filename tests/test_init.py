"""Tests of the names, version and signatures of the package."""

import builtins
import inspect
from importlib.metadata import version

import sim2reason


def test_a_star_import_replaces_no_builtin() -> None:
    names: dict[str, object] = {}
    exec("from sim2reason import *", names)
    del names["__builtins__"]
    assert "generate" in names
    assert not set(names) & set(dir(builtins))
    for name in ("open", "list", "eval"):
        assert callable(getattr(sim2reason, name))
        assert name in dir(sim2reason)


def test_the_version_is_told() -> None:
    assert sim2reason.__version__ == version("sim2reason")


def test_help_shows_each_option_of_generate_with_its_type_default_and_meaning() -> None:
    signature = inspect.signature(sim2reason.generate)
    assert "order" not in signature.parameters
    assert {"items", "recipe", "difficulty", "mode", "seed", "split", "solutions"} <= set(signature.parameters)
    told = inspect.getdoc(sim2reason.generate) or ""
    for name, parameter in signature.parameters.items():
        assert parameter.annotation is not parameter.empty
        assert name == "out" or parameter.default is not parameter.empty
        assert f"\n    {name}: " in told

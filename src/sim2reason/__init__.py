r"""Physics simulators turned into verified problems for language models.

Each command of the command line has a function of its name here, with underscores for dashes. The names are loaded when
they are first used, so that the import is fast. ``open``, ``list`` and ``eval``, which are builtins of Python, too, are
reached through the module alone: ``import *`` leaves them out.

Example:
    >>> import sim2reason
    >>> problem = sim2reason.item("pulley", "easy", seed=7)
    >>> sim2reason.grade(problem, r"The answer is \boxed{0}.").reward
    0.0
"""

import gc
from collections.abc import Iterable
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    __version__: str
    from sim2reason.base.registry import members
    from sim2reason.datasets.dataset import Dataset, verify
    from sim2reason.datasets.exports.export import export
    from sim2reason.datasets.fresh import iterable
    from sim2reason.datasets.generate import generate
    from sim2reason.datasets.grade import grade
    from sim2reason.datasets.inspection import explain, show, stats
    from sim2reason.datasets.items import item, sample, stream
    from sim2reason.datasets.scene_questions import ask, solve
    from sim2reason.errors import Sim2ReasonError
    from sim2reason.evaluation.reports.evaluation import evaluate
    from sim2reason.figures.drawing import figure, plot
    from sim2reason.generation.item import Item
    from sim2reason.grading import Score
    from sim2reason.questions.prompt import parse_prompt
    from sim2reason.scenes.dsl.mechanism import Mechanism
    from sim2reason.scenes.dsl.scene import Scene
    from sim2reason.scenes.files import dump, load
    from sim2reason.scenes.files.schema import schema
    from sim2reason.simulation.certify import Certificate
    from sim2reason.simulation.scenes import certify, simulate
    from sim2reason.simulation.trace import Trace
    from sim2reason.text.parsing import parse_scene
    from sim2reason.text.prose import describe
    from sim2reason.training import train
    from sim2reason.training.corpora.solutions import sample_solutions

    open = Dataset  # noqa: A001 - as gzip.open
    list = members  # noqa: A001 - named as the command
    eval = evaluate  # noqa: A001 - named as the command

_HOMES = {
    "Certificate": "simulation.certify",
    "Dataset": "datasets.dataset",
    "Item": "generation.item",
    "Mechanism": "scenes.dsl.mechanism",
    "Scene": "scenes.dsl.scene",
    "Score": "grading",
    "Sim2ReasonError": "errors",
    "Trace": "simulation.trace",
    "ask": "datasets.scene_questions",
    "certify": "simulation.scenes",
    "describe": "text.prose",
    "dump": "scenes.files",
    "eval": "evaluation.reports.evaluation:evaluate",
    "export": "datasets.exports.export",
    "explain": "datasets.inspection",
    "figure": "figures.drawing",
    "generate": "datasets.generate",
    "grade": "datasets.grade",
    "item": "datasets.items",
    "iterable": "datasets.fresh",
    "list": "base.registry:members",
    "load": "scenes.files",
    "open": "datasets.dataset:Dataset",
    "parse_prompt": "questions.prompt",
    "parse_scene": "text.parsing",
    "plot": "figures.drawing",
    "sample": "datasets.items",
    "sample_solutions": "training.corpora.solutions",
    "schema": "scenes.files.schema",
    "show": "datasets.inspection",
    "simulate": "simulation.scenes",
    "solve": "datasets.scene_questions",
    "stats": "datasets.inspection",
    "stream": "datasets.items",
    "train": "training",
    "verify": "datasets.dataset",
}
"""Module of each public name; after a colon, the name in that module where it differs."""

__all__ = [
    "Certificate",
    "Dataset",
    "Item",
    "Mechanism",
    "Scene",
    "Score",
    "Sim2ReasonError",
    "Trace",
    "ask",
    "certify",
    "describe",
    "dump",
    "explain",
    "export",
    "figure",
    "generate",
    "grade",
    "item",
    "iterable",
    "load",
    "parse_prompt",
    "parse_scene",
    "plot",
    "sample",
    "sample_solutions",
    "schema",
    "show",
    "simulate",
    "solve",
    "stats",
    "stream",
    "train",
    "verify",
]


def __getattr__(name: str) -> object:
    """Import the module of a public name when the name is first used."""
    if name == "__version__":
        return import_module("importlib.metadata").version(__name__)
    if name not in _HOMES:
        raise AttributeError(f"module 'sim2reason' has no attribute {name!r}")
    module, _, called = _HOMES[name].partition(":")
    collects = gc.isenabled()
    gc.disable()  # imports make many objects and no garbage: collections would take a seventh of the time
    try:
        return getattr(import_module(f"sim2reason.{module}"), called or name)
    finally:
        if collects:
            gc.enable()


def __dir__() -> Iterable[str]:
    """Return the public names."""
    return sorted([*_HOMES, "__version__"])

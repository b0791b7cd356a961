"""Physics simulators turned into verified problems for language models.

The public names below are loaded when they are first used, so that the import itself costs next to nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sim2reason.datasets.dataset import Dataset
    from sim2reason.datasets.generate import generate
    from sim2reason.datasets.grade import grade
    from sim2reason.datasets.item import Item
    from sim2reason.datasets.items import item, stream
    from sim2reason.datasets.random_scenes import sample
    from sim2reason.dsl.mechanism import Mechanism
    from sim2reason.dsl.scene import Scene
    from sim2reason.errors import Sim2ReasonError
    from sim2reason.exports.parts.export import export
    from sim2reason.grading import Score
    from sim2reason.parsing import parse_scene
    from sim2reason.prose import describe
    from sim2reason.scene_files import dump, load
    from sim2reason.simulation.certify import Certificate
    from sim2reason.simulation.scenes import certify, simulate
    from sim2reason.simulation.trace import Trace

_HOMES = {
    "Certificate": "simulation.certify",
    "Dataset": "datasets.dataset",
    "Item": "datasets.item",
    "Mechanism": "dsl.mechanism",
    "Scene": "dsl.scene",
    "Score": "grading",
    "Sim2ReasonError": "errors",
    "Trace": "simulation.trace",
    "certify": "simulation.scenes",
    "describe": "prose",
    "dump": "scene_files",
    "export": "exports.parts.export",
    "generate": "datasets.generate",
    "grade": "datasets.grade",
    "item": "datasets.items",
    "load": "scene_files",
    "parse_scene": "parsing",
    "sample": "datasets.random_scenes",
    "simulate": "simulation.scenes",
    "stream": "datasets.items",
}

__all__ = [
    "Certificate",
    "Dataset",
    "Item",
    "Mechanism",
    "Scene",
    "Score",
    "Sim2ReasonError",
    "Trace",
    "certify",
    "describe",
    "dump",
    "export",
    "generate",
    "grade",
    "item",
    "load",
    "parse_scene",
    "sample",
    "simulate",
    "stream",
]


def __getattr__(name: str) -> object:
    """Import the home of a public name at its first use."""
    if name not in _HOMES:
        raise AttributeError(f"module 'sim2reason' has no attribute {name!r}")
    return getattr(import_module(f"sim2reason.{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    """The public names."""
    return sorted(__all__)
